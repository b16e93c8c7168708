"""The help figures: the two ways out, the Minkowski differences, and the bound over an interval."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase.depth import Escape, Shape, ShapePair, preset
from game.physics.narrowphase.minkowski import minkowski_difference
from game.scenes.depth.borders import border_of
from game.scenes.shared.marks import dot, turn
from game.ui.canvas.pen import Pen

SCALE, X0, Y0 = 62.0, 126.0, 138.0


def slotted() -> ShapePair:
    """A bar that is caught in a slot."""
    return ShapePair(preset("bar", 0.75), preset("slot"), (0.02, 0.42, math.radians(68.0)), (0.0, 0.0, 0.0))


def _draw_border(
    pen: Pen, shape: Shape, place: tuple[float, float, float], color: str, dash: float = 0.0
) -> None:
    x, y, angle = place
    c, s = math.cos(angle), math.sin(angle)
    for a, b in (border_of(shape) @ np.array(((c, s), (-s, c))) + (x, y)).tolist():
        ends = [(X0 + SCALE * u, Y0 - SCALE * v) for u, v in (a, b)]
        if dash:
            pen.line(ends, color, 1.4, dash=dash)
        else:
            pen.line(ends, color, 2.0)


def draw_two_ways(pen: Pen) -> None:
    """A bar in a slot: how far it must go straight, and with a turn."""
    pair = slotted()
    _draw_border(pen, pair.b, pair.place_b, "violet")
    _draw_border(pen, pair.a, pair.place_a, "chalk")
    slide, found = pair.translational(), pair.generalised()
    for way, color in ((slide, "amber"), (found, "green")):
        _draw_border(pen, pair.a, pair.moved(way), color, 4.0)
    _words(pen, slide, "amber", "straight", 18.0)
    _words(pen, found, "green", "with a turn", 36.0)


def _words(pen: Pen, way: Escape, color: str, name: str, y: float) -> None:
    pen.words(f"{name} {way.sigma:.2f} m", 286.0, y, color, "right")


def draw_differences(pen: Pen) -> None:
    """The Minkowski differences of a bar and the parts of a slot, and the nearest place out of them."""
    pair = slotted()
    angle = pair.place_a[2]
    body = np.concatenate(pair.a.placed(0.0, 0.0, angle))
    for part in pair.b.placed(*pair.place_b):
        corners = minkowski_difference(part, body) - pair.place_a[:2]
        points = [(148.0 + 52.0 * u, 116.0 - 52.0 * v) for u, v in corners.tolist()]
        pen.area(points, "violet", 0.22)
        pen.line((*points, points[0]), "violet", 1.4)
    slide = pair.translational()
    tip = (148.0 + 52.0 * slide.x, 116.0 - 52.0 * slide.y)
    pen.arrow((148.0, 116.0), tip, "amber", 2.2)
    dot(pen, (148.0, 116.0), "text1", 4.0)
    pen.words("the origin: A as it is", 10.0, 16.0, "text2", "left")


def draw_local(pen: Pen) -> None:
    """Shorter from neighbour to neighbour: where that ends, from two beginnings."""
    pair, far = slotted(), math.pi
    angles = np.linspace(-far, far, 181)
    sigmas = pair.sigmas(angles)
    top = 1.1 * float(np.max(sigmas))

    def at(i: int) -> tuple[float, float]:
        return 148.0 + 130.0 * float(angles[i]) / far, 184.0 - 150.0 * float(sigmas[i]) / top

    pen.line([at(i) for i in range(len(angles))], "chalk", 2.0)
    for begin, color, row in ((36, "amber", 0), (122, "green", 1)):
        end = descent(sigmas, begin)
        pen.line([at(i) for i in range(min(begin, end), max(begin, end) + 1)], color, 3.0)
        dot(pen, at(begin), color, 3.2, ring=1.4)
        dot(pen, at(end), color, 4.5)
        pen.words(f"ends at {sigmas[end]:.2f} m", 286.0, 18.0 + 18.0 * row, color, "right")
    pen.formula(r"\sigma(\theta)", 40.0, 20.0)


def descent(values: Floats, begin: int) -> int:
    """Where one comes who goes to the lower neighbour from a place of a row, as long as there is one."""
    at = begin
    while True:
        near = [i for i in (at - 1, at, at + 1) if 0 <= i < len(values)]
        best = min(near, key=lambda i: float(values[i]))
        if best == at:
            return at
        at = best


def draw_bound(pen: Pen) -> None:
    """Sigma over the angle, and the bounds of the intervals below it."""
    pair = slotted()
    found = pair.generalised(0.02)
    far = 0.9
    angles = np.linspace(-far, far, 181)
    top = 1.2 * pair.translational().sigma

    def at(angle: float, sigma: float) -> tuple[float, float]:
        return 148.0 + 130.0 * angle / far, 184.0 - 150.0 * min(sigma, top) / top

    for middle, half, _, bound, _ in pair.intervals.tolist():
        if abs(middle) - half < far and bound < top:
            pen.line((at(max(middle - half, -far), bound), at(min(middle + half, far), bound)), "pink", 1.4)
    pen.line(
        [at(*one) for one in zip(angles.tolist(), pair.sigmas(angles).tolist(), strict=True)], "chalk", 2.0
    )
    pen.line((at(-far, 0.0), at(far, 0.0)), "text3", 1.0)
    dot(pen, at(found.angle, found.sigma), "green", 4.5)
    dot(pen, at(0.0, pair.translational().sigma), "amber", 4.5)
    pen.formula(r"\sigma(\theta)", 40.0, 20.0)


def draw_norm(pen: Pen) -> None:
    """How far the points of a bar go as it turns."""
    cx, cy, half = 148.0, 108.0, 104.0
    for angle, color in ((0.0, "chalk"), (0.5, "green")):
        c, s = math.cos(angle), math.sin(angle)
        corners = [
            (cx + c * x - s * y, cy - s * x - c * y)
            for x, y in ((-half, -9), (half, -9), (half, 9), (-half, 9))
        ]
        pen.line((*corners, corners[0]), color, 2.0)
    for part in (-0.9, -0.6, -0.3, 0.3, 0.6, 0.9):
        start = (cx + part * half, cy)
        pen.arrow(start, (cx + part * half * math.cos(0.5), cy - part * half * math.sin(0.5)), "amber", 1.6)
    dot(pen, (cx, cy), "text1", 4.0)
    turn(pen, (cx, cy), 40.0, 0.0, math.degrees(0.5), "text2", 1.4)
