"""Round bodies of the physics scenes, contacts, handles, and the markers of plots.

Fill, outline and a radius line that shows the turn; sleeping bodies at half strength.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.physics.jit import kernel
from game.ui.raster import (
    BUTT,
    fill_box,
    fill_disc,
    fill_polygon,
    packed,
    scratch_for,
    stroke_polyline,
    stroke_ring,
    stroke_segment,
)
from game.ui.raster_pixels import is_drawable
from game.ui.theme import Color, Theme

Array = np.ndarray
OUTLINE, RADIUS_LINE = 2.0, 1.6  # design px
CONTACT_RADIUS, CHOSEN_RADIUS, HANDLE_RADIUS = 4.5, 8.0, 4.5  # design px
ASLEEP = 0.5
MARKERS = ("disc", "ring", "square", "triangle-up", "triangle-down", "diamond", "plus", "cross")


@kernel
def paint_bodies(
    pixels: Any,
    clip: Any,
    points: Any,
    radii: Any,
    angles: Any,
    fills: Any,
    outlines: Any,
    opacities: Any,
    width: float,
    line: float,
) -> None:
    """Round bodies: ``points`` (n, 2) px, ``radii`` (n,) px, ``angles`` (n,) rad on the screen (y down).

    ``fills`` and ``outlines`` (n,) uint32, ``opacities`` (n,) 0 to 1; ``width`` px of the outline, which lies
    inside the radius, ``line`` px of the radius line (0 leaves it out). Bodies below 3 px are plain discs.
    """  # fmt: skip
    for i in range(points.shape[0]):
        x, y, r, opacity = points[i, 0], points[i, 1], radii[i], opacities[i]
        edge = np.int64(outlines[i])
        if r < 3.0:
            fill_disc(pixels, clip, x, y, r, edge, opacity)
            continue
        w = min(width, 0.4 * r)
        fill_disc(pixels, clip, x, y, r - 0.5 * w, np.int64(fills[i]), opacity)
        if line > 0.0 and r >= 6.0 and is_drawable(angles[i]):
            c, s = math.cos(angles[i]), math.sin(angles[i])
            stroke_segment(pixels, clip, x, y, x + (r - w) * c, y + (r - w) * s, line, BUTT, edge, opacity)
        stroke_ring(pixels, clip, x, y, r - 0.5 * w, w, edge, opacity)


def draw_contacts(
    pixels: Array, clip: Array, points: Array, theme: Theme, k: float, chosen: int = -1
) -> None:
    """Contact points (n, 2) px as amber discs; the chosen one has a ring."""
    color = packed(theme.amber.mark)
    for i in range(points.shape[0]):
        x, y = float(points[i, 0]), float(points[i, 1])
        fill_disc(pixels, clip, x, y, CONTACT_RADIUS * k, color, 1.0)
        if i == chosen:
            stroke_ring(pixels, clip, x, y, CHOSEN_RADIUS * k, 1.6 * k, color, 1.0)


def draw_handle(
    pixels: Array, clip: Array, x: float, y: float, theme: Theme, k: float, lit: float = 0.0
) -> None:
    """A point that can be dragged: an accent ring filled with the stage; ``lit`` 0 to 1 when hovered."""
    radius = (HANDLE_RADIUS + lit) * k
    fill_disc(pixels, clip, x, y, radius, packed(theme.stage), 1.0)
    stroke_ring(pixels, clip, x, y, radius, 2.0 * k, packed(theme.accent), 1.0)


def draw_marker(
    pixels: Array,
    clip: Array,
    shape: str,
    x: float,
    y: float,
    radius: float,
    color: Color,
    hollow: bool = False,
) -> None:
    """The marker of a series at a point; ``radius`` px of a disc of its size, ``hollow`` for what is to come.

    ValueError names an unknown shape.
    """
    if shape not in MARKERS:
        raise ValueError(f"marker {shape!r}: there is none; known are {', '.join(MARKERS)}")
    cover, area, extent = scratch_for(pixels)
    ink, width, r = packed(color), max(1.0, 0.36 * radius), radius
    if shape == "ring" or (shape == "disc" and hollow):
        stroke_ring(pixels, clip, x, y, r - 0.5 * width, width, ink, 1.0)
    elif shape == "disc":
        fill_disc(pixels, clip, x, y, r, ink, 1.0)
    elif shape == "plus":
        stroke_segment(pixels, clip, x - r, y, x + r, y, 1.6 * width, BUTT, ink, 1.0)
        stroke_segment(pixels, clip, x, y - r, x, y + r, 1.6 * width, BUTT, ink, 1.0)
    elif shape == "cross":
        d = 0.75 * r
        stroke_segment(pixels, clip, x - d, y - d, x + d, y + d, width, BUTT, ink, 1.0)
        stroke_segment(pixels, clip, x - d, y + d, x + d, y - d, width, BUTT, ink, 1.0)
    elif shape == "square" and not hollow:
        fill_box(pixels, clip, x - 0.9 * r, y - 0.9 * r, x + 0.9 * r, y + 0.9 * r, 0.0, ink, 1.0)
    else:
        corners = r * np.array(_CORNERS[shape]) + (x, y)
        if hollow:
            stroke_polyline(pixels, clip, cover, corners, 0.8 * width, True, ink, 1.0)
        else:
            fill_polygon(pixels, clip, area, extent, corners, ink, 1.0)


_CORNERS = {
    "square": ((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)),
    "triangle-up": ((0.0, -1.25), (1.15, 0.85), (-1.15, 0.85)),
    "triangle-down": ((0.0, 1.25), (-1.15, -0.85), (1.15, -0.85)),
    "diamond": ((0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)),
}


def _warm_up() -> None:
    """Compile the kernel of the round bodies."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    one, color = np.ones(1), np.zeros(1, np.uint32)
    paint_bodies(pixels, clip, np.full((1, 2), 4.0), 3.0 * one, one, color, color, one, OUTLINE, RADIUS_LINE)


WARM_UPS = [("paint_bodies", _warm_up)]
