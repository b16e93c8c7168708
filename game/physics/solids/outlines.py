"""Outlines of polygons: checked and cleaned, their area, whether they are convex, and cut into convex parts.

Cutting: ears (Meisters 1975), then triangles are joined again over diagonals that no corner needs (Hertel,
Mehlhorn 1983: at most four times the least number of parts).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.kernels import elementary
from game.physics.solids.arrays.state import MOST_CORNERS

LARGEST = 1e6  # m
MERGED = 1e-9  # of the extent: closer corners are one
STRAIGHT = 1e-12  # of the squared extent: a corner that turns less is none


def checked_points(name: str, points: ArrayLike, least: int) -> Floats:
    """Finite points (n, 2) m, n at least ``least``, or ValueError."""
    try:
        array = np.array(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected points (x, y)") from None
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"{name}: expected points (x, y)")
    if not (np.abs(array) <= LARGEST).all():
        raise ValueError(f"{name}: expected finite numbers up to {LARGEST:g} m")
    if len(array) < least:
        raise ValueError(f"{name}: {len(array)} points, expected at least {least}")
    return array


def signed_area(corners: Floats) -> float:
    """Of a polygon (n, 2) m; positive for anticlockwise."""
    p = corners - corners[0]
    q = np.roll(p, -1, axis=0)
    return 0.5 * float((p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1]).sum())


def without_doubles(points: Floats, closed: bool = True) -> Floats:
    """Points without those that lie on the one before (closed: nor the last on the first)."""
    extent = float(np.ptp(points, axis=0).max(initial=0.0))
    kept = [points[0]]
    for point in points[1:]:
        if np.abs(point - kept[-1]).max() > MERGED * extent:
            kept.append(point)
    while closed and len(kept) > 1 and np.abs(kept[-1] - kept[0]).max() <= MERGED * extent:
        kept.pop()
    return np.array(kept)


def clean_outline(name: str, points: ArrayLike) -> Floats:
    """A simple polygon (n, 2) m, anticlockwise, without double or needless corners.

    ValueError for fewer than three corners, no area, edges that cross, or what is not finite.
    """
    corners = without_doubles(checked_points(name, points, 3))
    if len(corners) < 3:
        raise ValueError(f"{name}: fewer than three different corners")
    extent = float(np.ptp(corners, axis=0).max())
    area = signed_area(corners)
    if not abs(area) > STRAIGHT * extent * extent:
        raise ValueError(f"{name}: the corners enclose no area")
    if area < 0.0:
        corners = corners[::-1].copy()
    if _has_crossing(corners):
        raise ValueError(f"{name}: edges cross each other")
    corners = corners[np.abs(_turns(corners)) > STRAIGHT * extent * extent]
    if len(corners) < 3:
        raise ValueError(f"{name}: the corners enclose no area")
    return corners


def is_convex(corners: Floats) -> bool:
    """True if an anticlockwise polygon has no corner that turns right."""
    return bool((_turns(corners) >= 0.0).all())


def convex_parts(corners: Floats) -> list[Floats]:
    """A clean outline cut into convex polygons, anticlockwise, of at most MOST_CORNERS corners."""
    if is_convex(corners) and len(corners) <= MOST_CORNERS:
        return [corners]
    parts = [list(part) for part in _ears(corners)]
    edges = {(part[k], part[(k + 1) % 3]): n for n, part in enumerate(parts) for k in range(3)}
    for (i, j), n in list(edges.items()):
        m = edges.get((j, i))
        if m is None or m == edges[i, j]:
            continue
        n = edges[i, j]
        joined = _join(parts[n], parts[m], i, j)
        if len(joined) <= MOST_CORNERS and is_convex(corners[joined]):
            parts[n], parts[m] = joined, []
            edges.update({(joined[k], joined[(k + 1) % len(joined)]): n for k in range(len(joined))})
            del edges[i, j], edges[j, i]
    return [corners[part] for part in parts if part]


def _turns(corners: Floats) -> Floats:
    """Cross product of the edges before and after each corner."""
    before, after = corners - np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0) - corners
    turns: Floats = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    return turns


def _side(a: Floats, b: Floats, p: Floats) -> float:
    return float((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]))


def _has_crossing(corners: Floats) -> bool:
    """True if two edges that are not neighbours have a point in common."""
    a, b = corners, np.roll(corners, -1, axis=0)
    n = len(corners)
    for i in range(n - 2):
        stop = n - 1 if i == 0 else n
        c, d = a[i + 2 : stop], b[i + 2 : stop]
        p, q = a[i], b[i]
        ahead = q - p
        side_c = ahead[0] * (c[:, 1] - p[1]) - ahead[1] * (c[:, 0] - p[0])
        side_d = ahead[0] * (d[:, 1] - p[1]) - ahead[1] * (d[:, 0] - p[0])
        other = d - c
        side_p = other[:, 0] * (p[1] - c[:, 1]) - other[:, 1] * (p[0] - c[:, 0])
        side_q = other[:, 0] * (q[1] - c[:, 1]) - other[:, 1] * (q[0] - c[:, 0])
        near = (np.maximum(c, d) >= np.minimum(p, q)).all(1) & (np.minimum(c, d) <= np.maximum(p, q)).all(1)
        if (near & (side_c * side_d <= 0.0) & (side_p * side_q <= 0.0)).any():
            return True
    return False


def _ears(corners: Floats) -> list[tuple[int, int, int]]:
    """Triangles of a simple polygon, by cutting ears; of all ears the one with the widest least angle."""
    left = list(range(len(corners)))
    triangles = []
    while len(left) > 3:
        best, place = -np.inf, -1
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            shape = _ear_quality(corners, i, j, m, left)
            if shape > best:
                best, place = shape, k
        i, j, m = left[place - 1], left[place], left[(place + 1) % len(left)]
        triangles.append((i, j, m))
        left.pop(place)
    triangles.append((left[0], left[1], left[2]))
    return triangles


def _ear_quality(corners: Floats, i: int, j: int, m: int, left: list[int]) -> float:
    """Area over the squared longest edge of an ear; minus infinity for what is none."""
    a, b, c = corners[i], corners[j], corners[m]
    area = _side(a, b, c)
    if area <= 0.0:
        return -np.inf
    others = corners[[k for k in left if k not in (i, j, m)]]
    inside = np.ones(len(others), dtype=bool)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= (q[0] - p[0]) * (others[:, 1] - p[1]) - (q[1] - p[1]) * (others[:, 0] - p[0]) >= 0.0
    if inside.any():
        return -np.inf
    longest = max(float((elementary.square(p - q)).sum()) for p, q in ((a, b), (b, c), (c, a)))
    return area / longest


def _join(first: list[int], second: list[int], i: int, j: int) -> list[int]:
    """Two polygons that share the edge i to j (in the first; j to i in the second) as one."""
    k = first.index(i)
    around = first[k + 1 :] + first[: k + 1]  # from j round to i
    return around + _between(second, i, j)


def _between(ring: list[int], i: int, j: int) -> list[int]:
    """Corners of a ring after i and before j."""
    k = ring.index(i)
    turned = ring[k + 1 :] + ring[:k]
    return turned[: turned.index(j)]
