"""Sparks and stars: what shells are filled with. Sizes, lives and drags are those of real ones, rounded."""

from __future__ import annotations

from typing import NamedTuple

from game.physics.generations import Birth, Kind

STAR_DRAG = 0.022  # 1/m, of a star of 12 mm at full mass
COLORS = ("red", "green", "blue", "lemon", "violet", "white")


class Amounts(NamedTuple):
    """What the table is made for. sparks: how many a trail leaves, 1: as it is; places: share of the pool."""

    sparks: float = 1.0
    places: float = 1.0


def _room(places: int, amounts: Amounts) -> int:
    return max(int(places * amounts.places), 1)


def spark_kinds(amounts: Amounts) -> tuple[Kind, ...]:
    """The last generation: what only glows and goes out. Smoke is one of them."""
    room = amounts
    return (
        Kind("ember", life_s=2.3, life_spread=0.35, weight=0.6, linear_drag_per_s=0.9, burns=0.9,
             capacity=_room(28_000, room)),
        Kind("cinder", life_s=1.7, life_spread=0.4, weight=0.6, linear_drag_per_s=1.0, burns=0.9,
             capacity=_room(54_000, room)),
        Kind("glitter", life_s=0.85, life_spread=0.5, weight=0.8, linear_drag_per_s=1.6, burns=0.9,
             capacity=_room(24_000, room)),
        Kind("silver", life_s=0.6, life_spread=0.5, weight=0.8, linear_drag_per_s=1.8, burns=0.9,
             capacity=_room(6_000, room)),
        Kind("crack", life_s=0.22, life_spread=0.5, linear_drag_per_s=2.0, burns=0.9,
             capacity=_room(4_000, room)),
        Kind("lift", life_s=0.7, life_spread=0.5, drag_per_m=0.03, burns=0.9, capacity=_room(3_000, room)),
        Kind("smoke", life_s=34.0, life_spread=0.3, weight=-0.02, linear_drag_per_s=1.3, grounded=False,
             capacity=_room(6_000, room)),
    )  # fmt: skip


def star_kinds(amounts: Amounts) -> tuple[Kind, ...]:
    """Stars that shells throw: plain ones by colour, and those with trails or children of their own."""
    room, more = amounts, amounts.sparks

    def trail(kind: str, rate: float, scatter: float, inherited: float = 0.25) -> Birth:
        return Birth("trail", kind, rate_per_s=rate * more, inherited=inherited, scatter_m_s=scatter)

    plain = tuple(
        Kind(color, life_s=2.0, life_spread=0.12, drag_per_m=STAR_DRAG, burns=0.75,
             capacity=_room(1_600, room))
        for color in COLORS
    )  # fmt: skip
    return (
        *plain,
        Kind("gilt", life_s=2.3, life_spread=0.1, drag_per_m=0.02, burns=0.7, capacity=_room(1_200, room),
             births=(trail("glitter", 34.0, 0.8),)),
        Kind("weeping", life_s=4.4, life_spread=0.12, weight=0.8, drag_per_m=0.028, burns=0.5,
             capacity=_room(900, room), births=(trail("ember", 26.0, 0.5, 0.4),)),
        Kind("cyan", life_s=2.2, life_spread=0.06, drag_per_m=0.018, burns=0.7, capacity=_room(800, room)),
        Kind("frond", life_s=2.7, life_spread=0.1, drag_per_m=0.010, burns=0.5, capacity=_room(160, room),
             births=(trail("ember", 110.0, 1.6, 0.25),)),
        Kind("split", life_s=0.95, drag_per_m=0.016, burns=0.4, capacity=_room(300, room),
             births=(trail("silver", 30.0, 0.4),
                     Birth("death", "cross", count=4, pattern="arms", speed_m_s=26.0, angle_deg=45.0))),
        Kind("cross", life_s=0.9, life_spread=0.1, drag_per_m=0.03, burns=0.7, capacity=_room(1_200, room),
             births=(trail("silver", 55.0, 0.5),)),
        Kind("magnesium", life_s=5.5, life_spread=0.25, weight=0.7, drag_per_m=0.09, burns=0.3,
             capacity=_room(700, room)),
        Kind("whirl", life_s=2.4, life_spread=0.08, drag_per_m=0.014, burns=0.7,
             capacity=_room(400, room), births=(trail("silver", 22.0, 0.4),)),
        Kind("lace", life_s=3.6, life_spread=0.12, drag_per_m=0.03, burns=0.5,
             capacity=_room(1_300, room), births=(trail("cinder", 37.0, 1.0, 0.3),)),
        Kind("rose", life_s=2.6, life_spread=0.06, drag_per_m=0.014, burns=0.6, capacity=_room(500, room)),
        Kind("popping", life_s=1.9, life_spread=0.3, drag_per_m=0.026, burns=0.4, reports=True,
             capacity=_room(500, room),
             births=(Birth("death", "crack", count=6, speed_m_s=22.0, speed_spread=0.4),)),
    )  # fmt: skip
