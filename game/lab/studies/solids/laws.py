"""Set-ups of solids whose answer is known: each built on any settings, run for a time, and measured."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from game.physics.kernels import elementary
from game.physics.solids import Capsule, Disc, Material, SolidSettings, SolidWorld, box

G = 9.81  # m/s²
FRAME = 1.0 / 60.0  # s


class Law(NamedTuple):
    """name, title, what its error is and its unit, s of a run, and `measure`: a world's error, which it
    makes and runs.

    points: contact points at most, for solvers that have a limit. spread: error below which the law itself
    is not sure.
    """

    name: str
    title: str
    error: str
    unit: str
    seconds: float
    measure: Callable[[SolidSettings], float]
    reference: str
    points: int = 4
    spread: float = 1e-13


def tilted(settings: SolidSettings, degrees: float, friction: float) -> SolidWorld:
    """A world with a floor whose top is y = 0, tilted by turning gravity: downhill is +x."""
    turn = math.radians(degrees)
    world = SolidWorld(settings)
    world.set(gravity=(G * elementary.sin(turn), -G * elementary.cos(turn)))
    world.add_body(box(400.0, 1.0, material=Material(friction=friction)), (0.0, -0.5), kind="fixed")
    return world


def run(world: SolidWorld, seconds: float) -> SolidWorld:
    """Steps of a frame for so long."""
    for _ in range(round(seconds / FRAME)):
        world.step(FRAME)
    return world


def slide(settings: SolidSettings) -> float:
    """A box on a slope of 30 degrees, friction 0.3, for 1 s: g t² (sin - mu cos) / 2."""
    world = tilted(settings, 30.0, 0.3)
    body = world.add_body(box(1.0, 1.0, material=Material(friction=0.3)), (0.0, 0.5))
    return abs(float(run(world, 1.0).bodies.positions[body, 0]) - 1.1781436183311982)


def slide_to_roll(settings: SolidSettings) -> float:
    """A disc let go at 4 m/s without spin, friction 0.25: place after 1 s; it rolls from 0.5437 s on."""
    world = tilted(settings, 0.0, 0.25)
    body = world.add_body(Disc(0.2, material=Material(friction=0.25)), (0.0, 0.2), velocity=(4.0, 0.0))
    exact = 1.8122097632800998 + (8.0 / 3.0) * (1.0 - 0.5436629289840299)
    return abs(float(run(world, 1.0).bodies.positions[body, 0]) - exact)


def roll(settings: SolidSettings) -> float:
    """A disc rolls down 20 degrees for 2 s without slip: g t² sin / 3."""
    world = tilted(settings, 20.0, 0.6)
    body = world.add_body(Disc(0.3, material=Material(friction=0.6)), (0.0, 0.3))
    return abs(float(run(world, 2.0).bodies.positions[body, 0]) - 4.473623474699747)


def column_sinks(settings: SolidSettings) -> float:
    """Ten unit boxes upon each other after 3 s: how far the top one is from where it was put."""
    world = tilted(settings, 0.0, 0.6)
    bodies = [world.add_body(box(1.0, 1.0), (0.0, 0.5 + k)) for k in range(10)]
    x, y = run(world, 3.0).bodies.positions[bodies[-1]].tolist()
    return elementary.hypot(x, y - 9.5)


def heavy_on_light(settings: SolidSettings) -> float:
    """A box of 1,000 kg upon three of 1 kg after 2 s: how far it is from where it was put."""
    world = tilted(settings, 0.0, 0.6)
    for k in range(3):
        world.add_body(box(1.0, 1.0), (0.0, 0.5 + k))
    heavy = world.add_body(box(1.0, 1.0, material=Material(1000.0)), (0.0, 3.5))
    x, y = run(world, 2.0).bodies.positions[heavy].tolist()
    return elementary.hypot(x, y - 3.5)


def double_rod(settings: SolidSettings) -> float:
    """Two rods of 1 m linked and let go from horizontal: their angles after 1 s, by Lagrange's equations."""
    world = SolidWorld(settings)
    base = world.add_body(box(0.1, 0.1), (0.0, 5.0), kind="fixed")
    thin = Material(density=1000.0)
    rods = [world.add_body(box(1.0, 1e-3, material=thin), (0.5 + k, 0.0)) for k in range(2)]
    world.add_joint("pin", base, rods[0], (0.0, 0.0))
    world.add_joint("pin", rods[0], rods[1], (1.0, 0.0))
    angles = run(world, 1.0).bodies.angles[rods] + 0.5 * math.pi
    return elementary.hypot(angles[0] + 1.2077162381906033, angles[1] + 0.814391023091329)


