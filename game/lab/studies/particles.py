"""What accuracy costs for a particle: integrators, and three ways to handle an impact.

A shot with linear drag, free and against a stone, against its closed form. Free, each method shows its order.
With an impact handled at the end of a step all are of first order, even Runge-Kutta 4. With the chord's
crossing all are of second order, with the root of the step of their own.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np

from game.lab.ranges import counts_between
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.fields import DRAG, GRAVITY
from game.physics.kernels import elementary
from game.physics.particles import CALM, CONTACTS, EVALUATIONS, METHODS, OBSTACLES, ORDERS, PARTICLES, Discs
from game.physics.particles.contacts import Rules
from game.physics.particles.shot import shoot

GRAVITY_G, DRAG_K = 9.81, 0.7  # m/s², 1/s
START = (0.0, 0.0, 3.0, 8.0)  # m, m/s
STONE, RADIUS, RESTITUTION = (2.0, 1.2), 0.5, 0.5  # m
FREE_TIME, BOUNCE_TIME = 1.0, 1.6  # s
FEWEST = 8  # steps: with fewer, a bounce would be shorter than four steps and so not be made
COPIES = 16  # of the shot in one run, so that beginning a run costs next to nothing
LABELS = {
    "explicit-euler": "explicit Euler",
    "semi-implicit-euler": "semi-implicit Euler",
    "midpoint": "midpoint",
    "verlet": "Verlet",
    "stormer-verlet": "Störmer-Verlet",
    "rk4": "Runge-Kutta 4",
    "exponential": "exponential",
}
CONTACT_LABELS = {"end": "step end", "chord": "chord", "root": "root"}
SHOWN = (
    ("explicit-euler", "end", 1),
    ("verlet", "end", 1),
    ("rk4", "end", 1),
    ("verlet", "chord", 2),
    ("rk4", "chord", 2),
    ("verlet", "root", 2),
    ("rk4", "root", 4),
)


def exact_flight(state: Sequence[float], t: float) -> np.ndarray:
    """State (4,) after t (s) of gravity and linear drag: the closed form."""
    x, y, vx, vy = state
    reach, fall = -elementary.expm1(-DRAG_K * t) / DRAG_K, GRAVITY_G / DRAG_K
    decay = elementary.exp(-DRAG_K * t)
    return np.array(
        [x + vx * reach, y + (vy + fall) * reach - fall * t, vx * decay, (vy + fall) * decay - fall]
    )


@cache
def exact_bounce() -> tuple[float, ...]:
    """State at BOUNCE_TIME: exact flight to the root of the distance, impact, exact flight."""

    def gap(t: float) -> float:
        x, y, _, _ = exact_flight(START, t)
        return elementary.dist((x, y), STONE) - RADIUS

    low, high = 0.9, 1.2  # s: it falls on the stone from above between these
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        low, high = (middle, high) if gap(middle) > 0.0 else (low, middle)
    x, y, vx, vy = exact_flight(START, low)
    nx, ny = (x - STONE[0]) / RADIUS, (y - STONE[1]) / RADIUS
    change = -(1.0 + RESTITUTION) * (vx * nx + vy * ny)
    after = (x, y, vx + change * nx, vy + change * ny)
    return tuple(exact_flight(after, BOUNCE_TIME - low).tolist())


class Shot:
    """The shot in so many steps; error: distance from the exact place at the end."""

    def __init__(self, method: str, contact: str, steps: int, bounce: bool) -> None:
        self.until = BOUNCE_TIME if bounce else FREE_TIME
        self.simulated_s = COPIES * self.until
        self.bounce = bounce
        mask = PARTICLES.mask(GRAVITY | DRAG | OBSTACLES if bounce else GRAVITY | DRAG)
        dt = self.until / steps
        self.rules = Rules(CONTACTS.index(contact), METHODS.index(method), mask, 0.0, RESTITUTION, dt)
        self.law = CALM._replace(gravity=GRAVITY_G, drag=DRAG_K)
        self.solids = Discs([STONE], [RADIUS], RESTITUTION)
        self.steps = steps
        self.end = np.array(exact_bounce()) if bounce else exact_flight(START, FREE_TIME)
        self.states = np.tile(START, (COPIES, 1))

    def reset(self) -> None:
        self.states[:] = START

    def run(self) -> None:
        self.impacts = shoot(
            self.rules, self.law, self.solids.rows, self.states, self.steps, self.solids.impulses
        )

    def outcome(self) -> Outcome:
        off = self.states[0, :2] - self.end[:2]
        failure = ""
        if not np.all(np.isfinite(self.states)):
            failure = "diverged"
        elif self.bounce and self.impacts != COPIES:
            failure = "passes the stone" if self.impacts == 0 else "stays at the stone"
        counter = self.steps * EVALUATIONS[self.rules.method]
        return Outcome(math.sqrt(float(off @ off)), counter, failure)


def _steps(most: int, number: int) -> list[int]:
    """Counts of steps spread evenly in the logarithm; every sixth first, so the whole soon shows."""
    counts = counts_between(FEWEST, most, number)
    return counts[::6] + [count for i, count in enumerate(counts) if i % 6]


def _scene(method: str, contact: str, dt: float) -> dict[str, Any]:
    return {"method": method, "contact": contact, "step_length": min(max(dt, 1.0 / 2000.0), 0.5)}


def bounce_settings() -> list[Setting]:
    """All combinations of SHOWN, at 8 to 4000 steps."""
    return [
        Setting(
            f"{method}/{contact}", BOUNCE_TIME / n, {}, _scene(method, contact, BOUNCE_TIME / n), 50.0 + n
        )
        for n in _steps(4000, 48)
        for method, contact, _ in SHOWN
    ]


def free_settings() -> list[Setting]:
    """All integrators without a stone, at 8 to 6000 steps."""
    return [
        Setting(
            method, FREE_TIME / n, {}, {"method": method, "step_length": max(FREE_TIME / n, 0.0005)}, 50.0 + n
        )
        for n in _steps(6000, 24)
        for method in METHODS
    ]


def bounce_trial(setting: Setting) -> Shot:
    """The shot against the stone of a setting."""
    method, contact = setting.method.split("/")
    return Shot(method, contact, max(1, round(BOUNCE_TIME / setting.knob)), True)


def free_trial(setting: Setting) -> Shot:
    """The free shot of a setting."""
    return Shot(setting.method, "end", max(1, round(FREE_TIME / setting.knob)), False)


def present_bounce(parameters: Mapping[str, Any]) -> Setting:
    """Where the fountain with these parameters stands."""
    return Setting(f"{parameters['method']}/{parameters['contact']}", float(parameters["step_length"]))


def present_free(parameters: Mapping[str, Any]) -> Setting:
    """The same without regard to impacts."""
    return Setting(str(parameters["method"]), float(parameters["step_length"]))


free_flight_study = Study(
    name="c04-free",
    title="Particle fountain: free flight",
    short="Free flight",
    error="distance from the exact place after 1 s",
    error_unit="m",
    counter="evaluations of the force",
    knob=Knob("step_length", "step", "s"),
    methods=tuple(
        Method(name, LABELS[name], None if name == "exponential" else float(order))
        for name, order in zip(METHODS, ORDERS, strict=True)
    ),
    settings=free_settings,
    trial=free_trial,
    reference="closed form of the flight with linear drag.",
    expectation="Orders 1, 1, 2, 2, 2 and 4; the exponential method is exact here.",
    order_over="counter",
    present=present_free,
    workload=Workload("one particle in free flight"),
)

bounce_study = Study(
    name="c04",
    title="Particle fountain: one bounce off the stone",
    short="Bounce",
    error="distance from the exact place after 1.6 s",
    error_unit="m",
    counter="evaluations of the force",
    knob=Knob("step_length", "step", "s"),
    methods=tuple(
        Method(f"{name}/{contact}", f"{LABELS[name]}, {CONTACT_LABELS[contact]}", float(order))
        for name, contact, order in SHOWN
    ),
    settings=bounce_settings,
    trial=bounce_trial,
    reference="closed form of the flight, root of its distance from the stone, Newton's law.",
    expectation=(
        "Handled at the end of the step an impact makes every method one of first order. The chord "
        "restores the second, the root the full order."
    ),
    order_over="counter",
    envelope=True,
    floor=1e-12,
    ceiling=0.2 * RADIUS,
    present=present_bounce,
    workload=Workload("one particle and one stone"),
    related=(free_flight_study,),
)
