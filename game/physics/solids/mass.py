"""Mass, centre and inertia of shapes of even density, by Green's theorem; rounding counts exactly.

A convex polygon with a rounding radius is its core, a rectangle on each edge, and a sector at each corner.
All sectors together are one disc, moved apart.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary


class Mass(NamedTuple):
    """mass kg, centre (x, y) m, inertia about the centre kg m²."""

    mass: float
    centre: tuple[float, float]
    inertia: float


def joined(parts: list[Mass]) -> Mass:
    """Of several parts taken as one body (parallel axes); all zero for none."""
    mass = math.fsum(part.mass for part in parts)
    if not mass > 0.0:
        return Mass(0.0, (0.0, 0.0), 0.0)
    x = math.fsum(part.mass * part.centre[0] for part in parts) / mass
    y = math.fsum(part.mass * part.centre[1] for part in parts) / mass
    inertia = math.fsum(
        part.inertia
        + part.mass * (elementary.square(part.centre[0] - x) + elementary.square(part.centre[1] - y))
        for part in parts
    )
    return Mass(mass, (x, y), inertia)


def polygon_mass(corners: NDArray[np.float64], density: float = 1.0) -> Mass:
    """Of a simple polygon (n, 2) m, anticlockwise or clockwise, without rounding; density kg/m²."""
    middle = corners.mean(axis=0)
    p = corners - middle
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1]
    area = 0.5 * float(cross.sum())
    if area == 0.0:
        return Mass(0.0, (float(middle[0]), float(middle[1])), 0.0)
    centre = (cross[:, None] * (p + q)).sum(axis=0) / (6.0 * area)
    about_middle = float((cross * ((p * p).sum(1) + (p * q).sum(1) + (q * q).sum(1))).sum()) / 12.0
    inertia = abs(about_middle) - abs(area) * (
        elementary.square(float(centre[0])) + elementary.square(float(centre[1]))
    )
    x, y = (middle + centre).tolist()
    return Mass(density * abs(area), (x, y), density * inertia)


def disc_mass(centre: tuple[float, float], radius: float, density: float = 1.0) -> Mass:
    """Of a disc of radius m about a centre m; density kg/m²."""
    mass = density * math.pi * radius * radius
    return Mass(mass, centre, 0.5 * mass * radius * radius)


def rounded_mass(corners: NDArray[np.float64], radius: float, density: float = 1.0) -> Mass:
    """Of a convex hull of corners (n, 2) m, anticlockwise, grown by a radius m; density kg/m²."""
    if len(corners) == 1:
        return disc_mass((float(corners[0, 0]), float(corners[0, 1])), radius, density)
    parts = [polygon_mass(corners, density)] if len(corners) > 2 else []
    if radius > 0.0:
        for i, start in enumerate(corners):
            end = corners[(i + 1) % len(corners)]
            along = end - start
            length = elementary.hypot(along[0], along[1])
            out = np.array([along[1], -along[0]]) / length * radius
            parts.append(polygon_mass(np.array([start, start + out, end + out, end]), density))
            before = start - corners[i - 1]
            parts.append(_sector(start, before, along, radius, density))
    return joined(parts)


def _sector(
    corner: NDArray[np.float64], before: NDArray[np.float64], after: NDArray[np.float64], r: float, d: float
) -> Mass:
    """Of the sector of a disc at a corner, between the outward normals of the edges before and after."""
    turn = elementary.atan2(
        before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1]
    )
    if turn <= 0.0 and before[0] * after[0] + before[1] * after[1] < 0.0:
        turn = math.pi  # the end of a capsule
    half = 0.5 * turn
    if half <= 0.0:
        return Mass(0.0, (float(corner[0]), float(corner[1])), 0.0)
    first = elementary.atan2(-before[0], before[1])  # direction of the outward normal of the edge before
    mass = d * half * r * r
    out = 2.0 * r * elementary.sin(half) / (3.0 * half)
    centre = (corner[0] + out * elementary.cos(first + half), corner[1] + out * elementary.sin(first + half))
    return Mass(mass, (float(centre[0]), float(centre[1])), mass * (0.5 * r * r - out * out))
