"""Shells: what flies up from a mortar with recoil sparks and smoke, and what it bursts into."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.physics.generations import Birth, Kind
from game.physics.kernels import elementary
from game.scenes.fireworks.stars import Amounts, spark_kinds, star_kinds

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
