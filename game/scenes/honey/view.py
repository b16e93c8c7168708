"""How liquids are drawn: wall and table, vessel, the body of liquid or its particles, heaters, taps."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.particle_fluids.store import ROOM_HEAT
from game.scenes.honey.world import HoneyState, HoneyWorld
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.painting.inks import channels, color_of, opaque
from game.worlds.painting.liquid import draw_backdrop, draw_table
from game.worlds.painting.particle_liquid import ParticleLiquidPainter

INKS = {
    "water": 0x3F9FC8, "honey": 0xE39A1C, "slime": 0x58B93C, "oil": 0xD9C53A, "wax": 0xE2483A,
    "lamp": 0x5A4B9E, "steam": 0xDCE8EE, "air": 0xE9F3F7, "milk": 0xF0ECE0, "tar": 0x4A3B33,
}  # fmt: skip
THIN = {"steam": 0.75, "air": 0.75}  # amount of a particle beside one of liquid: smaller bubbles
COLD, WARM, HOT = 0x2F6FC4, 0xD7D2C4, 0xE8452C  # of temperatures, of densities below and above rest
GLASS, DARK_GLASS = 0x86A2AD, 0x4B6470
WALL = 7.0  # px
FASTEST = 3.0  # m/s, of the warmest colour of speeds
SPREAD = 0.04  # of the relative density, from the middle to either colour
GLOW = 0.16  # of what is warmed or cooled


def part_in_box(outline: Floats, low: tuple[float, float], high: tuple[float, float]) -> Floats:
    """(n, 2) corners of the part of a closed outline in a box (Sutherland and Hodgman 1974)."""
    for axis in (0, 1):
        for side, limit in ((1.0, low[axis]), (-1.0, high[axis])):
            kept: list[Floats] = []
            for k, here in enumerate(outline):
                before = outline[k - 1]
                a, b = side * (before[axis] - limit), side * (here[axis] - limit)
                if (a >= 0.0) != (b >= 0.0):
                    kept.append(before + (here - before) * a / (a - b))
                if b >= 0.0:
                    kept.append(here)
            outline = np.array(kept).reshape(-1, 2)
    return outline


class HoneyView:
    """Draws a world."""

    def __init__(self, model: HoneyWorld, hand: Hand):
        self.model, self.hand = model, hand
        self.painter = ParticleLiquidPainter()
        outline = np.asarray(model.content.vessel[0], dtype=np.float64)
        self.foot = float(np.min(outline[:, 1]))
        boxes = (((one.left, one.bottom), (one.right, one.top)) for one in model.content.heaters)
        self.heated = [part_in_box(outline, *box) for box in boxes]
        pools = [one.heat for one in model.content.pools]
        self.first_heat = sum(pools) / len(pools) if pools else ROOM_HEAT

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the colours mean, where they are not the liquids' own."""
        return {
            "kind": [],
            "temperature": [("line:vermilion", "warmest", ""), ("line:chalk", "coldest", "")],
            "density": [("line:vermilion", "squeezed", ""), ("line:chalk", "loose", "")],
            "speed": [("line:vermilion", "fast", ""), ("line:chalk", "slow", "")],
            "order": [("line:vermilion", "last in memory", ""), ("line:chalk", "first", "")],
        }[self.model.parameters.colours]

    def draw(self, canvas: Canvas, previous: HoneyState | None, alpha: float) -> None:
        """The liquid ``alpha`` of the way from the state before to now."""
        draw_backdrop(canvas)
        draw_table(canvas, self.foot)
        self._draw_vessel(canvas)
        fluid = self.model.fluid
        place = fluid.place
        if previous is not None and previous.fluid.place.shape == place.shape:
            moved = place - previous.fluid.place
            near = np.sum(np.square(moved), axis=1) < fluid.support * fluid.support
            place = np.where(near[:, None], previous.fluid.place + alpha * moved, place)
        inks = self._inks()
        if self.model.parameters.dots:
            canvas.discs(place, 0.42 * fluid.spacing, opaque(inks * 255.0))
        elif len(place):
            amounts = np.array([THIN.get(one.look, 1.0) for one in self.model.content.liquids])[fluid.kind]
            spots = canvas.place_all(place).astype(np.float64)
            spacing = fluid.spacing * canvas.pixels_per_unit
            self.painter.paint(canvas.raster_target, spots, spacing, inks, amounts)
        self._draw_heaters(canvas)
        self._draw_edges(canvas)
        if self.model.pours is not None:
            canvas.ring(self.model.pours, color="accent")

    def _inks(self) -> Floats:
        """(n, 3) 0 to 1, of what is shown."""
        fluid, shown = self.model.fluid, self.model.parameters.colours
        if shown == "kind":
            table = channels(np.array([INKS[one.look] for one in self.model.content.liquids])) / 255.0
            return np.asarray(table[fluid.kind])
        if shown == "temperature":
            warm = fluid.temperature()
            low, high = (float(np.min(warm)), float(np.max(warm))) if len(warm) else (0.0, 1.0)
            share = (warm - low) / max(high - low, 1.0)
        elif shown == "density":
            share = 0.5 + 0.5 * (fluid.density() - 1.0) / SPREAD
        elif shown == "order":
            share = fluid.ranks() / max(len(fluid.place) - 1, 1)
        else:
            share = np.sqrt(np.sum(np.square(fluid.velocity), axis=1)) / FASTEST
        share = np.clip(share, 0.0, 1.0)[:, None]
        cold, warm, hot = channels(np.array((COLD, WARM, HOT))) / 255.0
        low = cold + (warm - cold) * np.minimum(2.0 * share, 1.0)
        return np.asarray(low + (hot - low) * np.maximum(2.0 * share - 1.0, 0.0))

    def _draw_vessel(self, canvas: Canvas) -> None:
        for number, loop in enumerate(self.model.content.vessel):
            canvas.polygon(loop, "stage" if number == 0 else "line2", 0.35 if number == 0 else 1.0)
        for tap in self.model.content.taps:
            (x, y), half = tap.at, 0.6 * tap.width
            canvas.polygon(
                ((x - half, y), (x + half, y), (x + 0.8 * half, y + half), (x - 0.8 * half, y + half)),
                "text2",
            )

    def _draw_heaters(self, canvas: Canvas) -> None:
        """A breath of red or blue over what is warmed or cooled, beside the liquid as it began."""
        for heater, part in zip(self.model.content.heaters, self.heated, strict=True):
            if len(part) > 2:
                canvas.polygon(part, "vermilion" if heater.heat > self.first_heat else "chalk", GLOW)

    def _draw_edges(self, canvas: Canvas) -> None:
        color = color_of(DARK_GLASS if is_dark(canvas) else GLASS)
        for loop in self.model.content.vessel:
            canvas.polyline((*loop, loop[0], loop[1]), color, WALL)
