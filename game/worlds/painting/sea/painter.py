"""Paints a sea before a plane and behind it, so that a boat may stand between."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Inks
from game.worlds.painting.sea import cuts as cut
from game.worlds.painting.sea.cuts import AWAY, HORIZON, NEAREST, NO_WAKE, Cuts, Eye, Light, Wake
from game.worlds.painting.sea.pixels import (
    SLOPES,
    Paper,
    Patterns,
    Shades,
    fill_mirrors,
    froth_of,
    glow_table,
    paint_sea,
)
from game.worlds.painting.sea.ripples import CELLS, LEVELS, SIDE, Ripples, is_short, mean_square_slope

NO_PICTURE: Inks = np.zeros((0, 0), np.uint32)
CLEAR, FOGGY = 900.0, 350.0  # m by which the air has taken most of what is seen, in fair weather and foul
ROUGHER = 0.12  # of the sea's mean square slope: ripples finer than a tile can hold


class Water(NamedTuple):
    """Waves (n, 5) of a `Sea`; the light; colours (k, 3) of the sky by the root of the sine of height;
    gravity, m/s²; wind, m/s; m by which foam has gone along x and z; haze, 0 to 1; the wake of a boat.
    """

    rows: Floats
    light: Light
    sky: Floats
    gravity: float
    wind: float
    moves: Floats
    haze: float = 0.0
    wake: Wake = NO_WAKE


class SeaPainter:
    """Keeps the cuts of a picture, and the tile of short waves. every: of so many columns one is lit."""

    def __init__(self, every: int = 2) -> None:
        self.every = every
        self.ripples = Ripples()
        self._width = 0

    def _cuts(self, width: int, near: bool, lowest: float) -> Cuts:
        """Those before the plane, or behind it. lowest: shrinking at the picture's lower edge."""
        count = -(-width // cut.STEP) + 2
        if count != self._width:
            self._width = count
            self._sums, self._foam = np.zeros((4, count)), np.zeros(count)
            self._samples = [np.zeros((n, 6, count)) for n in (cut.LAYERS_NEAR, cut.LAYERS_FAR)]
            self._mirrors = np.zeros((max(cut.LAYERS_FAR, cut.LAYERS_NEAR), SLOPES, 4))
        samples = self._samples[0 if near else 1]
        ends = (lowest, NEAREST + 0.035) if near else (NEAREST + 0.12, cut.FARTHEST)
        shrinks = np.linspace(*ends, len(samples))
        return Cuts(shrinks, samples, np.zeros(len(samples)), self._sums, self._foam)

    def paint(self, canvas: Any, water: Water, near: bool, bare: Inks = NO_PICTURE, beside: int = 0) -> None:
        """The sea before the plane x, y, or behind it. bare (h, w): the picture before there was a boat in
        it, from the column ``beside`` on."""
        pixels, clip = canvas.raster_target
        width = int(clip[2] - clip[0])
        if width <= 1:
            return
        seen = canvas.camera.visible()
        x, y = canvas.place((0.0, 0.0))
        scale = float(canvas.pixels_per_unit)
        eye = Eye(0.5 * (seen.left + seen.right), float(x - clip[0]), float(y), scale)
        cuts = self._cuts(width, near, 1.5 * max((HORIZON - seen.bottom) / HORIZON, NEAREST + 0.05))
        shrinks, light, gravity = cuts.shrinks, water.light, max(water.gravity, 0.1)
        long = np.ascontiguousarray(water.rows[~is_short(water.rows)])
        crests = cut.crests_of(long, water.wind, gravity)
        cut.see_sea(long, cuts, eye, light, water.wake, cut.wake_table(), crests, gravity)
        shades = self._shades(cuts, scale, water, near)
        fog = 1.0 - np.exp(-AWAY / shrinks / (CLEAR + water.haze * (FOGGY - CLEAR)))
        fill_mirrors(shrinks, shades, water.sky, light, fog)
        shades.rough[:] *= 2.0
        red, green, blue = (a - b for a, b in zip(light.thin, light.deep, strict=True))
        patterns = Patterns(self.ripples.tiles, froth_of(), glow_table(), water.moves)
        paper = Paper(pixels, clip, bare, beside, self.every)
        paint_sea(paper, eye, light._replace(thin=(red, green, blue)), cuts, shades, patterns)

    def _shades(self, cuts: Cuts, scale: float, water: Water, near: bool) -> Shades:
        """With mirrors that are to be filled. scale: px to a m."""
        shrinks = cuts.shrinks
        pixel = AWAY / (shrinks * shrinks * scale * HORIZON)  # m of a row of pixels, away from the eye
        levels = np.rint(np.log2(np.maximum(pixel * CELLS / SIDE, 1.0))).astype(np.int64)
        levels = np.minimum(levels, LEVELS)
        rough = self.ripples.rough[levels] + cuts.lost + ROUGHER * mean_square_slope(water.wind)
        veils = np.where(near & (shrinks <= 1.14), 215, 256).astype(np.int64)
        return Shades(levels, self._mirrors[: len(shrinks)], rough, veils)


class _Nowhere(NamedTuple):
    """As much of a canvas as is asked for."""

    raster_target: Any
    pixels_per_unit: float
    camera: Any

    @staticmethod
    def place(at: Any) -> Any:
        return at


class _Seen(NamedTuple):
    left: float = 0.0
    right: float = 8.0
    bottom: float = -4.0
    top: float = 8.0

    def visible(self) -> Any:
        return self


def warm_up_sea() -> None:
    """Compile what paints, on a tiny picture."""
    light = Light(*(((0.0, 0.0, 0.0),) * 4), (0.3, 0.3, 0.9), 1.0)
    rows = np.array([[0.1, 0.3, 0.1, 1.0, 0.0]])
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    painter = SeaPainter()
    painter.ripples.make(rows, (1.0, 0.0), 0.0, 0.0)
    canvas = _Nowhere((pixels, clip), 1.0, _Seen())
    painter.paint(canvas, Water(rows, light, np.zeros((8, 3)), 9.81, 1.0, np.zeros(2)), near=True)
