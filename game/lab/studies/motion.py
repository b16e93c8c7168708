"""What accuracy costs for one motion whose end is known: a study in one call, for small scenes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from game.lab.ranges import counts_between
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import chosen_setting, computation
from game.naming import words_of
from game.physics.integrators import METHODS, ORDERS, integrate
from game.physics.oscillators import (
    bead_positions,
    bounce_height,
    fall,
    pendulum_angle,
    rod_pull,
    spring_pull,
)

FEWEST, MOST, POINTS = 20, 1_000, 10  # steps of a run
SHORTEST, LONGEST = 1.0 / 2_000.0, 0.1  # s, steps that a scene can be set to
INTEGRATORS = tuple(Method(name, words_of(name), ORDERS[name]) for name in METHODS)


class KnownMotion(NamedTuple):
    """A motion whose end is known: in words, its length (s), and where it ends exactly, in a unit."""

    words: str
    seconds: float
    end: float
    unit: str = "m"


def motion_study(
    name: str,
    title: str,
    run: Callable[[str, float, int], float],
    methods: Sequence[Method],
    motion: KnownMotion,
    *,
    reference: str,
    choice: str = "method",
    expectation: str = "",
) -> Study:
    """Error at the end of a motion against CPU time, for steps of many lengths.

    run(method, dt, steps): where the motion ends. choice: the parameter of the scene that names the method.
    The scene has a parameter "step_length". reference: where the exact end is from.
    """
    seconds = motion.seconds

    def settings() -> list[Setting]:
        return [
            Setting(
                method.name,
                seconds / steps,
                scene={choice: method.name, "step_length": min(max(seconds / steps, SHORTEST), LONGEST)},
                weight=float(steps),
            )
            for steps in counts_between(FEWEST, MOST, POINTS)
            for method in methods
        ]

    def trial(setting: Setting) -> Trial:
        steps = max(1, round(seconds / setting.knob))
        return computation(
            seconds,
            lambda: run(setting.method, seconds / steps, steps),
            lambda end: Outcome(abs(end - motion.end), steps),
        )

    return Study(
        name=name,
        title=title,
        error=f"distance from the exact place after {seconds:g} s",
        error_unit=motion.unit,
        counter="steps",
        knob=Knob("step_length", "step", "s"),
        methods=tuple(methods),
        settings=settings,
        trial=trial,
        reference=reference,
        expectation=expectation,
        present=chosen_setting(choice, "step_length"),
        workload=Workload(motion.words),
    )


def swing_study(name: str) -> Study:
    """The integrators on a pendulum of 1 m let go at 60 degrees."""

    def run(method: str, dt: float, steps: int) -> float:
        angle, _ = integrate(method, rod_pull(9.81), [math.pi / 3.0], [0.0], dt, steps)
        return float(angle[0])

    return motion_study(
        name, "A pendulum let go at 60 degrees", run, INTEGRATORS,
        KnownMotion(
            "a rod of 1 m let go at 60 degrees", 2.0, pendulum_angle(math.pi / 3.0, 9.81, 2.0), "rad"
        ),
        reference="Jacobi's elliptic functions.",
    )  # fmt: skip


def bounce_study(name: str) -> Study:
    """Two ways to find an impact, on a ball let go 1 m above the ground, with restitution 0.8."""

    def drop(impact: str, dt: float, steps: int) -> float:
        y, v = 1.0, 0.0
        for _ in range(steps):
            y, v = fall(y, v, 9.81, 0.8, impact == "root", dt)
        return y

    methods = (
        Method("step-end", "at the end of the step", 1.0),
        Method("root", "at the root", None, "exact"),
    )
    return motion_study(
        name, "A ball that bounces three times", drop, methods,
        KnownMotion("a fall of 1 m, restitution 0.8", 2.0, bounce_height(1.0, 0.8, 9.81, 2.0)),
        choice="impact", reference="parabolas between bounces.",
        expectation="Found at the end of a step, an impact costs an error of first order.",
    )  # fmt: skip


def chain_study(name: str) -> Study:
    """The integrators on a chain of 15 beads that is plucked in the middle."""
    start = 1.0 - np.abs(np.linspace(-1.0, 1.0, 17))[1:-1]

    def run(method: str, dt: float, steps: int) -> float:
        beads, _ = integrate(method, spring_pull(100.0), start, np.zeros(15), dt, steps)
        return float(beads[7])

    return motion_study(
        name, "A plucked chain: its middle bead", run, INTEGRATORS,
        KnownMotion(
            "15 beads plucked in the middle, k/m = 100/s²", 2.0, float(bead_positions(start, 10.0, 2.0)[7])
        ),
        reference="the sum of all modes.",
    )  # fmt: skip
