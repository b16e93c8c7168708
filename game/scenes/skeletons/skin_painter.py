"""Paints all skins, or all bones, of a figure in one call: polygon by polygon, each over a darker edge.

The edge is the same polygon, its corners moved outwards by the edge's width, and lies below the fill; that
costs a third of a line drawn around.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray

from game.physics.kernels.lean import lean_kernel
from game.scenes.skeletons.cells import WHOLE, Cell
from game.scenes.skeletons.rig import Rig
from game.ui.canvas.canvas import Canvas
from game.ui.raster.areas import fill_polygon
from game.ui.raster.scratch import scratch_for

Array = NDArray[np.float64]
INK = pygame.Color(18, 22, 26)  # what edges are darkened with
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


@lean_kernel
def paint_polygons(pixels, clip, area, extent, places, starts, inks, shares, edges, width, moved):
    """Fill polygons: places (v, 2) px from ``starts`` (m + 1,) on, colours ``inks`` (m,), opacity ``shares``.

    edges (m,): colours of their edges, or NO_EDGE. moved (v, 2): room to work in. An opacity of 0 is skipped.
    """
    for j in range(inks.shape[0]):
        first, last = starts[j], starts[j + 1]
        if shares[j] <= 0.0 or abs(signed_area(places, first, last)) < LEAST_AREA:
            continue
        if edges[j] >= 0:
            move_outwards(places, first, last, width, moved)
            fill_polygon(pixels, clip, area, extent, moved[: last - first], edges[j], 1.0)
        fill_polygon(pixels, clip, area, extent, places[first:last], inks[j], shares[j])


def fill_color(canvas: Canvas, fill: str) -> pygame.Color:
    """The colour of a skin by name or "#rrggbb"; what is none is chalk."""
    try:
        return pygame.Color(fill) if fill.startswith("#") else canvas.color(fill)
    except (KeyError, ValueError, AttributeError):
        return canvas.color("chalk")


class SkinPainter:
    """Paints the skins of one rig after the other; keeps the colours of the last."""

    def __init__(self) -> None:
        self._rig: Rig | None = None
        self._theme: Any = None
        self._moved = np.zeros((0, 2))
        self._inks = self._edges = self._none = np.zeros(0, dtype=np.int64)
        self._strengths, self._shades = np.zeros(0), np.zeros(0, dtype=bool)

    def _take(self, canvas: Canvas, rig: Rig) -> None:
        """Colours of the rig's skins. A skin that lets something through has a line for its edge, or none."""
        if rig is self._rig and canvas.theme is self._theme:
            return
        self._rig, self._theme = rig, canvas.theme
        skins = rig.figure.skins
        colors = [fill_color(canvas, skin.fill) for skin in skins]
        self._inks = np.array([canvas.ink(color) for color in colors], dtype=np.int64)
        darker = [canvas.ink(color.lerp(INK, 0.5)) for color in colors]
        solid = [skin.outline and skin.strength >= 1.0 for skin in skins]
        self._edges = np.array(
            [ink if s else NO_EDGE for ink, s in zip(darker, solid, strict=True)], np.int64
        )
        self._strengths = np.array([skin.strength for skin in skins])
        self._shades = np.array([not skin.outline and skin.strength < 0.5 for skin in skins])
        self._moved = np.zeros((len(rig.skinned), 2))
        self._none = np.full_like(self._edges, NO_EDGE)

    def paint(
        self, canvas: Canvas, rig: Rig, points: Array, strength: float = 1.0, fine: bool = True,
        cell: Cell = WHOLE,
    ) -> None:  # fmt: skip
        """All skins, from the first to the last, at places (v, 2) of the figure, which stands in ``cell``.

        fine: with edges, shades and every point; else the few points of `Rig.show_few`.
        """
        if not rig.figure.skins:
            return
        self._take(canvas, rig)
        solid = strength >= 1.0
        starts = rig.starts if fine else rig.few_starts
        points = cell.out(points[: starts[-1]])
        edges = self._edges if solid and fine else self._none
        shares = strength * self._strengths
        if not fine:
            shares[self._shades] = 0.0
        paint(canvas, points, starts, self._inks, shares, edges, self._moved)
        for i, skin in enumerate(rig.figure.skins):
            if skin.outline and (not solid or skin.strength < 1.0):
                edge = fill_color(canvas, skin.fill).lerp(INK, 0.25)
                outline = points[starts[i] : starts[i + 1]]
                canvas.polyline(outline, edge, 1.6, closed=True, alpha=0.9 * strength)


def paint(
    canvas: Canvas, points: Array, starts: NDArray[np.int64], inks: NDArray[np.int64], shares: Array,
    edges: NDArray[np.int64], moved: Array,
) -> None:  # fmt: skip
    """Polygons at places (v, 2) of the world; see `paint_polygons`."""
    pixels, clip = canvas.raster_target
    scratch = scratch_for(pixels)
    places = canvas.place_all(points)
    paint_polygons(
        pixels, clip, scratch.area, scratch.extent, places, starts, inks, shares, edges,
        EDGE_PX * canvas.k, moved,
    )  # fmt: skip


def warm_up_painter() -> None:
    """Compile what paints, on a tiny picture."""
    pixels = np.zeros((8, 8), np.uint32)
    scratch = scratch_for(pixels)
    corners = np.array(((1.0, 1.0), (6.0, 1.0), (3.0, 6.0)))
    paint_polygons(
        pixels, np.array((0, 0, 8, 8), np.int64), scratch.area, scratch.extent, corners,
        np.array((0, 3)), np.zeros(1, np.int64), np.ones(1), np.zeros(1, np.int64), 0.9, np.zeros((3, 2)),
    )  # fmt: skip
