"""Liquids of particles painted as bodies: lit from the upper left, deeper inside, glossy at their edge.

Each particle spreads its amount and its colour over a coarse lattice of the picture, by a smooth hump. The
surface is where the sum passes a half of what liquid at rest has. Its slope is taken for the tilt.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, bounds_of, fill_row

STEP = 3  # px between points of the lattice
REACH = 1.55  # spacings that a particle's hump reaches
EDGE = 0.5  # of the field of liquid at rest: its surface
WELL_IN = 0.92  # of it: from here on a place lies well inside
ALIKE = 0.02  # of a colour: cells whose corners differ by less have one colour
SOFT = 0.12  # of the field over which the edge goes
RIM, GLOSS = 0.32, 0.75  # light at the edge's lit side, and where it is brightest
DEEP = 0.14  # darker inside than at the surface
LIGHT = (-0.55, -0.83)  # to the lamp, in pixels


@lean_kernel
def spread(field, places, reach, inks, amounts):
    """Add humps to a field (4, rows, columns): amount, and colours times it. places: (n, 2) points.

    inks: (n, 3) 0 to 1; amounts (n,); reach: points.
    """
    rows, columns = field.shape[1], field.shape[2]
    field[:] = 0.0
    for i in range(len(places)):
        x, y = places[i, 0], places[i, 1]
        if not (-reach < x < columns + reach and -reach < y < rows + reach):
            continue
        for row in range(max(math.ceil(y - reach), 0), min(math.floor(y + reach), rows - 1) + 1):
            for column in range(max(math.ceil(x - reach), 0), min(math.floor(x + reach), columns - 1) + 1):
                dx, dy = (column - x) / reach, (row - y) / reach
                near = 1.0 - dx * dx - dy * dy
                if near > 0.0:
                    part = amounts[i] * near * near
                    field[0, row, column] += part
                    for c in range(3):
                        field[1 + c, row, column] += part * inks[i, c]


@inner_kernel
def _between(field, c, row, column, down, right):
    """A field within a cell of its lattice, in lines."""
    top = field[c, row, column] + right * (field[c, row, column + 1] - field[c, row, column])
    low = field[c, row + 1, column] + right * (field[c, row + 1, column + 1] - field[c, row + 1, column])
    return top + down * (low - top)


@inner_kernel
def _lit(field, row, column, down, right, full):
    """Colour 0xRRGGBB and weight 0 to 1 of the liquid within a cell."""
    amount = _between(field, 0, row, column, down, right) / full
    cover = (amount - EDGE + 0.5 * SOFT) / SOFT
    if cover <= 0.0:
        return 0, 0.0
    nx = (field[0, row, column + 1] - field[0, row, column]) * (1.0 - down)
    nx += (field[0, row + 1, column + 1] - field[0, row + 1, column]) * down
    ny = (field[0, row + 1, column] - field[0, row, column]) * (1.0 - right)
    ny += (field[0, row + 1, column + 1] - field[0, row, column + 1]) * right
    nx, ny = -nx / full, -ny / full
    steep = math.sqrt(nx * nx + ny * ny)
    facing = (nx * LIGHT[0] + ny * LIGHT[1]) / (steep + 0.04)
    inside = min(max((amount - EDGE) / (WELL_IN - EDGE), 0.0), 1.0)
    shade = 1.0 - DEEP * inside + RIM * facing * (1.0 - inside)
    gloss = max(facing, 0.0)
    gloss = GLOSS * gloss * gloss * gloss * 4.0 * max(inside - 0.05, 0.0) * max(0.6 - inside, 0.0) / 0.3
    whole = max(amount * full, 1e-9)
    ink = 0
    for c in range(3):
        own = _between(field, 1 + c, row, column, down, right) / whole * shade
        own += gloss * (1.0 - own)
        ink = ink << 8 | int(min(max(255.0 * own, 0.0), 255.0))
    return ink, min(cover, 1.0)


@inner_kernel
def _even_ink(field, row, column, full):
    """Colour 0xRRGGBB of a cell that lies well inside and has one colour, or -1."""
    ink = 0
    for c in range(1, 4):
        low, high, total = 1.0, 0.0, 0.0
        for j in range(row, row + 2):
            for i in range(column, column + 2):
                if field[0, j, i] < WELL_IN * full:
                    return -1
                own = field[c, j, i] / field[0, j, i]
                low, high, total = min(low, own), max(high, own), total + own
        if high - low > ALIKE:
            return -1
        ink = ink << 8 | int(min(max(255.0 * 0.25 * total * (1.0 - DEEP), 0.0), 255.0))
    return ink


@lean_kernel
def paint_liquid(pixels, clip, field, full):
    """Lay the liquid of a field over a picture; points of the field are STEP px apart from its corner."""
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    rows, columns = field.shape[1] - 1, field.shape[2] - 1
    least = full * (EDGE - 0.5 * SOFT)
    for row in range(rows):
        for column in range(columns):
            most = max(
                max(field[0, row, column], field[0, row, column + 1]),
                max(field[0, row + 1, column], field[0, row + 1, column + 1]),
            )
            if most <= least:
                continue
            even = _even_ink(field, row, column, full)
            if even >= 0:
                left = clip[0] + column * STEP
                for y in range(max(clip[1] + row * STEP, y_low), min(clip[1] + row * STEP + STEP, y_high)):
                    fill_row(pixels, y, max(left, x_low), min(left + STEP, x_high), even, 256)
                continue
            for j in range(STEP):
                y = clip[1] + row * STEP + j
                if not y_low <= y < y_high:
                    continue
                for i in range(STEP):
                    x = clip[0] + column * STEP + i
                    if x_low <= x < x_high:
                        ink, weight = _lit(field, row, column, (j + 0.5) / STEP, (i + 0.5) / STEP, full)
                        if weight > 0.0:
                            blend(pixels, y, x, ink, int(256.0 * weight))


def field_at_rest(reach: float) -> float:
    """Amount of liquid at rest, a square lattice of spacing 1, at the mean place; reach: in spacings."""
    return math.pi * reach * reach / 3.0


class ParticleLiquidPainter:
    """Keeps the field from picture to picture."""

    def __init__(self) -> None:
        self._field: Floats = np.zeros((4, 2, 2))

    def paint(self, target: tuple, places: Floats, spacing: float, inks: Floats, amounts: Floats) -> None:
        """Paint particles at places (n, 2) px of the picture; spacing: px; inks: (n, 3) 0 to 1."""
        pixels, clip = target
        shape = (4, int(clip[3] - clip[1]) // STEP + 2, int(clip[2] - clip[0]) // STEP + 2)
        if min(shape) < 2 or not len(places):
            return
        if self._field.shape != shape:
            self._field = np.zeros(shape)
        reach = max(REACH * spacing / STEP, 1.0)
        corner = np.array((float(clip[0]), float(clip[1])))
        spread(self._field, (places - corner) / STEP, reach, inks, amounts)
        full = field_at_rest(reach * STEP / spacing)
        paint_liquid(pixels, clip, self._field, full)


def warm_up_particle_liquid() -> None:
    """Compile it on a picture of a few pixels."""
    target = np.zeros((12, 12), dtype=np.uint32), np.array((0, 0, 12, 12), dtype=np.int64)
    ParticleLiquidPainter().paint(target, np.full((1, 2), 6.0), 4.0, np.full((1, 3), 0.5), np.ones(1))
