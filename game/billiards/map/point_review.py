"""What a stroke of carom was worth: the surest way there was, the chance of the one tried, why it missed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.map.carom import THOROUGH, Group, Position, whole_map
from game.billiards.map.causes import Cause, Hand, causes_of, rows
from game.billiards.search.strokes import Noise, draw_noise, with_noise
from game.billiards.table.carom import BALL_RADIUS

LOOKS = THOROUGH._replace(groups=6, candidates=3, moves=8, draws=48)
DRAWS, SEED = 96, 71  # strokes of a hand that a chance is counted from


class PointReview(NamedTuple):
    """best: the surest way that there was. chance: of the stroke as it was meant. code: of the way it was
    meant to go, 0 if it was meant to go none. strayed: the meant stroke scores, and the hand did another one.
    causes: the smallest first.
    """

    best: Group | None
    chance: float
    code: int
    made: bool
    strayed: bool = False
    causes: tuple[Cause, ...] = ()


def review_point(position: Position, meant: Stroke, done: Stroke, noise: Noise) -> PointReview:
    """The review of a stroke. position: that it was played from; noise: of the hand."""

    def works(strokes: Floats) -> NDArray[np.bool_]:
        return position.wanted.scores(position.play(strokes))

    hand = with_noise(rows([meant]), draw_noise(SEED, DRAWS), noise, BALL_RADIUS)
    routes = position.play(rows([meant]))
    code = int(routes.codes[0]) if position.wanted.scores(routes)[0] else 0
    made = bool(works(rows([done]))[0])
    found = PointReview(best_way(position, noise), float(works(hand).mean()), code, made)
    if found.made:
        return found
    strayed, causes = causes_of(works, meant, done, Hand(noise, BALL_RADIUS))
    return found._replace(strayed=strayed, causes=causes)


def best_way(position: Position, noise: Noise) -> Group | None:
    """The surest way to score; None without one."""
    groups = whole_map(position, noise, LOOKS).groups
    return groups[0] if groups else None
