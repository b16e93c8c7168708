"""Looking into one box of a broad-phase scene: names, the box itself, and whom it is tested against."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from game.scenes.boxes.view import places_between
from game.ui.canvas.canvas import Canvas

if TYPE_CHECKING:
    from game.scenes.boxes.base import BoxesScene

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
AXES = ("x", "y")
MOST_TESTS = 400  # candidates that are drawn
FEW_TESTS = 12  # of which each is told where it is apart


def named(scene: BoxesScene) -> bool:
    """Whether there are so few boxes that each has a letter."""
    return len(scene.alive) <= len(LETTERS)


def name_of(scene: BoxesScene, box: int) -> str:
    """A letter where there are few boxes, else the id."""
    return LETTERS[box] if named(scene) else f"#{box}"


def listed_names(scene: BoxesScene, boxes: Sequence[int], most: int = 4) -> str:
    """The names of some boxes, the rest by their number."""
    names = [name_of(scene, box) for box in boxes[:most]]
    return ", ".join(names) + (f" and {len(boxes) - most} more" if len(boxes) > most else "")


def apart_on(scene: BoxesScene, a: int, b: int) -> str:
    """The axes on which what two boxes cover does not overlap: "x", "y", "x and y", or "" for a pair."""
    lowers, uppers = scene.covered()
    gaps = (lowers[a] > uppers[b]) | (lowers[b] > uppers[a])
    return " and ".join(AXES[axis] for axis in range(2) if gaps[axis])


def outcomes(scene: BoxesScene, box: int, candidates: Sequence[int]) -> tuple[list[int], list[int]]:
    """Of the boxes that a box is tested against: those that overlap it and those rejected, each but once."""
    distinct = list(dict.fromkeys(candidates))
    pairs = [other for other in distinct if not apart_on(scene, box, other)]
    return pairs, [other for other in distinct if other not in set(pairs)]


def result_of(pairs: Sequence[int], rejected: Sequence[int]) -> str:
    """What came of the tests, in a few words."""
    found = f"{len(pairs)} pair" + ("" if len(pairs) == 1 else "s")
    return f"{found}, {len(rejected)} rejected"


def draw_names(scene: BoxesScene, canvas: Canvas, alpha: float) -> None:
    """The letters of few boxes, at their upper left corners."""
    if not named(scene):
        return
    low, high = places_between(scene, alpha)
    for box in scene.ids.tolist():
        at = (low[box, 0], high[box, 1])
        if np.isfinite(at).all():
            canvas.label(at, LETTERS[box], "text1", 12, "semibold", "topleft", (4.0, 2.0))


def draw_tests(scene: BoxesScene, canvas: Canvas, alpha: float, box: int, candidates: Sequence[int]) -> None:
    """The box with a line to each that it is tested against: solid to a pair, dashed where they are apart."""
    low, high = places_between(scene, alpha)
    with np.errstate(invalid="ignore", over="ignore"):
        centers = 0.5 * (low + high)
    pairs, rejected = outcomes(scene, box, candidates[:MOST_TESTS])
    for other in rejected:
        if np.isfinite(centers[other]).all():
            canvas.line(centers[box], centers[other], "text2", 1.2, dash=(5.0, 4.0))
            if len(rejected) <= FEW_TESTS:
                middle = 0.5 * (centers[box] + centers[other])
                words = f"apart on {apart_on(scene, box, other)}"
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
