"""A painted picture behind a scene: which of its cells the pixels of a canvas show."""

from __future__ import annotations

from collections.abc import Hashable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel
from game.ui.canvas.canvas import Canvas


class Painted(NamedTuple):
    """Where a picture lies in the world: its upper left corner, and the width of its cells, m."""

    left: float
    top: float
    cell: float


def cells_seen(
    canvas: Canvas, painted: Painted, shape: tuple[int, ...]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Row of the picture for each row of pixels in the canvas's clip, and column for each column; the nearest
    ones beyond its edges. shape: rows and columns of the picture.
    """
    _, clip = canvas.raster_target
    width, height = max(int(clip[2] - clip[0]), 0), max(int(clip[3] - clip[1]), 0)
    (cx, cy), scale = canvas.camera.center, canvas.pixels_per_unit
    mid_x, mid_y = canvas.place((cx, cy))
    x = cx + (np.arange(width) + 0.5 + int(clip[0]) - mid_x) / scale
    y = cy - (np.arange(height) + 0.5 + int(clip[1]) - mid_y) / scale
    columns = np.clip(((x - painted.left) / painted.cell).astype(np.int64), 0, shape[1] - 1)
    rows = np.clip(((painted.top - y) / painted.cell).astype(np.int64), 0, shape[0] - 1)
    return rows, columns


@lean_kernel
def gather(layer: Any, rows: Any, columns: Any, out: Any) -> None:
    """Into out (h, w): cells (rows[y], columns[x]) of a layer."""
    for y in range(rows.shape[0]):
        row = rows[y]
        for x in range(columns.shape[0]):
            out[y, x] = layer[row, columns[x]]


class Seen:
    """Layers of a painted picture as the pixels of a canvas show them, kept while the view stands."""

    def __init__(self) -> None:
        self._key: Hashable = None
        self._sources: tuple[NDArray[Any], ...] = ()  # held, so that no other array can be taken for one
        self._layers: tuple[NDArray[Any], ...] = ()
        self.rows = self.columns = np.zeros(0, np.int64)  # of the picture, of each row and column of pixels

    def of(
        self, canvas: Canvas, painted: Painted, layers: tuple[NDArray[Any], ...]
    ) -> tuple[NDArray[Any], ...]:
        """Of each layer (h, w) the cell that each pixel in the canvas's clip shows; good until the next
        call.
        """
        _, clip = canvas.raster_target
        key = (canvas.camera.affine(), clip.tobytes(), painted, tuple(map(id, layers)))
        if key == self._key:
            return self._layers
        self._key, self._sources = key, layers
        self.rows, self.columns = cells_seen(canvas, painted, layers[0].shape)
        shape = (len(self.rows), len(self.columns))
        if [(one.shape, one.dtype) for one in self._layers] != [(shape, one.dtype) for one in layers]:
            self._layers = tuple(np.empty(shape, one.dtype) for one in layers)
        for layer, out in zip(layers, self._layers, strict=True):
            gather(layer, self.rows, self.columns, out)
        return self._layers


def warm_up_backdrop() -> None:
    """Compile what brings colours and light of a picture to pixels."""
    none = np.zeros(1, np.int64)
    for kind in (np.uint32, np.uint8):
        gather(np.zeros((1, 1), kind), none, none, np.zeros((1, 1), kind))
