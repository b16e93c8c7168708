"""Outlines that go into the tunnel: named ones and drawn ones, checked, about their own middle.

An outline's own axes: the chord lies along x, and the wind of a tunnel comes along +x at an angle of attack
of 0, so the nose is at the left. Its place is the centroid of its area; moments are taken about it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.kernels import elementary, elementwise
from game.physics.solids.outlines import clean_outline, signed_area
from game.physics.surfaces.surface import Sample, empty_sample

SHAPES = ("disc", "square", "plate", "aerofoil", "leaf")
ROUND = 64  # corners of a disc
THIN = 0.08  # of the chord: thickness of plate and leaf
CAMBER = 0.14  # of the chord: how far a leaf is arched
MOST_CORNERS = 400
LEAST_CHORD, MOST_CHORD = 1e-3, 1e3  # m
ON_IT = 1e-9  # of an edge: how near a point lies on it, and has the edge's normal
ALIKE = 1e-6  # of the chord: corners that close are one


class TunnelOutline(NamedTuple):
    """corners (n, 2) m about the centroid, anticlockwise; chord m, by which coefficients are made; area m².

    mirrored: it is its own image in the chord line; turned: half a turn leaves it as it is.
    """

    corners: Floats
    chord: float
    area: float
    mirrored: bool
    turned: bool

    @property
    def reach(self) -> float:
        """m from the centroid to the farthest corner."""
        return float(np.max(elementwise.hypot(self.corners[:, 0], self.corners[:, 1])))

    @property
    def thickness(self) -> float:
        """beta = b/a of the ellipse of this chord and area, at most 1."""
        return min(1.0, self.area / (0.25 * math.pi * self.chord * self.chord))

    def placed(self, attack: float, at: tuple[float, float]) -> Floats:
        """Corners (n, 2) m with the nose raised by an angle of attack (rad), the centroid at a place (m)."""
        c, s = elementary.cos(attack), -elementary.sin(attack)
        x, y = self.corners[:, 0], self.corners[:, 1]
        return np.stack([at[0] + (c * x - s * y), at[1] + (s * x + c * y)], axis=1)

    def width(self, attack: float) -> float:
        """m that it covers across the wind."""
        return float(np.ptp(self.placed(attack, (0.0, 0.0))[:, 1]))


def outline_of(points: ArrayLike, chord: float = 0.0) -> TunnelOutline:
    """An outline through points (n, 2) m, whichever way round. chord: m, 0: the longest way across.

    ValueError, in one line, for what encloses no area, crosses itself, has too many corners or no length.
    """
    corners = clean_outline("shape", points)
    if len(corners) > MOST_CORNERS:
        raise ValueError(f"shape: {len(corners)} corners, expected at most {MOST_CORNERS}")
    area = signed_area(corners)
    corners = corners - _centroid(corners, area)
    apart = corners[:, None] - corners[None]
    longest = math.sqrt(float(np.max((apart * apart).sum(axis=2))))
    length = chord or longest
    if not LEAST_CHORD <= length <= MOST_CHORD or length > 2.0 * longest:
        raise ValueError(f"shape: chord = {length:g} m, expected {LEAST_CHORD:g} to {MOST_CHORD:g}")
    mirrored = _alike(corners, corners * (1.0, -1.0), ALIKE * length)
    turned = _alike(corners, -corners, ALIKE * length)
    return TunnelOutline(np.ascontiguousarray(corners), length, area, mirrored, turned)


def _centroid(corners: Floats, area: float) -> Floats:
    p = corners - corners[0]
    q = np.roll(p, -1, axis=0)
    cross = (p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1])[:, None]
    return np.asarray(corners[0] + ((p + q) * cross).sum(axis=0) / (6.0 * area))


def _alike(corners: Floats, images: Floats, near: float) -> bool:
    """Whether each image lies on some corner."""
    apart = corners[:, None] - images[None]
    return bool((np.sqrt((apart * apart).sum(axis=2)).min(axis=0) <= near).all())


def shape_named(name: str, chord: float = 1.0) -> TunnelOutline:
    """One of SHAPES; ValueError for others. An aerofoil is NACA's 4412 (Jacobs, Ward and Pinkerton 1933)."""
    if name == "disc":
        turn = 2.0 * math.pi * np.arange(ROUND) / ROUND
        return outline_of(
            0.5 * chord * np.stack([elementwise.cos(turn), elementwise.sin(turn)], axis=1), chord
        )
    if name == "square":
        half = 0.5 * chord
        return outline_of([(-half, -half), (half, -half), (half, half), (-half, half)], chord)
    if name == "plate":
        half, thin = 0.5 * chord, 0.5 * THIN * chord
        return outline_of([(-half, -thin), (half, -thin), (half, thin), (-half, thin)], chord)
    if name == "aerofoil":
        return outline_of(chord * _naca(0.04, 0.4, 0.12), chord)
    if name == "leaf":
        return outline_of(chord * _arched(), chord)
    raise ValueError(f"shape = {name!r}: expected one of {', '.join(SHAPES)}")


