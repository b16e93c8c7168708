"""What the studies of hits missed share: shots at a resting ball, and how many of them are not noticed."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from game.billiards.table.rack import BALL_RADIUS
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload

HIT_SPEED = 3.0  # m/s
HIT_SHOTS = 400


class HitShots:
    """Shots with impact parameters even over [0, 2 R], each begun anywhere in a step; error: share missed.

    dt: s. way: m, from before the contact to behind it. A subclass plays them in its `run`.
    """

    def __init__(self, dt: float, way: float) -> None:
        self.dt = dt
        self.steps = math.ceil(way / (HIT_SPEED * dt)) + 1
        self.simulated_s = HIT_SHOTS * self.steps * dt
        rng = np.random.default_rng(1)
        across = 2.0 * BALL_RADIUS * (np.arange(HIT_SHOTS) + rng.random(HIT_SHOTS)) / HIT_SHOTS
        starts = rng.random(HIT_SHOTS) * HIT_SPEED * dt
        # of the resting ball, m aside, and of the moving one, m on its way
        self.places: list[tuple[float, float]] = list(zip(across.tolist(), starts.tolist(), strict=True))
        self.missed = 0
        self.tests = 0

    def reset(self) -> None:
        self.missed = 0
        self.tests = 0

    def outcome(self) -> Outcome:
        share = self.missed / HIT_SHOTS
        return Outcome(share, self.tests, "misses every other hit" if share >= 0.5 else "")


def missed_hits_of(
    name: str,
    title: str,
    knob: Knob,
    methods: Sequence[tuple[str, str]],
    settings: Callable[[], Sequence[Setting]],
    trial: Callable[[Setting], Trial],
    present: Callable[[Mapping[str, Any]], Setting],
    expectation: str,
    **more: Any,
) -> Study:
    """A study of hits missed. methods: names and labels. more: further fields of the study."""
    return Study(
        name=name,
        title=f"{title}: hits missed at {HIT_SPEED:g} m/s",
        error="share of hits not noticed",
        error_unit="",
        counter="pair tests",
        knob=knob,
        methods=tuple(Method(key, label, 2.0) for key, label in methods),
        settings=settings,
        trial=trial,
        present=present,
        workload=Workload(f"{HIT_SHOTS} shots at a resting ball"),
        reference="P = 1 − b₀/(2 D) − D/(2 c) acos(b₀/D), where D = 2 R, c = v h, b₀² = D² − c².",
        expectation=expectation,
        short="Missed hits",
        **more,
    )
