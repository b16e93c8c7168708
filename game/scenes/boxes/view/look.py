"""Looking into one box of a broad-phase scene: the box itself, and those that it is tested against."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from game.scenes.boxes.model.arrays import BoxArrays
from game.scenes.boxes.model.names import LETTERS, apart_on, named, outcomes
from game.scenes.boxes.view.world import Places
from game.ui.canvas.canvas import Canvas

MOST_TESTS = 400  # candidates that are drawn
FEW_TESTS = 12  # each labelled with the axis on which it is apart


def draw_names(boxes: BoxArrays, canvas: Canvas, places: Places) -> None:
    """The letters of few boxes, at their upper left corners."""
    if not named(boxes):
        return
    low, high = places
    for box in boxes.ids.tolist():
        at = (low[box, 0], high[box, 1])
        if np.isfinite(at).all():
            canvas.label(at, LETTERS[box], "text1", 12, "semibold", "topleft", (4.0, 2.0))


def draw_tests(boxes: BoxArrays, canvas: Canvas, places: Places, box: int, candidates: Sequence[int]) -> None:
    """The box with a line to each that it is tested against: solid to a pair, dashed where they are apart."""
    low, high = places
    with np.errstate(invalid="ignore", over="ignore"):
        centers = 0.5 * (low + high)
    pairs, rejected = outcomes(boxes, box, candidates[:MOST_TESTS])
    for other in rejected:
        if np.isfinite(centers[other]).all():
            canvas.line(centers[box], centers[other], "text2", 1.2, dash=(5.0, 4.0))
            if len(rejected) <= FEW_TESTS:
                middle = 0.5 * (centers[box] + centers[other])
                words = f"apart on {apart_on(boxes, box, other)}"
                canvas.label(middle, words, "text2", 11, clear=True)
    for other in pairs:
        if np.isfinite(centers[other]).all():
            canvas.line(centers[box], centers[other], "vermilion", 3.0)
    outline(canvas, low[box], high[box])


def outline(canvas: Canvas, lower: Any, upper: Any, color: str = "amber", width: float = 2.5) -> None:
    """A box's outline, if it has ends."""
    (x0, y0), (x1, y1) = lower, upper
    corners = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
    if np.isfinite(corners).all():
        canvas.polygon(corners, outline=color, width=width)


def shade_cells(
    canvas: Canvas, cells: Sequence[tuple[int, int]], edge: float, color: str, veil: float
) -> None:
    """Cells by column and row, of an edge in m, laid over with a colour."""
    for column, row in cells:
        x, y = column * edge, row * edge
        square = np.array([(x, y), (x + edge, y), (x + edge, y + edge), (x, y + edge)])
        canvas.polygon(square, fill=color, fill_alpha=veil, outline=color, width=1.0)