def _naca(camber: float, place: float, thick: float, count: int = 24) -> Floats:
    """Corners of a four-digit aerofoil of chord 1, with a closed trailing edge."""
    x = 0.5 - 0.5 * elementwise.cos(math.pi * np.arange(count + 1) / count)
    x2 = x * x
    half = 5.0 * thick * (
        0.2969 * np.sqrt(x) - 0.1260 * x - 0.3516 * x2 + 0.2843 * (x2 * x) - 0.1036 * (x2 * x2)
    )  # fmt: skip
    front = camber / (place * place) * (2.0 * place * x - x2)
    rest = camber / ((1.0 - place) * (1.0 - place)) * (1.0 - 2.0 * place + 2.0 * place * x - x2)
    middle = np.where(x < place, front, rest)
    over, under = np.stack([x, middle + half], axis=1), np.stack([x, middle - half], axis=1)
    return np.concatenate([under[:-1], over[:0:-1]])


def _arched(count: int = 16) -> Floats:
    """A leaf: a strip along a parabola, pointed at both ends."""
    x = np.linspace(-0.5, 0.5, count + 1)
    up = CAMBER * (1.0 - 4.0 * x * x)
    half = 0.5 * THIN * np.sqrt(np.clip(1.0 - 4.0 * x * x, 0.0, 1.0))
    under = np.stack([x, up - half], axis=1)
    over = np.stack([x, up + half], axis=1)
    return np.concatenate([under, over[-2:0:-1]])


@kernel
def outline_distances(corners, points, found):
    """Write (n, 3): signed distance (m, negative inside) of points (n, 2) m, and the outward normal."""
    count = corners.shape[0]
    for k in range(points.shape[0]):
        x, y = points[k, 0], points[k, 1]
        best, bx, by, inside = math.inf, 0.0, 0.0, False
        ax, ay = corners[count - 1, 0], corners[count - 1, 1]
        ex, ey = 1.0, 0.0
        for i in range(count):
            cx, cy = corners[i, 0], corners[i, 1]
            wx, wy = cx - ax, cy - ay
            along = ((x - ax) * wx + (y - ay) * wy) / (wx * wx + wy * wy)
            along = min(max(along, 0.0), 1.0)
            dx, dy = x - (ax + along * wx), y - (ay + along * wy)
            squared = dx * dx + dy * dy
            if squared < best:
                best, bx, by, ex, ey = squared, dx, dy, wx, wy
            if (ay > y) != (cy > y) and x < ax + (y - ay) / (cy - ay) * (cx - ax):
                inside = not inside
            ax, ay = cx, cy
        far = math.sqrt(best)
        sign = -1.0 if inside else 1.0
        found[k, 0] = sign * far
        if far > ON_IT * math.sqrt(ex * ex + ey * ey):
            found[k, 1], found[k, 2] = sign * bx / far, sign * by / far
        else:
            length = math.sqrt(ex * ex + ey * ey)
            found[k, 1], found[k, 2] = ey / length, -ex / length


class PlacedOutline:
    """Corners (n, 2) m in the world as a solid at rest, of a grid of gas."""

    def __init__(self, corners: Floats):
        self.corners = np.ascontiguousarray(corners)

    def distances(self, points: Floats) -> Floats:
        """(n, 3): signed distance m, and outward normal, at points (n, 2) m."""
        found = np.empty((len(points), 3))
        outline_distances(self.corners, np.ascontiguousarray(points), found)
        return found

    def sample(self, points: ArrayLike) -> Sample:
        """As solids of `physics.surfaces` answer."""
        places = np.asarray(points, dtype=np.float64).reshape(-1, 2)
        near, found = self.distances(places), empty_sample(len(places))
        found.distance[:], found.normal[:], found.body[:] = near[:, 0], near[:, 1:], 0
        return found
