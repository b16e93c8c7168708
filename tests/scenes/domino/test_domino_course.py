"""The floor of the course: heights and slopes, beyond its ends as well."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.domino.course import height_at

FLOOR = np.array([(0.0, 1.0), (2.0, 2.0), (2.0, 1.5), (4.0, 1.5), (5.0, 0.5)])  # up, a step down, level, down


@pytest.mark.parametrize(
    ("x", "height", "slope"),
    [
        (-1.0, 1.0, math.atan(0.5)), (0.0, 1.0, math.atan(0.5)), (1.0, 1.5, math.atan(0.5)),
        (2.0, 1.5, 0.0), (3.0, 1.5, 0.0), (4.25, 1.25, -math.pi / 4), (9.0, 0.5, -math.pi / 4),
    ],
)  # fmt: skip
def test_height_and_slope(x, height, slope):
    assert height_at(FLOOR, x) == pytest.approx((height, slope))
