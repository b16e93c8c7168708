"""The paper on stacking (P05): order of integration, contact and shock propagation."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from game.lab.timing import least_time
from game.physics.solids import SUGGESTED, Material, Polygon, SolidSettings, SolidWorld, box
from game.scenes.shared.marks import dot, outline
from game.scenes.solids.measures import contact_points
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

DT, G = 1.0 / 60.0, 9.81
SLOPE, FRICTION = 30.0, 0.3  # degrees, of the incline that is measured
RATES = (60, 600)  # steps a second, at which it slides
HALF_AN_L = (
    ((0.0, 0.0), (1.2, 0.0), (1.2, 0.4), (0.0, 0.4)),
    ((0.0, 0.4), (0.4, 0.4), (0.4, 1.2), (0.0, 1.2)),
)


def _world(degrees: float = 0.0, friction: float = 0.5, solver: str = "shock-propagation") -> SolidWorld:
    """A floor, tilted by turning gravity, in a world of that solver."""
    turn = math.radians(degrees)
    suggested: dict[str, Any] = SUGGESTED.get(solver, {})
    gravity = (G * math.sin(turn), -G * math.cos(turn))
    world = SolidWorld(SolidSettings(solver=solver, gravity=gravity, **suggested))
    world.add_body(box(400.0, 1.0, material=Material(friction=friction)), (0.0, -0.5), kind="fixed")
    return world


def _step(world: SolidWorld, steps: int, dt: float = DT) -> None:
    """So many steps, of ``dt`` s each."""
    for _ in range(steps):
        world.step(dt)


def slid(steps: int) -> float:
    """Share by which a block is off g t² (sin α − μ cos α) / 2 after one second of so many steps."""
    world = _world(SLOPE, FRICTION)
    body = world.add_body(box(1.0, 1.0, material=Material(friction=FRICTION)), (0.0, 0.5))
    _step(world, steps, 1.0 / steps)
    turn = math.radians(SLOPE)
    exact = 0.5 * G * (math.sin(turn) - FRICTION * math.cos(turn))
    return float(world.bodies.positions[body, 0]) / exact - 1.0


def _stack(count: int, seconds: float, solver: str = "shock-propagation") -> tuple[SolidWorld, list[int]]:
    """Unit boxes on top of each other, after some time."""
    world = _world(solver=solver)
    ids = [world.add_body(box(1.0, 1.0), (0.0, 0.5 + k)) for k in range(count)]
    _step(world, round(seconds / DT))
    return world, ids


def _draw_order(pen: Pen) -> None:
    """A step as three boxes in a row: collisions, velocities, contacts; then places."""
    for k, (words, color) in enumerate(
        (("collisions", "amber"), ("forces", "chalk"), ("contacts", "green"), ("places", "text1"))
    ):
        y = 30.0 + 46.0 * k
        pen.box(84.0, y, 128.0, 30.0, pen.veiled(color, 0.75))
        pen.box(84.0, y, 128.0, 30.0, color, ring=1.4)
        pen.words(words, 148.0, y + 15.0, "text1")
        if k:
            pen.arrow((148.0, y - 16.0), (148.0, y - 1.0), "text2", 1.4)
    for y, words in ((45.0, "e"), (137.0, "0")):
        pen.formula(words, 236.0, y, "text2")


def _draw_cone(pen: Pen) -> None:
    """Boxes on slopes from 0 to 45 degrees: friction beside the push of the ground, as shares of weight.

    Up to the slope of the cone they hold; steeper ones slide, on the cone itself.
    """
    friction = 0.5
    pen.line(((40.0, 16.0), (40.0, 176.0), (284.0, 176.0)), "text3", 1.0)
    pen.line(((40.0, 176.0), (40.0 + 220.0, 176.0 - 220.0 * friction)), "text2", 1.2, dash=4.0)
    for degrees in range(0, 46, 5):
        world = _world(float(degrees), friction)
        body = world.add_body(box(1.0, 1.0, material=Material(friction=friction)), (0.0, 0.5))
        _step(world, 30)
        found, weight = contact_points(world), G * DT / float(world.bodies.inverse_masses[body])
        push, rub = (float(np.abs(part).sum()) / weight for part in (found.pushes, found.rubs))
        slides = float(world.bodies.velocities[body, 0]) > 1e-3
        dot(pen, (40.0 + 220.0 * push, 176.0 - 220.0 * rub), "amber" if slides else "green", 4.5)
    pen.words("holds", 48.0, 24.0, "green", "left")
    pen.words("slides", 48.0, 41.0, "amber", "left")
    pen.formula(r"\mu j_n", 226.0, 70.0, "text2")
    pen.formula("j_n", 272.0, 192.0, "text2")
    pen.formula("j_t", 22.0, 24.0, "text2")


def _draw_levels(pen: Pen) -> None:
    """A small pile as the solver leaves it, its bodies numbered by contacts from the ground."""
    world = _world()
    places = [(-1.05, 0.5), (0.0, 0.5), (1.05, 0.5), (-0.55, 1.5), (0.55, 1.5), (0.0, 2.5)]
    ids = [world.add_body(box(1.0, 1.0), place) for place in places]
    _step(world, 30)
    levels = (1, 1, 1, 2, 2, 3)
    pen.box(20.0, 176.0, 256.0, 16.0, "body")
    for body, level in zip(ids, levels, strict=True):
        x, y = world.bodies.positions[body].tolist()
        angle = float(world.bodies.angles[body])
        corners = [
            (148.0 + 50.0 * (x + u * math.cos(angle) - v * math.sin(angle)),
             176.0 - 50.0 * (y + u * math.sin(angle) + v * math.cos(angle)))
            for u, v in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
        ]  # fmt: skip
        outline(pen, corners, "chalk")
        pen.words(str(level), 148.0 + 50.0 * x, 176.0 - 50.0 * y, "amber", size=15, weight="semibold")
    pen.words("0", 262.0, 168.0, "amber", size=15, weight="semibold")


def _draw_towers(pen: Pen) -> None:
    """Ten boxes after two seconds with the sweeps of contacts alone, and with shock propagation."""
    for middle, solver, words in (
        (86.0, "sequential-impulses", "sequential impulses"),
        (210.0, "shock-propagation", "shock propagation"),
    ):  # fmt: skip
        world, ids = _stack(10, 2.0, solver)
        pen.box(middle - 50.0, 184.0, 100.0, 8.0, "body")
        for body in ids:
            x, y = world.bodies.positions[body].tolist()
            pen.box(middle + 16.0 * (x - 0.5), 184.0 - 16.0 * (y + 0.5), 15.0, 15.0, "chalk", ring=1.3)
        top = float(world.bodies.positions[ids[-1], 1])
        pen.words(words, middle, 10.0, "text2", size=11)
        pen.words(f"{1e3 * (9.5 - top):.1f} mm lower", middle, 200.0, "amber", size=11)


def _measure() -> Iterator[Comparison]:
    yield Comparison(
        f"a block slides down {SLOPE:.0f}°: off g t² (sin α − μ cos α) / 2 after 1 s, at "
        f"{' and '.join(map(str, RATES))} steps a second",
        "indistinguishable",
        ", ".join(f"{100.0 * slid(rate):+.2f} %" for rate in RATES),
    )
    world = _world(20.0, 0.4)
    body = world.add_body(box(1.0, 1.0, material=Material(friction=0.4)), (0.0, 0.5))
    _step(world, 120)
    crept = float(world.bodies.positions[body, 0])
    yield Comparison("it stands at 20°, friction 0.4: creeps in 2 s", "0", f"{1e3 * crept:.2f} mm")
    world, ids = _stack(40, 1.0)
    sunk = 39.5 - float(world.bodies.positions[ids[-1], 1])
    yield Comparison("forty boxes on each other, 1 s: the top sinks", "stands", f"{1e3 * sunk:.1f} mm")
    world, ids = _stack(10, 1.0, "sequential-impulses")
    other = 9.5 - float(world.bodies.positions[ids[-1], 1])
    world, ids = _stack(10, 1.0)
    own = 9.5 - float(world.bodies.positions[ids[-1], 1])
    yield Comparison(
        "ten boxes: shock propagation, sequential impulses", "", f"{1e3 * own:.2f}, {1e3 * other:.2f} mm"
    )
    yield Comparison(
        "five boxes: the lowest contact is said to bear, in weights, with each of the two", "",
        f"{_borne('shock-propagation'):.2f}, {_borne('sequential-impulses'):.2f} of 5",
    )  # fmt: skip
    yield Comparison(
        "1,000 bodies of two parts each, coming to rest: a step of 1/60 s", "", f"{_cost_of_ls(1_000):.1f} ms"
    )


def _borne(solver: str) -> float:
    """Push of the lowest contact of five boxes as multiples of the uppermost, which bears one weight."""
    world, _ = _stack(5, 1.0, solver)
    found = contact_points(world)
    low, high = found.places[:, 1] < 0.5, found.places[:, 1] > 3.5
    return float(found.pushes[low].sum() / found.pushes[high].sum())


def _cost_of_ls(count: int) -> float:
    """Mean CPU of a frame (ms) with many L-shaped bodies that fall into a heap."""
    world = _world()
    rng = np.random.default_rng(5)
    for k in range(count):
        shapes = tuple(Polygon(part) for part in HALF_AN_L)
        place = (1.6 * (k % 50) - 40.0, 1.2 + 1.3 * (k // 50))
        world.add_body(shapes, place, float(rng.uniform(0.0, 6.0)))
    _step(world, 60)
    return 1e3 * least_time(lambda: _step(world, 20), 1) / 20.0


STACKING = Paper(
    problem=(
        "Rigid bodies that lie on each other are hard for impulse methods: a block on a slope that should "
        "stand hops and creeps. In a stack every box adds its weight to those below, so that sweeps over "
        "the contacts never come to an end.",
    ),
    idea=(
        "Change the order within a step, so that bouncing and resting are told apart without thresholds. "
        "And go through a stack from the ground upwards once, as if what has been dealt with could not "
        "move any more: the weight of all is taken in a single pass.",
    ),
    steps=(
        Step(
            "Collisions first, by the velocities from before, with restitution; then the forces; then "
            "contacts, without restitution; places last. What rests has no speed of falling when "
            "collisions are looked for, so it does not bounce.",
            _draw_order,
        ),
        Step(
            "In a contact the impulse along the normal stops the approach, and friction acts within its "
            "cone.",
            _draw_cone,
            r"\abs{j_t} \le \mu j_n",
        ),
        Step(
            "Count for each body how many contacts away from the ground it stands.",
            _draw_levels,
        ),
        Step(
            "Level after level from below is swept once more, each with the level below taken as fixed. "
            "Then what still overlaps is pushed apart in the same order.",
            _draw_towers,
        ),
    ),
    showed=(
        "Stacks and heaps of up to a thousand non-convex bodies, rings and bones and the like. A domino "
        "rally, and a block on a slope that agrees with the theory. The weak side of shock propagation is "
        "a seesaw, which needs its sweeps of contacts without it.",
    ),
    measure=_measure,
    limits=(
        "Weight is hidden from what stands below, so a plank or a seesaw that should tip by what stands on "
        "it is held too well. Ours finds contacts between convex parts and not by distance fields. It "
        "counts friction over all of a substep, where the paper bounds that of each sweep: so a block "
        "creeps a tenth of a millimetre, and not twenty millimetres.",
    ),
    after=(
        "Warm started impulses (Catto 2005) and many small steps (Macklin and others 2019) hold stacks "
        "without a hidden weight. Shock propagation lives on as a last pass in position based methods "
        "(Macklin and others 2014). Both stand beside it in the solver race.",
    ),
)
