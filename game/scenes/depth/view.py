"""How two shapes, their overlap and the ways out of it are drawn."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase.depth import Escape, Shape
from game.scenes.depth.borders import border_of, common
from game.scenes.depth.chart import DepthChart
from game.scenes.depth.model import OUT, DepthModel
from game.ui.canvas.canvas import PREDICTION_DASH, Canvas
from game.ui.look.numerals import format_si

COLORS = ("chalk", "violet")


class DepthView:
    """Draws a model; keeps the outer borders of its shapes."""

    def __init__(self, model: DepthModel):
        self.model = model
        self.chart = DepthChart(model)
        self._borders: dict[int, tuple[Shape, Floats]] = {}

    def _border(self, shape: Shape) -> Floats:
        """(n, 2, 2) m about the centroid."""
        kept = self._borders.get(id(shape))
        if kept is None or kept[0] is not shape:
            self._borders = {key: value for key, value in self._borders.items() if len(self._borders) < 4}
            kept = self._borders[id(shape)] = (shape, border_of(shape))
        return kept[1]

    def draw(self, canvas: Canvas) -> None:
        """All of it."""
        canvas.grid(None, "")
        model, pair = self.model, self.model.pair
        places = [tuple(place) for place in model.places.tolist()]
        bodies = [shape.placed(*place) for shape, place in zip((pair.a, pair.b), places, strict=True)]
        for k in (1, 0):
            for part in bodies[k]:
                canvas.polygon(part, COLORS[k], 0.16)
            self._draw_border(canvas, k, places[k], COLORS[k])
        for one in bodies[0]:
            for other in bodies[1]:
                region = common(one, other)
                if len(region) > 2:
                    canvas.polygon(region, "vermilion", 0.4, "vermilion", 1.4)
        if model.parameters.ghosts and model.slide.sigma > OUT:
            self._draw_ways(canvas)
        for k, (x, y, _) in enumerate(places):
            canvas.dot((x, y), 3.5, COLORS[k])
            canvas.label((x, y), "AB"[k], COLORS[k], 18, "semibold", offset=(-14.0, -12.0), clear=True)
        if model.parameters.curve:
            self.chart.draw(canvas)

    def _draw_border(
        self, canvas: Canvas, which: int, place: tuple[float, ...], color: str, width: float = 2.0
    ) -> None:
        x, y, angle = place
        c, s = math.cos(angle), math.sin(angle)
        shape = (self.model.pair.a, self.model.pair.b)[which]
        lines = self._border(shape) @ np.array(((c, s), (-s, c))) + (x, y)
        canvas.segments(lines[:, 0], lines[:, 1], color, width)

    def _draw_ghost(self, canvas: Canvas, way: Escape, color: str) -> None:
        x, y, angle = self.model.pair.moved(way)
        c, s = math.cos(angle), math.sin(angle)
        lines = self._border(self.model.pair.a) @ np.array(((c, s), (-s, c))) + (x, y)
        for a, b in lines.tolist():
            canvas.line(tuple(a), tuple(b), color, 1.6, dash=PREDICTION_DASH)

    def _draw_ways(self, canvas: Canvas) -> None:
        """A after both motions, how its centroid goes, and by which angle it turns."""
        model = self.model
        slide, found = model.slide, model.found
        x, y, angle = model.places[0].tolist()
        self._draw_ghost(canvas, slide, "amber")
        canvas.arrow((x, y), (slide.x, slide.y), "amber")
        self._draw_ghost(canvas, found, "green")
        canvas.arrow((x, y), (found.x, found.y), "green")
        if abs(found.angle) > 1e-3:
            centre, radius = (x + found.x, y + found.y), 0.45 * model.pair.a.reach
            canvas.arc(centre, radius, angle, angle + found.angle, "green", 2.0)
            for turned, dim in ((angle, 0.5), (angle + found.angle, 1.0)):
                tip = (centre[0] + radius * math.cos(turned), centre[1] + radius * math.sin(turned))
                canvas.line(centre, tip, "green", 1.2, alpha=dim)
        seen = canvas.camera.visible()
        place = (max(seen.left, -2.3), max(seen.bottom, -2.1))
        words = f"with rotation {format_si(found.sigma, 'm')}, turned by {math.degrees(found.angle):.1f}°"
        canvas.label(
            place, f"without rotation {format_si(slide.sigma, 'm')}", "amber", 13, "semibold", "bottomleft",
            (14.0, -34.0),
        )  # fmt: skip
        canvas.label(place, words, "green", 13, "semibold", "bottomleft", (14.0, -14.0))
