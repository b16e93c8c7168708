"""Brackets and bars of formulas: drawn as strokes, for no font has them in every height."""

from __future__ import annotations

from itertools import pairwise

from game.ui.text.formula_boxes import Stroke


def bracket(sign: str, half: float, em: float, w: float) -> tuple[tuple[Stroke, ...], float]:
    """Strokes about y = 0, ``half`` px up and down, and the width they take.

    ``em``: px; ``w``: width of a stroke, px.
    """
    if sign in "|‖":
        lines = tuple(
            Stroke(x * em, -half, x * em, half, w) for x in ((0.12,) if sign == "|" else (0.1, 0.24))
        )
        return lines, (0.24 if sign == "|" else 0.34) * em
    near, far, width = 0.1 * em, 0.26 * em, 0.34 * em
    if sign in "[]":
        a, b = (near, far) if sign == "[" else (width - near, width - far)
        return (
            Stroke(b, -half, a, -half, w),
            Stroke(a, -half - 0.5 * w, a, half + 0.5 * w, w),
            Stroke(a, half, b, half, w),
        ), width
    if sign in "{}":
        xs, ys = (0.30, 0.2, 0.2, 0.08, 0.2, 0.2, 0.30), (-1.0, -0.86, -0.14, 0.0, 0.14, 0.86, 1.0)
    else:
        xs, ys = (0.28, 0.16, 0.1, 0.09, 0.1, 0.16, 0.28), (-1.0, -0.72, -0.35, 0.0, 0.35, 0.72, 1.0)
    points = [((x if sign in "({⟨" else 0.34 - x) * em, y * half) for x, y in zip(xs, ys, strict=True)]
    return tuple(Stroke(*a, *b, 1.2 * w) for a, b in pairwise(points)), width
