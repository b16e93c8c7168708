"""Whether a stroke is legal: what the rules ask of it before it is played, and which of many strokes keep it.

The referee says the same of a stroke that has been played (`game.billiards.game.rules.common_fouls`). Map,
aim and computer players ask here.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.game.frame import Frame
from game.billiards.game.rules import Game
from game.billiards.search.aims import bits_of
from game.billiards.search.outcomes import NO_LINE, Outcomes, find_fouls
from game.billiards.search.strokes import Board
from game.billiards.table.rack import HEAD_SPOT


class Legality(NamedTuple):
    """What is asked of a stroke. first: numbers of the balls that may be touched first. barred: of those that
    must not go down. line: y, m, behind which no ball may be met first, NO_LINE without one.
    """

    first: tuple[int, ...]
    barred: tuple[int, ...] = ()
    line: float = NO_LINE

    @classmethod
    def free(cls, board: Board) -> Legality:
        """Nothing is asked but that the cue ball meets a ball and stays on the table."""
        return cls(board.layout.numbers)

    def fouls(self, board: Board, outcomes: Outcomes) -> NDArray[np.bool_]:
        """Which of the strokes (m,) played on a board break the rules."""
        numbers = board.layout.numbers
        fouls = np.empty(len(outcomes.facts), np.bool_)
        find_fouls(outcomes.facts, bits_of(numbers, self.first), bits_of(numbers, self.barred), fouls)
        return fouls


def legality_of(frame: Frame) -> Legality:
    """What the game asks of the next stroke."""
    game: Game = frame.game
    line = HEAD_SPOT * frame.table.length if game.from_behind else NO_LINE
    return Legality(game.legal_first(), game.barred(), line)


def board_of(frame: Frame) -> Board:
    """The board that a frame's next stroke is played on. ValueError without a cue ball."""
    return Board(frame.layout, frame.table, frame.physics, legality_of(frame).line)
