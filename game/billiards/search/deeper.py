"""One stroke deeper: what a stroke leaves is worth what the best stroke after it is worth."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from game.billiards.search.looking import Effort, Looked, look
from game.billiards.search.outcomes import NOWHERE
from game.billiards.search.rating import SCORED, Aims
from game.billiards.search.strokes import in_threads
from game.billiards.search.view import UNLIMITED, Clock, View

Array = NDArray[np.float64]


def look_deeper(
    view: View,
    aims: Aims,
    looked: Looked,
    effort: Effort,
    draws: Array,
    pool: ThreadPoolExecutor | None = None,
    clock: Clock = UNLIMITED,
) -> Looked:
    """The first strokes judged by the best stroke after each; these come first, by their new worth."""
    after = effort.after
    if after is None:
        return looked
    every = looked.kinds.shape[1]
    k = min(effort.deep_samples, every)
    new: list[float] = []
    for f in range(min(effort.deep, len(looked.strokes))):
        if new and clock.is_out():
            break
        outcomes = looked.outcomes.rows(slice(f * every, f * every + k))
        kinds = looked.kinds[f, :k]
        worth = view.worth(outcomes, aims, kinds, pool)
        scored = np.flatnonzero(kinds == SCORED).tolist()
        places = outcomes.places

        def follow(i: int, places: Array = places, worth: Array = worth) -> float:
            return worth_after(view, aims, places[i], after, draws, worth[i])

        worth[scored] = in_threads(pool, follow, scored)
        new.append(float(worth.mean()))
    deeper = looked.worth.copy()
    deeper[: len(new)] = new
    order = np.concatenate([np.argsort(-deeper[: len(new)], kind="stable"), np.arange(len(new), len(deeper))])
    return looked._replace(worth=deeper).taken(order)


def worth_after(
    view: View, aims: Aims, places: Array, effort: Effort, draws: Array, otherwise: float
) -> float:
    """Worth of a table (places (n, 2) m) by the best stroke found there; `otherwise` if none is."""
    kept = np.flatnonzero(places[:, 0] > 0.5 * NOWHERE)
    board = view.board.moved(places, kept)
    below = View(board, view.noise, view.gates, view.bed)
    looked = look(below, aims_left(aims, kept), effort, draws)
    return float(looked.worth[0]) if looked is not None else otherwise


def aims_left(aims: Aims, kept: NDArray[np.intp]) -> Aims:
    """The aims when only some rows are left, which are numbered anew."""

    def squeezed(bits: int) -> int:
        return sum(1 << new for new, old in enumerate(kept.tolist()) if bits >> old & 1)

    needed = squeezed(aims.needed)
    ending = squeezed(aims.win | aims.lose)
    before = needed & ~ending
    if aims.rotation:
        lowest = needed & -needed
        return aims._replace(
            first=lowest, score=squeezed(aims.score), needed=needed, win=squeezed(aims.win), lose=0,
            other=squeezed(aims.other),
        )  # fmt: skip
    playable = before or needed
    return aims._replace(
        first=playable, score=playable, needed=needed, win=0 if before else ending,
        lose=ending if before else 0, other=squeezed(aims.other),
    )  # fmt: skip
