"""An arch of voussoirs: half a ring without gaps, its own mirror image, standing on both ends."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from game.scenes.solids.level import ArchEntry, SolidContent
from game.scenes.solids.structures import make

RADIUS, THICKNESS = 3.0, 0.7


def stones(blocks: int) -> list[np.ndarray]:
    """Corners (4, 2) m of each stone, as they stand in the world."""
    arch = ArchEntry(at=(1.5, -0.5), radius=RADIUS, thickness=THICKNESS, blocks=blocks)
    bodies = make(SolidContent(arches=(arch,)), 1).bodies
    return [np.array(body.shapes[0].polygon) + body.position for body in bodies]


@pytest.mark.parametrize("blocks", [3, 4, 11, 30])
def test_an_arch_is_half_a_ring(blocks):
    placed = stones(blocks)
    assert len(placed) == blocks
    away = np.concatenate(placed) - (1.5, -0.5)
    reach = np.hypot(*away.T)
    near = np.abs(reach - RADIUS + 0.5 * THICKNESS) < 1e-9
    far = np.abs(reach - RADIUS - 0.5 * THICKNESS) < 1e-9
    assert (near | far).all() and near.sum() == far.sum() == 2 * blocks
    assert away[:, 1].min() > -1e-9 and (np.abs(away[:, 1]) < 1e-9).sum() == 4  # its two ends
    turn = math.sin(0.5 * math.pi / blocks)
    outer, inner = RADIUS + 0.5 * THICKNESS, RADIUS - 0.5 * THICKNESS
    for stone in placed:
        x, y = stone.T
        area = 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))
        assert abs(area) == pytest.approx((outer**2 - inner**2) * turn * math.cos(0.5 * math.pi / blocks))


@pytest.mark.parametrize("blocks", [3, 4, 11])
def test_neighbours_share_two_corners_and_the_whole_is_its_mirror_image(blocks):
    placed = stones(blocks)
    for one, other in pairwise(placed):
        gaps = np.hypot(*(one[:, None] - other[None]).transpose(2, 0, 1))
        assert (gaps < 1e-9).sum() == 2
    corners = np.concatenate(placed)
    mirrored = np.column_stack([3.0 - corners[:, 0], corners[:, 1]])
    gaps = np.hypot(*(corners[:, None] - mirrored[None]).transpose(2, 0, 1))
    assert gaps.min(axis=1).max() < 1e-9
