"""What accuracy costs for balls on tracks: an incline, the quickest way down, and a loop, by the substep."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from game.lab.studies.qualities import quality_marks
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.dominoes import STANDARD_GRAVITY
from game.physics.kernels import elementary, elementwise
from game.physics.solids import TIERS
from game.physics.solids.tracks import DISC, Curve, TrackSettings, TrackWorld, motion, moved_aside
from game.physics.solids.tracks.descent import (
    crossing_share,
    cycloid_time,
    loop_drop,
    rolling_acceleration,
)

STEP_S = 1.0 / 120.0
COUNTS = (1, 2, 4, 8, 12, 16, 24, 32)  # substeps
BALL, SLOPE, WAY = 0.1, math.radians(30.0), 3.0  # m, rad, m down the incline
WIDTH, DEPTH, SMALL, POINTS = math.pi, 2.0, 0.06, 400  # of the cycloid, m; its ball, m
LOOP, CHORDS, HALVINGS = 1.0, 100, 14
LONGEST_S = 4.0
NO_SLIP = 1e6  # friction
INCLINE, RACE, ROUND = "incline", "race", "loop"


def _time_to(curve: Curve, start: tuple[float, float], radius: float, goal: float, h: float) -> float:
    """s from rest at a place on a track until x = goal; infinity if that takes too long."""
    world = TrackWorld([curve], TrackSettings(1, (0.0, -STANDARD_GRAVITY)))
    ball = world.add_ball(start, radius, friction=NO_SLIP)
    world.put_down(ball, radius)
    for step in range(int(LONGEST_S / h)):
        x, v = world.balls.rows[ball, [motion.X, motion.VX]].tolist()
        world.step(h)
        after, ahead = world.balls.rows[ball, [motion.X, motion.VX]].tolist()
        if after >= goal:
            return (step + crossing_share(x, after, v * h, ahead * h, goal)) * h
    return math.inf


def incline_error(h: float) -> float:
    """Relative error of the acceleration of a disc down an incline."""
    c, s = elementary.cos(SLOPE), elementary.sin(SLOPE)
    curve = Curve(np.array([(-1.0 * c, 1.0 * s), (6.0 * c, -6.0 * s)]))
    took = _time_to(curve, (BALL * s, BALL * c), BALL, BALL * s + WAY * c, h)
    return abs(2.0 * WAY / (took * took) / rolling_acceleration(SLOPE, STANDARD_GRAVITY, DISC) - 1.0)


def race_error(h: float) -> float:
    """Relative error of the time down a cycloid that the ball's centre follows."""
    turn = np.linspace(0.0, 1.2 * math.pi, POINTS)
    way = np.stack([turn - elementwise.sin(turn), elementwise.cos(turn) - 1.0], axis=1)
    curve = Curve(moved_aside(way, -SMALL))
    took = _time_to(curve, (0.0, 0.0), SMALL, WIDTH, h)
    return abs(took / cycloid_time(WIDTH, DEPTH, STANDARD_GRAVITY, DISC) - 1.0)


def loop_error(h: float) -> float:
    """Relative error of the least drop from which a disc comes round."""
    exact = loop_drop(LOOP, BALL, DISC)
    low, high = 0.77 * exact, 1.31 * exact
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if _comes_round(middle, h) else (middle, high)
    return abs(high / exact - 1.0)


def _comes_round(drop: float, h: float) -> bool:
    turn = np.linspace(-0.5 * math.pi, 1.5 * math.pi, CHORDS + 1)
    curve = Curve(LOOP * np.stack([elementwise.cos(turn), 1.0 + elementwise.sin(turn)], axis=1))
    world = TrackWorld([curve], TrackSettings(1, (0.0, -STANDARD_GRAVITY)))
    speed = math.sqrt(2.0 * STANDARD_GRAVITY * drop / (1.0 + DISC))
    ball = world.add_ball((1e-3, BALL), BALL, (speed, 0.0), -speed / BALL, friction=NO_SLIP)
    world.put_down(ball, 0.05)
    for _ in range(int(2.0 / h)):
        world.step(h)
        x, y = world.balls.rows[ball, [motion.X, motion.Y]].tolist()
        if world.balls.pieces[ball, motion.PIECE] == motion.FREE:
            return False
        if x < -0.3 and 0.3 < y < 0.9:
            return True
    return False


ERRORS: dict[str, Callable[[float], float]] = {
    INCLINE: incline_error, RACE: race_error, ROUND: loop_error,
}  # fmt: skip


def marble_trial(setting: Setting) -> Trial:
    """One ball, from rest to its goal; in the loop several, from as many heights: the relative error."""
    error, h = ERRORS[setting.method], float(setting.knob)
    return computation(
        LONGEST_S, lambda: error(h), lambda found: Outcome(max(found, 1e-12), round(STEP_S / h))
    )


def marble_settings() -> list[Setting]:
    """1 to 32 substeps."""
    return [
        Setting(
            name, STEP_S / n, {}, {"substeps": n, "tier": "own", "step_length": STEP_S},
            (40.0 if name == ROUND else 4.0) * n,
        )
        for n in COUNTS
        for name in ERRORS
    ]  # fmt: skip


def present_marbles(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: its substep, in the race."""
    substeps = TIERS.get(parameters["tier"], int(parameters["substeps"]))
    h = float(parameters["step_length"]) / substeps
    return Setting(RACE, min(max(h, STEP_S / COUNTS[-1]), STEP_S), {}, {})


marble_study = Study(
    name="a22",
    title="Balls on tracks",
    error="relative error: of 2/3 g sin, of the time down a cycloid, of the least drop for a loop",
    error_unit="",
    counter="substeps",
    knob=Knob("step_length", "substep", "s"),
    methods=(
        Method(INCLINE, "incline", None),
        Method(RACE, "cycloid", 2.0),
        Method(ROUND, "loop", None),
    ),
    settings=marble_settings,
    trial=marble_trial,
    reference="2/3 g sin, the cycloid's time (Bernoulli 1696), 11/4 (R - r) (Huygens 1673)",
    expectation=(
        "Along a straight track each step is exact, and the speed follows from the energy everywhere; what "
        "is left is when it is where: second order in the substep."
    ),
    present=present_marbles,
    workload=Workload("one ball"),
    mark=quality_marks(RACE),
)
