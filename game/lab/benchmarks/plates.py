"""A thousand leaves in the air, and the same law in vectorised numpy."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from game.arrays import Floats
from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.fields import GRAVITY, QUADRATIC_DRAG
from game.physics.kernels import elementary, elementwise
from game.physics.plates import Plate, Plates, law
from game.physics.plates.effects import BENDING, CIRCULATION

DT = 1.0 / 600.0  # s: one substep each, as the numpy twin takes one; at 1/240 s half of them take two
INERTIAS = (0.4, 1.6)  # of the leaves, least and most


def leaves(count: int, bend_hz: float = 0.0) -> Plates:
    """Leaves of half a chord of 3 cm in still air, far above the ground."""
    random = np.random.default_rng(1)
    kinds = [Plate(0.03, float(i), bend_hz=bend_hz) for i in random.uniform(*INERTIAS, count)]
    places = np.stack(
        [random.uniform(low, high, count) for low, high in ((-5.0, 5.0), (50.0, 60.0), (-1.0, 1.0))],
        axis=1,
    )  # fmt: skip
    effects = GRAVITY | QUADRATIC_DRAG | CIRCULATION
    return Plates(kinds, places, effects=effects | BENDING if bend_hz else effects)


def numpy_rates(
    states: Floats, inertia: Floats | float, beta: Floats | float, gravity: float = 1.0, linear: float = 0.2
) -> Floats:
    """u_x', u_y', w' by the printed law with the default coefficients, of (angle, u_x, u_y, w) (4, n).

    Reduced units, body axes. gravity: in units of what the weight is.
    """
    theta, ux, uy, w = states
    speed = np.sqrt(ux * ux + uy * uy)
    per = 1.0 / np.maximum(speed, 1e-300)
    lift = 2.0 / math.pi * (math.pi * w - 1.2 * ux * uy * per)
    drag = (1.4 * speed - (ux * ux - uy * uy) * per) / math.pi
    along, across = inertia + beta * beta, inertia + 1.0
    about = (inertia * (1.0 + beta * beta) + 0.5 * elementary.square(1.0 - beta * beta)) / 4.0
    return np.stack([
        (across * w * uy - lift * uy - gravity * elementwise.sin(theta) - drag * ux) / along,
        (-along * w * ux + lift * ux - gravity * elementwise.cos(theta) - drag * uy) / across,
        (-(1.0 - beta * beta) * ux * uy - (linear + 0.2 * np.abs(w)) * w) / about,
    ])  # fmt: skip


class NumpyPlates:
    """Rigid plates with Runge-Kutta of fourth order on whole arrays, in reduced units."""

    def __init__(self, count: int):
        random = np.random.default_rng(1)
        self.inertia, self.beta = random.uniform(*INERTIAS, count), 1.0 / 14.0
        self.state = np.zeros((6, count))  # angle, u_x, u_y, w, x, y
        self.state[0] = 0.2

    def slopes(self, state: Floats) -> Floats:
        """Rates (6, n)."""
        c, s = elementwise.cos(state[0]), elementwise.sin(state[0])
        moves = numpy_rates(state[:4], self.inertia, self.beta)
        return np.stack(
            [state[3], *moves, c * state[1] - s * state[2], s * state[1] + c * state[2]]
        )  # fmt: skip

    def step(self, h: float) -> None:
        """One step."""
        one = self.slopes(self.state)
        two = self.slopes(self.state + 0.5 * h * one)
        three = self.slopes(self.state + 0.5 * h * two)
        four = self.slopes(self.state + h * three)
        self.state += h / 6.0 * (one + 2.0 * two + 2.0 * three + four)


def gap_after(steps: int, h: float) -> float:
    """The largest difference of the two in any state, reduced units, after so many steps h (a/U)."""
    twin = NumpyPlates(5)
    for _ in range(steps):
        twin.step(h)
    worst = 0.0
    for i, inertia in enumerate(twin.inertia.tolist()):
        plate = Plate(0.03, inertia, twin.beta)
        own = Plates([plate], [(0.0, 0.0, 0.2)], effects=GRAVITY | QUADRATIC_DRAG | CIRCULATION)
        for _ in range(steps):
            own.step(h * plate.time)
        row = own.rows[:, 0]
        c, s = elementary.cos(row[law.THETA]), elementary.sin(row[law.THETA])
        u = (
            (c * row[law.VX] + s * row[law.VY]) / plate.speed,
            (c * row[law.VY] - s * row[law.VX]) / plate.speed,
        )
        found = (row[law.THETA], *u, row[law.SPIN] * plate.time, row[law.X] / 0.03, row[law.Y] / 0.03)
        worst = max(worst, float(np.max(np.abs(np.array(found) - twin.state[:, i]))))
    return worst


def _kernel(count: int, bend_hz: float = 0.0) -> Call:
    return partial(leaves(count, bend_hz).step, DT)


SCENARIOS = (
    Scenario(
        "leaves-1000", "1,000 plates in still air, RK4", "step", partial(_kernel, 1000),
        peers=(Peer("numpy, same law", lambda: partial(NumpyPlates(1000).step, 0.08)),),
    ),
    Scenario("bent-leaves-1000", "1,000 leaves that bend, RK4", "step", partial(_kernel, 1000, 10.0)),
)  # fmt: skip
