"""Random positions of three balls."""

from __future__ import annotations

import numpy as np

from game.billiards.map.carom import Position
from game.billiards.map.routes import Wanted
from game.billiards.shot.cloths import CLOTHS, HEATED
from game.billiards.table.carom import BALL_RADIUS, CAROM_LENGTH, CAROM_WIDTH, fits
from game.billiards.table.table import Table


def random_places(random: np.random.Generator) -> np.ndarray:
    """Places (3, 2) m, one in four with a ball frozen to a rail, one in four with two balls close."""
    while True:
        places = random.uniform(BALL_RADIUS, (CAROM_WIDTH - BALL_RADIUS, CAROM_LENGTH - BALL_RADIUS), (3, 2))
        ball, kind = int(random.integers(3)), random.random()
        if kind < 0.25:
            places[ball, 0] = BALL_RADIUS
        elif kind < 0.5:
            angle = random.uniform(0.0, 2.0 * np.pi)
            near = 2.0 * BALL_RADIUS * random.uniform(1.0001, 1.5)
            places[ball] = places[ball - 1] + near * np.array([np.cos(angle), np.sin(angle)])
        if fits(places):
            return places


def position_at(
    places, cushions: int = 3, cue: int = 0, opening: bool = False, cloth: str = HEATED
) -> Position:
    """A position on a match table."""
    return Position(np.asarray(places, float), cue, Table.carom(), CLOTHS[cloth], Wanted(cushions, opening))
