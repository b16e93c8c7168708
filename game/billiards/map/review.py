"""What a stroke was worth: the best pot that there was, the chance of the one that was tried, why it missed.

Why is asked of the exact table: the stroke is played again with one of its parts put right, the others as
they were. Where a hand strayed from what was meant and the meant stroke pots, right is what was meant. Else
it is the smallest change that pots. Throw is put right by balls without friction.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.map.pool import Pot, pool_map
from game.billiards.search.chances import as_hand_does, pocket_of
from game.billiards.search.legality import board_of, legality_of
from game.billiards.search.outcomes import CUSHIONS, POCKET
from game.billiards.search.strokes import (
    AZIMUTH,
    LARGEST_TIP,
    LEAST_SPEED,
    SPEED,
    TIP_LEFT,
    TIP_UP,
    Board,
    Noise,
)
from game.billiards.table.aim import first_contact
from game.physics.kernels import elementwise

AIM, PACE, SPIN, THROW = CAUSES = ("aim", "speed", "spin", "throw")
PARTS = {AIM: (AZIMUTH,), PACE: (SPEED,), SPIN: (TIP_LEFT, TIP_UP)}  # columns of a stroke
TURNS: Floats = math.radians(0.02) * elementwise.power(1.22, np.arange(31.0))  # rad, up to 8 degrees
PACES: Floats = 0.03 * np.arange(1.0, 17.0)  # shares of the speed
SPINS: Floats = 0.04 * np.arange(1.0, 16.0)  # ball radii
MISSED_BY = tuple(math.radians(size) for size in (0.25, 0.5, 1.0, 1.5))  # rad, beside a ball
HARDER = 1.45  # times the speed, of a stroke that is too soft
GROUPS = 6  # pots of the map that are compared


class Cause(NamedTuple):
    """A part of a stroke that, put right alone, pots: its name, of CAUSES.

    change: what is to be added: rad to the left, m/s of the cue, or ball radii, to the left or up. It is 0 of
    throw. up: of spin, whether the change is up. size: times the noise of the hand.
    """

    name: str
    change: float
    size: float
    up: bool = False


class Review(NamedTuple):
    """best: the surest pot that there was. ball, pocket: that was tried, by number and row; None if none was.

    chance: of the stroke as it was meant. made: it went down; foul: it did, and was a foul. strayed: the
    meant stroke pots, and the hand did another one. causes: the smallest first.
    """

    best: Pot | None
    ball: int | None = None
    pocket: int | None = None
    chance: float = 0.0
    made: bool = False
    foul: bool = False
    strayed: bool = False
    causes: tuple[Cause, ...] = ()


def review(before: Frame, meant: Stroke, done: Stroke, call: Call, noise: Noise) -> Review:
    """The review of a stroke. before: the frame that it was played from; noise: of the hand.

    ValueError if there was no cue ball.
    """
    board = board_of(before)
    pots = pool_map(board, noise, legality_of(before), groups=GROUPS).pots
    found = Review(pots[0] if pots else None)
    ball = call.ball if call.ball is not None else _aimed_at(before, meant)
    if ball is None or ball not in board.layout.numbers or call.safety:
        return found
    tried = Tried(before, board, ball)
    pocket = call.pocket if call.pocket is not None else tried.nearest(meant)
    if pocket is None:
        return found._replace(ball=ball)
    chance = float((tried.legal(as_hand_does(_rows([meant]), noise, board.radius)) == pocket).mean())
    made = bool(tried.legal(_rows([done]))[0] == pocket)
    found = found._replace(ball=ball, pocket=pocket, chance=chance, made=made)
    if made:
        return found
    found = found._replace(foul=bool(tried.fallen(_rows([done]))[0] == pocket))
    strayed = meant != done and bool(tried.pockets(_rows([meant]))[0] == pocket)
    causes = _put_back(tried, pocket, meant, done, noise) if strayed else ()
    causes = causes or _changed(tried, pocket, done, noise)
    if tried.without_throw(done) == pocket:
        causes = (*causes, Cause(THROW, 0.0, math.inf))
    return found._replace(strayed=strayed, causes=tuple(sorted(causes, key=lambda one: one.size)))


def best_pot(frame: Frame, noise: Noise) -> Pot | None:
    """The surest pot of the player at turn; None without one, without the cue ball, or after the game."""
    if not frame.playable or frame.cue_ball is None or frame.game.opening:
        return None
    pots = pool_map(board_of(frame), noise, legality_of(frame), groups=GROUPS).pots
    return pots[0] if pots else None


class Tried:
    """A ball (number) that strokes are to pot from a frame, on the exact table.

    direct: it is meant to go into its pocket by no cushion.
    """

    def __init__(self, before: Frame, board: Board, ball: int) -> None:
        self.before = before
        self.board = board
        self.row = board.layout.numbers.index(ball)
        self.legality = legality_of(before)
        self.direct = False

    def fallen(self, strokes: Floats) -> NDArray[np.int64]:
        """The pocket (m,) into which each stroke (m, 5) sends the ball, -1 for none."""
        return self.board.play(strokes).histories[:, self.row, POCKET]

    def legal(self, strokes: Floats) -> NDArray[np.int64]:
        """The same, -1 also for a foul."""
        return pocket_of(self.board, self.board.play(strokes), self.legality, self.row)

    def pockets(self, strokes: Floats) -> NDArray[np.int64]:
        """The same, -1 also by a cushion where the pot is direct, for that is luck."""
        outcomes = self.board.play(strokes)
        found = pocket_of(self.board, outcomes, self.legality, self.row)
        return np.where(self.direct & (outcomes.histories[:, self.row, CUSHIONS] > 0), -1, found)

    def nearest(self, stroke: Stroke) -> int | None:
        """The pocket that the stroke sends the ball into once it is turned as little as can be: by no cushion
        if there is one. A stroke that is too soft for any is tried harder.
        """
        turns = np.concatenate([[0.0], np.stack([TURNS, -TURNS], axis=1).ravel()])
        for pace in (1.0, HARDER):
            strokes = changed(stroke._replace(cue_speed=pace * stroke.cue_speed), AZIMUTH, turns)
            for self.direct in (True, False):
                found = self.pockets(strokes)
                down = np.flatnonzero(found >= 0)
                if len(down):
                    return int(found[down[0]])
        return None

    def without_throw(self, stroke: Stroke) -> int:
        """The pocket that it falls into where balls have no friction, -1 for none."""
        smooth = self.before.physics._replace(ball_ball="elastic", ball_friction=0.0)
        board = Board(self.board.layout, self.board.table, smooth, self.board.line)
        return int(pocket_of(board, board.play(_rows([stroke])), self.legality, self.row)[0])


def changed(stroke: Stroke, column: int, changes: Floats) -> Floats:
    """The stroke (m, 5) with one of its numbers changed by each of (m,)."""
    strokes = np.repeat(_rows([stroke]), len(changes), axis=0)
    strokes[:, column] += changes
    return strokes


def _rows(strokes: Iterable[Stroke]) -> Floats:
    return np.array(list(strokes), dtype=np.float64)


def _aimed_at(before: Frame, stroke: Stroke) -> int | None:
    """Number of the ball on the straight line of a stroke, or missed by a little; None if there is none."""
    balls = before.layout
    row, every = balls.numbers.index(CUE_BALL), np.ones(len(balls.numbers), dtype=np.bool_)
    for turn in (0.0, *(sign * size for size in MISSED_BY for sign in (1.0, -1.0))):
        first = first_contact(row, stroke.azimuth + turn, balls.positions, balls.radii, every, before.table)
        if first.kind == "ball":
            return balls.numbers[first.target]
    return None


def _put_back(tried: Tried, pocket: int, meant: Stroke, done: Stroke, noise: Noise) -> tuple[Cause, ...]:
    """Parts that pot as soon as they are what was meant, the others as the hand did them."""
    found = []
    for name, columns in PARTS.items():
        stroke = list(done)
        for column in columns:
            stroke[column] = meant[column]
        if tried.pockets(_rows([Stroke(*stroke)]))[0] == pocket:
            column = max(columns, key=lambda one: abs(meant[one] - done[one]))
            found.append(_cause(name, column, meant[column] - done[column], noise, tried.board.radius))
    return tuple(found)


def _changed(tried: Tried, pocket: int, done: Stroke, noise: Noise) -> tuple[Cause, ...]:
    """The smallest change of each part that pots."""
    found = []
    for name, columns in PARTS.items():
        causes = []
        for column in columns:
            steps = {AIM: TURNS, PACE: PACES * done.cue_speed, SPIN: SPINS}[name]
            changes = np.stack([steps, -steps], axis=1).ravel()
            strokes = changed(done, column, changes)
            able = strokes[:, SPEED] > LEAST_SPEED
            tips = strokes[:, TIP_LEFT : TIP_UP + 1]
            able &= (tips * tips).sum(axis=1) < LARGEST_TIP * LARGEST_TIP
            strokes, changes = strokes[able], changes[able]
            if len(strokes) and (tried.pockets(strokes) == pocket).any():
                first = int(np.argmax(tried.pockets(strokes) == pocket))
                causes.append(_cause(name, column, float(changes[first]), noise, tried.board.radius))
        found += sorted(causes, key=lambda one: one.size)[:1]
    return tuple(found)


def _cause(name: str, column: int, change: float, noise: Noise, radius: float) -> Cause:
    sigma = {AIM: noise.azimuth, PACE: noise.speed, SPIN: noise.tip / radius}[name]
    if name == AIM:
        change = math.remainder(change, math.tau)
    return Cause(name, change, abs(change) / max(sigma, 1e-12), column == TIP_UP)
