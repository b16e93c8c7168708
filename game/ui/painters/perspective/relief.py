"""A table as two sheets for the eye of a camera: what lies at the cloth's height, what at that of the rails.

Both are the picture from above; its alpha says how much of a pixel is raised: cushions and wood but for the
pockets. Smaller copies, each half as large, serve what is far away (mip maps, Williams 1983).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pygame

from game.arrays import Floats
from game.billiards.table.table import CUSHION_DEPTH, Table
from game.ui.painters.table import SURROUND
from game.ui.painters.table_shapes import cushion_shapes
from game.ui.raster import clip_of, fill_disc, fill_polygon, pixels_of, scratch_for

SCALE = 420.0  # px to a metre of the largest copy
EDGE = 0.03  # m of floor about the frame
LEVELS = 5
LEAST_SIDE = 16  # px


class Relief(NamedTuple):
    """texels (n,) uint32: all copies, row by row, one after the other. levels (m, 4) int64: where each
    begins, columns, rows, and by how much it is smaller. bed (4,): half length and half width of the bed and
    of the table with its frame, m. scale: px to a metre of the first copy. height: of the rails, m.
    """

    texels: Any
    levels: Any
    bed: Floats
    scale: float
    height: float


def sheet_size(table: Table) -> tuple[int, int]:
    """Columns and rows of the picture from above that a relief is made of."""
    around = 2.0 * (SURROUND + EDGE)
    return round((table.length + around) * SCALE), round((table.width + around) * SCALE)


def relief_of(picture: pygame.Surface, table: Table, height: float) -> Relief:
    """A relief of a picture from above, of `sheet_size` with the bed in its middle. height: of rails, m."""
    columns, rows = picture.get_size()
    colours = pixels_of(picture) & 0xFFFFFF
    raised = _raised(table, (columns, rows))
    layer = _channels(colours, raised)
    texels, levels, begin = [], [], 0
    for level in range(LEVELS):
        rows, columns = layer.shape[:2]
        levels.append((begin, columns, rows, 1 << level))
        texels.append(_packed(layer))
        begin += rows * columns
        if min(rows, columns) < 2 * LEAST_SIDE:
            break
        even = layer[: rows // 2 * 2, : columns // 2 * 2]
        layer = 0.25 * (even[::2, ::2] + even[1::2, ::2] + even[::2, 1::2] + even[1::2, 1::2])
    half = np.array((0.5 * table.length, 0.5 * table.width))
    return Relief(
        np.concatenate(texels), np.array(levels, np.int64), np.concatenate((half, half + SURROUND)), SCALE,
        float(height),
    )  # fmt: skip


def _raised(table: Table, size: tuple[int, int]) -> Any:
    """How much of each pixel (rows, columns) is as high as the rails, 0 to 255."""
    mask = pygame.Surface(size, 0, 32)
    pixels, clip = pixels_of(mask), clip_of(mask)
    _, area, extent = scratch_for(pixels)
    left, top = 0.5 * size[0] - 0.5 * table.length * SCALE, 0.5 * size[1] - 0.5 * table.width * SCALE

    def points(places: Any) -> Any:
        return np.ascontiguousarray(np.asarray(places)[:, ::-1] * SCALE + (left, top))

    for reach, color in ((SURROUND, 0xFF), (CUSHION_DEPTH, 0)):
        far_x, far_y = table.width + reach, table.length + reach
        corners = ((-reach, -reach), (far_x, -reach), (far_x, far_y), (-reach, far_y))
        fill_polygon(pixels, clip, area, extent, points(corners), color, 1.0)
    for shape in cushion_shapes(table, CUSHION_DEPTH):
        fill_polygon(pixels, clip, area, extent, points(shape.outline), 0xFF, 1.0)
    for (x, y), radius in zip(points(table.pockets[:, :2]).tolist(), table.pockets[:, 2], strict=True):
        fill_disc(pixels, clip, x, y, float(radius) * SCALE, 0, 1.0)
    return (pixels & 0xFF).copy()


def _channels(colours: Any, raised: Any) -> Any:
    """Blue, green, red and raised share (rows, columns, 4) of packed colours."""
    parts = [(colours >> shift) & 0xFF for shift in (0, 8, 16)]
    return np.stack([*parts, raised], axis=2).astype(np.float64)


def _packed(layer: Any) -> Any:
    """Texels (n,) uint32 of channels (rows, columns, 4)."""
    parts = np.rint(layer).astype(np.uint32)
    shifts = np.array((0, 8, 16, 24), np.uint32)
    return np.bitwise_or.reduce(parts << shifts, axis=2).ravel()
