"""Finding the strokes of a combination match: one ball goes down, by way of another, and cleanly.

A hand that does not shake plays them. So a stroke is looked for that works, with a margin, and leaves a table
where the next one can be found.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.state import IN_MASS
from game.billiards.search import candidates as c
from game.billiards.search import outcomes as o
from game.billiards.search.fans import make_styles, rays_for, spread_fans, squirt_of
from game.billiards.search.outcomes import Outcomes
from game.billiards.search.rating import Aims
from game.billiards.search.view import View
from game.billiards.shot.cue import CUE_END_MASS
from game.physics.kernels import elementwise

SPEEDS = (0.7, 1.1, 1.6, 2.3, 3.2)  # m/s
UPS = (-0.3, 0.0, 0.3)  # ball radii
TRIED = 24  # candidates of geometry
RAYS = 31
ROUND_RAYS = 1500  # directions all around, when geometry finds nothing
ROUND_SPEEDS = (0.9, 1.5, 2.2, 3.0, 4.0, 5.0)  # m/s
NEXT_LOOKS = 40  # strokes whose next table is looked at
NEXT_KINDS = 3  # candidates that are counted there
WIDE = 0.002  # rad; a window that leaves a margin


class Option(NamedTuple):
    """A stroke that pots one ball as a round expects; merit: how much better than others."""

    stroke: Stroke
    merit: float


def options_for(
    view: View, chain: int, kinds: tuple[str, ...], most: int, pool: ThreadPoolExecutor | None = None
) -> list[Option]:
    """Strokes that pot exactly one ball, the best first; empty if none was found.

    chain: least balls in its chain, the cue ball counted. kinds: of candidates to try before all directions.
    """
    aims = _aims(view, chain)
    candidates = view.candidates(aims, kinds, TRIED)
    found: list[Option] = []
    if len(candidates):
        found = _from_fans(view, candidates, make_styles(SPEEDS, UPS, (0.0,)), chain, most, pool)
    if not found:
        found = _from_all_around(view, chain, most, pool)
    return found


def _aims(view: View, chain: int) -> Aims:
    """Any ball by way of any."""
    every = ((1 << view.board.count) - 1) & ~(1 << view.board.cue)
    return Aims(every, every, every, solo=True, chain=chain)


def _from_fans(
    view: View, candidates: Floats, styles: Floats, chain: int, most: int, pool: ThreadPoolExecutor | None
) -> list[Option]:
    """What the fans of candidates find."""
    rays = rays_for(candidates, most=RAYS)
    sizes = rays * len(styles)
    starts = np.concatenate([[0], np.cumsum(sizes)[:-1]]).astype(np.int64)
    strokes = np.empty((int(sizes.sum()), 5))
    squirt = squirt_of(styles, float(view.board.base[view.board.cue, IN_MASS]), CUE_END_MASS)
    spread_fans(candidates, styles, rays, starts, squirt, strokes)
    steps = np.repeat(2.0 * candidates[:, c.SPREAD] / (rays - 1), sizes)
    fans = np.repeat(np.arange(len(candidates) * len(styles)), np.repeat(rays, len(styles)))
    return _ranked(view, strokes, steps, fans, chain, most, pool)


def _from_all_around(view: View, chain: int, most: int, pool: ThreadPoolExecutor | None) -> list[Option]:
    """What is found in all directions."""
    styles = make_styles(ROUND_SPEEDS, UPS, (0.0,))
    row = np.zeros((1, c.COLUMNS))
    row[0, [c.AIM, c.SPREAD, c.WINDOW, c.CHANCE]] = 0.0, np.pi, 1.0, 1.0
    rays = np.array([ROUND_RAYS], np.int64)
    strokes = np.empty((ROUND_RAYS * len(styles), 5))
    spread_fans(row, styles, rays, np.zeros(1, np.int64), np.zeros(len(styles)), strokes)
    steps = np.full(len(strokes), 2.0 * np.pi / ROUND_RAYS)
    fans = np.repeat(np.arange(len(styles)), ROUND_RAYS)
    return _ranked(view, strokes, steps, fans, chain, most, pool)


def _ranked(
    view: View,
    strokes: Floats,
    steps: Floats,
    fans: NDArray[np.int64],
    chain: int,
    most: int,
    pool: ThreadPoolExecutor | None,
) -> list[Option]:
    """Strokes that do it, by how wide their window is and what they leave."""
    outcomes = view.board.play(strokes, pool)
    good = is_clean(outcomes, chain)
    rows = np.flatnonzero(good)
    if not len(rows):
        return []
    room = np.empty(len(strokes), np.int64)
    count_neighbours(good.astype(np.int64), fans, room)
    width = room[rows] * steps[rows]
    order = np.argsort(-np.minimum(width, WIDE), kind="stable")[:NEXT_LOOKS]
    chosen = rows[order]
    left = np.array([_next_chance(view, outcomes.places[row]) for row in chosen.tolist()])
    merit = (0.2 + np.minimum(width[order], WIDE) / WIDE) * (0.02 + left)
    best = np.argsort(-merit, kind="stable")[:most]
    return [Option(Stroke(*strokes[chosen[k]].tolist()), float(merit[k])) for k in best.tolist()]


def is_clean(outcomes: Outcomes, chain: int, once: bool = True) -> NDArray[np.bool_]:
    """Which strokes (m,) pot exactly one ball, and not the cue ball, by a chain of at least so many.

    once: only one ball touched the one that falls, so that there is no doubt which sent it on.
    """
    facts, histories = outcomes.facts, outcomes.histories
    down = facts[:, o.DOWN]
    single = (down != 0) & (down & (down - 1) == 0)
    good = single & (facts[:, o.SCRATCH] == 0) & (facts[:, o.GIVEN_UP] == 0) & (facts[:, o.FIRST_BALLS] != 0)
    rows = np.flatnonzero(good)
    ball = elementwise.log2(down[rows]).astype(np.intp)
    history = histories[rows, ball]
    length = np.zeros(len(rows), np.int64)
    for bit in range(histories.shape[1]):
        length += history[:, o.CHAIN] >> bit & 1
    kept = length >= chain
    if chain and once:
        kept &= history[:, o.CONTACTS] == 1
    good[rows] = kept
    return good


@lean_kernel
def count_neighbours(good, fans, room):
    """How far each good stroke is from the nearer end of its run, to space (m,): 1 there, by 2 more inside.

    good (m,) 0 or 1; fans (m,): which fan a stroke is of.
    """
    m = good.shape[0]
    run = 0
    for i in range(m):
        run = 0 if good[i] == 0 else (run + 1 if i > 0 and fans[i] == fans[i - 1] else 1)
        room[i] = run
    run = 0
    for i in range(m - 1, -1, -1):
        run = 0 if good[i] == 0 else (run + 1 if i < m - 1 and fans[i] == fans[i + 1] else 1)
        room[i] = max(2 * min(room[i], run) - 1, 0)


def _next_chance(view: View, places: Floats) -> float:
    """How good a combination the table offers that a stroke leaves; of one ball or none, 1."""
    kept = np.flatnonzero(places[:, 0] > 0.5 * o.NOWHERE)
    if len(kept) <= 2:
        return 1.0
    below = view.moved(places, kept)
    kinds = ("combination",)
    candidates = below.candidates(_aims(below, 3), kinds, NEXT_KINDS)
    return float(candidates[:, c.CHANCE].sum()) / NEXT_KINDS
