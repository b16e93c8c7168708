"""Paints many polygons in one call, one after the other, each over a darker edge if it has one.

The edge is the same polygon, its corners moved outwards by the edge's width, and lies below the fill. That
costs a third of a line drawn around.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.ui.canvas.canvas import Canvas
from game.ui.raster.areas import fill_polygon
from game.ui.raster.scratch import scratch_for

EDGE_PX = 0.9  # design px, beyond the fill
LEAST_AREA = 2.0  # px², of a polygon that is worth painting
NO_EDGE = -1


@lean_kernel
def signed_area(places, first, last):
    """Area (px²) of the polygon through the places from ``first`` to before ``last``."""
    twice = 0.0
    for i in range(first, last):
        j = i + 1 if i + 1 < last else first
        twice += (places[i, 0] - places[first, 0]) * (places[j, 1] - places[first, 1])
        twice -= (places[j, 0] - places[first, 0]) * (places[i, 1] - places[first, 1])
    return 0.5 * twice


@lean_kernel
def move_outwards(places, first, last, width, moved):
    """Write the corners of a polygon moved outwards by ``width`` px into ``moved``, from its beginning."""
    side = width if signed_area(places, first, last) > 0.0 else -width
    for i in range(first, last):
        before = i - 1 if i > first else last - 1
        after = i + 1 if i + 1 < last else first
        dx, dy = places[after, 0] - places[before, 0], places[after, 1] - places[before, 1]
        length = math.sqrt(dx * dx + dy * dy)
        share = side / length if length > 0.0 else 0.0
        moved[i - first, 0] = places[i, 0] + share * dy
        moved[i - first, 1] = places[i, 1] - share * dx


class Polygons(NamedTuple):
    """Polygons to be painted; an opacity of 0 is skipped."""

    places: Floats  # (v, 2) px, corners of all of them
    starts: NDArray[np.int64]  # (m + 1,) first corner of each
    inks: NDArray[np.int64]  # (m,) colours
    shares: Floats  # (m,) opacity
    edges: NDArray[np.int64]  # (m,) colours of their edges, or NO_EDGE


@lean_kernel
def paint_polygons(pixels, clip, area, extent, polygons, width, moved):
    """Fill `Polygons`, with edges ``width`` px wide. moved (v, 2): scratch buffer."""
    places, starts, inks, shares, edges = polygons
    for j in range(inks.shape[0]):
        first, last = starts[j], starts[j + 1]
        if shares[j] <= 0.0 or abs(signed_area(places, first, last)) < LEAST_AREA:
            continue
        if edges[j] >= 0:
            move_outwards(places, first, last, width, moved)
            fill_polygon(pixels, clip, area, extent, moved[: last - first], edges[j], 1.0)
        fill_polygon(pixels, clip, area, extent, places[first:last], inks[j], shares[j])


def paint(
    canvas: Canvas, points: Floats, starts: NDArray[np.int64], inks: NDArray[np.int64], shares: Floats,
    edges: NDArray[np.int64], moved: Floats,
) -> None:  # fmt: skip
    """Polygons at places (v, 2) of the world; see `paint_polygons`."""
    pixels, clip = canvas.raster_target
    scratch = scratch_for(pixels)
    places = canvas.place_all(points)
    paint_polygons(
        pixels, clip, scratch.area, scratch.extent, Polygons(places, starts, inks, shares, edges),
        EDGE_PX * canvas.k, moved,
    )  # fmt: skip


def warm_up_painter() -> None:
    """Compile what paints, on a tiny picture."""
    pixels = np.zeros((8, 8), np.uint32)
    scratch = scratch_for(pixels)
    corners = np.array(((1.0, 1.0), (6.0, 1.0), (3.0, 6.0)))
    paint_polygons(
        pixels, np.array((0, 0, 8, 8), np.int64), scratch.area, scratch.extent,
        Polygons(corners, np.array((0, 3)), np.zeros(1, np.int64), np.ones(1), np.zeros(1, np.int64)),
        0.9, np.zeros((3, 2)),
    )  # fmt: skip
