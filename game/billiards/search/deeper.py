"""One stroke deeper: what a stroke leaves is worth what the best stroke after it is worth."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.search.looking import Effort, Looked, look, sample
from game.billiards.search.outcomes import NOWHERE
from game.billiards.search.rating import SCORED, Aims
from game.billiards.search.strokes import in_threads
from game.billiards.search.view import UNLIMITED, Clock, View


def look_deeper(
    view: View,
    aims: Aims,
    looked: Looked,
    effort: Effort,
    draws: Floats,
    pool: ThreadPoolExecutor | None = None,
    clock: Clock = UNLIMITED,
) -> Looked:
    """The first strokes, sampled more closely and judged by the best stroke after each; the best first.

    How often a stroke pots, and what it is worth by estimate, is known from many samples. The error of the
    estimate is known from the few that are looked at deeply.
    """
    after = effort.after
    if after is None:
        return looked
    d = min(effort.deep, len(looked.strokes))
    closer = sample(view, aims, looked.strokes[:d], looked.candidates[:d], draws[: effort.close], pool)
    every = closer.kinds.shape[1]
    new: list[float] = []
    for f in range(d):
        if new and clock.is_out():
            break
        scored = np.flatnonzero(closer.kinds[f] == SCORED)[: effort.deep_samples]
        places = closer.outcomes.places[f * every : (f + 1) * every]
        values = closer.values[f]

        def follow(i: int, places: Floats = places, values: Floats = values) -> float:
            return worth_after(view, aims, places[i], after, draws, values[i]) - values[i]

        off = in_threads(pool, follow, scored.tolist())
        share = float((closer.kinds[f] == SCORED).mean())
        worth = float(closer.worth[f]) + share * (sum(off) / len(off) if off else 0.0)
        new.append(min(max(worth, 0.0), 1.0))
    done = closer.taken(np.arange(len(new)))._replace(worth=np.array(new))
    return done.taken(np.argsort(-done.worth, kind="stable"))


def worth_after(
    view: View, aims: Aims, places: Floats, effort: Effort, draws: Floats, otherwise: float
) -> float:
    """Worth of a table (places (n, 2) m) by the best stroke found there; `otherwise` if none is."""
    kept = np.flatnonzero(places[:, 0] > 0.5 * NOWHERE)
    looked = look(view.moved(places, kept), aims_left(aims, kept), effort, draws)
    return float(looked.worth[0]) if looked is not None else otherwise


def aims_left(aims: Aims, kept: NDArray[np.intp]) -> Aims:
    """The aims when only the rows ``kept`` (k,) are left, which are numbered again."""

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
