"""Exact times of descent from rest, of a ball that rolls without slip: its centre follows the curve.

Each curve begins at (0, 0) and goes through (width, -depth), m. share: k = I/(m r²); 0 for a bead that slides
without friction. gravity m/s². ValueError where nothing would move or the curve does not go there.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise

NODES = 64  # of the quadrature, whose integrand is smooth


def cycloid_through(width: float, depth: float) -> tuple[float, float]:
    """Radius (m) of the wheel and its angle (rad) at the end, of the cycloid with its cusp at the start."""
    low, high = 1e-9, 2.0 * math.pi - 1e-9
    for _ in range(100):
        middle = 0.5 * (low + high)
        if (middle - elementary.sin(middle)) * depth < width * (1.0 - elementary.cos(middle)):
            low = middle
        else:
            high = middle
    end = 0.5 * (low + high)
    return depth / (1.0 - elementary.cos(end)), end


def arc_radius(width: float, depth: float) -> float:
    """Radius (m) of the circle that begins upright."""
    return (width * width + depth * depth) / (2.0 * width)


def line_time(width: float, depth: float, gravity: float, share: float = 0.0) -> float:
    """s, along the straight line (Galilei 1638)."""
    _check(width, depth, gravity, share)
    return math.sqrt(2.0 * (1.0 + share) * (width * width + depth * depth) / (gravity * depth))


def cycloid_time(width: float, depth: float, gravity: float, share: float = 0.0) -> float:
    """s, along the cycloid: the least of all (Johann Bernoulli 1696)."""
    _check(width, depth, gravity, share)
    wheel, end = cycloid_through(width, depth)
    return end * math.sqrt((1.0 + share) * wheel / gravity)


def arc_time(width: float, depth: float, gravity: float, share: float = 0.0) -> float:
    """s, along the arc of a circle that begins upright: the integral of dφ / sqrt(sin φ), with φ = u²."""
    _check(width, depth, gravity, share)
    radius = arc_radius(width, depth)
    end = math.sqrt(elementary.atan2(depth, radius - width))
    nodes, weights = _quadrature()
    u = 0.5 * end * (nodes + 1.0)
    total = 0.5 * end * float((weights * 2.0 * u / np.sqrt(elementwise.sin(u * u))).sum())
    return math.sqrt(0.5 * (1.0 + share) * radius / gravity) * total


def rolling_acceleration(slope: float, gravity: float, share: float) -> float:
    """m/s² of the centre down an incline of ``slope`` rad, while it does not slip: g sin / (1 + k)."""
    return gravity * elementary.sin(slope) / (1.0 + share)


def loop_drop(radius: float, ball: float, share: float) -> float:
    """Least drop (m) of the centre for a loop of ``radius`` m and a ball of ``ball`` m that does not slip: at
    the top its weight alone keeps it on the circle (Huygens 1673). NaN: it does not fit into the loop.
    """
    if ball >= radius:
        return math.nan
    return 0.5 * (5.0 + share) * (radius - ball)


def leaving_angle(drop: float, radius: float, ball: float, share: float) -> float:
    """Angle (rad from upright) at which a ball that does not slip leaves a loop of ``radius`` m, its centre
    having begun ``drop`` m above the foot: where the push of the track becomes zero. NaN: it goes round,
    never comes above the middle, or does not fit into the loop.
    """
    if ball >= radius:
        return math.nan
    cosine = (2.0 * drop / (radius - ball) - 2.0) / (3.0 + share)
    return elementary.acos(cosine) if 0.0 <= cosine < 1.0 else math.nan


def crossing_share(x0: float, x1: float, way0: float, way1: float, level: float) -> float:
    """Part of a step (0 to 1) after which a motion from x0 to x1 passes a level: on the cubic that begins and
    ends at its speeds (way0, way1: m in a step).
    """
    s = (level - x0) / (x1 - x0)
    for _ in range(4):
        a, b = way0 + way1 - 2.0 * (x1 - x0), 3.0 * (x1 - x0) - 2.0 * way0 - way1
        off = x0 + s * (way0 + s * (b + s * a)) - level
        slope = way0 + s * (2.0 * b + 3.0 * s * a)
        if slope * (x1 - x0) <= 0.0:
            break
        s = min(max(s - off / slope, 0.0), 1.0)
    return s


@lru_cache(maxsize=1)
def _quadrature() -> tuple[Floats, Floats]:
    """Nodes and weights of Gauss and Legendre."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    return nodes, weights


def _check(width: float, depth: float, gravity: float, share: float) -> None:
    for name, value in (("width", width), ("depth", depth), ("gravity", gravity)):
        if not 0.0 < value < math.inf:
            raise ValueError(f"{name} = {value!r}: expected a number above 0")
    if not 0.0 <= share <= 1.0:
        raise ValueError(f"share = {share!r}: expected 0 to 1")
