"""Shells, what they are filled with, and what they burst into.

Sizes, lives and drags of sparks and stars are those of real ones, rounded.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.physics.generations import Birth, Kind
from game.physics.kernels import elementary

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


SHELL_DRAG = 0.0012  # 1/m, of a shell of 0.15 m
PLACES = 64  # shells of a kind that can fly at a time
Points = tuple[tuple[float, float], ...]


class Head(NamedTuple):
    """The stars of a shell by whose reach a burst is measured: kind, fastest speed (m/s)."""

    star: str
    speed: float


def centred(points: Points) -> Points:
    """Points moved so that their mean is at the origin, and scaled so that the farthest is at 1."""
    x = math.fsum(point[0] for point in points) / len(points)
    y = math.fsum(point[1] for point in points) / len(points)
    reach = max(elementary.hypot(point[0] - x, point[1] - y) for point in points)
    return tuple(((point[0] - x) / reach, (point[1] - y) / reach) for point in points)


def heart(count: int) -> Points:
    """Points of a heart, evenly in its parameter."""
    turns = [math.tau * (i + 0.5) / count for i in range(count)]
    return centred(
        tuple(
            (16.0 * elementary.cube(elementary.sin(t)),
             13.0 * elementary.cos(t) - 5.0 * elementary.cos(2.0 * t)
             - 2.0 * elementary.cos(3.0 * t) - elementary.cos(4.0 * t))
            for t in turns
        )
    )  # fmt: skip


def spiral_arms(count: int, arms: int = 3) -> Points:
    """Points of Archimedean spirals."""
    each = count // arms
    return centred(
        tuple(
            (r * elementary.cos(turn), r * elementary.sin(turn))
            for arm in range(arms)
            for r, turn in (
                (0.12 + 0.88 * i / (each - 1), math.tau * (arm / arms + 0.62 * i / (each - 1)))
                for i in range(each)
            )
        )
    )


def _burst(star: str, count: int, speed: float, spread: float = 0.0, **more: object) -> Birth:
    return Birth("death", star, count=count, speed_m_s=speed, speed_spread=spread, **more)  # type: ignore[arg-type]


# what each shell bursts into, the head first
BURSTS: dict[str, tuple[Birth, ...]] = {
    "peony": (_burst("red", 260, 62.0, 0.06), _burst("lemon", 70, 24.0, 0.1)),
    "peony-blue": (_burst("blue", 260, 62.0, 0.06), _burst("white", 60, 22.0, 0.1)),
    "peony-green": (_burst("green", 240, 60.0, 0.06), _burst("violet", 90, 28.0, 0.1)),
    "dahlia": (_burst("violet", 150, 72.0, 0.04), _burst("lemon", 90, 40.0, 0.05)),
    "chrysanthemum": (_burst("gilt", 190, 60.0, 0.05), _burst("red", 60, 20.0, 0.1)),
    "willow": (_burst("weeping", 130, 44.0, 0.18),),
    "ring": (
        _burst("cyan", 90, 58.0, pattern="ring", angle_deg=18.0, spread_deg=62.0),
        _burst("rose", 60, 34.0, pattern="ring", angle_deg=-35.0, spread_deg=50.0),
    ),
    "palm": (
        _burst("frond", 12, 46.0, 0.12, pattern="arms", angle_deg=15.0, spread_deg=32.0),
        _burst("lemon", 30, 14.0, 0.2),
    ),
    "crossette": (_burst("split", 22, 52.0, 0.03, pattern="ring", angle_deg=10.0, spread_deg=25.0),),
    "strobe": (_burst("magnesium", 120, 46.0, 0.25),),
    "spiral": (_burst("whirl", 90, 52.0, pattern="shape", points=spiral_arms(90)),),
    "brocade": (_burst("lace", 130, 58.0, 0.12),),
    "heart": (_burst("rose", 112, 56.0, pattern="shape", points=heart(112)),),
    "crackle": (_burst("popping", 90, 54.0, 0.2), _burst("green", 60, 60.0, 0.05)),
    "rocket": (_burst("white", 90, 44.0, 0.1), _burst("blue", 60, 56.0, 0.05)),
    "comet": (),
}
SHELLS = tuple(BURSTS)
HEADS = {  # a rocket is fast when it bursts, and its stars with it: no circle is to be expected
    shell: Head(births[0].kind, births[0].speed_m_s * (1.0 + births[0].speed_spread))
    for shell, births in BURSTS.items()
    if births and shell != "rocket"
}


def _launch() -> tuple[Birth, ...]:
    """What a mortar throws out with a shell: sparks upwards, recoil sparks to the sides, smoke."""
    return (
        Birth("birth", "lift", count=36, pattern="cone", speed_m_s=42.0, speed_spread=0.5, inherited=0.0,
              spread_deg=9.0),
        Birth("birth", "lift", count=18, pattern="cone", speed_m_s=13.0, speed_spread=0.6, inherited=-0.04,
              spread_deg=84.0),
        Birth("birth", "smoke", count=5, pattern="cone", speed_m_s=6.0, speed_spread=0.6, inherited=0.02,
              spread_deg=50.0),
    )  # fmt: skip


def _shell(name: str, amounts: Amounts) -> Kind:
    more = amounts.sparks
    puffs = Birth(
        "death", "smoke", count=24, speed_m_s=22.0, speed_spread=0.7, inherited=0.3, scatter_m_s=6.0
    )
    births = list(_launch())
    if name == "comet":
        births += [
            Birth("trail", "ember", rate_per_s=190.0 * more, inherited=0.12, scatter_m_s=1.8),
            Birth("trail", "smoke", rate_per_s=5.0, inherited=0.1, scatter_m_s=1.0),
        ]
    elif name == "rocket":
        births += [
            Birth("trail", "glitter", rate_per_s=170.0 * more, inherited=-0.35, scatter_m_s=3.0),
            Birth("trail", "smoke", rate_per_s=7.0, inherited=-0.1, scatter_m_s=1.0),
            puffs,
        ]
    else:
        births += [
            Birth("trail", "glitter", rate_per_s=45.0 * more, inherited=0.15, scatter_m_s=0.7),
            Birth("trail", "smoke", rate_per_s=2.0, inherited=0.1, scatter_m_s=0.5),
            puffs,
        ]
    driven = name == "rocket"
    return Kind(
        name, life_s=2.6 if driven else 4.0, drag_per_m=SHELL_DRAG, burns=0.42 if driven else 0.0,
        exhaust_m_s=105.0 if driven else 0.0, reports=True, capacity=PLACES,
        births=(*births, *BURSTS[name]),
    )  # fmt: skip


USUAL = Amounts()


def all_kinds(amounts: Amounts = USUAL) -> tuple[Kind, ...]:
    """Every kind, shells last."""
    return (
        *spark_kinds(amounts), *star_kinds(amounts), *(_shell(name, amounts) for name in SHELLS),
    )  # fmt: skip
