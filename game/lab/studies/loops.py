"""What accuracy costs for a ball in a loop: the least height from which it comes round."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.studies.qualities import quality_marks
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.kernels import elementwise
from game.physics.solids import TIERS
from game.physics.solids.tracks import DISC, Curve, TrackSettings, TrackWorld, motion

GRAVITY, LOOP, BALL, STEP = 9.81, 1.0, 0.1, 1.0 / 120.0
EXACT = 0.5 * (5.0 + DISC) * (LOOP - BALL)  # m, drop of the centre
HALVINGS, MOST_STEPS = 30, 240
HIGHEST = 3.0  # drops tried at most, in exact ones
SMOOTH, CORNERS = "smooth", "chords"
CHORDS = {SMOOTH: (20, 35, 50, 70, 100, 140, 200), CORNERS: (20, 50, 100, 200, 400, 800)}
SUBSTEPS, MARKED = 4, 100  # of most points; chords at which all qualities are measured
HOPS = {SMOOTH: 0, CORNERS: 6}  # steps in the air that a corner may take


def comes_round(method: str, chords: int, substeps: int, drop: float) -> bool:
    """Whether a disc that rolls into the loop, after that drop (m), passes its top."""
    turn = np.linspace(-0.5 * math.pi, 1.5 * math.pi, chords + 1)
    points = LOOP * np.stack([elementwise.cos(turn), 1.0 + elementwise.sin(turn)], axis=1)
    curve = Curve(points, corner=35.0 if method == SMOOTH else 0.0)
    world = TrackWorld([curve], TrackSettings(substeps))
    speed = math.sqrt(2.0 * GRAVITY * drop / (1.0 + DISC))
    ball = world.add_ball((1e-3, BALL), BALL, (speed, 0.0), -speed / BALL, friction=1e6)
    world.put_down(ball, 0.05)
    hops = 0
    for _ in range(MOST_STEPS):
        world.step(STEP)
        x, y = world.balls.rows[ball, [motion.X, motion.Y]].tolist()
        hops = hops + 1 if world.balls.pieces[ball, motion.PIECE] == motion.FREE else 0
        if hops > HOPS[method]:  # it flies for longer than a corner takes
            return False
        if x < -0.3 and 0.3 < y < 0.9:
            return True
    return False


class LoopTrial:
    """The limit by halving between two heights."""

    simulated_s = 1.0

    def __init__(self, setting: Setting):
        self.method, self.chords = setting.method, int(setting.knob)
        self.substeps = int(setting.others["substeps"])

    def reset(self) -> None:
        """Nothing is kept between runs."""

    def run(self) -> None:
        """All trials; the limit is infinite where it does not come round from the highest place."""
        low, high = 0.5 * EXACT, HIGHEST * EXACT
        if not self._passes(high):
            self.limit = math.inf
            return
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            if self._passes(middle):
                high = middle
            else:
                low = middle
        self.limit = high

    def _passes(self, drop: float) -> bool:
        return comes_round(self.method, self.chords, self.substeps, drop)

    def outcome(self) -> Outcome:
        """How far the limit is from the exact one."""
        failure = "" if self.limit < math.inf else f"not round from {HIGHEST * EXACT:.1f} m either"
        return Outcome(abs(self.limit - EXACT), HALVINGS * self.substeps, failure)


def _substeps(method: str, chords: int) -> tuple[int, ...]:
    qualities = tuple(TIERS.values()) if method == SMOOTH and chords == MARKED else ()
    return tuple(sorted({SUBSTEPS, *qualities}))


def _settings() -> list[Setting]:
    return [
        Setting(
            method,
            float(chords),
            {"substeps": float(n)},
            {"tier": "own", "substeps": n, "chords": chords},
            float(n * chords),
        )
        for method in (SMOOTH, CORNERS)
        for chords in CHORDS[method]
        for n in _substeps(method, chords)
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    chords = float(parameters["chords"]) or 100.0
    substeps = TIERS.get(str(parameters["tier"]), int(parameters["substeps"]))
    return Setting(SMOOTH, chords, {"substeps": float(substeps)})


loop_study = Study(
    name="loop",
    title="The least height for a loop",
    error="limit of the drop against (5 + k)/2 (R - r)",
    error_unit="m",
    counter="substeps",
    knob=Knob("chords", "chords", parts=True),
    methods=(Method(SMOOTH, "smooth curve", 2.0), Method(CORNERS, "chords with corners")),
    settings=_settings,
    trial=LoopTrial,
    reference="the energy at the top, where the track presses no more.",
    expectation="Each corner of chords is an impact that takes speed, so that none comes round. Through a "
    "smooth curve the limit is met to second order in the chords, whatever the substeps.",
    present=_present,
    workload=Workload("a disc of 0.1 m in a loop of 1 m, its limit found by halving"),
    mark=quality_marks(SMOOTH, float(MARKED)),
)
