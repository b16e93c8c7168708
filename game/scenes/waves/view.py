"""How water in a channel is drawn: sky and hills, the body of water, its bed, the exact surface."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from game.arrays import Floats, Inks
from game.physics.waves import AiryTank
from game.scenes.waves.painting import SHADES, columns_of, paint_water
from game.scenes.waves.world import THIN, WavesState, WavesWorld
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.painting.inks import channels, opaque
from game.worlds.painting.landscape import Landscape

# water at its surface and deep down, bed at its top and deep down
DAY = (0x5FB4C9, 0x0B3E63, 0xD9BE8A, 0x7A5B3A)
NIGHT = (0x2F7F9E, 0x061C33, 0x8A7650, 0x2B2118)
FOAMS, WHITE = 0.12, 0.6  # drop of the speed over two cells, in speeds of a wave: where foam begins, is full
TRAIL = 10  # px that foam reaches to either side
ARROWS = 24
SEEN_DEPTH = 1e-6  # m; less is not drawn


@lru_cache(maxsize=8)
def shades_of(above: int, below: int) -> Inks:
    """(SHADES,) colours, darker downwards at first fast."""
    share = (np.linspace(0.0, 1.0, SHADES) ** 0.6)[:, None]
    return opaque(channels(above) + (channels(below) - channels(above)) * share)


def foam_at(depth: Floats, speed: Floats) -> Floats:
    """(n,) 0 to 1: where fast water runs into slow, as in a bore or a jump."""
    drop = np.zeros_like(depth)
    drop[1:-1] = (speed[:-2] - speed[2:]) / np.sqrt(9.81 * np.maximum(depth[1:-1], THIN))
    drop[1:-1] = np.maximum(np.maximum(drop[:-2], drop[1:-1]), drop[2:])
    return np.clip((drop - FOAMS) / (WHITE - FOAMS), 0.0, 1.0)


def trailed(foam: Floats) -> Floats:
    """(w,) with what is left of it on the pixels beside."""
    found = foam.copy()
    for k in range(1, TRAIL):
        part = 1.0 - k / TRAIL
        found[k:] = np.maximum(found[k:], part * foam[:-k])
        found[:-k] = np.maximum(found[:-k], part * foam[k:])
    return found


class WavesView:
    """Draws a world."""

    def __init__(self, model: WavesWorld, hand: Hand):
        self.model, self.hand = model, hand
        view, self.stretch = model.content.view, model.content.stretch
        self.landscape = Landscape(self.stretch * (view.bottom + 0.4 * (view.top - view.bottom)))

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """The surface by theory, while it is known."""
        if not (self.model.parameters.exact and self.model.undisturbed):
            return []
        airy = isinstance(self.model.theory, AiryTank)
        return [("line:vermilion", "waves of any length (Airy)" if airy else "exact surface", "")]

    def draw(self, canvas: Canvas, previous: WavesState | None, alpha: float) -> None:
        """The water ``alpha`` of the way from the state before to now."""
        self.landscape.draw(canvas)
        water = self.model.water
        depth = water.depth[0]
        if previous is not None and previous.water.depth.shape == water.depth.shape:
            before = previous.water.depth[0]
            depth = before + alpha * (depth - before)
        speed = water.velocity()[0][0]
        self._paint(canvas, depth, speed)
        chosen = self.model.parameters
        expected = self.model.expected() if chosen.exact else None
        if expected is not None:
            wet = np.nonzero(expected > 1e-4)[0]
            span = slice(wet[0], wet[-1] + 2) if len(wet) else slice(0, 0)
            surface = self.stretch * (water.bed[0] + expected)
            canvas.polyline(np.stack([self.model.x[span], surface[span]], axis=1), "vermilion", 1.8)
        if chosen.arrows or canvas.teaching:
            self._draw_arrows(canvas, depth, speed)
        if self.stretch > 1.0:
            view = self.model.content.view
            at = (view.left, self.stretch * view.bottom)
            canvas.label(
                at, f"heights × {self.stretch:g}", "text1", 16, "semibold", "bottomleft", (10.0, -10.0)
            )

    def _paint(self, canvas: Canvas, depth: Floats, speed: Floats) -> None:
        pixels, clip = canvas.raster_target
        width = int(clip[2] - clip[0])
        if width <= 0:
            return
        seen = canvas.camera.visible()
        x, bed = self.model.x, self.model.water.bed[0]
        level = np.where(depth > SEEN_DEPTH, bed + depth, bed)
        foam_of = foam_at(depth, speed)
        across = (x, width, float(seen.left), float(seen.right))
        zero, scale = canvas.place((0.0, 0.0))[1], canvas.pixels_per_unit * self.stretch
        surface, floor = columns_of(level, *across), columns_of(bed, *across)
        half = 0.5 * float(self.model.parameters.length)
        places = np.linspace(seen.left, seen.right, width)
        for end, beyond in zip(self.model.content.ends, (places < -half, places > half), strict=True):
            if end == "wall":
                surface[beyond] = floor[beyond] = self.model.content.view.top
        surface, floor = zero - scale * surface, zero - scale * floor
        foam = trailed(columns_of(foam_of, *across))
        above, below, sand, deep = NIGHT if is_dark(canvas) else DAY
        reach = 0.6 * float(clip[3] - clip[1])
        paint_water(pixels, clip, surface, floor, foam, shades_of(above, below), shades_of(sand, deep), reach)

    def _draw_arrows(self, canvas: Canvas, depth: Floats, speed: Floats) -> None:
        """Speeds at places evenly along the channel."""
        count = len(depth)
        bed = self.model.water.bed[0]
        scale = float(self.model.parameters.length) / 200.0
        for i in range(count // (2 * ARROWS), count, max(count // ARROWS, 1)):
            if depth[i] > THIN and abs(speed[i]) > 0.02:
                at = (float(self.model.x[i]), self.stretch * float(bed[i] + 0.5 * depth[i]))
                canvas.arrow(at, (scale * float(speed[i]), 0.0), "text1")
