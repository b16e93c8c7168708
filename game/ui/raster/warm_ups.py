"""One call of each drawing kernel on a tiny picture: what compiles them ahead of use."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

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
from game.ui.raster.glow import Bloom, add_lights, gather_glows, gather_lights, stamps_of
from game.ui.raster.lines import BUTT, ROUND, stroke_segment, stroke_segments
from game.ui.raster.scratch import scratch_for
from game.ui.raster.veil import paint_veil, veil_room
from game.ui.raster.water import mirror_rows, wave_table

_PIXELS = np.zeros((8, 8), np.uint32)
_CLIP = np.array((0, 0, 8, 8), np.int64)
_POINTS = np.array(((1.0, 1.0), (6.0, 1.0), (3.0, 6.0)))
_RADII, _COLORS, _SEGMENTS = np.ones(3), np.zeros(3, np.uint32), np.zeros((2, 4))


def _lights() -> None:
    sizes, shares, bloom = np.zeros(3, np.uint8), np.ones(3), Bloom()
    add_lights(_PIXELS, _PIXELS.reshape(-1), _CLIP, _POINTS, _COLORS, sizes, *stamps_of((2.0,)))
    bloom.fit(8, 8)
    gather_lights(bloom.light, 0.0, 0.0, _POINTS, _COLORS, shares)
    gather_glows(bloom.light, 0.0, 0.0, _POINTS, _RADII, _COLORS, shares)
    bloom.shine(_PIXELS, _CLIP, 1.0, 0.5)


def _veil() -> None:
    veil, room = np.zeros((2, 2, 2), np.float32), veil_room(_PIXELS.shape[1])
    box = np.array((0.0, 0.0, 8.0, 8.0))
    paint_veil(_PIXELS, _CLIP, veil, box, 0, np.zeros(256, np.uint32), room, True)


def _chain(kernel: Callable[..., object], *rest: object) -> object:
    return kernel(_PIXELS, _CLIP, scratch_for(_PIXELS).cover, _POINTS, *rest)


def _area(kernel: Callable[..., object], *rest: object) -> object:
    scratch = scratch_for(_PIXELS)
    return kernel(_PIXELS, _CLIP, scratch.area, scratch.extent, *rest)


# name, call with the kinds of argument that the program uses
WARM_UPS: list[tuple[str, Callable[[], object]]] = [
    ("fill_disc", lambda: fill_disc(_PIXELS, _CLIP, 4.0, 4.0, 2.0, 0, 1.0)),
    ("stroke_ring", lambda: stroke_ring(_PIXELS, _CLIP, 4.0, 4.0, 2.0, 1.0, 0, 1.0)),
    ("stroke_arc", lambda: stroke_arc(_PIXELS, _CLIP, 4.0, 4.0, 2.0, 1.0, 0.0, 1.0, 0, 1.0)),
    ("fill_discs", lambda: fill_discs(_PIXELS, _CLIP, _POINTS, _RADII, _COLORS, 1.0)),
    ("fill_particles", lambda: fill_particles(_PIXELS, _CLIP, _POINTS, _COLORS, 1.15, 1.0)),
    (
        "fill_particle_streaks",
        lambda: fill_particle_streaks(_PIXELS, _CLIP, _POINTS, _POINTS, _COLORS, 1.15, 0.017, 1.0),
    ),
    ("color_by_speed", lambda: color_by_speed(_POINTS, 0, 0, 1.0, _COLORS)),
    ("stroke_segment", lambda: stroke_segment(_PIXELS, _CLIP, 1.0, 1.0, 5.0, 6.0, 2.0, ROUND, 0, 1.0)),
    ("stroke_segments", lambda: stroke_segments(_PIXELS, _CLIP, _SEGMENTS, 1.0, BUTT, _COLORS, 1.0)),
    ("stroke_polyline", lambda: _chain(stroke_polyline, 1.0, True, 0, 1.0)),
    ("stroke_dashes", lambda: _chain(stroke_dashes, 1.0, False, 2.0, 2.0, 0.0, 0, 1.0)),
    ("fill_polygon", lambda: _area(fill_polygon, _POINTS, 0, 1.0)),
    ("fill_arrow", lambda: _area(fill_arrow, 1.0, 1.0, 6.0, 6.0, 1.0, 0, 1.0)),
    ("fill_under", lambda: fill_under(_PIXELS, _CLIP, _POINTS, 8.0, 1.0, 0, 1.0)),
    ("fill_box", lambda: fill_box(_PIXELS, _CLIP, 1.0, 1.0, 6.0, 6.0, 1.0, 0, 1.0)),
    ("stroke_box", lambda: stroke_box(_PIXELS, _CLIP, 1.0, 1.0, 6.0, 6.0, 1.0, 1.0, 0, 1.0)),
    ("lights", _lights),
    ("paint_veil", _veil),
    ("mirror_rows", lambda: mirror_rows(_PIXELS, _CLIP, 4.0, 1.0, wave_table(), 0.0, 0, 0.5)),
    ("fill_shadow", lambda: fill_shadow(_PIXELS, _CLIP, 1.0, 1.0, 6.0, 6.0, 1.0, 2.0, 0, 1.0)),
]
