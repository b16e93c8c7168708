"""Boards and boxes as polygons, to be painted at once."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.kernels import elementwise
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.polygons import NO_EDGE, paint

WHOLE = (-1.0, -1.0, 1.0, 1.0)  # of a box, in shares of its half sizes
# of a stone's face: pits and chips, each at a place and of half a size, in shares of half sizes
PITS = ((-0.62, 0.18, 0.1, 0.16), (0.14, -0.3, 0.16, 0.1), (0.55, 0.42, 0.08, 0.14), (-0.2, 0.5, 0.12, 0.08))
LIT_SIDE, SHADED_SIDE = (-1.0, 0.55, 1.0, 1.0), (-1.0, -1.0, 1.0, -0.6)
SMOOTH = 0.5  # rad: where a floor turns by more, its board ends


class Shapes(NamedTuple):
    """Corners (v, 2) m of polygons, and the first corner of each, (m + 1,)."""

    corners: Floats
    starts: Longs


def boards_of(points: Floats, thick: float) -> Shapes:
    """What a floor is made of, ``thick`` m deep; a polygon for each smooth run."""
    along = np.diff(points, axis=0)
    angles = elementwise.arctan2(along[:, 1], along[:, 0])
    turns = np.abs(np.remainder(np.diff(angles) + math.pi, math.tau) - math.pi)
    cuts = [0, *(np.flatnonzero(turns > SMOOTH) + 1).tolist(), len(along)]
    parts = []
    for first, last in pairwise(cuts):
        run = points[first : last + 1]
        normals = np.stack(
            [elementwise.sin(angles[first:last]), -elementwise.cos(angles[first:last])], axis=1
        )
        both = np.concatenate([normals[:1], 0.5 * (normals[1:] + normals[:-1]), normals[-1:]])
        parts.append(np.concatenate([run, (run + thick * both)[::-1]]))
    return joined(parts)


def joined(parts: list[Floats]) -> Shapes:
    """Polygons one after the other."""
    starts = np.cumsum([0, *(len(part) for part in parts)])
    return Shapes(np.concatenate([np.zeros((0, 2)), *parts]), starts.astype(np.int64))


def moved(shapes: Shapes, by: Floats) -> Shapes:
    """The same elsewhere: ``by`` (2,) m."""
    return Shapes(shapes.corners + by, shapes.starts)


def placed(box: tuple[float, float, float, float], sizes: Floats, places: Floats, turned: Floats) -> Floats:
    """Corners (4 n, 2) m of a part of n boxes: ``box`` in shares of half sizes (n, 2), at places and cosine
    and sine (n, 2)."""
    return placed_parts(np.array((box,)), sizes, places, turned)


def placed_parts(boxes: Floats, sizes: Floats, places: Floats, turned: Floats) -> Floats:
    """Corners (4 k n, 2) m of k parts of n boxes, the first part of all boxes first; ``boxes`` (k, 4), and
    the rest as `placed` has it."""
    unit = boxes[:, [0, 1, 2, 1, 2, 3, 0, 3]].reshape(-1, 1, 4, 2)
    x, y = (unit[..., axis] * sizes[:, None, axis] for axis in (0, 1))
    c, s = turned[:, 0, None], turned[:, 1, None]
    corners = np.stack([c * x - s * y, s * x + c * y], axis=-1) + places[:, None, :]
    return corners.reshape(-1, 2)


def rects(rows: Any) -> Floats:
    """Corners (4 n, 2) m of upright rectangles (n, 4): left, lower, right, upper, m."""
    return np.asarray(rows, dtype=np.float64).reshape(-1, 4)[:, [0, 1, 2, 1, 2, 3, 0, 3]].reshape(-1, 2)


def beams(ends: Floats, breadth: float) -> Floats:
    """Corners (4 n, 2) m of straight beams between ends (n, 2, 2) m."""
    along = ends[:, 1] - ends[:, 0]
    lengths = elementwise.hypot(along[:, 0], along[:, 1])
    sizes = 0.5 * np.stack([lengths, np.full(len(ends), breadth)], axis=1)
    return placed(WHOLE, sizes, ends.mean(axis=1), along / np.maximum(lengths, 1e-9)[:, None])


def paint_quads(
    canvas: Canvas, corners: Floats, inks: Any, shares: Any = 1.0,
    edges: Any = NO_EDGE,
) -> None:  # fmt: skip
    """Quadrangles (4 n, 2) m, those in the picture; colours, opacities and edges of all or of each."""
    if not len(corners):
        return
    boxes, seen = corners.reshape(-1, 4, 2), canvas.camera.visible()
    low, high = boxes.min(axis=1), boxes.max(axis=1)
    there = (low[:, 0] < seen.right) & (high[:, 0] > seen.left)
    there &= (low[:, 1] < seen.top) & (high[:, 1] > seen.bottom)
    kept = np.ascontiguousarray(boxes[there].reshape(-1, 2))
    count = len(kept) // 4
    if count:
        own, veils, rims = (
            np.full(count, one, dtype=kind) if np.ndim(one) == 0 else np.ascontiguousarray(one[there])
            for one, kind in ((inks, np.int64), (shares, np.float64), (edges, np.int64))
        )  # type: Any, Any, Any
        paint(canvas, kept, np.arange(0, 4 * count + 1, 4), own, veils, rims, np.zeros((4, 2)))


def paint_timber(canvas: Canvas, ends: Floats, breadth: float, inks: tuple[int, int, int]) -> None:
    """Straight beams between ends (n, 2, 2) m: wood, its lit upper edge, its outline, its grain."""
    paint_quads(canvas, beams(ends, breadth), inks[0], edges=inks[2])
    for beside, share in ((-0.3, 0.4), (-0.08, 0.22), (0.06, 0.3)):  # along the beam, as wood is sawn
        along = ends[:, 1] - ends[:, 0]
        across = np.stack([-along[:, 1], along[:, 0]], axis=1)
        across /= np.maximum(elementwise.hypot(along[:, 0], along[:, 1]), 1e-9)[:, None]
        paint_quads(canvas, beams(ends + beside * breadth * across[:, None], 0.07 * breadth), inks[2], share)
    paint_quads(canvas, beams(ends + np.array((0.0, 0.2 * breadth)), 0.25 * breadth), inks[1], 0.5)


def paint_blocks(canvas: Canvas, sizes: Floats, places: Floats, turned: Floats, inks: Any, edge: int) -> None:
    """Boxes of half sizes (n, 2) m, lit on one long side and shaded on the other."""
    paint_quads(canvas, placed(WHOLE, sizes, places, turned), inks, edges=edge)
    paint_quads(canvas, placed(LIT_SIDE, sizes, places, turned), 0xFFFFFF, 0.14)
    paint_quads(canvas, placed(SHADED_SIDE, sizes, places, turned), 0x000000, 0.16)


def paint_pits(canvas: Canvas, sizes: Floats, places: Floats, turned: Floats, ink: int) -> None:
    """Pits and chips of stones of half sizes (n, 2) m, others on each of four."""
    for k, (x, y, wide, tall) in enumerate(PITS):
        some = slice(k % 2, None, 2) if k < 2 else slice(k - 2, None, 3)
        box = (x - wide, y - tall, x + wide, y + tall)
        paint_quads(canvas, placed(box, sizes[some], places[some], turned[some]), ink, 0.35)


def paint_shapes(canvas: Canvas, shapes: Shapes, ink: int, share: float = 1.0) -> None:
    """Polygons of one colour."""
    count = len(shapes.starts) - 1
    inks, none = np.full(count, ink, dtype=np.int64), np.full(count, NO_EDGE, dtype=np.int64)
    paint(canvas, shapes.corners, shapes.starts, inks, np.full(count, share), none, np.zeros((4, 2)))


def paint_shadows(canvas: Canvas, corners: Floats, ink: int, side: float = 1.0) -> None:
    """Soft shadows on the floor below boxes (4 n, 2) m, towards the right, or with side -1 the left."""
    if not len(corners):
        return
    boxes = corners.reshape(-1, 4, 2) * (side, 1.0)
    low, high = boxes.min(axis=1), boxes.max(axis=1)
    foot = low[:, 1]
    for wider, deep, share in ((0.0, 0.05, 0.3), (0.1, 0.1, 0.2)):
        left, right = low[:, 0] - 0.4 * wider, high[:, 0] + 0.22 * (high[:, 1] - foot) + wider
        quads = np.stack(
            [np.stack([left, foot], 1), np.stack([right, foot], 1),
             np.stack([right - 0.06, foot - deep], 1), np.stack([left + 0.06, foot - deep], 1)], axis=1
        )  # fmt: skip
        paint_quads(canvas, quads.reshape(-1, 2) * (side, 1.0), ink, share)
