"""The help figures: a projected link (C14), sweeps over a chain (C15)."""

from __future__ import annotations

import math
from itertools import pairwise

from game.scenes.shared.marks import ahead, between, dot, span
from game.ui.canvas.pen import Pen, Point


def draw_projection(pen: Pen) -> None:
    """Two linked particles fall apart in a step and are moved back along the link, the light one more."""
    length, light = 132.0, 2.0 / 3.0  # px; part of the correction for a particle of half the mass
    a, b = (64.0, 44.0), ahead((64.0, 44.0), 0.0, length)
    pa, pb = (a[0] - 26.0, a[1] + 72.0), (b[0] + 44.0, b[1] + 92.0)
    direction = math.degrees(math.atan2(pa[1] - pb[1], pb[0] - pa[0]))
    excess = math.dist(pa, pb) - length
    qa, qb = ahead(pa, direction, light * excess), ahead(pb, direction, -(1.0 - light) * excess)
    sizes = (7.0, 9.9)  # areas as the masses
    pen.line((a, b), "ghost", 1.4)
    pen.line((pa, pb), "text2", 1.1, dash=3.5)
    for start, end, size in ((a, pa, sizes[0]), (b, pb, sizes[1])):
        pen.disc(*start, size, "ghost", ring=1.3)
        heading = math.degrees(math.atan2(start[1] - end[1], end[0] - start[0]))
        pen.arrow(ahead(start, heading, size), ahead(end, heading, -size - 1.0), "chalk", 1.8)
    pen.line((qa, qb), "green", 2.0)
    for at, after, size in ((pa, qa, sizes[0]), (pb, qb, sizes[1])):
        dot(pen, at, "text2", size, ring=1.3)
        pen.disc(*after, size, pen.veiled("green", 0.6))
        pen.disc(*after, size, "green", ring=1.6)
    for at, after in ((pa, qa), (pb, qb)):
        pen.arrow(at, after, "amber", 2.2)
    low = direction - 90.0
    span(pen, ahead(qa, low, 26.0), ahead(qb, low, 26.0), "text1")
    pen.formula("L", *ahead(between(qa, qb, 0.5), low, 38.0))
    pen.formula(r"\v{x}_a", a[0] - 2.0, a[1] - 19.0, "text2")
    pen.formula(r"\v{x}_b", b[0] - 2.0, b[1] - 22.0, "text2")
    pen.formula(r"h\v{v}^*", *ahead(between(b, pb, 0.42), 0.0, 27.0), "chalk")
    pen.formula(r"\v{p}_a", pa[0] - 20.0, pa[1], "text1")
    pen.formula(r"\v{p}_b", pb[0] + 22.0, pb[1] + 4.0, "text1")
    pen.formula(r"\Delta\v{p}_a", *ahead(between(pa, qa, 0.6), direction + 90.0, 20.0), "amber")
    pen.formula(r"\Delta\v{p}_b", *ahead(between(pb, qb, 1.25), direction + 90.0, 25.0), "amber")
    pen.formula("w_a = 2 w_b", 250.0, 186.0, "text2")


def draw_sweeps(pen: Pen) -> None:
    """Four sweeps over a spring that is too long by C: with k each time, and with k'."""
    wall, rest, far = 34.0, 128.0, 262.0
    k, sweeps = 0.5, 4
    spread = 1.0 - (1.0 - k) ** (1.0 / sweeps)
    for y, part, name in ((80.0, k, "k"), (142.0, spread, "k'")):
        places = [rest + (far - rest) * (1.0 - part) ** i for i in range(sweeps + 1)]
        pen.line((_coil((wall, y), places[-1] - wall - 7.0)), "text2", 1.5)
        pen.line(((wall, y - 15.0), (wall, y + 15.0)), "text1", 2.4)
        for a, b in pairwise(places):
            if a - b > 12.0:
                pen.arrow((a, y), (b, y), "amber", 1.8)
        dot(pen, (far, y), "text2", 7.0, ring=1.3)
        for x in places[1:-1]:
            dot(pen, (x, y), "text1", 2.4)
        pen.disc(places[-1], y, 7.0, pen.veiled("green", 0.6))
        pen.disc(places[-1], y, 7.0, "green", ring=1.6)
        pen.formula(name, wall - 14.0, y)
    half = rest + (1.0 - k) * (far - rest)
    for x in (rest, half, far):
        pen.line(((x, 40.0), (x, 182.0)), "text3", 1.0, dash=3.0)
    span(pen, (rest, 40.0), (far, 40.0), "text1")
    span(pen, (wall, 182.0), (rest, 182.0), "text1")
    span(pen, (rest, 182.0), (half, 182.0), "text1")
    pen.formula("C", 0.5 * (rest + far), 28.0)
    pen.formula("L", 0.5 * (wall + rest), 195.0)
    pen.formula("(1-k) C", 0.5 * (rest + half), 195.0)
    pen.words("four sweeps", wall, 34.0, "text2", align="left")


def _coil(start: Point, length: float, turns: int = 9, breadth: float = 8.0) -> list[Point]:
    """A spring to the right, with straight ends."""
    x, y = start
    lead = 8.0
    step = (length - 2.0 * lead) / turns
    peaks = [(x + lead + (i + 0.5) * step, y + (breadth if i % 2 else -breadth)) for i in range(turns)]
    return [start, (x + lead, y), *peaks, (x + length - lead, y), (x + length, y)]
