"""How a tank of liquid is drawn: a wall, the water, solids, taps, drains; or what the method sees."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.scenes.liquid.parameters import TOOLS
from game.scenes.liquid.world import TALL, WEIGHT, WIDE, LiquidWorld, LiquidWorldState
from game.ui.canvas.canvas import Canvas
from game.worlds.hands.hand import Hand, legend_of
from game.worlds.members.solids import turned_between
from game.worlds.painting.boards import paint_blocks
from game.worlds.painting.inks import mixed
from game.worlds.painting.liquid import LiquidPainter, draw_backdrop, draw_table
from game.worlds.painting.spheres import draw_spheres

WOOD, STONE, FIXED = 0xD9A25F, 0x6E7480, 0x8C8F96  # lighter than water, as heavy as stone, immovable
EDGE = 0x2A2018
ARROWS = 16  # along the tank
ABOUT_DENSITIES = "density beside water's: so much of a body is under water as it floats"


def inks_of(weights: Floats) -> np.ndarray:
    """(n,) colours by density: wood to stone; what does not move is grey."""
    share = np.clip(weights / 2.5, 0.0, 1.0)
    inks = mixed(np.full(len(weights), WOOD), STONE, share)
    return np.where(weights > 0.0, inks, FIXED)


class LiquidView:
    """Draws a tank."""

    def __init__(self, model: LiquidWorld, hand: Hand):
        self.model, self.hand = model, hand
        self.painter = LiquidPainter(model.liquid)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the hand does next."""
        return legend_of(TOOLS, self.model.parameters.tool)

    def draw(self, canvas: Canvas, previous: LiquidWorldState | None, alpha: float) -> None:
        """All of it ``alpha`` of the way from the state before to now."""
        draw_backdrop(canvas)
        look, liquid = self.model.parameters.look, self.model.liquid
        places = liquid.places
        if previous is not None and len(previous.liquid.places) == len(places):
            places = previous.liquid.places + alpha * (places - previous.liquid.places)
        if look == "water":
            self.painter.draw(canvas, places)
        elif look == "dots":
            canvas.discs(places, 0.45 * math.sqrt(liquid.area), canvas_speed(canvas, liquid.speeds))
        else:
            self._draw_cells(canvas, look == "pressure")
        self._draw_solids(canvas, previous, alpha)
        self._draw_taps(canvas)
        self._draw_tank(canvas)
        if canvas.marks(self.model.parameters.densities):
            self._draw_densities(canvas, previous, alpha)
        if canvas.marks(self.model.parameters.arrows):
            self._draw_arrows(canvas)

    def _draw_tank(self, canvas: Canvas) -> None:
        """Its walls, and the table below it."""
        grid = self.model.liquid.grid
        (left, low), (right, high) = grid.lower, grid.upper
        if "bottom" not in self.model.content.open:
            draw_table(canvas, low)
        rims = {
            "left": ((left, high), (left, low)), "bottom": ((left, low), (right, low)),
            "right": ((right, low), (right, high)), "top": ((right, high), (left, high)),
        }  # fmt: skip
        for side, (a, b) in rims.items():
            if side not in self.model.content.open:
                canvas.line(a, b, "text1", 2.4)

    def _draw_solids(self, canvas: Canvas, previous: LiquidWorldState | None, alpha: float) -> None:
        model = self.model
        if not len(model.things):
            return
        before = previous.solids if previous is not None else None
        places, turned = turned_between(model.solids.world, before, alpha)
        bodies, things = model.bodies(), model.things
        inks = inks_of(things[:, WEIGHT])
        boxes = things[:, TALL] > 0.0
        if boxes.any():
            chosen = bodies[boxes]
            paint_blocks(
                canvas, things[boxes][:, [WIDE, TALL]], places[chosen], turned[chosen], inks[boxes], EDGE
            )
        balls = ~boxes
        chosen = bodies[balls]
        draw_spheres(canvas, places[chosen], things[balls, WIDE], turned[chosen], inks[balls])

    def _draw_densities(self, canvas: Canvas, previous: LiquidWorldState | None, alpha: float) -> None:
        """At each solid that moves its density, and once what the numbers are."""
        model, grid = self.model, self.model.liquid.grid
        before = previous.solids if previous is not None else None
        places, _ = turned_between(model.solids.world, before, alpha)
        for (x, y), density in zip(
            places[model.bodies()].tolist(), model.things[:, WEIGHT].tolist(), strict=True
        ):
            if density > 0.0:
                canvas.label((x, y), f"{density:g}", "text1", 20, "semibold")
        at = 0.5 * (grid.lower[0] + grid.upper[0]), grid.upper[1] - 0.03 * (grid.upper[1] - grid.lower[1])
        canvas.label(at, ABOUT_DENSITIES, "text1", 16, "semibold", "top")

    def _draw_taps(self, canvas: Canvas) -> None:
        for x, y, width, u, v in self.model.mouths.taps.tolist():
            fast = max(math.hypot(u, v), 1e-9)
            nx, ny = u / fast, v / fast
            half, long = 0.6 * width, 1.4 * width
            corners = [
                (x - ny * half, y + nx * half), (x + ny * half, y - nx * half),
                (x + ny * half - nx * long, y - nx * half - ny * long),
                (x - ny * half - nx * long, y + nx * half - ny * long),
            ]  # fmt: skip
            canvas.polygon(corners, "text3", outline="text1")
        for x, y, radius in self.model.mouths.drains.tolist():
            canvas.circle((x, y), radius, None, outline="amber")

    def _draw_cells(self, canvas: Canvas, pressure: bool) -> None:
        """Wet cells by how full they are, or by the pressure in them."""
        cells, grid = self.model.liquid.cells, self.model.liquid.grid
        wet = np.argwhere(cells.rank > 0)
        if not len(wet):
            return
        h = grid.cell
        if pressure:
            p = cells.q[wet[:, 0], wet[:, 1]]
            share = np.clip(p / max(float(np.max(np.abs(p))), 1e-12), 0.0, 1.0)
        else:
            share = np.clip(cells.fill[wet[:, 0], wet[:, 1]] - 0.5, 0.0, 1.0)
        inks = mixed(np.full(len(wet), 0x1B5A88), 0xFFC857 if pressure else 0xE8F6FF, share)
        middle = (wet[:, ::-1] + 0.5) * h + np.asarray(grid.lower)
        sizes = np.full((len(wet), 2), 0.47 * h)
        paint_blocks(canvas, sizes, middle, np.tile((1.0, 0.0), (len(wet), 1)), inks, 0x0A2438)

    def _draw_arrows(self, canvas: Canvas) -> None:
        """Speeds at places evenly over the wet cells."""
        cells, grid = self.model.liquid.cells, self.model.liquid.grid
        every = max(1, grid.nx // ARROWS)
        for j in range(every // 2, grid.ny, every):
            for i in range(every // 2, grid.nx, every):
                if cells.rank[j, i] == 0:
                    continue
                u = 0.5 * float(cells.u[j, i] + cells.u[j, i + 1])
                v = 0.5 * float(cells.v[j, i] + cells.v[j + 1, i])
                if math.hypot(u, v) > 0.03:
                    at = grid.lower[0] + (i + 0.5) * grid.cell, grid.lower[1] + (j + 0.5) * grid.cell
                    canvas.arrow(at, (0.04 * u, 0.04 * v), "text1")


def canvas_speed(canvas: Canvas, speeds: Floats) -> np.ndarray:
    """Colours of particles by their speeds."""
    fastest = float(np.max(np.abs(speeds))) if len(speeds) else 0.0
    return canvas.speed_colors(speeds, max(fastest, 0.5))
