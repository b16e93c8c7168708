"""The two questions that detection asks, each with one rule for what lies on the border.

A point is in a triangle if it is in the triangle's closed box and none of its barycentric coordinates is
negative: edges and corners belong to it. A triangle whose area is 0 in floating point holds nothing.
Two edges cross if their closed boxes meet and each has its ends strictly on two sides of the other: edges
that only meet do not cross. Naming the box makes the answer one and the same for all ways of looking.

All products are of differences to one of the points. So a place far from the origin costs only the digits
which the coordinates have lost already.
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel


@lean_kernel
def turn_of(a, b, p):
    """Twice the signed area of a, b, p as seen from p; above 0 if p is on the left of a to b. Points (2,)."""
    return (a[0] - p[0]) * (b[1] - p[1]) - (a[1] - p[1]) * (b[0] - p[0])


@lean_kernel
def on_one_side(px, py, ax, ay, bx, by, cx, cy):
    """Whether p, of the closed box of the triangle a, b, c of either orientation, is in it."""
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    first = (bx - px) * (cy - py) - (by - py) * (cx - px)
    second = (cx - px) * (ay - py) - (cy - py) * (ax - px)
    third = (ax - px) * (by - py) - (ay - py) * (bx - px)
    # all at once: a branch that the processor cannot guess costs more than what it saves
    left = (area > 0.0) & (first >= 0.0) & (second >= 0.0) & (third >= 0.0)
    right = (area < 0.0) & (first <= 0.0) & (second <= 0.0) & (third <= 0.0)
    return left | right


@lean_kernel
def in_triangle(p, a, b, c):
    """Whether p is in the triangle a, b, c, of either orientation. Points (2,)."""
    if p[0] < min(a[0], b[0], c[0]) or p[0] > max(a[0], b[0], c[0]):
        return False
    if p[1] < min(a[1], b[1], c[1]) or p[1] > max(a[1], b[1], c[1]):
        return False
    return on_one_side(p[0], p[1], a[0], a[1], b[0], b[1], c[0], c[1])


@lean_kernel
def weights_in(p, a, b, c):
    """Barycentric coordinates of p in the triangle a, b, c; a third each where there are none."""
    first = turn_of(b, c, p)
    second = turn_of(c, a, p)
    third = turn_of(a, b, p)
    total = first + second + third
    if total == 0.0:
        return 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0
    return first / total, second / total, third / total


@lean_kernel
def edges_cross(a, b, c, d):
    """Whether the edges a to b and c to d cross, each strictly on both sides of the other."""
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    from_c = turn_of(a, b, c)
    from_d = turn_of(a, b, d)
    if not ((from_c > 0.0 and from_d < 0.0) or (from_c < 0.0 and from_d > 0.0)):
        return False
    from_a = turn_of(c, d, a)
    from_b = turn_of(c, d, b)
    return (from_a > 0.0 and from_b < 0.0) or (from_a < 0.0 and from_b > 0.0)
