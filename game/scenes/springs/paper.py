"""The paper on position based dynamics (P08): what a projection does, and what its stiffness means."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from game.lab.timing import least_time
from game.physics.constraints.effects import LINKS
from game.physics.constraints.shapes import cloth, rope
from game.physics.constraints.system import PositionBasedDynamics
from game.physics.fields import GRAVITY
from game.scenes.shared.marks import dot
from game.scenes.springs.figure import draw_projection, draw_sweeps
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

LENGTH, LINK_COUNT = 2.0, 20  # m, of the rope that is drawn and measured
DT = 1.0 / 60.0


def _hanging(iterations: int, seconds: float) -> PositionBasedDynamics:
    """A rope that hangs from its first particle and was let go level, after some time."""
    shape = rope((0.0, 0.0), (LENGTH, 0.0), LINK_COUNT)
    system = PositionBasedDynamics(
        shape.positions, shape.inverse_masses, shape.links, effects=GRAVITY | LINKS, iterations=iterations
    )
    for _ in range(round(seconds / DT)):
        system.step(DT)
    return system


def _stepped() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Places (n, 2) of a falling rope before a step, predicted by free flight, and after the step."""
    shape = rope((0.0, 0.0), (LENGTH, 0.0), 8)
    systems = [
        PositionBasedDynamics(
            shape.positions, shape.inverse_masses, shape.links, effects=chosen, iterations=20
        )
        for chosen in (GRAVITY | LINKS, GRAVITY)
    ]
    held, free = systems
    for _ in range(30):
        held.step(DT)
    before = held.positions.copy()
    free.restore(held.state())
    for _ in range(3):  # steps of a sixtieth are too short for the eye
        free.step(DT)
        held.step(DT)
    return before, free.positions.copy(), held.positions.copy()


def _drawn(places: np.ndarray) -> list[tuple[float, float]]:
    return [(34.0 + 112.0 * x, 16.0 - 104.0 * y) for x, y in places.tolist()]


def _draw_prediction(pen: Pen) -> None:
    """Places before a step, and where free flight would lead them: the links there are too long."""
    before, free, _ = (_drawn(places) for places in _stepped())
    pen.line(before, "text3", 1.6)
    pen.line(free, "vermilion", 1.2, dash=4.0)
    for a, b in zip(before, free, strict=True):
        if math.dist(a, b) > 5.0:
            pen.arrow(a, b, "amber", 1.4)
        dot(pen, a, "text2", 3.0)
    pen.formula(r"\v{p}", free[-1][0] + 14.0, free[-1][1] - 4.0, "vermilion")
    pen.formula(r"\v{x}", before[-1][0] + 14.0, before[-1][1], "text2")


def _draw_velocities(pen: Pen) -> None:
    """The same step with its links: what was moved is the velocity."""
    before, _, after = (_drawn(places) for places in _stepped())
    pen.line(before, "text3", 1.6)
    pen.line(after, "chalk", 1.8)
    for a, b in zip(before, after, strict=True):
        if math.dist(a, b) > 5.0:
            pen.arrow(a, b, "green", 1.4)
        dot(pen, b, "chalk", 3.0)
    pen.formula(r"h \v{v}", after[-1][0] + 20.0, 0.5 * (after[-1][1] + before[-1][1]), "green")


def _draw_ropes(pen: Pen) -> None:
    """The rope after 0.4 s with one sweep a step, with four, with twenty."""
    for iterations, color, row in ((1, "vermilion", 0), (4, "chalk", 1), (20, "green", 2)):
        places = _hanging(iterations, 0.4).positions
        points = [(30.0 + 110.0 * x, 26.0 - 62.0 * y) for x, y in places.tolist()]
        pen.line(points, color, 1.8)
        pen.words(f"{iterations} sweep{'s' * (iterations > 1)}", 286.0, 150.0 + 17.0 * row, color, "right")
    dot(pen, (30.0, 26.0), "text1", 4.0)


