"""Parts of the proof that a capsule is the least."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.bounds.least_capsule import MANY, diameter_bound


@pytest.mark.parametrize("corners", [MANY, MANY + 1])
@pytest.mark.parametrize("middle", [(0.0, 0.0), (30.0, 0.0), (0.0, 30.0), (-1.0, -1.0)])
def test_the_diameter_is_bounded_wherever_the_hull_lies(corners, middle):
    turn = np.linspace(0.0, 2.0 * math.pi, corners, endpoint=False)
    hull = np.stack([np.cos(turn), np.sin(turn)], axis=1) + middle
    diameter = 2.0 * math.cos(0.5 * math.pi / corners) if corners % 2 else 2.0
    assert diameter - 1e-9 <= diameter_bound(hull, corners) <= math.sqrt(2.0) * 2.0 + 1e-9
