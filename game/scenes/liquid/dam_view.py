"""How one dam by several methods is drawn: floor above floor, with lines where fronts are known."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.scenes.liquid.dam_world import DamState, DamWorld
from game.scenes.liquid.methods import ByLiquid, ByShallowWater, DamMethod
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.painting.inks import color_of
from game.worlds.painting.liquid import LiquidPainter, draw_backdrop

WATER = (0x4F93B5, 0x235F82)  # by day, by night


class DamView:
    """Draws all methods of a world."""

    def __init__(self, model: DamWorld, hand: Any):
        self.model = model
        self.painters = {
            one.name: LiquidPainter(one.liquid) for one in model.methods if isinstance(one, ByLiquid)
        }

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """The lines through all floors."""
        rows = []
        if self.model.parameters.experiment and not math.isnan(self.model.measured()):
            rows.append(("line:amber", "front in the experiment (Martin and Moyce 1952)", ""))
        if self.model.parameters.exact:
            rows.append(("line:vermilion", "shallow water by Ritter (1892)", ""))
        return rows

    def draw(self, canvas: Canvas, previous: DamState | None, alpha: float) -> None:
        """All floors, as they are now."""
        draw_backdrop(canvas)
        model, content = self.model, self.model.content
        for one in model.methods:
            self._draw_water(canvas, one)
            floor, length = one.floor, content.length
            canvas.line((0.0, floor), (length, floor), "text1", 2.4)
            canvas.line((0.0, floor), (0.0, floor + content.height), "text1", 2.4)
            canvas.line((length, floor), (length, floor + content.height), "text1", 2.4)
            at = (0.5 * (content.width + length), floor + 0.92 * content.height)
            canvas.label(at, one.title, "text1", 18, "semibold", "center")
        top = 2.0 * content.rise - 0.1 * content.height
        if model.parameters.exact:
            self._draw_exact(canvas, top)
        measured = model.measured()
        if model.parameters.experiment and not math.isnan(measured):
            canvas.line((measured, 0.0), (measured, top), "amber", 2.0, dash=(7.0, 4.0))

    def _draw_water(self, canvas: Canvas, one: DamMethod) -> None:
        if isinstance(one, ByLiquid):
            self.painters[one.name].draw(canvas, one.liquid.places)
        elif isinstance(one, ByShallowWater):
            depth = one.water.depth[0]
            wet = np.flatnonzero(depth > 1e-4 * one.column.height)
            if len(wet):
                x, surface = one.x[: wet[-1] + 1], one.floor + depth[: wet[-1] + 1]
                top = list(zip(x.tolist(), surface.tolist(), strict=True))
                top = [(0.0, top[0][1]), *top]
                canvas.polygon(
                    [*top, (top[-1][0], one.floor), (0.0, one.floor)], color_of(WATER[is_dark(canvas)])
                )
                canvas.polyline(np.array(top), "chalk", 2.0)

    def _draw_exact(self, canvas: Canvas, top: float) -> None:
        """Ritter's surface on the floor of shallow water, and his front through all."""
        front, found = self.model.exact_front(), self.model.surface()
        if not math.isnan(front):
            canvas.line((front, 0.0), (front, top), "vermilion", 1.6, dash=(3.0, 3.0))
        for one in self.model.methods:
            if found is not None and isinstance(one, ByShallowWater):
                x, depth = found
                canvas.polyline(np.stack([x, one.floor + depth], axis=1), "vermilion", 1.8)
