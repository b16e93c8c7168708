"""Where the cue ball ends for the noise of a hand: strokes of the exact table, a few in each picture, until
there are enough or the stroke is another one. Nothing of it belongs to the state.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from time import perf_counter
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.search.outcomes import GIVEN_UP, SCRATCH
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise
from game.physics.kernels import elementwise

SAMPLES = 256  # strokes
BATCH = 8  # between two looks at the clock
SLICE_S = 0.002  # s that a picture may wait for it
SEED = 91


class Landing(NamedTuple):
    """ends (k, 2) m: where the cue ball came to rest. scratches: how often it went down; tried: strokes
    so far.
    """

    ends: Floats
    scratches: int
    tried: int

    @property
    def middle(self) -> Floats:
        """Mean (2,) m of the ends; nan without any."""
        return self.ends.mean(axis=0) if len(self.ends) else np.full(2, np.nan)

    @property
    def half_within(self) -> float:
        """Radius, m, of the circle round the middle in which half of the ends lie; nan without any."""
        if not len(self.ends):
            return float("nan")
        return float(np.median(elementwise.hypot(*(self.ends - self.middle).T)))


def landings(board: Board, stroke: Stroke, noise: Noise) -> Iterator[Landing]:
    """What is known after each few strokes, and at last after SAMPLES of them."""
    noisy = with_noise(np.array([stroke], dtype=np.float64), draw_noise(SEED, SAMPLES), noise, board.radius)
    ends, scratches = [np.empty((0, 2))], 0
    for begin in range(0, SAMPLES, BATCH):
        outcomes = board.play(np.ascontiguousarray(noisy[begin : begin + BATCH]))
        down = outcomes.facts[:, SCRATCH] != 0
        scratches += int(down.sum())
        ends.append(outcomes.places[~down & (outcomes.facts[:, GIVEN_UP] == 0), board.cue])
        yield Landing(np.concatenate(ends), scratches, begin + BATCH)


class LandingMeter:
    """The cloud of the stroke that is aimed, drawn on in each picture and kept until it is another one."""

    def __init__(self, now: Callable[[], float] = perf_counter) -> None:
        self._now = now
        self._key: object = None
        self._work: Iterator[Landing] | None = None
        self._landing: Landing | None = None

    def of(self, frame: Frame, stroke: Stroke, noise: Noise) -> Landing | None:
        """What is known now; None before the first strokes, or if it cannot be played."""
        key = (frame.layout.places, frame.conditions, stroke, noise)
        if key != self._key:
            self._key, self._landing = key, None
            self._work = landings(Board(frame.layout, frame.table, frame.physics), stroke, noise)
        began = self._now()
        while self._work is not None and self._now() - began < SLICE_S:
            try:
                self._landing = next(self._work)
            except StopIteration:
                self._work = None
            except ValueError:
                self._work = self._landing = None
        return self._landing
