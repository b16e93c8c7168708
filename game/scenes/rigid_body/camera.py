"""How the rigid body scene is looked at: along parallel rays, turned about the vertical and tilted."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, linear

HOME = (-20.0, 12.0)  # degrees, turn and tilt for which the whole box is in view


def camera_matrix(turn: float, tilt: float) -> Floats:
    """(3, 3) whose rows are, in the world's frame, the picture's right, up, and the direction to the viewer.

    turn, tilt: degrees; tilt above 0 looks from above.
    """
    a, t = math.radians(turn), math.radians(tilt)
    ca, sa, ct, st = elementary.cos(a), elementary.sin(a), elementary.cos(t), elementary.sin(t)
    return np.array(((ca, 0.0, sa), (sa * st, ct, -ca * st), (-sa * ct, st, ca * ct)))


def hit_sphere(
    view: Floats, places: Floats, radii: Floats, point: tuple[float, float]
) -> tuple[int, Floats] | None:
    """The foremost sphere at a point of the picture and the place (3,) m on its surface; None beside all.

    view: of `camera_matrix`; places (n, 3) m; point: picture coordinates, m.
    """
    seen = linear.product(places, view.T)
    off = elementary.square(seen[:, 0] - point[0]) + elementary.square(seen[:, 1] - point[1])
    inside = off <= radii * radii
    if not inside.any():
        return None
    near = np.where(inside, seen[:, 2] + np.sqrt(np.maximum(radii * radii - off, 0.0)), -np.inf)
    index = int(np.argmax(near))
    return index, linear.product(view.T, np.array((point[0], point[1], near[index])))


def on_plane(view: Floats, center: Floats, point: tuple[float, float]) -> Floats:
    """The place (3,) m at a point of the picture in the plane across the view through ``center``."""
    return linear.product(view.T, np.array((point[0], point[1], float(linear.product(view[2], center)))))


def box_edges(half: Floats) -> Floats:
    """(12, 2, 3): the edges of a box about the origin."""
    edges = []
    for axis in range(3):
        others = [k for k in range(3) if k != axis]
        for s in (-1.0, 1.0):
            for t in (-1.0, 1.0):
                ends = np.zeros((2, 3))
                ends[:, axis] = (-half[axis], half[axis])
                ends[:, others[0]], ends[:, others[1]] = s * half[others[0]], t * half[others[1]]
                edges.append(ends)
    return np.array(edges)
