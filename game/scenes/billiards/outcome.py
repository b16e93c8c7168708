"""What is computed from the frame on the billiard table: its word, what came of its last stroke."""

from __future__ import annotations

from typing import NamedTuple

import msgspec

from game.billiards.game.frame import Frame, Played, Struck
from game.billiards.game.games import Practice
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.laws.state import BALL_POCKET
from game.scenes.shared.tables.outcome import Outcome

SETS = ("tries", "needed")  # fields of drills
TURNS = "alternating"  # of a combination match
OWN = ("set_up", "hand")  # fields of practice


class PoolOutcome(Outcome[Frame, Played]):
    """As at every table, and the pot that decided the rack."""

    def __init__(self) -> None:
        super().__init__(_said)
        self._decided_of: Struck | None = None
        self._decided: Decided | None = None

    def decided(self, frame: Frame) -> Decided | None:
        """Of a frame's last stroke."""
        if self._decided_of is not frame.last:
            self._decided = decided_by(self.played(frame))
            self._decided_of = frame.last
        return self._decided


class Decided(NamedTuple):
    """The pot that decided a rack: when, s after the hit, and the pocket (x, y) m."""

    time: float
    pocket: tuple[float, float]


def decided_by(played: Played | None) -> Decided | None:
    """The last pot of a stroke that ended its rack; None if it did not, or by no pot."""
    if played is None or not played.frame.game.over:
        return None
    cue = played.trajectory.shot.ids.index(str(CUE_BALL))
    rows = [row for row in played.trajectory.rows.tolist() if row[1] == BALL_POCKET and int(row[2]) != cue]
    if not rows:
        return None
    time, _, _, hole = rows[-1]
    x, y = played.trajectory.shot.table.pockets[int(hole), :2].tolist()
    return Decided(time, (x, y))


def _said(frame: Frame) -> object:
    """What a frame says, but for the frames before it."""
    last, game = frame.last, msgspec.to_builtins(frame.game)
    # the word of a game without sets, turns or a position of one's own stays what it was before these
    for name in (*SETS, TURNS, *(OWN if isinstance(frame.game, Practice) else ())):
        if not game.get(name, True):
            del game[name]
    return (
        game, frame.layout.places, frame.conditions, Call(), frame.strokes,
        None if last is None
        else (last.frame.layout.places, last.stroke, last.call, last.frame.conditions),
    )  # fmt: skip
