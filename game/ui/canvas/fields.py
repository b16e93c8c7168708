"""A verb for fields: an array of numbers as a smooth picture, over colours of the theme."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.ui.canvas.base import Point, Token
from game.ui.canvas.lights import LightCanvas
from game.ui.look.look import Look
from game.ui.raster.field import field_room, paint_field, shade_table
from game.ui.raster.veil import paint_veil, veil_room

Stop = tuple[float, Token]


class FieldCanvas(LightCanvas):
    """What is given on a grid."""

    def __init__(self, look: Look) -> None:
        super().__init__(look)
        self._tables: dict[tuple[tuple[float, int], ...], NDArray[np.uint32]] = {}
        self._room = field_room(0, 0)
        self._veil_room = veil_room(0)

    def field(
        self, values: Any, corner: Point, opposite: Point, stops: Sequence[Stop], alpha: float = 1.0
    ) -> None:
        """Values (rows, columns) between a lower left and an upper right corner in the world, cell by cell.

        stops: colours from (0, colour) to (1, colour); values outside take the nearest. The first row is the
        lowest. Linear between the middles of cells.
        """
        grid = np.ascontiguousarray(values, dtype=np.float32)
        table = self._table(stops)
        columns, width = grid.shape[1], self._pixels.shape[1]
        if len(self._room.row) < columns or len(self._room.first) < width:
            self._room = field_room(max(columns, len(self._room.row)), max(width, len(self._room.first)))
        left, bottom = self._place(corner)
        right, top = self._place(opposite)
        box = np.array((left, top, right, bottom))
        paint_field(self._pixels, self._clip, grid, box, table, self._room, float(alpha))

    def veil(
        self, values: Any, corner: Point, opposite: Point, smoke: Token, stops: Sequence[Stop],
        adds: bool = True,
    ) -> None:  # fmt: skip
        """Smoke and light (rows, columns, 2), both 0 to 1, over what is drawn, between two corners.

        The first covers with the colour ``smoke``. The second is light in the colours of ``stops``, added
        (the first stop is black then). Where ``adds`` is false it is laid over, as on a light ground.
        """
        cells = np.ascontiguousarray(values, dtype=np.float32)
        if len(self._veil_room.share) < self._pixels.shape[1]:
            self._veil_room = veil_room(self._pixels.shape[1])
        left, bottom = self._place(corner)
        right, top = self._place(opposite)
        box = np.array((left, top, right, bottom))
        paint_veil(
            self._pixels, self._clip, cells, box, self.ink(smoke), self._table(stops), self._veil_room, adds
        )

    def _table(self, stops: Sequence[Stop]) -> NDArray[np.uint32]:
        """256 colours through stops; a theme has colours of its own."""
        key = tuple((place, self.ink(color)) for place, color in stops)
        table = self._tables.get(key)
        if table is None:
            self._tables[key] = table = shade_table([(place, self.color(color)) for place, color in stops])
        return table
