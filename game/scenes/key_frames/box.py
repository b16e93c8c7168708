"""Corners and handle of the box, from its pose alone."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise
from game.scenes.key_frames.level import Point

ARM = 0.45  # m beyond the box's end: where the handle is that turns it
UNIT_BOX = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])


def box_corners(
    poses: Sequence[float] | Sequence[Sequence[float]] | Floats, box: tuple[float, float]
) -> Floats:
    """Corners (4, 2) of a box of width and height at a pose x, y, angle; (k, 4, 2) at poses (k, 3)."""
    x, y, angle = np.moveaxis(np.asarray(poses, dtype=np.float64), -1, 0)[..., None]
    cos, sin = elementwise.cos(angle), elementwise.sin(angle)
    along, across = (UNIT_BOX * box).T
    return np.stack((x + cos * along - sin * across, y + sin * along + cos * across), axis=-1)


def turning_handle(box: tuple[float, float], x: float, y: float, angle: float) -> Point:
    """Where the handle is that turns a box of this width and height (m) with this pose (m, rad)."""
    arm = 0.5 * box[0] + ARM
    return x + arm * elementary.cos(angle), y + arm * elementary.sin(angle)


def is_inside(point: Point, pose: Sequence[float], box: tuple[float, float]) -> bool:
    """Whether a point is in a box of width and height (m) at a pose x, y, angle."""
    x, y, angle = pose
    along = elementary.cos(angle) * (point[0] - x) + elementary.sin(angle) * (point[1] - y)
    across = elementary.cos(angle) * (point[1] - y) - elementary.sin(angle) * (point[0] - x)
    return abs(along) <= 0.5 * box[0] and abs(across) <= 0.5 * box[1]
