"""What lies below a ball in the air, at both sides of every edge, and when it is beyond the rails."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.billiards.flight import plans, region
from game.billiards.laws.state import (
    FLOAT_ROWS,
    FREE_LEFT,
    FREE_LOWER,
    FREE_RIGHT,
    FREE_UPPER,
    NEVER,
    PHYSICS_COLUMNS,
    VX,
    VY,
    X,
    Y,
)
from game.billiards.table.table import CUSHION_DEPTH, RAIL_WIDTH
from game.compiler.decorator import lean_kernel


class Elements(NamedTuple):
    """As the kernels see a table."""

    cushions: np.ndarray
    jaws: np.ndarray
    pockets: np.ndarray


@lean_kernel
def below(x, y, elements, physics):
    """The inner kernels, with an entrance."""
    return region.is_over_bed(x, y, elements, physics), region.pocket_below(x, y, elements.pockets)


@lean_kernel
def edge_time(state, i, horizon, physics):
    """The inner kernel, with an entrance."""
    return plans._edge_time(state, i, horizon, physics)


PHYSICS = np.zeros(PHYSICS_COLUMNS)
PHYSICS[[FREE_LEFT, FREE_RIGHT, FREE_LOWER, FREE_UPPER]] = -0.5, 0.6, -1.0, 1.2
# a cushion along the right edge between two mouths, a jaw beside each, a pocket in the upper right corner
TABLE = Elements(
    np.array([[0.6, -0.8, 0.6, 0.9, -1.0, 0.0, 1.0]]),
    np.array([[0.62, 0.95, 0.02], [0.62, -0.85, 0.02]]),
    np.array([[0.65, 1.25, 0.06], [0.65, -1.05, 0.06]]),
)
WITHOUT = Elements(TABLE.cushions, TABLE.jaws, np.zeros((0, 3)))
TINY = 1e-9


@pytest.mark.parametrize(
    ("x", "y", "bed", "pocket"),
    [  # farther out than a cushion is deep there is a hole or wood, no bed
        (0.6, 0.0, True, -1),
        (0.6 + TINY, 0.0, False, -1),
        (0.6 + 0.01, 0.9, False, -1),
        (0.6 + 0.01, 0.9 + TINY, True, -1),  # past the cushion's end: the mouth
        (0.6 + 0.01, -0.8 - TINY, True, -1),
        (0.62, 0.95 + 0.02 - TINY, False, -1),  # on a jaw
        (0.62, 0.95 + 0.02 + TINY, True, -1),
        (0.6 + CUSHION_DEPTH - TINY, 1.0, True, -1),
        (0.6 + CUSHION_DEPTH + TINY, 1.0, False, -1),
        (0.65, 1.25 - 0.06 + TINY, False, 0),
        (0.65, 1.25 - 0.06 - TINY, False, -1),
        (0.65 - 0.06 + TINY, -1.05, False, 1),
        (-0.5, 0.0, True, -1),
        (0.0, 1.2, True, -1),
        (0.0, -1.0, True, -1),
    ],
)
def test_bed_cushion_mouth_and_hole_have_their_edges(x, y, bed, pocket):
    assert below(x, y, TABLE, PHYSICS) == (bed, pocket)


def test_without_pockets_there_is_bed_between_the_noses_only():
    for x, y, bed in (
        (0.6, 0.0, True), (0.6 + TINY, 1.0, False), (-0.5, 0.0, True), (-0.5 - TINY, 0.0, False),
        (0.0, 1.2, True), (0.0, 1.2 + TINY, False), (0.0, -1.0, True), (0.0, -1.0 - TINY, False),
    ):  # fmt: skip
        assert below(x, y, WITHOUT, PHYSICS) == (bed, -1)


@pytest.mark.parametrize(
    ("place", "velocity", "expected"),
    [
        ((0.1, 0.2), (2.0, 0.0), (0.6 + RAIL_WIDTH - 0.1) / 2.0),
        ((0.1, 0.2), (-2.0, 0.0), (0.1 + 0.5 + RAIL_WIDTH) / 2.0),
        ((0.1, 0.2), (0.0, 4.0), (1.2 + RAIL_WIDTH - 0.2) / 4.0),
        ((0.1, 0.2), (0.0, -4.0), (0.2 + 1.0 + RAIL_WIDTH) / 4.0),
        ((0.1, 0.2), (1.0, 4.0), (1.2 + RAIL_WIDTH - 0.2) / 4.0),  # the earlier of two
        ((0.1, 0.2), (4.0, 1.0), (0.6 + RAIL_WIDTH - 0.1) / 4.0),
        ((0.1, 0.2), (0.0, 0.0), NEVER),
    ],
)
def test_a_ball_is_off_the_table_when_its_centre_is_beyond_a_rail(place, velocity, expected):
    state = np.zeros((FLOAT_ROWS, 2))
    state[[X, Y], 1], state[[VX, VY], 1] = place, velocity
    assert edge_time(state, 1, 5.0, PHYSICS) == pytest.approx(expected, rel=1e-12)
    if expected < NEVER:
        assert edge_time(state, 1, expected * (1.0 + 1e-9), PHYSICS) < NEVER
        assert edge_time(state, 1, expected * (1.0 - 1e-9), PHYSICS) == NEVER
