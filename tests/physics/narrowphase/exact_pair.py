"""Distance and depth of two convex outlines in exact arithmetic, by looking at everything: a naive twin."""

from __future__ import annotations

from decimal import Decimal, localcontext
from fractions import Fraction


def _rows(points):
    return [(Fraction(float(x)), Fraction(float(y))) for x, y in points]


def _edges(rows):
    return [(rows[k], rows[(k + 1) % len(rows)]) for k in range(len(rows))] if len(rows) > 1 else []


def _to_segment(p, a, b):
    """Squared distance of a point from a segment."""
    ex, ey, dx, dy = b[0] - a[0], b[1] - a[1], p[0] - a[0], p[1] - a[1]
    squared = ex * ex + ey * ey
    along = min(max((ex * dx + ey * dy) / squared, Fraction(0)), Fraction(1)) if squared else Fraction(0)
    x, y = dx - along * ex, dy - along * ey
    return x * x + y * y


def _root(value):
    with localcontext() as context:
        context.prec = 50
        return float((Decimal(value.numerator) / Decimal(value.denominator)).sqrt())


def _gap_beyond(edge, rows, inner):
    """Signed square of the gap between an edge's line and the nearest of the rows beyond it."""
    (ax, ay), (bx, by) = edge
    ex, ey = bx - ax, by - ay
    squared = ex * ex + ey * ey
    if not squared:
        return None
    inside = max(ey * (x - ax) - ex * (y - ay) for x, y in inner)
    cross = min(ey * (x - ax) - ex * (y - ay) for x, y in rows) - inside
    return cross * abs(cross) / squared


def exact_depth(points_a, points_b):
    """Least overlap over the normals of all edges, m; None if they are apart along one of them."""
    a, b = _rows(points_a), _rows(points_b)
    gaps = []
    for one, other in ((a, b), (b, a)):
        for p, q in _edges(one):
            gaps += [_gap_beyond((p, q), other, one), _gap_beyond((q, p), other, one)]
    gaps = [gap for gap in gaps if gap is not None]
    best = max(gaps, default=Fraction(0))
    return None if best > 0 else _root(-best)


def exact_distance(points_a, points_b):
    """Distance of two outlines, either way round, m; of overlapping ones minus their depth."""
    a, b = _rows(points_a), _rows(points_b)
    sides_a, sides_b = _edges(a) or [(a[0], a[0])], _edges(b) or [(b[0], b[0])]
    nearest = min(
        min(_to_segment(p, *side) for p in a for side in sides_b),
        min(_to_segment(p, *side) for p in b for side in sides_a),
    )
    depth = exact_depth(points_a, points_b)
    if depth is None or len(a) == len(b) == 1:
        return _root(nearest)
    touching = any(_cross(one, other) for one in sides_a for other in sides_b)
    inside = _holds(a, b[0]) or _holds(b, a[0])
    return -depth if nearest == 0 or touching or inside else _root(nearest)


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _cross(one, other):
    """True if two segments cross in their insides."""
    (a, b), (c, d) = one, other
    return _turn(a, b, c) * _turn(a, b, d) < 0 and _turn(c, d, a) * _turn(c, d, b) < 0


def _holds(rows, point):
    turns = [_turn(p, q, point) for p, q in _edges(rows)]
    return len(rows) > 2 and (min(turns) >= 0 or max(turns) <= 0) and any(turns)
