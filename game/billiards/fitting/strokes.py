"""The stroke that explains a track, on a table that is known.

The first samples give direction and speed. A grid about them, over side and height of the tip too, is played
for the first seconds. The best go downhill while the horizon grows, since the later a contact the more it
depends on all before it. Last, steps at random about what was found lead out of wrong valleys.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.fitting import errors as e
from game.billiards.fitting.descent import descend
from game.billiards.fitting.errors import Goal, Ground, Scratch, Target, errors_of, scratch_for
from game.physics.kernels import elementary, elementwise

EVERYTHING = 1e6  # s; a horizon beyond every track
SHARP = 0.1  # m
PLAIN = 0.5  # m; hardly anything is robust about it
SCALES = np.array([0.004, 0.05, 0.05, 0.05, 0.004])  # of the first simplex: rad, m/s, radii, radii, s
SPREADS = np.array([0.01, 0.05, 0.08, 0.08, 0.004])  # of steps at random
SIZES = np.array([0.15, 0.4, 1.0, 2.5])
TURNS = np.array([0, 1, -1, 2, -2, 4, -4, 8, -8, 16, -16, 30, -30]) * 0.01  # rad about the first direction
SPEEDS = np.array([0.92, 0.96, 1.0, 1.04, 1.09])  # times the first speed
TIPS = np.linspace(-0.6, 0.6, 9)
GRID_SECONDS = 3.0
STEPS_AT_RANDOM = 300
FIRST_SAMPLES = 5


class Effort(NamedTuple):
    """keep: strokes of the grid that go downhill. hops: rounds of steps at random."""

    keep: int
    hops: int


QUICK = Effort(24, 1)
THOROUGH = Effort(50, 2)


class Fit(NamedTuple):
    """A stroke (5,), what it costs, and how far off each ball is: sums (n, 3) as in `errors`."""

    stroke: Floats
    cost: float
    sums: Floats


class Bench:
    """One target, with space to play it; strokes go through here."""

    def __init__(self, target: Target) -> None:
        self.target = target
        self.scratch: Scratch = scratch_for(len(target.balls))
        self.first = first_guess(target)

    def errors(self, ground: Ground, strokes: Floats, goal: Goal) -> tuple[Floats, Floats]:
        """Sums (k, n, 3) and costs (k,) of strokes (k, 5)."""
        sums = np.zeros((len(strokes), len(self.target.balls), e.SUM_COLUMNS))
        costs = np.zeros(len(strokes))
        errors_of(self.target, self.scratch, ground, np.ascontiguousarray(strokes), goal, sums, costs)
        return sums, costs

    def downhill(self, ground: Ground, strokes: Floats, goal: Goal, evaluations: int) -> list[Fit]:
        """Where strokes (k, 5) lead, best first."""
        found = np.ascontiguousarray(strokes).copy()
        sums = np.zeros((len(found), len(self.target.balls), e.SUM_COLUMNS))
        costs = np.zeros(len(found))
        descend(self.target, self.scratch, ground, found, goal, SCALES, evaluations, sums, costs)
        order = np.argsort(costs, kind="stable")
        return [Fit(found[k], float(costs[k]), sums[k]) for k in order]


def first_guess(target: Target) -> Floats:
    """A stroke (5,) from the first samples of the struck ball, tip in the middle."""
    first, end = (int(row) for row in target.ranges[0])
    samples = target.samples[first : min(end, first + FIRST_SAMPLES + 1)]
    steps = np.diff(samples, axis=0)
    lengths = elementwise.hypot(steps[:, 1], steps[:, 2])
    # from where it lay to the second sample the ball may have waited; a clock in coarse ticks may stand still
    speed = float((lengths[1:] / np.maximum(steps[1:, 0], 0.01)).max())
    towards = samples[min(2, len(samples) - 1), 1:] - samples[0, 1:]
    speed = max(speed, 0.05)
    seen = float(samples[1, 0])
    start = min(max(seen - float(lengths[0]) / speed, seen - 0.04), seen)
    return np.array([elementary.atan2(towards[1], towards[0]), speed, 0.0, 0.0, start])


def grid_about(first: Floats) -> Floats:
    """Strokes (k, 5) about the first guess, with the tip anywhere it may be."""
    axes = np.meshgrid(first[0] + TURNS, first[1] * SPEEDS, TIPS, TIPS, indexing="ij")
    grid = np.stack([axis.ravel() for axis in axes], axis=1)
    grid = grid[
        grid[:, e.LEFT] * grid[:, e.LEFT] + grid[:, e.UP] * grid[:, e.UP] < e.LARGEST_TIP * e.LARGEST_TIP
    ]
    return np.column_stack([grid, np.full(len(grid), first[e.START])])


def fit_stroke(bench: Bench, ground: Ground, effort: Effort = THOROUGH) -> list[Fit]:
    """Strokes that explain the track on this table, best first, none of them the same as another."""
    grid = grid_about(bench.first)
    seen = float(bench.first[e.START])
    _, costs = bench.errors(ground, grid, Goal(seen + GRID_SECONDS, SHARP))
    strokes = grid[np.argsort(costs, kind="stable")[: effort.keep]]
    keep = effort.keep
    for seconds, kept, evaluations in (
        (GRID_SECONDS, keep, 60),
        (5.0, keep, 80),
        (8.0, keep // 2 + 1, 80),
        (EVERYTHING, keep // 3 + 1, 120),
        (EVERYTHING, 5, 200),
    ):
        goal = Goal(seen + seconds, SHARP)
        _, costs = bench.errors(ground, strokes, goal)
        strokes = strokes[np.argsort(costs, kind="stable")[:kept]]
        fits = bench.downhill(ground, strokes, goal, evaluations)
        strokes = np.array([fit.stroke for fit in fits])
    chance = np.random.default_rng(5)
    for _ in range(effort.hops):
        fits = _hop(bench, ground, fits, chance)
    return fits


def _hop(bench: Bench, ground: Ground, fits: list[Fit], chance: np.random.Generator) -> list[Fit]:
    """Steps at random from the three best fits; where the best of them lead."""
    goal = Goal(EVERYTHING, SHARP)
    best = np.array([fit.stroke for fit in fits[:3]])
    spread = SPREADS * np.array([1.0, max(float(bench.first[1]), 0.2) * 0.4, 1.0, 1.0, 1.0])
    strokes = np.repeat(best, STEPS_AT_RANDOM // len(best), axis=0)
    size = chance.choice(SIZES, (len(strokes), 1))
    strokes = strokes + chance.standard_normal(strokes.shape) * spread * size
    _, costs = bench.errors(ground, strokes, goal)
    chosen = np.concatenate([best, strokes[np.argsort(costs, kind="stable")[:12]]])
    return bench.downhill(ground, chosen, goal, 100)


def polish(bench: Bench, ground: Ground, fits: list[Fit]) -> Fit:
    """The best of some fits by the plain sum of squares, brought to its least."""
    strokes = np.array([fit.stroke for fit in fits[:3]])
    return bench.downhill(ground, strokes, Goal(EVERYTHING, PLAIN), 300)[0]


def root_mean_squares(sums: Floats) -> tuple[float, float]:
    """Root of the mean squared distance, m, over all samples of the struck ball, and of all balls."""
    cue = math.sqrt(sums[0, e.SQUARES] / max(sums[0, e.COUNT], 1.0))
    every = math.sqrt(sums[:, e.SQUARES].sum() / max(sums[:, e.COUNT].sum(), 1.0))
    return cue, every


assert len(SCALES) == len(SPREADS) == e.STROKE_COLUMNS
