"""Cells of a grid, shaded by the boxes in them."""

from __future__ import annotations

import math

import numpy as np
import pygame
from numpy.typing import NDArray

from game.ui.canvas.canvas import Canvas
from game.ui.painters.boxes import paint_raster, shades

LEAST_CELL = 5.0  # px; smaller cells are shaded together


def draw_loads(
    canvas: Canvas, loads: NDArray[np.int32], cell: float, full: float, color: str = "chalk"
) -> None:
    """Cells shaded by the number of boxes in them, from none to ``full`` and above; small cells together."""
    together = max(math.ceil(LEAST_CELL * canvas.k / (cell * canvas.pixels_per_unit)), 1)
    rows, columns = loads.shape
    if together > 1:
        high, wide = -(-rows // together), -(-columns // together)
        padded = np.zeros((high * together, wide * together), dtype=np.int32)
        padded[:rows, :columns] = loads
        across = padded.reshape(high, together, wide * together).sum(axis=1)
        shaded = across.reshape(high, wide, together).sum(axis=2) / together**2
    else:
        shaded = loads.astype(np.float64)
    height, width = (n * together * cell for n in shaded.shape)
    paint_raster(canvas, shades(canvas, 0.42 * shaded / full, color), (0.0, 0.0), (width, height))
    if together == 1 and cell * canvas.pixels_per_unit >= 9.0 * canvas.k:
        _draw_cells(canvas, rows, columns, cell)


def _draw_cells(canvas: Canvas, rows: int, columns: int, cell: float) -> None:
    """Borders of cells on whole pixels, as the grid of every stage has them: sharp, and quickly filled."""
    to_screen, surface, color = canvas.camera.to_screen, canvas.surface, canvas.color("grid2")
    (left, bottom), (right, top) = (to_screen(0.0, 0.0), to_screen(columns * cell, rows * cell))
    area = pygame.Rect(int(left), int(top), int(right) - int(left) + 1, int(bottom) - int(top) + 1)
    area = area.clip(canvas.rect)
    for i in range(columns + 1):
        x = int(left + i * (right - left) / columns)
        if area.left <= x < area.right:
            surface.fill(color, (x, area.top, 1, area.h))
    for i in range(rows + 1):
        y = int(bottom + i * (top - bottom) / rows)
        if area.top <= y < area.bottom:
            surface.fill(color, (area.left, y, area.w, 1))
