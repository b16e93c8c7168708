"""How one dam by several methods is drawn: tank above tank, with lines where fronts are known."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from game.scenes.liquid.dam_world import BESIDE, DamState, DamWorld
from game.scenes.liquid.methods import TALL, ByLiquid, ByParticles, ByShallowWater, DamMethod
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_number, format_si
from game.ui.painters.wall import is_dark
from game.worlds.painting.inks import channels, color_of
from game.worlds.painting.liquid import LiquidPainter, draw_backdrop
from game.worlds.painting.particle_liquid import ParticleLiquidPainter

WATER = (0x4F93B5, 0x235F82)  # by day, by night
EXPERIMENT, RITTER = "experiment of 1952", "Ritter's front"
AT_END = 0.01  # of the floor: so near to its end a front has arrived
LINE = 22.0  # design px from line to line of what is said beside a tank


def liquid_brush(one: Any) -> Callable[[Canvas], None]:
    """Paints the liquid's surface."""
    painter = LiquidPainter(one.liquid)
    return lambda canvas: painter.draw(canvas, one.liquid.places)


def particle_brush(one: Any) -> Callable[[Canvas], None]:
    """Paints particles as a body of water."""
    painter = ParticleLiquidPainter()

    def paint(canvas: Canvas) -> None:
        fluid, column = one.fluid, one.column
        left, bottom = canvas.place((0.0, one.floor))
        right, top = canvas.place((column.length, one.floor + TALL * column.height))
        pixels, clip = canvas.raster_target
        tank = np.array((math.floor(left), math.floor(top), math.ceil(right), math.ceil(bottom)), np.int64)
        tank = np.concatenate([np.maximum(tank[:2], clip[:2]), np.minimum(tank[2:], clip[2:])])
        inks = np.tile(channels(WATER[is_dark(canvas)]) / 255.0, (len(fluid.place), 1))
        spots = canvas.place_all(fluid.place).astype(np.float64)
        spacing = fluid.spacing * canvas.pixels_per_unit
        painter.paint((pixels, tank), spots, spacing, inks, np.ones(len(spots)))

    return paint


def shallow_brush(one: Any) -> Callable[[Canvas], None]:
    """Paints depths as an area."""

    def paint(canvas: Canvas) -> None:
        depth = one.water.depth[0]
        wet = np.flatnonzero(depth > 1e-4 * one.column.height)
        if len(wet):
            x, surface = one.x[: wet[-1] + 1], one.floor + depth[: wet[-1] + 1]
            top = [(0.0, float(surface[0])), *zip(x.tolist(), surface.tolist(), strict=True)]
            if wet[-1] == len(depth) - 1:
                top.append((one.column.length, top[-1][1]))
            below = [(top[-1][0], one.floor), (0.0, one.floor)]
            canvas.polygon([*top, *below], color_of(WATER[is_dark(canvas)]))
            canvas.polyline(np.array(top), "chalk", 2.0)

    return paint


BRUSHES: dict[type[DamMethod], Callable[[Any], Callable[[Canvas], None]]] = {
    ByLiquid: liquid_brush,
    ByParticles: particle_brush,
    ByShallowWater: shallow_brush,
}


def said_of(model: DamWorld, one: DamMethod) -> list[str]:
    """Front, loss and price of a method, a line each, and the price beside that of another code."""
    front, measured = one.front(), model.measured()
    arrived = front > (1.0 - AT_END) * one.column.length
    lines = ["front at the far wall" if arrived else f"front at {front:.2f} m"]
    if not math.isnan(measured):
        ahead = 100.0 * (front / measured - 1.0)
        lines.append(f"{abs(ahead):.0f} % {'ahead of' if ahead >= 0.0 else 'behind'} the experiment")
    lost = round(100.0 * (one.volume() / one.area - 1.0), 2)
    lines.append(f"volume error {format_si(lost, '%', 2)}")
    price = one.watch.median("step")
    if not math.isnan(price):
        times = model.times_as_fast(one)
        beside = "" if math.isnan(times) else f", {format_number(times, 2)} times as fast as PySPH"
        lines.append(f"{format_si(price, 's', 2)} a step{beside}")
    return lines


class DamView:
    """Draws all methods of a world."""

    def __init__(self, model: DamWorld, hand: Any):
        self.model = model
        self.brushes = [BRUSHES[type(one)](one) for one in model.methods]

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """None: lines have their names where they are drawn, and tanks beside them."""
        return ()

    def draw(self, canvas: Canvas, previous: DamState | None, alpha: float) -> None:
        """All tanks, as they are now."""
        draw_backdrop(canvas)
        for one, brush in zip(self.model.methods, self.brushes, strict=True):
            brush(canvas)
            self._draw_tank(canvas, one)
        self._draw_known(canvas)

    def _draw_tank(self, canvas: Canvas, one: DamMethod) -> None:
        """Its walls and lid; beside it, what is said of it."""
        length, low, high = one.column.length, one.floor, one.floor + TALL * one.column.height
        canvas.polyline([(0.0, low), (length, low), (length, high), (0.0, high)], "text1", 2.4, closed=True)
        at = (length * (1.0 + 0.05 * BESIDE), high)
        canvas.label(at, one.title, "text1", 18, "semibold", "topleft")
        for k, line in enumerate(said_of(self.model, one)):
            canvas.label(at, line, "text1", 14, anchor="topleft", offset=(0.0, 30.0 + LINE * k))

    def _draw_known(self, canvas: Canvas) -> None:
        """Fronts that are known, through all tanks, and Ritter's surface on shallow water."""
        model, content = self.model, self.model.content
        top = (len(model.methods) - 1) * content.rise + (TALL + 0.04) * content.height
        measured, front, found = model.measured(), model.exact_front(), model.surface()
        if model.parameters.exact and found is not None:
            for one in model.methods:
                if isinstance(one, ByShallowWater):
                    canvas.polyline(np.stack([found[0], one.floor + found[1]], axis=1), "vermilion", 1.8)
                    at = float(found[0][len(found[0]) // 2]), one.floor + float(found[1][len(found[1]) // 2])
                    canvas.label(
                        at, "Ritter's surface", "vermilion", 14, "semibold", "bottomleft", (8.0, -8.0)
                    )
        marks = []
        if model.parameters.experiment and not math.isnan(measured):
            marks.append((measured, EXPERIMENT, "amber", (7.0, 4.0)))
        if model.parameters.exact and not math.isnan(front):
            marks.append((front, RITTER, "vermilion", (3.0, 3.0)))
        for x, name, color, dash in marks:
            canvas.line((x, 0.0), (x, top), color, 2.0, dash=dash)
            canvas.label((x, top), name, color, 14, "semibold", "bottom", clear=True)