def domino_speed(settings: SolidSettings) -> float:
    """Dominoes 0.16 thick, 0.4 apart, 1 high, friction 0.2: speed of the wave / sqrt(g h) against 1.3466."""
    thick, apart, count = 0.16, 0.4, 24
    world = SolidWorld(settings)
    rough = Material(friction=20.0)  # the foot does not slide: with their own 0.2, 2 on the floor
    smooth = Material(friction=0.2)
    world.add_body(box(60.0, 1.0, material=rough), (10.0, -0.5), kind="fixed")
    row = [world.add_body(box(thick, 1.0, material=smooth), ((thick + apart) * k, 0.5)) for k in range(count)]
    world.set_velocity(row[0], (0.5, 0.0), -1.0)
    started: dict[int, float] = {}
    for _ in range(round(8.0 / FRAME)):
        world.step(FRAME)
        for k in (12, 20):
            angle = -float(world.bodies.angles[row[k]])
            if k not in started and angle > 0.05:  # since it passed, at the speed that it has now
                started[k] = world.time - (angle - 0.05) / max(1e-9, -float(world.bodies.spins[row[k]]))
        if 20 in started:
            break
    if len(started) < 2 or started[20] <= started[12]:
        return 1.0
    speed = 8.0 * (thick + apart) / (started[20] - started[12])
    return abs(speed / math.sqrt(G) / 1.3466 - 1.0)


def stands(settings: SolidSettings, degrees: float) -> bool:
    """Two cards of 1 m lean on each other by an angle from upright, friction 0.4: there after 0.75 s?"""
    radius, turn = 0.01, math.radians(degrees)
    paper = Material(friction=0.4)
    world = SolidWorld(settings)
    world.add_body(box(20.0, 1.0, material=paper), (0.0, -0.5), kind="fixed")
    x, y = radius + 0.5 * elementary.sin(turn), radius + 0.5 * elementary.cos(turn)
    cards = [
        world.add_body(Capsule((0.0, -0.5), (0.0, 0.5), radius, paper), (-x, y), -turn),
        world.add_body(Capsule((0.0, -0.5), (0.0, 0.5), radius, paper), (x, y), turn),
    ]
    run(world, 0.75)
    return all(abs(float(world.bodies.positions[card, 1]) - y) < 0.05 * y for card in cards)


def card_house(settings: SolidSettings) -> float:
    """Steepest lean at which two cards stand, by bisection from 30 to 46 degrees.

    Moments about the foot of a card of length L with ends of radius r: L sin / 2 = mu (L cos + r): 39.018
    degrees (38.66, by tan = 2 mu, for cards without thickness).
    """
    low, high = 30.0, 46.0
    for _ in range(7):
        middle = 0.5 * (low + high)
        if stands(settings, middle):
            low = middle
        else:
            high = middle
    return abs(0.5 * (low + high) - 39.01773447916722)


LAWS = {
    law.name: law
    for law in (
        Law("slope", "a box slides down a slope", "place after 1 s", "m", 1.0, slide,
            "Coulomb's law."),
        Law("slide-to-roll", "a disc slides, then rolls", "place after 1 s", "m", 1.0, slide_to_roll,
            "Coulomb's law, and rolling at two thirds of the speed.", 1),
        Law("rolling", "a disc rolls down a slope", "place after 2 s", "m", 2.0, roll,
            "Two thirds of g sin.", 1),
        Law("column", "a column of ten", "how far its top has moved", "m", 3.0, column_sinks,
            "Rigid boxes stay.", 20),
        Law("heavy-on-light", "1,000 kg upon three of 1 kg", "how far it has moved", "m", 2.0, heavy_on_light,
            "Rigid boxes stay.", 8),
        Law("double-rod", "two linked rods", "both angles after 1 s", "rad", 1.0, double_rod,
            "Lagrange's equations.", 0),
        Law("dominoes", "a wave of dominoes", "relative error of its speed", "", 8.0, domino_speed,
            "van Leeuwen 2010, with friction; itself good to 3 %.", 120, 0.03),
        Law("card-house", "two cards that lean on each other", "steepest lean that stands", "deg", 7 * 0.75,
            card_house, "Moments about a card's foot, with friction at its limit.", 6, 0.0625),
    )
}  # fmt: skip
