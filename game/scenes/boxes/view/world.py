"""How the broad-phase scenes are drawn: the world with its boxes and pairs, between two steps."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.scenes.boxes.hand import Hand
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.arrays import BoxesState
from game.scenes.boxes.model.base import BoxesModel
from game.scenes.boxes.numbers import grouped
from game.stage import Frame
from game.ui.canvas.canvas import Canvas
from game.ui.painters.boxes import HIDDEN, BoxPainter

Places = tuple[Floats, Floats]  # lower and upper corners (n, 2) m as they are drawn
FREE, OVERLAPPING, IN_HAND = 0, 1, 2  # kinds of boxes
MOST_LINES = 6_000

_boxes = BoxPainter(
    (
        ("body", 0.9, "text3", 0.75),
        ("vermilion", 0.34, "vermilion", 1.0),
        ("chalk", 0.4, "chalk", 1.0),
    )
)


class BoxesView:
    """Base of the views; a subclass draws ``draw`` on what is common to all."""

    def __init__(self, model: BoxesModel, hand: Hand):
        self.model, self.hand = model, hand

    def frame(self) -> Frame:
        """The part of the world to show."""
        return Frame(-4.5, -0.1, WIDTH + 0.1, HEIGHT + 0.1)

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean, with counts."""
        return [
            ("box:vermilion", "overlapping", grouped(self.model.overlapping())),
            ("box:ghost", "boxes", grouped(len(self.model.boxes))),
            ("line:vermilion", "pairs", grouped(len(self.model.pairs))),
        ]

    def draw(self, canvas: Canvas, before: BoxesState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the step after the state ``before``."""
        raise NotImplementedError

    def draw_boxes(self, canvas: Canvas, before: BoxesState | None, alpha: float) -> None:
        """All boxes: those that overlap filled and solid, the others in hairlines; lines between pairs."""
        model, boxes = self.model, self.model.boxes
        kinds = np.where(boxes.alive == 1, FREE, HIDDEN).astype(np.uint8)
        kinds[model.pairs.ravel()] = OVERLAPPING
        if model.held >= 0:
            kinds[model.held] = IN_HAND
        same = before is not None and len(before.lowers) == len(boxes.lowers)
        earlier = (before.lowers, before.uppers) if same and before is not None else None
        leap = _longest_move(model)
        _boxes.paint(canvas, boxes.lowers, boxes.uppers, kinds, earlier, alpha, leap)
        if model.parameters.lines and 0 < len(model.pairs) <= MOST_LINES:
            self._draw_lines(canvas, places_between(model, before, alpha))
        if self.hand.anchor is not None:
            (x0, y0), (x1, y1) = self.hand.anchor, self.hand.reach
            corners = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
            canvas.polygon(corners, outline="chalk", width=2.0, dash=(8.0, 6.0))

    def _draw_lines(self, canvas: Canvas, places: Places) -> None:
        """A line between the centres of each pair of finite boxes."""
        pairs, (low, high) = self.model.pairs, places
        with np.errstate(invalid="ignore", over="ignore"):
            centers = 0.5 * (low + high)
        canvas.segments(centers[pairs[:, 0]], centers[pairs[:, 1]], "vermilion", 1.4)


def draw_ground(canvas: Canvas) -> None:
    """The world's boundary."""
    corners = np.array([(0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT)])
    canvas.polygon(corners, outline="line2", width=1.5)


def _longest_move(model: BoxesModel) -> float:
    """How far a box can move in a step, m; one that moved further has leapt and is drawn where it is."""
    boxes = model.boxes
    speed = max(
        float(np.abs(boxes.velocities).max(initial=0.0)), float(np.abs(boxes.growth).max(initial=0.0))
    )
    return 2.0 * speed * model.parameters.step_length + 1e-9


def places_between(model: BoxesModel, before: BoxesState | None, alpha: float) -> Places:
    """Where boxes are drawn: ``alpha`` of the step after the state ``before``, unless they leapt."""
    low, high = model.boxes.lowers, model.boxes.uppers
    if alpha >= 1.0 or before is None or len(before.lowers) != len(low):
        return low, high
    leap = _longest_move(model)
    with np.errstate(invalid="ignore", over="ignore"):
        near = np.all(np.abs(low - before.lowers) <= leap, axis=1)[:, None]
        return (
            np.where(near, before.lowers + alpha * (low - before.lowers), low),
            np.where(near, before.uppers + alpha * (high - before.uppers), high),
        )
