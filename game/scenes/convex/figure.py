"""The help figures: Voronoi regions (C10), Minkowski difference (C11)."""

from __future__ import annotations

import math

from game.scenes.shared.marks import ahead, between, dot, outline, right_angle
from game.ui.canvas.pen import Pen, Point


def draw_regions(pen: Pen) -> None:
    """A vertex of B, tested against the region of a vertex of A: it lies beyond the border to an edge's."""
    before, vertex, after = (176.0, 214.0), (190.0, 136.0), (70.0, 100.0)
    x = (158.0, 62.0)
    side = _direction(vertex, after)  # of edge e_i
    normal, other = side - 90.0, _direction(before, vertex) - 90.0
    far = 300.0
    pen.area((vertex, ahead(vertex, other, far), ahead(vertex, normal, far)), "chalk", 0.84)
    band = (vertex, ahead(vertex, normal, far), ahead(after, normal, far), after)
    pen.area(band, "green", 0.84)
    for start, degrees in ((vertex, other), (vertex, normal), (after, normal)):
        pen.line((start, ahead(start, degrees, far)), "text2", 1.1, dash=3.5)
    outline(pen, (before, vertex, after, (20.0, 150.0), (40.0, 214.0)))
    outline(pen, (x, (228.0, 22.0), (210.0, -8.0), (128.0, -8.0)))
    foot = ahead(vertex, side, _along(vertex, x, side))
    pen.line((vertex, x), "chalk", 1.4, dash=4.0)
    pen.line((foot, x), "green", 2.4)
    right_angle(pen, foot, normal, color="text1")
    dot(pen, x, "amber", 4.2)
    dot(pen, vertex, "chalk", 4.2)
    dot(pen, foot, "green", 3.4)
    inside = normal + 180.0
    pen.arrow(ahead(ahead(vertex, side, 8.0), inside, 9.0), ahead(foot, inside, 9.0), "amber", 1.8)
    pen.formula(r"\v{p}_i", vertex[0] + 14.0, vertex[1] + 14.0, "chalk")
    pen.formula(r"\v{e}_i", *ahead(between(foot, after, 0.45), inside, 14.0))
    pen.formula(r"\v{e}_{i-1}", *ahead(between(before, vertex, 0.42), other + 180.0, 20.0))
    pen.formula(r"\v{x}", x[0] - 14.0, x[1] - 1.0, "amber")
    pen.formula("d", *ahead(between(foot, x, 0.36), side, 10.0), "green")
    pen.words("edge", 104.0, 78.0, "green")
    pen.words("vertex", 246.0, 92.0, "chalk")
    pen.words("Voronoi regions", 236.0, 190.0, "text2")


def _direction(a: Point, b: Point) -> float:
    return math.degrees(math.atan2(a[1] - b[1], b[0] - a[0]))


def _along(start: Point, at: Point, degrees: float) -> float:
    """How far a point lies ahead in a direction."""
    angle = math.radians(degrees)
    return (at[0] - start[0]) * math.cos(angle) - (at[1] - start[1]) * math.sin(angle)


A = ((0.0, 0.0), (40.0, -6.0), (56.0, 20.0), (30.0, 46.0), (4.0, 36.0))  # px, y up
B = ((62.0, 46.0), (96.0, 60.0), (70.0, 84.0))
SIMPLEX = ((-32.0, 0.0), (-14.0, -64.0))  # two corners of A - B


def draw_difference(pen: Pen) -> None:
    """A step of GJK: the simplex, its point closest to the origin, the corner farthest towards that."""
    for corners, name in ((A, "A"), (B, "B")):
        outline(pen, [_at_left(p) for p in corners])
        x, y = (sum(p[i] for p in corners) / len(corners) for i in (0, 1))
        pen.words(name, *_at_left((x, y)), "text2", size=13, weight="semibold")
    difference = _hull([(p[0] - q[0], p[1] - q[1]) for p in A for q in B])
    outline(pen, [_at_right(p) for p in difference])
    v = between(*SIMPLEX, _nearest_part(*SIMPLEX))
    a, b = max(A, key=lambda p: -_dot(p, v)), max(B, key=lambda p: _dot(p, v))
    w = (a[0] - b[0], a[1] - b[1])
    for at in (_at_left(a), _at_left(b), _at_right(w)):
        dot(pen, at, "pink", 4.2)
    away = _direction(_at_right((0.0, 0.0)), _at_right(v))
    bound = ahead(_at_right((0.0, 0.0)), away, SCALE * _dot(v, w) / math.sqrt(_dot(v, v)))
    pen.line((ahead(bound, away + 90.0, 66.0), ahead(bound, away - 90.0, 52.0)), "text2", 1.1, dash=3.5)
    pen.line([_at_right(p) for p in SIMPLEX], "amber", 2.2)
    for p in SIMPLEX:
        dot(pen, _at_right(p), "amber", 3.6)
    pen.arrow(_at_right((0.0, 0.0)), _at_right(v), "green", 2.2)
    dot(pen, _at_right((0.0, 0.0)), "text1", 3.2)
    zero = _at_right((0.0, 0.0))
    pen.formula("0", zero[0] + 12.0, zero[1])
    pen.formula(r"\v{v}", zero[0] - 6.0, zero[1] - 10.0, "green")
    pen.formula(r"\v{w}", _at_right(w)[0] + 17.0, _at_right(w)[1] + 2.0, "pink")
    pen.formula(r"s_A(-\v{v})", _at_left(a)[0] + 1.0, _at_left(a)[1] + 20.0, "pink", align="left")
    pen.formula(r"s_B(\v{v})", _at_left(b)[0] - 6.0, _at_left(b)[1] - 16.0, "pink", align="right")
    pen.formula("A - B", *ahead(_at_right(SIMPLEX[1]), 186.0, 66.0), "text2")


SCALE = 1.4  # of A - B


def _at_left(p: Point) -> Point:
    return 14.0 + p[0], 124.0 - p[1]


def _at_right(p: Point) -> Point:
    return 262.0 + SCALE * p[0], 56.0 - SCALE * p[1]


def _dot(p: Point, q: Point) -> float:
    return p[0] * q[0] + p[1] * q[1]


def _nearest_part(p: Point, q: Point) -> float:
    """Where on the segment from p to q the origin is closest."""
    along = (q[0] - p[0], q[1] - p[1])
    return min(max(-_dot(p, along) / _dot(along, along), 0.0), 1.0)


def _hull(points: list[Point]) -> list[Point]:
    """Corners of the convex hull, counter-clockwise (Andrew 1979)."""
    chains: list[list[Point]] = []
    for order in (sorted(points), sorted(points, reverse=True)):
        chain: list[Point] = []
        for p in order:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0.0:
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return chains[0] + chains[1]


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
