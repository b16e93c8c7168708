"""The help figures: a separating axis (C08), two capsules (C09)."""

from __future__ import annotations

import math

from game.scenes.shared.marks import ahead, between, dot, outline, span
from game.ui.canvas.pen import Pen, Point

TURN = 12.0  # degrees, of the first box and of the axis


def draw_separating_axis(pen: Pen) -> None:
    """Two boxes over an axis along a side of the first one: their shadows do not meet."""
    a, b = (76.0, 60.0), (206.0, 56.0)
    half_a, half_b, turn_b = (38.0, 22.0), (34.0, 19.0), 54.0
    radius_a, radius_b = half_a[0], _radius(half_b, turn_b - TURN)
    middle_a, middle_b = _shadow(a), _shadow(b)
    pen.line((ahead(middle_a, TURN, -54.0), ahead(middle_b, TURN, 38.0)), "text2", 1.1)
    pen.arrow(ahead(middle_b, TURN, 38.0), ahead(middle_b, TURN, 64.0), "text1", 1.8)
    _draw_shadow(pen, _corners(a, half_a, TURN), middle_a, radius_a)
    _draw_shadow(pen, _corners(b, half_b, turn_b), middle_b, radius_b)
    pen.line((ahead(middle_a, TURN, radius_a), ahead(middle_b, TURN, -radius_b)), "green", 3.4)
    pen.arrow(a, b, "chalk", 1.8)
    dot(pen, a, "text1", 2.8)
    low = TURN - 90.0
    span(pen, ahead(middle_a, low, 22.0), ahead(middle_b, low, 22.0), "text1")
    pen.words("A", a[0] - 24.0, a[1] + 12.0, "text2", size=13, weight="semibold")
    pen.words("B", b[0] + 10.0, b[1] - 14.0, "text2", size=13, weight="semibold")
    pen.formula(r"\v{d}", *ahead(between(a, b, 0.5), 90.0, 12.0), "chalk")
    pen.formula(r"\v{n}", *ahead(ahead(middle_b, TURN, 58.0), low, 12.0))
    pen.formula("r_A", *ahead(ahead(middle_a, TURN, -0.5 * radius_a), TURN + 90.0, 12.0))
    pen.formula("r_B", *ahead(ahead(middle_b, TURN, 0.5 * radius_b), TURN + 90.0, 12.0))
    pen.formula(r"\abs{\v{d} \cdot \v{n}}", *ahead(between(middle_a, middle_b, 0.5), low, 37.0))


def _draw_shadow(pen: Pen, corners: list[Point], middle: Point, radius: float) -> None:
    """A box and its projection on the axis."""
    outline(pen, corners)
    ends = ahead(middle, TURN, -radius), ahead(middle, TURN, radius)
    for end in ends:
        corner = max((c for c in corners if math.dist(_shadow(c), end) < 0.01), key=lambda c: c[1])
        pen.line((corner, end), "text3", 1.0, dash=3.0)
    pen.line(ends, "text1", 3.4)
    dot(pen, middle, "text1", 3.4)


def _corners(center: Point, half: Point, degrees: float) -> list[Point]:
    signs = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
    return [ahead(ahead(center, degrees, s * half[0]), degrees + 90.0, t * half[1]) for s, t in signs]


def _radius(half: Point, degrees: float) -> float:
    """Half of a box's shadow on an axis at that angle to its first side."""
    angle = math.radians(degrees)
    return half[0] * abs(math.cos(angle)) + half[1] * abs(math.sin(angle))


def _shadow(at: Point) -> Point:
    """The foot of a point on the axis."""
    angle, start = math.radians(TURN), (20.0, 170.0)
    along = (at[0] - start[0]) * math.cos(angle) - (at[1] - start[1]) * math.sin(angle)
    return ahead(start, TURN, along)


def draw_capsules(pen: Pen) -> None:
    """Two capsules apart: the distance of their cores against both radii together."""
    a, b, radius_a = (52.0, 158.0), (122.0, 122.0), 36.0
    c, d, radius_b = (196.0, 44.0), (250.0, 136.0), 25.0
    for start, end, radius in ((a, b, radius_a), (c, d, radius_b)):
        pen.area(_capsule(start, end, radius + 0.8), "text1")
        pen.area(_capsule(start, end, radius - 0.8), "body", 0.2)
        pen.line((start, end), "accent", 2.2)
        for at in (start, end):
            dot(pen, at, "accent", 3.6, ring=1.6)
    near = _nearest(b, c, d)
    toward = math.degrees(math.atan2(b[1] - near[1], near[0] - b[0]))
    pen.line((b, near), "text1", 1.4, dash=4.0)
    pen.line((ahead(b, toward, radius_a), ahead(near, toward, -radius_b)), "green", 2.8)
    dot(pen, near, "amber", 4.0)
    dot(pen, b, "amber", 4.0)
    pen.arrow(a, ahead(a, 214.0, radius_a), "text1", 1.4)
    pen.arrow(c, ahead(c, 40.0, radius_b), "text1", 1.4)
    pen.formula("d", *ahead(between(b, near, 0.5), toward + 90.0, 13.0))
    pen.formula(r"\v{a}", a[0] + 8.0, a[1] + 14.0, "accent")
    pen.formula(r"\v{b}", b[0] + 2.0, b[1] + 17.0, "accent")
    pen.formula(r"\v{c}(t)", *ahead(between(a, b, 0.45), 120.0, 15.0), "accent")
    pen.formula("r_A", *ahead(ahead(a, 214.0, 0.5 * radius_a), 124.0, 12.0))
    pen.formula("r_B", *ahead(ahead(c, 40.0, 0.5 * radius_b), -50.0, 12.0))
    pen.formula("d > r_A + r_B", 84.0, 40.0, "green")


def _capsule(a: Point, b: Point, radius: float) -> list[Point]:
    """The border of all points within the radius of a segment."""
    across = math.degrees(math.atan2(a[1] - b[1], b[0] - a[0]))
    first = [ahead(b, across + turn, radius) for turn in range(-90, 91, 5)]
    return [*first, *(ahead(a, across + turn, radius) for turn in range(90, 271, 5))]


def _nearest(at: Point, a: Point, b: Point) -> Point:
    """The point of a segment that is closest."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    part = ((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / (dx * dx + dy * dy)
    return between(a, b, min(max(part, 0.0), 1.0))
