"""Water painted from signed distances at nodes, as `game.worlds.painting.liquid` paints it from particles."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.painting.liquid import DAY, NIGHT, paint_field, shades_of

SHALLOW = 1.5  # points of depth for a cell: colours darken downwards as in a body of liquid


class DistancePainter:
    """Keeps the fields of pictures of one size. shape: rows and columns of nodes."""

    def __init__(self, shape: tuple[int, int]):
        self._fields: Floats = np.zeros((4, *shape))
        self._lines: Floats = np.zeros((4, shape[1]))

    def draw(self, canvas: Canvas, distance: Floats, corner: tuple[float, float], cell: float) -> None:
        """Liquid where distances (rows, columns) m are below 0; corner: of the first node, m."""
        rows, columns = distance.shape
        self._fields[0] = np.clip(0.5 - 0.5 * distance / cell, -1.0, 2.0)
        self._fields[2] = np.maximum(-distance / cell, 0.0) * SHALLOW
        left, bottom = canvas.place(corner)
        right, top = canvas.place((corner[0] + (columns - 1) * cell, corner[1] + (rows - 1) * cell))
        pixels, clip = canvas.raster_target
        tank = np.array((math.floor(left), math.floor(top), math.ceil(right), math.ceil(bottom)), np.int64)
        tank = np.concatenate([np.maximum(tank[:2], clip[:2]), np.minimum(tank[2:], clip[2:])])
        if (tank[2:] > tank[:2]).all():
            shades = shades_of(*(NIGHT if is_dark(canvas) else DAY))
            where = (float(left), float(bottom), cell * canvas.pixels_per_unit)
            paint_field(pixels, tank, self._fields, self._lines, shades, where)
