"""One box or one capsule round a set of points: by degrees as the course says, refined, and exactly."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.physics.bounds import building
from game.physics.bounds.building import Fit, fit_scratch, fit_volume
from game.physics.bounds.hull import hull_of
from game.physics.bounds.least_capsule import (
    CELLS,
    TOLERANCE,
    diameter_bound,
    polish,
    prove_least,
    try_axis,
    write_shortest,
)
from game.physics.bounds.validation import as_points, as_step, turns_of
from game.physics.kernels import elementary, linear

POLISHING = 4  # rounds of nested golden section, each about the best of the last
POLISHED_ANGLE = math.radians(1.0)  # on both sides of the best direction, in the first round
ROUNDING = 1e-12  # of the extent, that a point may lie outside of its volume


class Box(NamedTuple):
    """An oriented box. centre m; axis: unit vector along the longer side; half: its half lengths, m."""

    centre: tuple[float, float]
    axis: tuple[float, float]
    half: tuple[float, float]

    @property
    def area(self) -> float:
        """m²."""
        return 4.0 * self.half[0] * self.half[1]

    def corners(self) -> Floats:
        """Corners (4, 2), counter-clockwise, m."""
        return np.asarray(corners_of(np.array([(*self.centre, *self.axis, *self.half)]))[0])

    def outside(self, points: ArrayLike) -> Floats:
        """How far points (n, 2) lie beyond the nearest side, m; 0 or less inside."""
        off = np.asarray(points, dtype=np.float64).reshape(-1, 2) - self.centre
        c, s = self.axis
        along, across = (
            np.abs(linear.product(off, (c, s))) - self.half[0],
            np.abs(linear.product(off, (-s, c))) - self.half[1],
        )
        return np.maximum(along, across)


class Capsule(NamedTuple):
    """All points within ``radius`` (m) of the core from ``start`` to ``end`` (m)."""

    start: tuple[float, float]
    end: tuple[float, float]
    radius: float

    @property
    def length(self) -> float:
        """Length of the core, m."""
        dx, dy = self.end[0] - self.start[0], self.end[1] - self.start[1]
        return math.sqrt(dx * dx + dy * dy)

    @property
    def area(self) -> float:
        """m²."""
        return 2.0 * self.radius * self.length + math.pi * (self.radius * self.radius)

    def outside(self, points: ArrayLike) -> Floats:
        """Distance of points (n, 2) from the core less the radius, m; 0 or less inside."""
        off = np.asarray(points, dtype=np.float64).reshape(-1, 2) - self.start
        way = np.array(self.end) - self.start
        square = float(linear.product(way, way))
        share = np.clip(linear.product(off, way) / square, 0.0, 1.0) if square > 0.0 else np.zeros(len(off))
        rest = off - share[:, None] * way
        return np.sqrt((rest * rest).sum(axis=1)) - self.radius


def corners_of(rows: Floats) -> Floats:
    """Corners (m, 4, 2) of boxes (m, 6), counter-clockwise, m."""
    along = rows[:, None, 2:4]
    across = np.stack((-along[..., 1], along[..., 0]), axis=-1)
    u, v = np.array((-1.0, 1.0, 1.0, -1.0))[:, None], np.array((-1.0, -1.0, 1.0, 1.0))[:, None]
    return np.asarray(rows[:, None, 0:2] + u * rows[:, None, 4:5] * along + v * rows[:, None, 5:6] * across)


def fit_row(points: Floats, kind: int, fit: int, step_degrees: float) -> NDArray[np.float64]:
    """Row (6,) of the volume of checked points (n, 2)."""
    hull, origin = hull_of(points)
    volumes = np.zeros((1, 6))
    x, y = origin.tolist()
    step = math.radians(step_degrees)
    turns = turns_of(step_degrees)
    fit_volume(Fit(kind, fit, turns, step), hull, len(hull), x, y, volumes, 0, fit_scratch(len(turns)))
    return volumes[0]


def box_of(row: ArrayLike) -> Box:
    """A row (6,) as a box: middle m, unit vector along it, half sides m."""
    x, y, c, s, a, b = np.asarray(row).tolist()
    return Box((x, y), (c, s), (a, b))


def capsule_of(row: ArrayLike) -> Capsule:
    """A row (6,) as a capsule: both ends of its core and its radius, m; the last number is not used."""
    ax, ay, bx, by, radius, _ = np.asarray(row).tolist()
    return Capsule((ax, ay), (bx, by), radius)


def fit_obb(points: ArrayLike, step_degrees: float = 1.0, *, refine: bool = False) -> Box:
    """The box of least area among those turned by multiples of a step; the first of equal ones.

    points (n, 2) m; each axis pair is turned from 0 to below 90 degrees, the points are projected, the
    centre is the middle of the projections. ``refine``: the best angle is improved by golden section. With a
    best rectangle of aspect a and a step of 2 δ the area is within 1 + (a + 1/a) sin(2 δ) / 2 of the least.
    """
    fit = building.REFINED if refine else building.SEARCH
    return box_of(fit_row(as_points(points), building.OBB, fit, as_step(step_degrees)))


def minimal_obb(points: ArrayLike) -> Box:
    """The box of least area round points (n, 2) m, by rotating calipers (Freeman and Shapira 1975)."""
    return box_of(fit_row(as_points(points), building.OBB, building.EXACT, 1.0))


def upright_box(points: ArrayLike) -> Box:
    """The box of points (n, 2) m whose sides are upright and level."""
    return box_of(fit_row(as_points(points), building.AABB, building.SEARCH, 1.0))


def principal_box(points: ArrayLike) -> Box:
    """The box of points (n, 2) m on the axes of their greatest and least variance: quick, not small."""
    given = as_points(points)
    off = given - given.mean(axis=0)
    xx, xy, yy = (
        float(linear.product(off[:, 0], off[:, 0])),
        float(linear.product(off[:, 0], off[:, 1])),
        float(linear.product(off[:, 1], off[:, 1])),
    )
    angle = 0.5 * elementary.atan2(2.0 * xy, xx - yy)
    c, s = elementary.cos(angle), elementary.sin(angle)
    along, across = linear.product(off, (c, s)), linear.product(off, (-s, c))
    u, v = 0.5 * (along.max() + along.min()), 0.5 * (across.max() + across.min())
    x, y = given.mean(axis=0).tolist()
    half = 0.5 * float(np.ptp(along)), 0.5 * float(np.ptp(across))
    return Box((x + c * u - s * v, y + s * u + c * v), (c, s), half)


def thinnest_box(points: ArrayLike) -> Box:
    """The box of least breadth round points (n, 2) m, by rotating calipers; seldom that of least area."""
    return box_of(fit_row(as_points(points), building.OBB, building.THINNEST, 1.0))


def fit_capsule(points: ArrayLike, step_degrees: float = 1.0, *, refine: bool = False) -> Capsule:
    """The capsule of least area whose core lies along a multiple of a step, in the middle of the projection.

    points (n, 2) m. Its radius is half of the breadth, its core as short as the round ends allow.
    ``refine``: the best angle is improved by golden section.
    """
    fit = building.REFINED if refine else building.SEARCH
    return capsule_of(fit_row(as_points(points), building.CAPSULE, fit, as_step(step_degrees)))


def thinnest_capsule(points: ArrayLike) -> Capsule:
    """The capsule of least radius round points (n, 2) m, with the shortest core for it, by calipers."""
    return capsule_of(fit_row(as_points(points), building.CAPSULE, building.THINNEST, 1.0))


def near_least_capsule(points: ArrayLike) -> Capsule:
    """A capsule round points (n, 2) m whose area is within 1e-3 of the least: a tree's exact fit."""
    return capsule_of(fit_row(as_points(points), building.CAPSULE, building.EXACT, 1.0))


