"""What accuracy costs for a body that turns freely: ten integrators against Jacobi's elliptic functions.

Moments 1, 2, 3 kg m². Spin: how far off it is after 10 s, from (1, 1/2, 2) rad/s, well away from the
separatrix, beside which coarse runs show no order. Energy: the most that it is off within 100 s, near the
middle axis. The exponential map alone does not raise the order; a splitting has no drift.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from game.lab.ranges import counts_between
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.rigid import METHODS, ROTATION, FreeTop, RigidBody

MOMENTS = (1.0, 2.0, 3.0)
GENERIC, FLIPPING = (1.0, 0.5, 2.0), (0.2, 3.0, 0.4)  # rad/s
SPIN_S, ENERGY_S = 10.0, 100.0
LOOKS = 100  # how often the energy is looked at
ABSURD = 100.0  # rad/s or shares of the energy beyond which a run counts as diverged
EVALUATIONS = dict(zip(METHODS, (1, 1, 1, 2, 4, 1, 1, 1, 1, 1), strict=True))  # of the spin, in a step
OF_SPIN: dict[str, float | None] = {  # order expected
    "explicit-euler": 1.0, "exponential-map": 1.0, "implicit-gyroscopic": 1.0, "midpoint": 2.0,
    "splitting": 2.0, "rk4": 4.0, "exact": None,
}  # fmt: skip
OF_ENERGY: dict[str, float | None] = {
    "explicit-euler": None, "body-euler": None, "implicit-gyroscopic": None, "midpoint": None,
    "splitting": 2.0, "rk4": 5.0, "exact": None,
}  # fmt: skip


class Run:
    """A free body that is stepped for so long from the same start."""

    def __init__(self, method: str, spin: tuple[float, ...], dt: float, seconds: float, looks: int) -> None:
        self.body = RigidBody(1.0, MOMENTS, angular_velocity=spin, method=method, effects=ROTATION)
        self.start = self.body.state.copy()
        self.first = self.energy
        self.dt, self.steps = dt, max(1, round(seconds / dt))
        self.looks = np.diff(np.linspace(0, self.steps, min(looks, self.steps) + 1).astype(int)).tolist()
        self.simulated_s = dt * self.steps
        self.evaluations = EVALUATIONS[method] * self.steps

    @property
    def energy(self) -> float:
        return self.body.kinetic_energy[1]

    def reset(self) -> None:
        self.body.state[:] = self.start

    def run(self) -> None:
        """Nothing but steps, so that nothing else is timed."""
        self.body.step(self.dt, self.steps)

    def outcome(self) -> Outcome:
        error = self.error()
        sane = math.isfinite(error) and error < ABSURD
        return Outcome(error, self.evaluations, "" if sane else "diverged")

    def error(self) -> float:
        """Share of the energy that is off at most, looked at along the same steps made once more."""
        worst = 0.0
        self.reset()
        for count in self.looks:
            self.body.step(self.dt, count)
            worst = max(worst, abs(self.energy / self.first - 1.0))
        return worst if np.isfinite(self.body.state).all() else math.inf


class SpinRun(Run):
    """The same, and how far the spin is off at the end, as a share of that at first."""

    def error(self) -> float:
        """Share of the first spin by which the last one is off."""
        exact = FreeTop(MOMENTS, GENERIC).spin(self.simulated_s)
        off = (self.body.spin - exact) / math.sqrt(sum(w * w for w in GENERIC))
        return math.sqrt(float(off @ off)) if np.isfinite(off).all() else math.inf


def spin_trial(setting: Setting) -> Run:
    """Ten seconds, one look at the end."""
    return SpinRun(setting.method, GENERIC, setting.knob, SPIN_S, 1)


def energy_trial(setting: Setting) -> Run:
    """A hundred seconds."""
    return Run(setting.method, FLIPPING, setting.knob, ENERGY_S, LOOKS)


def settings_for(
    names: Iterable[str], seconds: float, fewest: int, most: int, number: int
) -> Callable[[], list[Setting]]:
    """These methods at step lengths that divide the time, spread evenly in the logarithm."""

    def settings() -> list[Setting]:
        return [
            Setting(
                name,
                seconds / n,
                {},
                {"method": name, "step_length": min(max(seconds / n, 5e-4), 0.1)},
                1.0 + n,
            )
            for n in counts_between(fewest, most, number)
            for name in names
        ]

    return settings


def present_in(seconds: float) -> Callable[[Mapping[str, Any]], Setting]:
    """Where a scene with some parameters stands in a study of so many seconds."""

    def present(parameters: Mapping[str, Any]) -> Setting:
        n = max(1, round(seconds / float(parameters["step_length"])))
        method = str(parameters["method"])
        return Setting(method, seconds / n, {}, {"method": method})

    return present


def methods(orders: Mapping[str, float | None]) -> tuple[Method, ...]:
    """Rows of a study with the orders expected in it."""
    labels = {
        "explicit-euler": ("explicit Euler", "as the course has it"),
        "exponential-map": ("exponential map", "the whole angle, but the same spin"),
        "body-euler": ("Euler of ω, body frame", "gains energy without bound"),
        "implicit-gyroscopic": ("implicit gyroscopic", "loses energy and angular momentum"),
        "midpoint": ("midpoint", ""),
        "splitting": ("splitting", "costs little more than Euler, and does not drift"),
        "rk4": ("Runge-Kutta 4", ""),
        "exact": ("exact", "Jacobi's solution as the step: rounding only"),
    }
    return tuple(Method(name, labels[name][0], orders[name], labels[name][1]) for name in orders)


energy_study = Study(
    name="c12-energy",
    title="Rigid body: energy of a hammer that flips",
    error="most that the energy is off in 100 s, as a share",
    error_unit="",
    counter="evaluations of the spin",
    knob=Knob("step_length", "time step", "s"),
    methods=methods(OF_ENERGY),
    settings=settings_for(OF_ENERGY, ENERGY_S, 1_000, 64_000, 9),
    trial=energy_trial,
    reference="the energy at first, which a free body keeps.",
    expectation=(
        "Explicit Euler ends at its bound, |L|²/(2 I₁) less the energy at first: 102 %. "
        "The splitting's error swings and does not grow; that of all others grows with time."
    ),
    floor=1e-11,
    present=present_in(ENERGY_S),
    workload=Workload("a hammer that flips"),
    short="Energy",
)

rotation_study = Study(
    name="c12",
    title="Rigid body: spin of a free body",
    error="spin off after 10 s, as a share",
    error_unit="",
    counter="evaluations of the spin",
    knob=Knob("step_length", "time step", "s"),
    methods=methods(OF_SPIN),
    settings=settings_for(OF_SPIN, SPIN_S, 100, 102_400, 15),
    trial=spin_trial,
    reference="Jacobi's elliptic functions.",
    expectation=(
        "Orders 1, 2, 4. The exponential map is of order 1 like plain Euler, as its spin is still the old "
        "one. The splitting costs little more than Euler and is of order 2."
    ),
    floor=1e-11,
    present=present_in(SPIN_S),
    workload=Workload("one free body"),
    short="Spin",
    related=(energy_study,),
)
