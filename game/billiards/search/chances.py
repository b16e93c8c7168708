"""How often a hand pots a ball: one definition for the map of a position and for the stroke that is aimed.

The hand plays DRAWS strokes, the same ones each time. The chance of a pot is the share of them that send the
ball into that pocket and break no rule.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.search.legality import Legality
from game.billiards.search.outcomes import POCKET, Outcomes
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise

DRAWS = 64  # of the hand's noise, for each stroke
SEED = 62


def as_hand_does(strokes: Floats, noise: Noise, radius: float, draws: int = DRAWS) -> Floats:
    """Each stroke (m, 5) as the hand does it, ``draws`` times: (m draws, 5). radius of the cue ball, m."""
    return with_noise(strokes, draw_noise(SEED, draws), noise, radius)


def pocket_of(board: Board, outcomes: Outcomes, legality: Legality, ball: int) -> NDArray[np.int64]:
    """The pocket (m,) into which each stroke sends a ball (its row) without a foul, -1 for none."""
    fallen = outcomes.histories[:, ball, POCKET]
    return np.where(legality.fouls(board, outcomes), -1, fallen)
