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

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.frame import Frame
from game.billiards.search.chances import DRAWS, as_hand_does, pocket_of
from game.billiards.search.legality import Legality
from game.billiards.search.outcomes import NO_LINE, POCKET
from game.billiards.search.strokes import AZIMUTH, Board, Noise
from game.billiards.table.table import Table
from game.physics.kernels import elementwise

HAND = Noise().scaled(1.9)  # of a practised person, as steady as an expert among the computer players
SLICE_S = 0.002  # s that a picture may wait for it
BATCH = 4  # strokes between two looks at the clock
# rad; how far off the aim is tried, from the middle out, and how often the last gap is halved then
OFFSETS: Floats = math.radians(0.01) * elementwise.power(1.35, np.arange(20.0))
HALVINGS = 5
FIRST_SAMPLES = 32  # of the hand's strokes, for the first figure


class Odds(NamedTuple):
    """What is known of a stroke so far; None: not yet, or there is none.

    ball: its number. missed: the stroke as it is set does not pot it. foul: it does, and is a foul. margin:
    rad that the azimuth may be more, and less; at most the last of OFFSETS is tried. chance: share of the
    hand's strokes that pot it. noise: of the hand.
    """

    ball: int
    missed: bool = False
    foul: bool = False
    margin: tuple[float, float] | None = None
    chance: float | None = None
    noise: Noise = HAND


class Asked(NamedTuple):
    """Which pot is asked about: ball, its number; pocket: row, None for the one it falls into, or any. What
    the rules ask, None for nothing; noise: of the hand.
    """

    ball: int
    pocket: int | None = None
    legality: Legality | None = None
    noise: Noise = HAND


def measure(board: Board, stroke: Stroke, asked: Asked) -> Iterator[Odds]:
    """What is known after each few strokes, and at last all of it."""
    row = board.layout.numbers.index(asked.ball)
    legality = Legality.free(board) if asked.legality is None else asked.legality

    def pockets(strokes: Floats) -> NDArray[np.int64]:
        """The pocket (m,) that the ball falls into with each stroke (m, 5), -1 for none, or with a foul."""
        return pocket_of(board, board.play(np.ascontiguousarray(strokes)), legality, row)

    meant = np.array([stroke], dtype=np.float64)
    outcome = board.play(meant)
    pocket = int(pocket_of(board, outcome, legality, row)[0])
    if asked.pocket is not None and pocket != asked.pocket:
        pocket = -1
    foul = pocket < 0 <= int(outcome.histories[0, row, POCKET]) and bool(legality.fouls(board, outcome)[0])
    odds = Odds(asked.ball, missed=pocket < 0, foul=foul, noise=asked.noise)
    yield odds
    if foul:
        return
    wanted = pocket if asked.pocket is None else asked.pocket
    if pocket >= 0:
        sides = []
        for sign in (1.0, -1.0):
            sides.append(0.0)
            for reach in _reach(lambda turned: pockets(turned) == pocket, meant, sign):
                sides[-1] = reach
                yield odds
        odds = odds._replace(margin=(sides[0], sides[1]))
        yield odds
    noisy = as_hand_does(meant, asked.noise, board.radius)
    down = 0
    for begin in range(0, DRAWS, BATCH):
        fell = pockets(noisy[begin : begin + BATCH])
        down += int((fell == wanted if wanted >= 0 else fell >= 0).sum())
        count = begin + BATCH
        if count in (FIRST_SAMPLES, DRAWS):
            odds = odds._replace(chance=down / count)
        yield odds


def _reach(pots: Callable[[Floats], NDArray[np.bool_]], meant: Floats, sign: float) -> Iterator[float]:
    """How far, rad, a stroke (1, 5) may be turned to one side and still pots: ever better known."""

    def turned(offsets: Floats) -> Floats:
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

    def of(self, frame: Frame, stroke: Stroke, asked: Asked) -> Odds | None:
        """What is known now of a stroke; None if it cannot be played."""
        key = (frame.layout.places, frame.conditions, stroke, asked)
        if key != self._key:
            self._key, self._odds = key, Odds(asked.ball, noise=asked.noise)
            self._work = measure(self._board_of(frame, asked.legality), stroke, asked)
        began = self._now()
        while self._work is not None and self._now() - began < SLICE_S:
            try:
                self._odds = next(self._work)
            except StopIteration:
                self._work = None
            except ValueError:
                self._work = self._odds = None
        return self._odds

    def _board_of(self, frame: Frame, legality: Legality | None) -> Board:
        line = NO_LINE if legality is None else legality.line
        key = (frame.layout.places, frame.conditions, line)
        if self._board is None or key != self._board_key:
            self._board_key = key
            self._board = Board(frame.layout, frame.table, frame.physics, line)
        return self._board


def warm_up() -> None:
    """Compile what the odds need."""
    board = Board(arrange({0: (0.5, 0.5), 1: (0.3, 0.3)}), Table.pool())
    for _ in measure(board, Stroke(1.0, 0.0), Asked(1)):
        pass
