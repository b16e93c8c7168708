"""The break: from where, how hard, and where on the white ball, tried under noise."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from game.billiards.arrangement import Arrangement, Stroke, bed_for, is_free
from game.billiards.rack import FOOT_SPOT, HEAD_SPOT
from game.billiards.rules import CUE_BALL
from game.billiards.search.rating import FOULED, LOST, SCORED, WON, Aims
from game.billiards.search.strokes import Board, Noise, with_noise
from game.billiards.search.view import View
from game.billiards.shot import Physics
from game.billiards.table import Table

Array = NDArray[np.float64]

PLACES = (0.5, 0.32, 0.68, 0.2, 0.8)  # across the table, behind the line
UPS = (0.0, 0.12, -0.12)  # ball radii
SLOWER = 0.85  # share of the hardest break that is tried as well


def apex_of(lie: Arrangement, table: Table) -> tuple[float, float]:
    """The ball of the rack that is nearest to the line, m; the foot spot if there is none."""
    places = [place for n, place in zip(lie.numbers, lie.positions.tolist(), strict=True) if n != CUE_BALL]
    if not places:
        return 0.5 * table.width, FOOT_SPOT * table.length
    x, y = min(places, key=lambda place: (place[1], place[0]))
    return x, y


def best_break(
    lie: Arrangement,
    table: Table,
    physics: Physics,
    aims: Aims,
    noise: Noise,
    speed: float,
    draws: Array,
    pool: ThreadPoolExecutor | None = None,
) -> tuple[tuple[float, float], Stroke, float]:
    """The break after which a ball is down most often: place of the white ball m, stroke, share that scored.

    speed: the hardest, m/s. aims: in rows of the arrangement with the white ball. draws (k, 5) of noise; with
    none, the plain break from the middle is taken.
    """
    radius = float(lie.balls.radii[CUE_BALL])
    left, right, lower, _ = bed_for(table, radius)
    y = max(lower, HEAD_SPOT * table.length - 0.5 * radius)
    target = apex_of(lie, table)
    without = lie.without(CUE_BALL)
    best: tuple[float, tuple[float, float], Stroke] | None = None
    for share in PLACES if len(draws) else PLACES[:1]:
        x = left + share * (right - left)
        if not is_free(without, table, CUE_BALL, x, y, "behind the line"):
            continue
        azimuth = math.atan2(target[1] - y, target[0] - x)
        strokes = np.array([(v, azimuth, 0.0, 0.0, up) for v in (speed, SLOWER * speed) for up in UPS])
        chances = _chances(
            without.with_ball(CUE_BALL, (x, y)), table, physics, aims, noise, strokes, draws, pool
        )
        at = int(np.argmax(chances))
        if best is None or chances[at] > best[0]:
            best = (float(chances[at]), (x, y), Stroke(*strokes[at].tolist()))
    if best is None:
        raise ValueError("break: there is no free place behind the line")
    return best[1], best[2], best[0]


def _chances(
    lie: Arrangement,
    table: Table,
    physics: Physics,
    aims: Aims,
    noise: Noise,
    strokes: Array,
    draws: Array,
    pool: ThreadPoolExecutor | None,
) -> Array:
    """Share of samples of each stroke (m, 5) that pot a ball, less the share that foul."""
    if not len(draws):
        return np.zeros(len(strokes))
    view = View(Board(lie, table, physics), noise)
    outcomes = view.board.play(with_noise(strokes, draws, noise, view.board.radius), pool)
    kinds = view.classes(outcomes, aims, np.full((len(outcomes.facts), 2), -1, np.int64))
    good = np.isin(kinds, (SCORED, WON)).astype(float) - np.isin(kinds, (FOULED, LOST))
    return good.reshape(len(strokes), -1).mean(axis=1)