def least_capsule(points: ArrayLike, tolerance: float = TOLERANCE) -> tuple[Capsule, float]:
    """The capsule of least area round points (n, 2) m, and a proven lower bound of that area, m².

    The bound is within ``tolerance`` of the area; the capsule itself, polished, is mostly much nearer to the
    least. ValueError for what are no points, or a tolerance not between 1e-6 and 0.5.
    """
    given = as_points(points)
    if not 1e-6 <= tolerance <= 0.5:
        raise ValueError(f"tolerance: expected 1e-6 to 0.5, not {tolerance!r}")
    hull, origin = hull_of(given)
    h = len(hull)
    start = capsule_of(fit_row(given, building.CAPSULE, building.REFINED, 1.0))
    thin = thinnest_capsule(given)
    if h <= 2 or thin.radius <= 0.0:
        return thin, thin.area
    best = np.array((math.inf, 0.0, 0.0))
    for capsule in (start, thin):
        dx, dy = capsule.end[0] - capsule.start[0], capsule.end[1] - capsule.start[1]
        length = elementary.hypot(dx, dy)
        try_axis(hull, h, dx / length if length else 1.0, dy / length if length else 0.0, best)
    polish(hull, h, POLISHED_ANGLE, 0.1 * best[2], thin.radius, best)
    bound = float(
        prove_least(hull, h, thin.radius, diameter_bound(hull, h), tolerance, np.empty((CELLS, 4)), best)
    )
    radius_range = 0.1 * best[2]
    for i in range(POLISHING):
        finer = elementary.pow(0.1, i)
        polish(hull, h, POLISHED_ANGLE * finer, radius_range * finer, thin.radius, best)
    row = np.zeros((1, 6))
    write_shortest(hull, h, best[1], best[2], *origin.tolist(), row, 0)
    found = min((capsule_of(row[0]), start, thin), key=lambda capsule: capsule.area)
    return found, min(bound, found.area)


def minimal_capsule(points: ArrayLike) -> Capsule:
    """The capsule of least area round points (n, 2) m; see `least_capsule` for how that is proven."""
    return least_capsule(points)[0]
