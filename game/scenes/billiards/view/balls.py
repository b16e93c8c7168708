"""The balls as they are drawn at rest."""

from __future__ import annotations

import numpy as np

from game.scenes.billiards.model import BilliardsModel
from game.scenes.shared.tables.view import Balls


def balls_at_rest(model: BilliardsModel) -> Balls:
    """The balls as they lie in the frame."""
    balls = model.frame.layout
    numbers = np.array(balls.numbers, dtype=np.int64)
    return Balls(balls.positions, balls.radii, numbers, model.turns[numbers], np.ones(len(numbers)))
