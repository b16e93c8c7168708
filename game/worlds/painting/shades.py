"""Pictures in two lights, painted cell by cell and laid on a canvas: grids, soft steps, finer cells."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Singles
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.lit import lit_room, paint_lit

Plane = NDArray[Any]  # (rows, columns), the lowest row first
Box = tuple[tuple[float, float], tuple[float, float]]  # m: lower left and upper right corner
Light = tuple[float, float, float]  # red, green, blue: 1 as it was painted
FINE = 4  # cells to one, of `finer`


def smoothstep(low: float, high: float, value: Any) -> Plane:
    """0 below ``low``, 1 above ``high``, softly between; the other way round where low is above high."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


def bump(value: Any, wide: float) -> Plane:
    """1 where a value is 0, and by Gauss's curve less where it is not; ``wide``: where it is 1/e."""
    return np.asarray(np.exp(-((value / wide) ** 2)))


def grid_of(box: Box, shape: tuple[int, int]) -> tuple[Plane, Plane]:
    """x and y (rows, columns) m of the middles of cells of a picture in a box."""
    (left, bottom), (right, top) = box
    x = left + (np.arange(shape[1]) + 0.5) * (right - left) / shape[1]
    y = bottom + (np.arange(shape[0]) + 0.5) * (top - bottom) / shape[0]
    return np.broadcast_to(x[None, :], shape), np.broadcast_to(y[:, None], shape)


def lay(colors: Plane, where: Plane, ink: Any) -> None:
    """Another colour, or other ones (rows, columns, 3), where a shape is."""
    colors[where] = np.broadcast_to(np.asarray(ink, np.float64), colors.shape)[where]


def soft(cells: Plane, sigma: tuple[float, float]) -> Plane:
    """(rows, columns, ...) blurred by so many cells down and across."""
    for axis, wide in enumerate(sigma):
        places = np.arange(cells.shape[axis])
        weights = np.exp(-0.5 * ((places[:, None] - places[None]) / wide) ** 2)
        weights /= weights.sum(axis=1, keepdims=True)
        cells = np.moveaxis(np.tensordot(weights, cells, axes=(1, axis)), 0, axis)
    return cells


def in_two_lights(own: Plane, flame: Plane, cover: Plane) -> Singles:
    """A picture as `lay_lit` takes it: colours (rows, columns, 3) in the room's light and in the flame's, and
    opacity (rows, columns)."""
    layers = np.concatenate([own, flame, cover[..., None]], axis=2)
    return np.ascontiguousarray(np.moveaxis(layers, 2, 1), dtype=np.float32)


def lit(color: Plane, own: Plane, flame: Plane, cover: Plane) -> Singles:
    """The same of one colour (rows, columns, 3) and how strong both lights are on it."""
    return in_two_lights(color * (own * cover)[..., None], color * (flame * cover)[..., None], cover)


def lay_lit(
    canvas: Canvas, layers: Singles, box: Box, own: Light, flame: Light,
    bend: Floats | None = None,
) -> None:  # fmt: skip
    """Lay a picture between two corners (m) in the room's light and in the flame's; bend (rows,) m."""
    pixels, clip = canvas.raster_target
    (left, bottom), (right, top) = canvas.place(box[0]), canvas.place(box[1])
    moved = np.zeros(layers.shape[0]) if bend is None else bend * canvas.pixels_per_unit
    paint_lit(
        pixels, clip, layers, np.array((left, top, right, bottom)), moved,
        np.array((*own, *flame), np.float32), lit_room(layers.shape[2], pixels.shape[1]),
    )  # fmt: skip


@lru_cache(maxsize=1)
def _weights() -> Floats:
    """(FINE, 5) of a cell and two to either side: cubic B-splines about their middles."""
    at = (np.arange(FINE) + 0.5) / FINE - 0.5
    away = np.abs(at[:, None] - np.arange(-2, 3)[None])
    return np.where(away < 1.0, 2.0 / 3.0 - away**2 + 0.5 * away**3, np.maximum(2.0 - away, 0.0) ** 3 / 6.0)


def finer(cells: Any) -> Any:
    """Cells (rows, columns, ...) FINE times as many both ways, and so smooth that none of them is seen."""
    for axis in range(2):
        own = np.moveaxis(cells, axis, 0)
        count = len(own)
        wider = own[np.clip(np.arange(-2, count + 2), 0, count - 1)]
        parts = [sum(w * wider[k : k + count] for k, w in enumerate(row)) for row in _weights().tolist()]
        smooth = np.stack(parts, axis=1).reshape(FINE * count, *own.shape[1:])
        cells = np.moveaxis(smooth, 0, axis)
    return cells
