"""The cue as a pinhole camera behind it sees it: tip, ferrule and shaft, round by three strips."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.arrays import Floats
from game.ui.painters.cue import BUTT_RADIUS, LENGTH, PARTS, TIP_RADIUS
from game.ui.painters.perspective.eye import NEAREST, Eye
from game.ui.raster import fill_polygon, scratch_for

STRIPS = ((-1.0, 1.0, 0.55), (-0.72, 0.78, 0.86), (-0.30, 0.42, 1.12))  # from, to across it; brightness
SHADED = 0.30  # opacity of its shadow on the cloth


def paint_stick(pixels: Any, clip: Any, eye: Eye, tip: Floats, along: Floats) -> None:
    """The cue from its tip (3,) m along a unit vector (3,) away from the ball; with its shadow on the cloth.

    Parts behind the eye are not drawn.
    """
    _, area, extent = scratch_for(pixels)
    sideways = np.array((along[1], -along[0], 0.0))
    sideways /= max(float(np.sqrt(sideways @ sideways)), 1e-9)
    ends = np.minimum(np.concatenate([[0.0], PARTS[:, 0]]), _reach(eye, tip, along))
    parts = int(np.count_nonzero(np.diff(ends) > 0.0))
    spine = tip + along * ends[: parts + 1, None]
    breadth = sideways * _radius(ends[: parts + 1, None])
    edges = np.concatenate([spine + breadth * side for pair in STRIPS for side in pair[:2]])
    flat = edges[: 2 * (parts + 1)] * (1.0, 1.0, 0.0)
    seen = eye.seen(np.concatenate([flat, edges]))[:, :2].reshape(-1, 2, parts + 1, 2)
    for strip, (left, right) in enumerate(seen):
        for part in range(parts):
            ring = np.array((left[part], left[part + 1], right[part + 1], right[part]))
            if strip == 0:
                fill_polygon(pixels, clip, area, extent, ring, 0, SHADED)
            else:
                color = _lit(PARTS[part, 1:4], STRIPS[strip - 1][2])
                fill_polygon(pixels, clip, area, extent, ring, color, 1.0)


def _radius(at: Floats) -> Floats:
    """Radius of the cue, so many m from its tip."""
    return TIP_RADIUS + (BUTT_RADIUS - TIP_RADIUS) * at / LENGTH


def _reach(eye: Eye, tip: Floats, along: Floats) -> float:
    """How much of the cue lies before the eye, m."""
    near, far = eye.seen(np.stack([tip, tip + along * LENGTH]))[:, 2].tolist()
    least = 4.0 * NEAREST
    if near <= least:
        return 0.0
    return LENGTH if far >= least else LENGTH * (near - least) / (near - far)


def _lit(color: Floats, bright: float) -> int:
    """A colour 0 to 255 at a brightness, as 0xRRGGBB."""
    red, green, blue = (int(min(255.0, bright * channel)) for channel in color.tolist())
    return (red << 16) | (green << 8) | blue
