"""How safe a stroke is: how far its aim may be off, and how often a hand pots with it.

Both are counted with strokes of the exact table, a few in each picture, until enough is known or the stroke
is another one. Nothing of it belongs to the state.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from time import perf_counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import Frame
from game.billiards.search.outcomes import GIVEN_UP, POCKET
from game.billiards.search.strokes import AZIMUTH, Board, Noise, draw_noise, with_noise
from game.billiards.table.table import Table
from game.physics.kernels import elementwise

Array = NDArray[np.float64]

HAND = Noise().scaled(1.9)  # of a practised person, as steady as an expert among the computer players
SLICE_S = 0.002  # s that a picture may wait for it
BATCH = 4  # strokes between two looks at the clock
# rad; how far off the aim is tried, from the middle out, and how often the last gap is halved then
OFFSETS: Array = math.radians(0.01) * elementwise.power(1.35, np.arange(20.0))
HALVINGS = 5
SAMPLES, FIRST_SAMPLES = 128, 32  # of the hand's strokes: all of them, and those of the first figure
SEED = 84


class Odds(NamedTuple):
    """What is known of a stroke so far; None: not yet, or there is none.

    ball: number of the ball that is met first. missed: the stroke as it is set does not pot it. margin: rad
    that the azimuth may be more, and less; at most the last of OFFSETS is tried. chance: share of the hand's
    strokes that pot it.
    """

    ball: int
    missed: bool = False
    margin: tuple[float, float] | None = None
    chance: float | None = None


def measure(board: Board, stroke: Stroke, ball: int) -> Iterator[Odds]:
    """What is known after each few strokes, and at last all of it. ball: number."""
    row = board.layout.numbers.index(ball)

    def pocket_of(strokes: Array) -> NDArray[np.int64]:
        """The pocket (m,) that the ball falls into with each stroke (m, 5), -1 for none."""
        outcomes = board.play(np.ascontiguousarray(strokes))
        return np.where(outcomes.facts[:, GIVEN_UP] == 1, -1, outcomes.histories[:, row, POCKET])

    meant = np.array([stroke], dtype=np.float64)
    pocket = int(pocket_of(meant)[0])
    odds = Odds(ball, missed=pocket < 0)
    yield odds
    if pocket >= 0:
        sides = []
        for sign in (1.0, -1.0):
            sides.append(0.0)
            for reach in _reach(lambda turned: pocket_of(turned) == pocket, meant, sign):
                sides[-1] = reach
                yield odds
        odds = odds._replace(margin=(sides[0], sides[1]))
        yield odds
    noisy = with_noise(meant, draw_noise(SEED, SAMPLES), HAND, board.radius)
    down = 0
    for begin in range(0, SAMPLES, BATCH):
        fell = pocket_of(noisy[begin : begin + BATCH])
        down += int((fell == pocket if pocket >= 0 else fell >= 0).sum())
        count = begin + BATCH
        if count in (FIRST_SAMPLES, SAMPLES):
            odds = odds._replace(chance=down / count)
        yield odds


def _reach(pots: Callable[[Array], NDArray[np.bool_]], meant: Array, sign: float) -> Iterator[float]:
    """How far, rad, a stroke (1, 5) may be turned to one side and still pots: ever better known."""

    def turned(offsets: Array) -> Array:
        strokes = np.repeat(meant, len(offsets), axis=0)
        strokes[:, AZIMUTH] += sign * offsets
        return strokes

    low, high = 0.0, math.nan
    for begin in range(0, len(OFFSETS), BATCH):
        offsets = OFFSETS[begin : begin + BATCH]
        missed = np.flatnonzero(~pots(turned(offsets)))
        first = int(missed[0]) if len(missed) else len(offsets)
        low = float(offsets[first - 1]) if first else low
        yield low
        if first < len(offsets):
            high = float(offsets[first])
            break
    for _ in range(HALVINGS if high == high else 0):
        middle = 0.5 * (low + high)
        if pots(turned(np.array([middle])))[0]:
            low = middle
        else:
            high = middle
        yield low


class OddsMeter:
    """The odds of the stroke that is aimed, measured on in each picture and kept until it is another one."""

    def __init__(self, now: Callable[[], float] = perf_counter) -> None:
        self._now = now
        self._board_key: object = None
        self._board: Board | None = None
        self._key: object = None
        self._work: Iterator[Odds] | None = None
        self._odds: Odds | None = None

    def of(self, frame: Frame, stroke: Stroke, ball: int) -> Odds | None:
        """What is known now of a stroke that meets a ball first; None if it cannot be played."""
        key = (frame.layout.places, frame.conditions, stroke, ball)
        if key != self._key:
            self._key, self._odds = key, Odds(ball)
            self._work = measure(self._board_of(frame), stroke, ball)
        began = self._now()
        while self._work is not None and self._now() - began < SLICE_S:
            try:
                self._odds = next(self._work)
            except StopIteration:
                self._work = None
            except ValueError:
                self._work = self._odds = None
        return self._odds

    def _board_of(self, frame: Frame) -> Board:
        key = (frame.layout.places, frame.conditions)
        if self._board is None or key != self._board_key:
            self._board_key = key
            self._board = Board(frame.layout, frame.table, frame.physics)
        return self._board


def warm_up() -> None:
    """Compile what the odds need."""
    board = Board(arrange({0: (0.5, 0.5), 1: (0.3, 0.3)}), Table.pool())
    for _ in measure(board, Stroke(1.0, 0.0), 1):
        pass
