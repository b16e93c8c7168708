"""The break: from where, how hard, and where on the cue ball, tried under noise.

All of them go at the middle of the apex ball, and none comes from far aside: the more oblique a break, the
fewer balls reach a cushion.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from itertools import groupby
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Arrangement, Stroke, bed_for, is_free
from game.billiards.game.games.straight_pool import DRIVEN as NEEDED_AT_OPENING
from game.billiards.game.rules import CUE_BALL, NEEDED_AT_BREAK
from game.billiards.search import rating
from game.billiards.search.outcomes import CUSHIONS, DOWN, Outcomes
from game.billiards.search.rating import Aims
from game.billiards.search.strokes import Board, Noise, with_noise
from game.billiards.search.view import View
from game.billiards.shot.physics import Physics
from game.billiards.table.rack import FOOT_SPOT, HEAD_SPOT
from game.billiards.table.table import Table
from game.physics.kernels import elementary

PLACES = (0.5, 0.41, 0.59, 0.3, 0.7)  # across the table, behind the line
UPS = (0.0, 0.12, -0.12)  # ball radii
SLOWER = 0.85  # share of the hardest break that is tried as well
SOFT_PLACES = (0.62, 0.7, 0.78)  # across the table, of a break that is to leave nothing
SOFT_SPEEDS = (2.2, 2.7, 3.2)  # m/s
THIN = np.linspace(0.75, 0.97, 8)  # where the corner ball is hit, as a share of what can be
SOFT_LEFTS = (-0.35, 0.0)  # ball radii


def apex_of(layout: Arrangement, table: Table) -> tuple[float, float]:
    """The ball of the rack that is nearest to the line, m; the foot spot if there is none."""
    places = layout.without(CUE_BALL).positions.tolist()
    if not places:
        return 0.5 * table.width, FOOT_SPOT * table.length
    x, y = min(places, key=lambda place: (place[1], place[0]))
    return x, y


class Break(NamedTuple):
    """A break: where the cue ball is put (m), the stroke, and how good it is under noise, see `_merits`."""

    place: tuple[float, float]
    stroke: Stroke
    merit: float = 0.0


def list_breaks(layout: Arrangement, table: Table, speed: float) -> list[Break]:
    """All breaks that are tried, the plain one from the middle first. speed: the hardest, m/s."""
    radius = float(layout.balls.radii[CUE_BALL])
    left, right, lower, _ = bed_for(table, radius)
    y = max(lower, HEAD_SPOT * table.length - 0.5 * radius)
    target = apex_of(layout, table)
    without = layout.without(CUE_BALL)
    breaks = []
    for x in (left + share * (right - left) for share in PLACES):
        if is_free(without, table, CUE_BALL, x, y, "behind the line"):
            azimuth = elementary.atan2(target[1] - y, target[0] - x)
            breaks += [
                Break((x, y), Stroke(v, azimuth, tip_up=up)) for v in (speed, SLOWER * speed) for up in UPS
            ]
    return breaks


def best_break(
    layout: Arrangement,
    table: Table,
    physics: Physics,
    aims: Aims,
    noise: Noise,
    speed: float,
    draws: Floats,
    pool: ThreadPoolExecutor | None = None,
) -> Break:
    """The break that is lawful and pots a ball most often. ValueError if the cue ball has no place.

    speed: the hardest, m/s. aims: in rows of the arrangement with the cue ball. draws (k, 5) of noise; with
    none, the plain break from the middle is taken.
    """
    breaks = list_breaks(layout, table, speed)
    if not breaks:
        raise ValueError("break: there is no free place behind the line")
    if not len(draws):
        return breaks[0]
    tried: list[Break] = []
    for place, same in groupby(breaks, key=lambda one: one.place):
        some = list(same)
        view = View(Board(layout.with_ball(CUE_BALL, place), table, physics), noise)
        strokes = np.array([one.stroke for one in some])
        outcomes = view.board.play(with_noise(strokes, draws, noise, view.board.radius), pool)
        merits = _merits(view, aims, outcomes).reshape(len(some), -1).mean(axis=1)
        tried += [one._replace(merit=merit) for one, merit in zip(some, merits.tolist(), strict=True)]
    return max(tried, key=lambda one: one.merit)


def safe_break(
    layout: Arrangement,
    table: Table,
    physics: Physics,
    aims: Aims,
    noise: Noise,
    draws: Floats,
    pool: ThreadPoolExecutor | None = None,
) -> Break:
    """The lawful opening of straight pool (WPA 4.3) that leaves the other least: the last ball of the rack is
    hit thinly, the cue ball comes back round the table. Arguments as of `best_break`; with no draws it is
    played as meant. ValueError if the cue ball has no place.
    """
    radius = float(layout.balls.radii[CUE_BALL])
    left, right, lower, _ = bed_for(table, radius)
    y = max(lower, HEAD_SPOT * table.length - 0.5 * radius)
    corner = max(layout.without(CUE_BALL).positions.tolist(), key=lambda place: (place[1], place[0]))
    some = draws if len(draws) else np.zeros((1, 5))
    tried: list[Break] = []
    for place in ((left + share * (right - left), y) for share in SOFT_PLACES):
        if not is_free(layout.without(CUE_BALL), table, CUE_BALL, *place, "behind the line"):
            continue
        view = View(Board(layout.with_ball(CUE_BALL, place), table, physics), noise)
        dx, dy = corner[0] - place[0], corner[1] - place[1]
        half = float(elementary.asin(min(1.0, 2.0 * radius / elementary.hypot(dx, dy))))
        middle = elementary.atan2(dy, dx)
        aimed = [middle - half * thin for thin in THIN.tolist()]
        strokes = np.array(
            [(v, aim, 0.0, tip, 0.0) for v in SOFT_SPEEDS for aim in aimed for tip in SOFT_LEFTS]
        )
        outcomes = view.board.play(with_noise(strokes, some, noise, view.board.radius), pool)
        worth = _safe_merits(view, aims, outcomes, pool).reshape(len(strokes), -1).mean(axis=1)
        tried += [
            Break(place, Stroke(*stroke), merit)
            for stroke, merit in zip(strokes.tolist(), worth.tolist(), strict=True)
        ]
    if not tried:
        raise ValueError("break: there is no free place behind the line")
    return max(tried, key=lambda one: one.merit)


def _safe_merits(view: View, aims: Aims, outcomes: Outcomes, pool: ThreadPoolExecutor | None) -> Floats:
    """Of each opening (m,): the chance that is left to win, -1 if it is a foul or not lawful."""
    kinds = view.classes(outcomes, aims, np.full((len(outcomes.facts), 2), -1, np.int64))
    driven = outcomes.histories[:, :, CUSHIONS] > 0
    cue_driven = driven[:, view.board.cue].copy()
    driven[:, view.board.cue] = False
    lawful = cue_driven & (driven.sum(axis=1) >= NEEDED_AT_OPENING) & (kinds == rating.MISSED)
    return np.where(lawful, view.worth(outcomes, aims, kinds, pool), -1.0)


def _merits(view: View, aims: Aims, outcomes: Outcomes) -> Floats:
    """Of each break (m,): 1 if it pots a ball, -1 if it is a foul or not lawful, else 0."""
    kinds = view.classes(outcomes, aims, np.full((len(outcomes.facts), 2), -1, np.int64))
    driven = outcomes.histories[:, :, CUSHIONS] > 0
    driven[:, view.board.cue] = False
    unlawful = (outcomes.facts[:, DOWN] == 0) & (driven.sum(axis=1) < NEEDED_AT_BREAK)
    bad = unlawful | np.isin(kinds, (rating.FOULED, rating.LOST))
    return np.isin(kinds, (rating.SCORED, rating.WON)).astype(float) - bad
