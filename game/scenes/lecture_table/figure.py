"""The help figure: a ball that steps over a wall."""

from __future__ import annotations

from game.ui.canvas.pen import Pen

RADIUS = 15.0


def _ball(pen: Pen, x: float, y: float, color: str = "text1", veil: float = 0.2) -> None:
    pen.disc(x, y, RADIUS, pen.veiled("body", veil))
    pen.disc(x, y, RADIUS, color, ring=1.5)


def draw_tunnelling(pen: Pen) -> None:
    """One step over another ball, and the same displacement in four substeps."""
    start, step, other = 42.0, 186.0, 141.0
    high, low = 62.0, 152.0
    for y in (high, low):
        _ball(pen, other, y)
    _ball(pen, start, high)
    pen.disc(start + step, high, RADIUS, "vermilion", ring=1.5)
    pen.arrow((start, high), (start + step, high), "chalk", 2.2)
    part = step / 4.0
    overlapping = start + 2.0 * part
    pen.disc(overlapping, low, RADIUS, pen.veiled("vermilion", 0.72))
    _ball(pen, start, low)
    pen.disc(start + part, low, RADIUS, "ghost", ring=1.2)
    pen.disc(other, low, RADIUS, "text1", ring=1.5)
    pen.disc(overlapping, low, RADIUS, "vermilion", ring=1.5)
    for i in range(2):
        pen.arrow((start + i * part, low), (start + (i + 1) * part, low), "chalk", 2.2)
    pen.formula(r"\v{x}_n", start, high - 29.0)
    pen.formula(r"\v{x}_{n+1}", start + step, high - 29.0, "vermilion")
    pen.formula(r"\v{v}_n \Delta t", 0.5 * (start + other) + 1.0, high - 12.0, "chalk")
    pen.formula(r"\frac{1}{4} \v{v}_n \Delta t", start + 0.5 * part, low + 36.0, "chalk")
    pen.words("no overlap, no hit", other, high + 30.0, "text2")
    pen.words("found in the second", other + 28.0, low - 4.0, "text2", align="left")
    pen.words("of four substeps", other + 28.0, low + 12.0, "text2", align="left")
