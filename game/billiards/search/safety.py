"""Strokes that are not meant to pot: safe ones, which leave the other little, and push-outs."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from game.arrays import Floats
from game.billiards.search import candidates
from game.billiards.search.candidates import NO_POT
from game.billiards.search.looking import Looked, sample
from game.billiards.search.rating import FOULED, LOST, SCORED, Aims
from game.billiards.search.view import View
from game.physics.kernels import elementwise, linear

SPEEDS = (0.35, 0.6, 0.9, 1.4, 2.2)  # m/s
UPS = (-0.3, 0.0, 0.3)  # ball radii
OFFSETS = np.linspace(-0.97, 0.97, 13)  # where a ball is hit, as a share of what can be
ROUND = 120  # directions all around, when the balls are hidden


def _strokes_at(view: View, first: int) -> Floats:
    """Strokes (m, 5) at every ball that may be touched first, thick and thin; and all around."""
    cue_ball = view.places[view.board.cue]
    directions: list[float] = []
    for ball in range(view.board.count):
        if first >> ball & 1:
            dx, dy = view.places[ball] - cue_ball
            reach = view.board.radii[ball] + view.board.radius
            half = float(elementwise.arcsin(min(1.0, reach / elementwise.hypot(dx, dy))))
            directions += (elementwise.arctan2(dy, dx) + half * OFFSETS).tolist()
    directions += np.linspace(0.0, 2.0 * np.pi, ROUND, endpoint=False).tolist()
    return np.array([(v, a, 0.0, 0.0, up) for a in directions for v in SPEEDS for up in UPS])


def no_candidates(count: int) -> Floats:
    """Candidates (c, 8) of strokes that mean to pot nothing."""
    rows = np.zeros((count, candidates.COLUMNS))
    rows[:, [candidates.BALL, candidates.INTO, candidates.VIA]] = -1.0
    rows[:, candidates.KIND] = NO_POT
    return rows


def look_for_safety(
    view: View, aims: Aims, finalists: int, draws: Floats, pool: ThreadPoolExecutor | None = None
) -> Looked:
    """The strokes after which the other has least, under noise; draws (k, 5), see `with_noise`."""
    strokes = _strokes_at(view, aims.first)
    outcomes = view.board.play(strokes, pool)
    nothing = np.full((len(strokes), 2), -1, np.int64)
    kinds = view.classes(outcomes, aims, nothing)
    worth = view.worth(outcomes, aims, kinds, pool)
    best = np.argsort(-worth, kind="stable")[:finalists]
    return sample(view, aims, strokes[best], no_candidates(len(best)), draws, pool)


def look_for_push_out(view: View, aims: Aims, seed: int, pool: ThreadPoolExecutor | None = None) -> Floats:
    """A stroke (5,) after which the turn matters least: the other player will choose."""
    rng = np.random.default_rng(seed)
    strokes = np.zeros((600, 5))
    strokes[:, 0] = linear.uniform(rng, 0.3, 2.0, len(strokes))
    strokes[:, 1] = linear.uniform(rng, 0.0, 2.0 * np.pi, len(strokes))
    outcomes = view.board.play(strokes, pool)
    nothing = np.full((len(strokes), 2), -1, np.int64)
    free = aims._replace(first=(1 << view.board.count) - 1, win=0, lose=0)
    kinds = view.classes(outcomes, free, nothing)
    lost = np.isin(kinds, (FOULED, LOST))
    worth = view.worth(outcomes, aims, np.full(len(strokes), SCORED), pool)
    even = np.where(lost, -1.0, np.minimum(worth, 1.0 - worth))
    return strokes[int(np.argmax(even))]