def _measure() -> Iterator[Comparison]:
    counts = (1, 5, 20, 100)
    stretches = [_hanging(count, 2.0).measure().length_ratio - 1.0 for count in counts]
    yield Comparison(
        f"rope of {LINK_COUNT} links, k = 1: longer by, at {', '.join(map(str, counts))} sweeps a step",
        "less with more sweeps",
        ", ".join(f"{100.0 * stretch:.2f}" for stretch in stretches) + " %",
    )
    left = []
    for sweeps in (1, 4, 16):
        part = 1.0 - (1.0 - 0.5) ** (1.0 / sweeps)
        pair = PositionBasedDynamics(
            [(0.0, 0.0), (2.0, 0.0)], 1.0, [(0, 1)], part, rest_lengths=1.0, effects=LINKS, iterations=sweeps
        )
        pair.step(DT)
        left.append(float(np.hypot(*(pair.positions[1] - pair.positions[0]))) - 1.0)
    yield Comparison(
        "one link, k = 0.5 as k': error left after 1, 4, 16 sweeps",
        "50 %, however many",
        ", ".join(f"{100.0 * gap:.2f}" for gap in left) + " %",
    )
    rng = np.random.default_rng(8)
    shape = rope((0.0, 0.0), (LENGTH, 0.0), LINK_COUNT, pins="none")
    speeds = 50.0 * rng.standard_normal(shape.positions.shape)
    free = PositionBasedDynamics(
        shape.positions, shape.inverse_masses, shape.links, velocities=speeds, effects=LINKS, iterations=10
    )
    before = np.array(free.momentum()[:2])
    energies = []
    for _ in range(600):
        free.step(DT)
        energies.append(float(np.sum(free.velocities**2)))
    lost = float(np.hypot(*(np.array(free.momentum()[:2]) - before))) / float(np.sum(np.abs(speeds)))
    yield Comparison("a free rope, 10 s: linear momentum lost", "0", f"{lost:.1e}")
    worst = max(energies) / float(np.sum(speeds**2))
    yield Comparison(
        "the same, started at 50 m/s: most kinetic energy, to the first", "stable", f"{worst:.2f}"
    )
    sheet = cloth((0.0, 0.0), 64, 64, 0.02)
    net = PositionBasedDynamics(
        sheet.positions, sheet.inverse_masses, sheet.links, effects=GRAVITY | LINKS, iterations=10
    )
    cost = least_time(lambda: net.step(DT)) / (10 * len(sheet.links))
    yield Comparison(f"one projection, cloth of {len(sheet.links)} links", "", f"{1e9 * cost:.1f} ns")


PBD = Paper(
    problem=(
        "Forces of stiff springs must be integrated with tiny steps or by solving large systems, and "
        "explicit methods explode when the step is too long. For games one wants a method that never "
        "explodes and lets one put a thing exactly where it should be.",
    ),
    idea=(
        "Work on positions. Let every particle fly freely for a step, then move the positions, one "
        "constraint after the other, so that each holds. The new velocity is the displacement, divided by "
        "the step. Since nothing is extrapolated from a force, there is nothing that could overshoot "
        "without bound.",
    ),
    steps=(
        Step(
            "Predict: positions after a step of free flight.",
            _draw_prediction,
            r"\v{p} = \v{x} + h (\v{v} + h \v{g})",
        ),
        Step(
            "Project a constraint: along its gradient, by as much as it is off, the lighter particle "
            "farther.",
            draw_projection,
            r"\Delta\v{p}_a = -\frac{w_a}{w_a + w_b} (|\v{p}_{ab}| - L) \v{n}",
        ),
        Step(
            "Sweep over all constraints, again and again, each from where the last one left it.", _draw_ropes
        ),
        Step(
            "Soft ones are moved by a part only. So that the number of sweeps does not change what it "
            "means, k' takes the place of k.",
            draw_sweeps,
            r"k' = 1 - (1-k)^{1/n}",
        ),
        Step("The velocity is what was moved.", _draw_velocities, r"\v{v} = (\v{p} - \v{x}) / h"),
    ),
    showed=(
        "Cloth and inflatable bodies at interactive rates. Collisions are constraints that are made and "
        "forgotten in each step. The user fixes and drags points, and no step length makes it explode.",
    ),
    measure=_measure,
    limits=(
        "Stiffness depends on the step and on the number of sweeps: with few of them all ropes are "
        "rubber. k' keeps its meaning only for a link by itself. Energy is lost, more with a longer step.",
    ),
    after=(
        "XPBD (Macklin, Müller, Chentanez 2016) gives the stiffness a unit; small steps (Macklin and "
        "others 2019) trade sweeps for substeps; both can be chosen in C15. Long range attachments (Kim, "
        "Chentanez, Müller 2012) keep ropes from stretching.",
    ),
)
