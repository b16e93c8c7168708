"""Which cells of a painted picture the pixels of a canvas show."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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
