"""What figures of these pages share: particles of a fluid, and curves over an axis."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.particle_fluids.smoothing import fill_kernel
from game.ui.canvas.pen import Pen

Span = tuple[float, float]
Box = tuple[float, float, float, float]  # left, top, right, bottom in the figure


def placed(box: Box, frame: tuple[Span, Span], x: float, y: float) -> tuple[float, float]:
    """Where a point of a frame (its spans across and up) lies in a box of the figure."""
    (left, top, right, bottom), (across, up) = box, frame
    along, high = (x - across[0]) / (across[1] - across[0]), (y - up[0]) / (up[1] - up[0])
    return left + along * (right - left), bottom - high * (bottom - top)


class Plot:
    """Curves in a box of a figure. across, up: the numbers at its sides."""

    def __init__(self, pen: Pen, box: Box, across: Span, up: Span):
        self.pen, self.box, self.across, self.up = pen, box, across, up
        left, top, right, bottom = box
        pen.line(((left, top), (left, bottom), (right, bottom)), "text3", 1.2)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Where a point is drawn; what is too high or low, at the rim."""
        return placed(self.box, (self.across, self.up), x, min(max(y, self.up[0]), self.up[1]))

    def curve(self, x: Floats, y: Floats, color: str, dash: float = 0.0) -> None:
        """A line through points (n,), (n,)."""
        points = [self.at(a, b) for a, b in zip(x.tolist(), y.tolist(), strict=True)]
        self.pen.line(points, color, 1.8, dash=dash)

    def points(self, x: Floats, y: Floats, color: str, radius: float = 2.6) -> None:
        """Dots."""
        for a, b in zip(x.tolist(), y.tolist(), strict=True):
            self.pen.disc(*self.at(a, b), radius, color)

    def level(self, y: float, color: str = "grid") -> None:
        """A line across."""
        self.pen.line((self.at(self.across[0], y), self.at(self.across[1], y)), color, 1.0, dash=3.0)


def draw_particles(
    pen: Pen, places: Floats, colors: Sequence[str], frame: tuple[Span, Span], box: Box, radius: float
) -> None:
    """Dots at places (n, 2) m; frame: what of the world is seen; radius m."""
    scale = (box[2] - box[0]) / (frame[0][1] - frame[0][0])
    for place, color in zip(places.tolist(), colors, strict=True):
        pen.disc(*placed(box, frame, place[0], place[1]), radius * scale, color)


def kernel_values(kind: int, q: Floats) -> tuple[Floats, Floats]:
    """Values and slopes of a kernel of support 1 at distances (n,)."""
    values, slopes = np.zeros(len(q)), np.zeros(len(q))
    fill_kernel(kind, q, values, slopes)
    return values, slopes
