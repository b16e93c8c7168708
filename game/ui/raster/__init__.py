"""Anti-aliased drawing into the pixels of a pygame surface: discs, lines, areas, boxes, very many particles.

Use::

    pixels, clip = pixels_of(surface), clip_of(surface)     # each frame again, never kept
    cover, area, extent = scratch_for(pixels)
    stroke_polyline(pixels, clip, cover, points, 2.0, False, 0x5FBAF9, 1.0)

Conventions, the same for every kernel:

- ``pixels`` (h, w) uint32, C order: the *whole* window or picture, 0xAARRGGBB (32-bit surfaces with masks
  0xFF0000, 0xFF00, 0xFF, such as ``convert()`` gives). The array has no lock: blits may go between kernels.
  But it dies with the surface, and the display's dies at a resize; so fetch it each frame.
- ``clip`` (4,) int64: left, top, right, bottom; nothing outside is touched. A subsurface gives the pixels of
  its parent and its own rectangle as clip, so coordinates are always those of the whole window.
- Coordinates are float64 px; the pixel in column i, row j covers [i, i+1] x [j, j+1]. A crisp line of 1 px
  has its middle on a half: y = j + 0.5. x grows right, y down.
- ``color`` is a Python int 0xRRGGBB (``packed``), ``alpha`` a float 0 to 1; arrays of colours are uint32.
  Pass floats as floats, ints as ints, arrays in C order: each new kind of argument compiles a new kernel.
- On a surface with alpha that was cleared to 0 the result is premultiplied: blit it with
  ``pygame.BLEND_PREMULTIPLIED`` or pass it through ``straighten`` once.
- Nan, infinite, negative or absurd input draws nothing; nothing raises, loops or writes outside. Nothing is
  allocated. Equal input gives equal pixels.

Kernels:

=====================================================================================  =====================
fill_disc(pixels, clip, x, y, radius, color, alpha)
stroke_ring(pixels, clip, x, y, radius, width, color, alpha)
stroke_arc(pixels, clip, x, y, radius, width, start, sweep, color, alpha)              round ends
fill_discs(pixels, clip, points, radii, colors, alpha)                                 any radii
fill_particles(pixels, clip, points, colors, radius, alpha)                            radius <= 3.5 px
fill_particle_streaks(pixels, clip, points, trails, colors, radius, seconds, alpha)    trails in px/s
color_by_speed(velocities, slow, fast, top_speed, colors)                              writes colors
stroke_segment(pixels, clip, x0, y0, x1, y1, width, ends, color, alpha)                ends ROUND or BUTT
stroke_segments(pixels, clip, segments, width, ends, colors, alpha)                    segments (n, 4)
stroke_polyline(pixels, clip, cover, points, width, closed, color, alpha)              blended once
stroke_dashes(pixels, clip, cover, points, width, closed, dash, gap, offset, color, alpha)
fill_polygon(pixels, clip, area, extent, points, color, alpha)                         any simple polygon
fill_arrow(pixels, clip, area, extent, x0, y0, x1, y1, width, color, alpha)            solid head
fill_under(pixels, clip, points, base, top, color, alpha)                              fading to base
fill_box(pixels, clip, x0, y0, x1, y1, radius, color, alpha)                           round corners
stroke_box(pixels, clip, x0, y0, x1, y1, radius, width, color, alpha)                  inside the box
fill_shadow(pixels, clip, x0, y0, x1, y1, radius, blur, color, alpha)
=====================================================================================  =====================

Rings and arcs: ``width`` lies half in, half out. ``points`` (n, 2).
"""

from __future__ import annotations

import numpy as np
import pygame

from game.ui.raster.areas import fill_arrow, fill_polygon, fill_under
from game.ui.raster.boxes import fill_box, fill_shadow, stroke_box
from game.ui.raster.chains import stroke_dashes, stroke_polyline
from game.ui.raster.discs import (
    color_by_speed,
    fill_disc,
    fill_discs,
    fill_particle_streaks,
    fill_particles,
    stroke_arc,
    stroke_ring,
)
from game.ui.raster.lines import BUTT, ROUND, stroke_segment, stroke_segments
from game.ui.raster.scratch import Scratch, scratch_for
from game.ui.raster.warm_ups import WARM_UPS

__all__ = [
    "BUTT",
    "ROUND",
    "WARM_UPS",
    "Scratch",
    "clip_of",
    "color_by_speed",
    "fill_arrow",
    "fill_box",
    "fill_disc",
    "fill_discs",
    "fill_particle_streaks",
    "fill_particles",
    "fill_polygon",
    "fill_shadow",
    "fill_under",
    "packed",
    "pixels_of",
    "scratch_for",
    "straighten",
    "stroke_arc",
    "stroke_box",
    "stroke_dashes",
    "stroke_polyline",
    "stroke_ring",
    "stroke_segment",
    "stroke_segments",
]

_MASKS = (0xFF0000, 0xFF00, 0xFF)


def pixels_of(surface: pygame.Surface) -> np.ndarray:
    """The pixels (h, w) uint32 of a surface, or of the whole picture that a subsurface is part of.

    Shares the surface's memory without locking it; see the module's text. ValueError for other formats.
    """
    whole = surface.get_abs_parent()
    width, height = whole.get_size()
    if whole.get_bitsize() != 32 or whole.get_masks()[:3] != _MASKS or whole.mustlock():
        raise ValueError("raster: the surface is not 32 bit RGB; convert() it")
    if whole.get_pitch() != 4 * width:
        raise ValueError("raster: the rows of the surface are not one after the other")
    if width == 0 or height == 0:
        return np.empty((height, width), np.uint32)
    return np.ndarray((height, width), np.uint32, whole.get_view("0"))  # type: ignore[arg-type]


def clip_of(surface: pygame.Surface) -> np.ndarray:
    """Clip (4,) int64 of a surface: its clip rectangle in coordinates of ``pixels_of(surface)``."""
    left, top = surface.get_abs_offset()
    x, y, width, height = surface.get_clip()
    whole_width, whole_height = surface.get_abs_parent().get_size()
    right, bottom = min(left + x + width, whole_width), min(top + y + height, whole_height)
    return np.array((max(0, left + x), max(0, top + y), right, bottom), np.int64)


def packed(color: pygame.Color) -> int:
    """A colour as 0xRRGGBB."""
    return (color.r << 16) | (color.g << 8) | color.b


def straighten(surface: pygame.Surface) -> None:
    """Turn a surface's premultiplied colours into the straight ones that a plain blit expects."""
    pixels = pixels_of(surface)
    alpha = (pixels >> 24).astype(np.uint32)
    divisor = np.maximum(alpha, 1)
    result = alpha << 24
    for shift in (0, 8, 16):
        channel = (pixels >> shift) & 0xFF
        result |= np.minimum(255, (channel * 255 + divisor // 2) // divisor) << shift
    pixels[:] = result
