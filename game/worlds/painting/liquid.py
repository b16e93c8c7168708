"""A liquid of particles painted as a body of water: lit from above, deep below, white where it is torn.

The particles' shares of a lattice of half cells, blurred, are a smooth field. Its
surface is where it is a half.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from game.arrays import Floats, Inks
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid import Liquid
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.ui.raster.pixels import blend, bounds_of, fill_row
from game.worlds.painting.inks import channels, color_of, opaque

SHADES = 64  # colours from the surface downwards
DEEP = 40.0  # points of the field over which they go
SEEN = 0.84  # share of the water's own colour over what is behind it
BODY = 0.8  # of the field: from here on a pixel lies well inside
SKIN = 3.2  # px of light at the surface
BENT = 7.0  # px by which the surface displaces what is seen through it
WHITE = 0xF2FAFF
DAY, NIGHT = (0x6CC0D2, 0x0C4A74), (0x3A8FB0, 0x072338)  # at the surface and deep down
WALL_DAY, WALL_NIGHT = (0xF3F1EA, 0xC8D2D6), (0x27333E, 0x10161C)  # at the top and the bottom
TABLE = (0xB08A63, 0x3B2C20)  # by day, by night
COVERED = 0.85  # of the full field: with less, a point lies in a solid
TORN, TORN_WHOLE = 0.7, 2.6  # change of speed over a cell, in sqrt(g cell): where foam begins, is full
AIRY, AIRLESS = 4.0, 9.0  # points below the surface: down to here all foam is seen; from here on none
SPRAY_LEAST = 0.3  # of the field: where it is less, a particle is drawn as a drop


@inner_kernel
def _spread(field, x, y, amount):
    """Add an amount around a place (points), by a quadratic B-spline."""
    i, j = math.floor(x + 0.5), math.floor(y + 0.5)
    for m in range(-1, 2):
        if not 0 <= j + m < field.shape[0]:
            continue
        b = abs(y - (j + m))
        up = 0.75 - b * b if b < 0.5 else 0.5 * (1.5 - b) * (1.5 - b)
        for n in range(-1, 2):
            if 0 <= i + n < field.shape[1]:
                a = abs(x - (i + n))
                along = 0.75 - a * a if a < 0.5 else 0.5 * (1.5 - a) * (1.5 - a)
                field[j + m, i + n] += amount * up * along


@inner_kernel
def _blur(field, spare):
    """Means with 1, 2, 1 along rows and columns, in place."""
    rows, columns = field.shape
    for j in range(rows):
        for i in range(columns):
            left, right = field[j, max(i - 1, 0)], field[j, min(i + 1, columns - 1)]
            spare[j, i] = 0.25 * (left + right) + 0.5 * field[j, i]
    for j in range(rows):
        low, mid, high = spare[max(j - 1, 0)], spare[j], spare[min(j + 1, rows - 1)]
        for i in range(columns):
            field[j, i] = 0.25 * (low[i] + high[i]) + 0.5 * mid[i]


@lean_kernel
def fill_full(quarters, full, spare):
    """What the field would be, were everything but solids full; quarters as `surface.fill_room` has them."""
    rows, columns = full.shape
    for j in range(rows):
        for i in range(columns):
            total = 0.0
            for y in range(max(j - 1, 0), min(j + 1, rows - 1)):
                for x in range(max(i - 1, 0), min(i + 1, columns - 1)):
                    total += quarters[y, x]
            full[j, i] = 0.25 * total
    _blur(full, spare)
    _blur(full, spare)


@inner_kernel
def _beside(field, full, j, i):
    """The field of a point in a solid, which is painted over it: that of the points around."""
    rows, columns = field.shape
    total, most = 0.0, 0.0
    for y in range(max(j - 3, 0), min(j + 4, rows)):
        for x in range(max(i - 3, 0), min(i + 4, columns)):
            if full[y, x] > COVERED:
                total, most = total + field[y, x], most + full[y, x]
    return total / most if most > 0.0 else 0.0


@inner_kernel
def _find_depth(field, full, depth):
    """Points below the surface: one more than in the mean of the three above. Solids count as liquid, so that
    they throw no light.
    """
    rows, columns = field.shape
    for j in range(rows - 1, -1, -1):
        for i in range(columns):
            depth[j, i] = 0.0
            if j < rows - 1 and (field[j, i] >= 0.4 or full[j, i] <= 0.8):
                left, right = depth[j + 1, max(i - 1, 0)], depth[j + 1, min(i + 1, columns - 1)]
                depth[j, i] = 1.0 + 0.25 * (left + right) + 0.5 * depth[j + 1, i]


@lean_kernel
def see_liquid(places, white, full, fields, frame):
    """Fields (4, rows, columns): liquid, foam, depth below the surface (points), spare.

    places (n, 2) m; white: (n,) 0 to 1; frame: x, y (m) of the first point, points a metre, amount of each,
    how often means are taken of the liquid.
    """
    field, foam, depth, spare = fields[0], fields[1], fields[2], fields[3]
    field[:], foam[:] = 0.0, 0.0
    for k in range(places.shape[0]):
        x, y = (places[k, 0] - frame[0]) * frame[2], (places[k, 1] - frame[1]) * frame[2]
        _spread(field, x, y, frame[3])
        if white[k] > 0.0:
            _spread(foam, x, y, frame[3] * white[k])
    for _ in range(frame[4]):
        _blur(field, spare)
    _blur(foam, spare)
    rows, columns = field.shape
    for j in range(rows):
        for i in range(columns):
            spare[j, i] = field[j, i]
    for j in range(rows):
        for i in range(columns):
            if full[j, i] > COVERED:
                field[j, i], foam[j, i] = field[j, i] / full[j, i], foam[j, i] / full[j, i]
            else:
                field[j, i], foam[j, i] = _beside(spare, full, j, i), 0.0
    _find_depth(field, full, depth)
    _blur(depth, spare)
    for j in range(rows):  # air is torn in at the surface; what is torn deeper down only shears
        for i in range(columns):
            foam[j, i] *= min(max((AIRLESS - depth[j, i]) / (AIRLESS - AIRY), 0.0), 1.0)


@inner_kernel
def _edge_pixel(pixels, row, column, here, ink):
    """A pixel near the surface. here: value of the field, its slopes to the right and up a px, foam."""
    value, along, up, foam = here
    slope = max(math.sqrt(along * along + up * up), 1e-3)
    inside = (value - 0.5) / slope
    cover = min(max(inside + 0.5, 0.0), 1.0)
    if cover <= 0.0:
        return
    bend = BENT * max(1.0 - inside / 14.0, 0.0)
    y, x = row + int(bend * (1.0 - 0.5 * up / slope)), column + int(bend * along / slope)
    if 0 <= x < pixels.shape[1] and 0 <= y < pixels.shape[0]:  # what lies lower is not painted over yet
        blend(pixels, row, column, int(pixels[y, x]) & 0xFFFFFF, int(256.0 * cover))
    blend(pixels, row, column, ink, int(256.0 * SEEN * cover))
    light = max(1.0 - abs(inside - 0.8) / SKIN, 0.0) * (0.28 + 0.62 * max(-up / slope, 0.0))
    light = max(light, min(foam, 1.0) * 0.85)
    blend(pixels, row, column, WHITE, int(256.0 * min(light, 0.9) * cover))


@lean_kernel
def paint_field(pixels, clip, fields, lines, shades, where):
    """Lay the liquid over a picture.

    lines: (4, columns) spare; where: x, y px of the first point, px a point.
    """
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    rows, columns = fields.shape[1], fields.shape[2]
    step = where[2]
    top = max(y_low, math.floor(where[1] - (rows - 1) * step))
    for row in range(top, min(y_high, math.ceil(where[1]))):
        y = (where[1] - (row + 0.5)) / step
        if not 0.0 <= y < rows - 1:
            continue
        j = int(y)
        part = y - j
        for m in range(3):
            low, high, goal = fields[m, j], fields[m, j + 1], lines[m]
            for i in range(columns):
                goal[i] = low[i] + part * (high[i] - low[i])
        low, high, rise = fields[0, j], fields[0, j + 1], lines[3]
        for i in range(columns):
            rise[i] = (high[i] - low[i]) / step
        for i in range(columns - 1):
            one, other = lines[0, i], lines[0, i + 1]
            if one < 0.4 and other < 0.4:
                continue
            first = max(x_low, math.ceil(where[0] + i * step - 0.5))
            last = min(x_high, math.ceil(where[0] + (i + 1) * step - 0.5))
            foam = 0.5 * (lines[1, i] + lines[1, i + 1])
            deep = 0.5 * (lines[2, i] + lines[2, i + 1])
            ink = int(shades[min(int(deep * SHADES / DEEP), SHADES - 1)])
            if one > BODY and other > BODY and deep > 2.0:
                fill_row(pixels, row, first, last, ink, int(256.0 * SEEN))
                if foam > 0.02:
                    fill_row(pixels, row, first, last, WHITE, int(256.0 * min(0.75 * foam, 0.75)))
                continue
            for column in range(first, last):
                f = (column + 0.5 - where[0]) / step - i
                here = (
                    one + f * (other - one), (other - one) / step, rise[i] + f * (rise[i + 1] - rise[i]),
                    lines[1, i] + f * (lines[1, i + 1] - lines[1, i]),
                )  # fmt: skip
                _edge_pixel(pixels, row, column, here, ink)


@lean_kernel
def paint_backdrop(pixels, clip, shades):
    """Cover a picture with rows of colours, from top to bottom."""
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    for row in range(y_low, y_high):
        k = (row - y_low) * SHADES // max(y_high - y_low, 1)
        fill_row(pixels, row, x_low, x_high, int(shades[k]), 256)


def draw_backdrop(canvas: Canvas) -> None:
    """A wall in even light, behind a tank."""
    pixels, clip = canvas.raster_target
    paint_backdrop(pixels, clip, shades_of(*(WALL_NIGHT if is_dark(canvas) else WALL_DAY)))


def draw_table(canvas: Canvas, height: float) -> None:
    """The table that a tank stands on: everything in sight below a height (m)."""
    seen = canvas.camera.visible()
    corners = [(seen.left, seen.bottom), (seen.right, seen.bottom), (seen.right, height), (seen.left, height)]
    canvas.polygon(corners, color_of(TABLE[is_dark(canvas)]))


@lru_cache(maxsize=8)
def shades_of(above: int, below: int) -> Inks:
    """(SHADES,) colours, darker downwards at first fast."""
    share = (np.linspace(0.0, 1.0, SHADES) ** 0.6)[:, None]
    return opaque(channels(above) + (channels(below) - channels(above)) * share)


class LiquidPainter:
    """Keeps the fields of one liquid's picture. soft: how often means are taken, which takes teeth off its
    edge where a flow has drawn out the rows of particles."""

    def __init__(self, liquid: Liquid, soft: int = 2):
        self.soft = soft
        shape = (2 * liquid.grid.ny + 1, 2 * liquid.grid.nx + 1)
        self.liquid = liquid
        self._fields: Floats = np.zeros((4, *shape))
        self._full: Floats = np.zeros(shape)
        self._lines: Floats = np.zeros((4, shape[1]))

    def draw(self, canvas: Canvas, places: Floats) -> None:
        """The liquid with its particles at places (n, 2) m."""
        liquid, grid = self.liquid, self.liquid.grid
        pixels, clip = canvas.raster_target
        points = 2.0 / grid.cell
        fill_full(liquid.quarters, self._full, self._fields[3])
        amount = (2.0 / liquid.spread) ** 2
        frame = (grid.lower[0], grid.lower[1], points, amount, self.soft)
        white = foam_of(liquid)
        see_liquid(np.ascontiguousarray(places), white, self._full, self._fields, frame)
        x, y = canvas.place(grid.lower)
        step = canvas.pixels_per_unit / points
        shades = shades_of(*(NIGHT if is_dark(canvas) else DAY))
        paint_field(pixels, clip, self._fields, self._lines, shades, (x, y, step))
        self._draw_spray(canvas, places, shades)

    def _draw_spray(self, canvas: Canvas, places: Floats, shades: Inks) -> None:
        """Particles that are too few for a surface, as drops."""
        liquid, grid = self.liquid, self.liquid.grid
        at = ((places - grid.lower) * (2.0 / grid.cell) + 0.5).astype(np.int64)
        field = self._fields[0]
        column, row = (np.clip(at[:, k], 0, field.shape[1 - k] - 1) for k in (0, 1))
        loose = field[row, column] < SPRAY_LEAST
        if loose.any():
            radius = 0.5 * math.sqrt(liquid.area / math.pi) * 1.3
            canvas.discs(places[loose], radius, int(shades[10]) & 0xFFFFFF, 0.9)


def foam_of(liquid: Liquid) -> Floats:
    """(n,) 0 to 1: how torn the liquid is at each particle."""
    change = liquid.particles.affine[: liquid.count]
    pull = max(abs(liquid.settings.gravity), 0.1)
    torn = np.sqrt(np.square(change).sum(axis=1) / (pull * liquid.grid.cell))
    return np.asarray(np.clip((torn - TORN) / (TORN_WHOLE - TORN), 0.0, 1.0))


def warm_up_backdrop() -> None:
    """Compile what paints the wall, on a tiny picture."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    paint_backdrop(pixels, clip, shades_of(*DAY))


def warm_up_liquid() -> None:
    """Compile what paints, on a tiny picture."""
    warm_up_backdrop()
    fields, full = np.zeros((4, 5, 5)), np.zeros((5, 5))
    fill_full(np.ones((4, 4)), full, fields[3])
    see_liquid(np.full((1, 2), 0.5), np.ones(1), full, fields, (0.0, 0.0, 4.0, 1.0, 2))
    shades = shades_of(*DAY)
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    paint_field(pixels, clip, fields, np.zeros((4, 5)), shades, (0.0, 8.0, 2.0))
