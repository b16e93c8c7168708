"""Convex pieces of a polygon, cut by lines, and the least circle about them."""

from __future__ import annotations

from collections.abc import Sequence

from game.arrays import Floats
from game.physics.kernels import elementary

Point = tuple[float, float]
Piece = list[Point]  # a convex polygon, counter-clockwise
ROUNDING = 1e-12


def cross(a: Point, b: Point, c: Point) -> float:
    """Twice the area of a triangle, positive counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def triangulate(corners: Floats) -> list[Piece]:
    """A simple polygon (n, 2), counter-clockwise, as n - 2 triangles, by ears (Meisters 1975).

    Of the ears, the one whose shortest side is longest against its longest is cut off first. ValueError if
    there is no ear: the outline crosses itself.
    """
    left: Piece = [(float(x), float(y)) for x, y in corners]
    found: list[Piece] = []
    while len(left) > 3:
        best, place = -1.0, -1
        for i in range(len(left)):
            a, b, c = left[i - 1], left[i], left[(i + 1) % len(left)]
            worth = cross(a, b, c) / elementary.square(
                max(elementary.dist(a, b), elementary.dist(b, c), elementary.dist(c, a))
            )
            if worth > max(best, ROUNDING) and not _any_inside(a, b, c, left):
                best, place = worth, i
        if place < 0:
            flat = [i for i in range(len(left)) if abs(cross(left[i - 1], left[i], left[(i + 1) % len(left)]))
                    <= ROUNDING]  # fmt: skip
            if not flat:
                raise ValueError("outline: expected a simple polygon, counter-clockwise")
            del left[flat[0]]
            continue
        found.append([left[place - 1], left[place], left[(place + 1) % len(left)]])
        del left[place]
    return [*found, left]


def _any_inside(a: Point, b: Point, c: Point, others: Piece) -> bool:
    return any(
        p not in (a, b, c) and cross(a, b, p) >= 0.0 and cross(b, c, p) >= 0.0 and cross(c, a, p) >= 0.0
        for p in others
    )


def area_of(piece: Piece) -> float:
    """Area of a convex piece."""
    return 0.5 * sum(cross(piece[0], piece[i], piece[i + 1]) for i in range(1, len(piece) - 1))


def cut(piece: Piece, axis: int, at: float) -> tuple[Piece, Piece]:
    """What of a piece lies below and above a coordinate, the cut itself in both; an empty list for none."""
    below: Piece = []
    above: Piece = []
    for i, p in enumerate(piece):
        q = piece[(i + 1) % len(piece)]
        if p[axis] <= at:
            below.append(p)
        if p[axis] >= at:
            above.append(p)
        if (p[axis] - at) * (q[axis] - at) < 0.0:
            share = (at - p[axis]) / (q[axis] - p[axis])
            between = (p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]))
            between = (at, between[1]) if axis == 0 else (between[0], at)
            below.append(between)
            above.append(between)
    return below, above


def least_circle(points: Sequence[Point]) -> tuple[float, float, float]:
    """Centre and radius of the least circle about points (Welzl 1991, with fixed order), rounded upwards."""
    c = (*points[0], 0.0)
    for i, p in enumerate(points):
        if not _holds(c, p):
            c = (*p, 0.0)
            for j in range(i):
                if not _holds(c, points[j]):
                    c = _on_two(p, points[j])
                    for k in range(j):
                        if not _holds(c, points[k]):
                            c = _on_three(p, points[j], points[k])
    reach = max(elementary.dist(c[:2], p) for p in points)
    return c[0], c[1], reach * (1.0 + ROUNDING)


def _holds(c: tuple[float, float, float], p: Point) -> bool:
    return elementary.hypot(p[0] - c[0], p[1] - c[1]) <= c[2] * (1.0 + ROUNDING) + 1e-15


def _on_two(a: Point, b: Point) -> tuple[float, float, float]:
    return 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * elementary.dist(a, b)


def _on_three(a: Point, b: Point, c: Point) -> tuple[float, float, float]:
    twice = 2.0 * cross(a, b, c)
    if abs(twice) < 1e-300:
        return max((_on_two(a, b), _on_two(b, c), _on_two(a, c)), key=lambda found: found[2])
    bx, by, cx, cy = b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]
    bb, cc = bx * bx + by * by, cx * cx + cy * cy
    x, y = (cy * bb - by * cc) / twice, (bx * cc - cx * bb) / twice
    return a[0] + x, a[1] + y, elementary.hypot(x, y)
