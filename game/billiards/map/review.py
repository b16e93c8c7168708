"""What a stroke was worth: the best pot that there was, the chance of the one that was tried, why it missed.

Why is asked of the exact table, see `causes`. Throw is put right by balls without friction.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.map.causes import THROW, TURNS, Cause, Hand, causes_of, changed, rows
from game.billiards.map.pool import Pot, pool_map
from game.billiards.search.chances import as_hand_does, pocket_of
from game.billiards.search.legality import Legality, board_of, legality_of
from game.billiards.search.outcomes import CUSHIONS, POCKET
from game.billiards.search.strokes import AZIMUTH, Board, Noise
from game.billiards.table.aim import first_contact

MISSED_BY = tuple(math.radians(size) for size in (0.25, 0.5, 1.0, 1.5))  # rad, beside a ball
HARDER = 1.45  # times the speed, of a stroke that is too soft
GROUPS = 6  # pots of the map that are compared


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


def review(
    before: Frame, meant: Stroke, done: Stroke, call: Call, noise: Noise, legality: Legality | None = None
) -> Review:
    """The review of a stroke. before: the frame that it was played from; noise: of the hand; legality: what
    the rules asked of it, None for what they ask of every stroke from there.

    ValueError if there was no cue ball.
    """
    board = board_of(before)
    pots = pool_map(board, noise, legality_of(before), groups=GROUPS).pots
    found = Review(pots[0] if pots else None)
    ball = call.ball if call.ball is not None else _aimed_at(before, meant)
    if ball is None or ball not in board.layout.numbers or call.safety:
        return found
    tried = Tried(before, board, ball, legality or legality_of(before))
    pocket = call.pocket if call.pocket is not None else tried.nearest(meant)
    if pocket is None:
        return found._replace(ball=ball)
    chance = float((tried.legal(as_hand_does(rows([meant]), noise, board.radius)) == pocket).mean())
    made = bool(tried.legal(rows([done]))[0] == pocket)
    found = found._replace(ball=ball, pocket=pocket, chance=chance, made=made)
    if made:
        return found
    found = found._replace(foul=bool(tried.fallen(rows([done]))[0] == pocket))
    strayed, causes = causes_of(
        lambda strokes: tried.pockets(strokes) == pocket, meant, done, Hand(noise, board.radius)
    )
    if tried.without_throw(done) == pocket:
        causes = (*causes, Cause(THROW, 0.0, math.inf))
    return found._replace(strayed=strayed, causes=causes)


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

    def __init__(self, before: Frame, board: Board, ball: int, legality: Legality) -> None:
        self.before = before
        self.board = board
        self.row = board.layout.numbers.index(ball)
        self.legality = legality
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
        return int(pocket_of(board, board.play(rows([stroke])), self.legality, self.row)[0])


def _aimed_at(before: Frame, stroke: Stroke) -> int | None:
    """Number of the ball on the straight line of a stroke, or missed by a little; None if there is none."""
    balls = before.layout
    row, every = balls.numbers.index(CUE_BALL), np.ones(len(balls.numbers), dtype=np.bool_)
    for turn in (0.0, *(sign * size for size in MISSED_BY for sign in (1.0, -1.0))):
        first = first_contact(row, stroke.azimuth + turn, balls.positions, balls.radii, every, before.table)
        if first.kind == "ball":
            return balls.numbers[first.target]
    return None
