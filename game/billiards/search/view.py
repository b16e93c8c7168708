"""A board as the search sees it: geometry, candidates, what strokes led to; and the time that is left."""

from __future__ import annotations

import math
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import bed_for
from game.billiards.search.candidates import CHANCE, COLUMNS, KINDS, MOST, list_candidates
from game.billiards.search.lanes import SIGHT, Geometry, gates_of
from game.billiards.search.outcomes import Outcomes
from game.billiards.search.rating import Aims, classify_all, packed, rate_all
from game.billiards.search.strokes import Board, Noise, in_threads

LEAST_SIGHT = 1e-5  # rad; of a steady hand, for which every free pot is sure


class Clock:
    """Time that is left, s; None: no limit, so that what is found does not depend on the machine."""

    def __init__(self, seconds: float | None = None) -> None:
        self._end = math.inf if seconds is None else time.monotonic() + seconds

    def is_out(self) -> bool:
        """True if there is no time left."""
        return self._end < math.inf and time.monotonic() >= self._end


UNLIMITED = Clock()


class View:
    """A board with what geometry needs of it: places (n, 2) m of the balls, and the rest."""

    def __init__(self, board: Board, noise: Noise) -> None:
        self.board = board
        self.noise = noise
        self.places = np.ascontiguousarray(board.places)
        sight = max(SIGHT * noise.azimuth / Noise().azimuth, LEAST_SIGHT)
        bed = np.array(bed_for(board.table, 0.0))
        self.geometry = Geometry(board.radii, gates_of(board.table), bed, board.cue, sight)

    def moved(self, places: Floats, kept: NDArray[np.intp]) -> View:
        """The view with some of its rows, at rest at other places (n, 2) m; nothing is checked."""
        view = View.__new__(View)
        view.board = self.board.moved(places, kept)
        view.noise = self.noise
        view.places = np.ascontiguousarray(view.board.places)
        view.geometry = self.geometry._replace(radii=view.board.radii, cue=view.board.cue)
        return view

    def candidates(self, aims: Aims, kinds: tuple[str, ...], most: int) -> Floats:
        """The likeliest candidates (c, 8), the likeliest first."""
        bits = sum(1 << KINDS.index(kind) for kind in kinds)
        found = np.empty((MOST, COLUMNS))
        count = list_candidates(self.places, self.geometry, aims.first, aims.score, bits, found)
        order = np.argsort(-found[:count, CHANCE], kind="stable")[:most]
        return found[order]

    def classes(self, outcomes: Outcomes, aims: Aims, meant: NDArray[np.int64]) -> NDArray[np.int64]:
        """What each stroke led to. meant (m, 2): ball and pocket."""
        kinds = np.empty(len(outcomes.facts), np.int64)
        classify_all(outcomes.facts, outcomes.histories, packed(aims), meant, kinds)
        return kinds

    def worth(
        self, outcomes: Outcomes, aims: Aims, kinds: NDArray[np.int64], pool: ThreadPoolExecutor | None = None
    ) -> Floats:
        """Estimated chance (m,) to win after each of m strokes; kinds (m,): their classes."""
        worth = np.empty(len(kinds))
        part = max(1, min(256, (len(kinds) + 1) // 2))

        def rate(start: int) -> None:
            rows = slice(start, start + part)
            rate_all(
                kinds[rows], outcomes.places[rows], self.geometry, packed(aims),
                np.empty(self.board.count), worth[rows],
            )  # fmt: skip

        in_threads(pool, rate, range(0, len(kinds), part))
        return worth
