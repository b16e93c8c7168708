"""Shadows of balls on the cloth: the dark spot each stands on, and the one that the nearer lamp casts."""

from __future__ import annotations

from typing import Any

from game.compiler.decorator import kernel
from game.ui.painters import ball_look as look
from game.ui.raster.pixels import blend, clip_bounds, is_drawable, weight_of

LARGEST_RADIUS = 1000.0  # px


@kernel
def lamp_offset(lamp: int, place_x: float, place_y: float) -> Any:
    """From a ball to a lamp: its middle (x, y), and its nearest point (x, y), in metres along the table."""
    dx, dy = look.LAMPS[lamp, 0] - place_x, look.LAMPS[lamp, 1] - place_y
    half_x, half_y = look.LAMPS[lamp, 2], look.LAMPS[lamp, 3]
    return dx, dy, dx - min(max(dx, -half_x), half_x), dy - min(max(dy, -half_y), half_y)


@kernel
def _paint_blob(
    pixels: Any, clip: Any, x: float, y: float, inner: float, outer: float, opacity: float
) -> None:
    """A round shadow, full up to ``inner`` px and gone from ``outer`` px."""
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - outer, y - outer, x + outer, y + outer)
    full = weight_of(1.0, opacity)
    fall = 1.0 / (outer * outer - inner * inner)
    for row in range(y_low, y_high):
        dy = row + 0.5 - y
        rest = outer * outer - dy * dy
        # no branch inside, so that several pixels are done at once; in the square of the distance no root
        for column in range(x_low, x_high):
            dx = column + 0.5 - x
            t = min(1.0, max(0.0, (rest - dx * dx) * fall))
            blend(pixels, row, column, 0, int(t * t * (3.0 - 2.0 * t) * full + 0.5))


@kernel
def paint_shadows(pixels: Any, clip: Any, points: Any, radii: Any, places: Any, opacities: Any) -> None:
    """Shadows of balls: the dark spot they stand on, and the one that the nearer lamp casts.

    ``points`` (n, 2) px, ``radii`` (n,) px, ``places`` (n, 2) m from the table's middle, x right, y up;
    ``opacities`` (n,) 0 to 1.
    """
    for i in range(points.shape[0]):
        x, y, r, opacity = points[i, 0], points[i, 1], radii[i], opacities[i]
        if not (is_drawable(x) and is_drawable(y) and 0.5 <= r <= LARGEST_RADIUS):
            continue
        if is_drawable(places[i, 0]) and is_drawable(places[i, 1]):
            _, _, lx, ly = lamp_offset(0, places[i, 0], places[i, 1])
            shift = look.CAST_SHIFT * r / look.LAMPS[0, 4]
            cast_x, cast_y = x - shift * lx, y + shift * ly
            _paint_blob(
                pixels,
                clip,
                cast_x,
                cast_y,
                look.CAST_INNER * r,
                look.CAST_OUTER * r,
                look.CAST_SHADE * opacity,
            )
        _paint_blob(
            pixels, clip, x, y, look.CONTACT_INNER * r, look.CONTACT_OUTER * r, look.CONTACT_SHADE * opacity
        )
