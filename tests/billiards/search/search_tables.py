"""Tables for the tests of the search: balls thrown on the bed, and a few set by hand."""

from __future__ import annotations

import numpy as np

from game.billiards import Table
from game.billiards.game.arrangement import Arrangement, BallSet, arrange, equal_balls, is_free

POOL = Table.pool()


def scattered(seed: int, count: int = 16, balls: BallSet | None = None) -> Arrangement:
    """Balls 0 to count - 1 at random places where they touch nothing."""
    rng = np.random.default_rng(seed)
    layout = arrange({}, equal_balls() if balls is None else balls)
    for number in range(count):
        while True:
            x, y = rng.uniform((0.03, 0.03), (POOL.width - 0.03, POOL.length - 0.03))
            if is_free(layout, POOL, number, x, y):
                break
        layout = layout.with_ball(number, (x, y))
    return layout


def unlike_balls(seed: int) -> BallSet:
    """Balls of different radius and mass."""
    rng = np.random.default_rng(seed)
    return BallSet(rng.uniform(0.025, 0.03, 16), rng.uniform(0.12, 0.2, 16))


def random_strokes(seed: int, count: int) -> np.ndarray:
    """Strokes (count, 5) of all sorts."""
    rng = np.random.default_rng(seed)
    low = (0.3, 0.0, 0.0, -0.4, -0.4)
    return rng.uniform(low, (4.0, 2.0 * np.pi, 0.3, 0.4, 0.4), (count, 5))
