"""Shadows of balls on the cloth: the dark spot each stands on, and the one that the nearer lamp casts."""

from __future__ import annotations

from typing import Any

from game.physics.jit import kernel
from game.ui.painters import ball_look as look
from game.ui.raster_pixels import blend, clip_bounds, is_drawable

LARGEST_RADIUS = 1000.0  # px


@kernel
def lamp_offset(lamp: int, place_x: float, place_y: float) -> Any:
    """From a ball to a lamp: its middle (x, y), and its nearest point (x, y), in metres along the table."""
    dx, dy = look.LAMPS[lamp, 0] - place_x, look.LAMPS[lamp, 1] - place_y
    half_x, half_y = look.LAMPS[lamp, 2], look.LAMPS[lamp, 3]
    return dx, dy, dx - min(max(dx, -half_x), half_x), dy - min(max(dy, -half_y), half_y)


@kernel
def _paint_blob(
    pixels: Any, clip: Any, x: float, y: float, radius: float, profile: Any, opacity: float
) -> None:
    """A round shadow that ends at ``radius``; ``profile`` is its strength by the square of the distance."""
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - radius, y - radius, x + radius, y + radius)
    steps = profile.shape[0] / (radius * radius)
    strength = 256.0 * min(1.0, max(0.0, opacity))
    for row in range(y_low, y_high):
        dy = row + 0.5 - y
        for column in range(x_low, x_high):
            dx = column + 0.5 - x
            step = int((dx * dx + dy * dy) * steps)
            if step < profile.shape[0]:
                blend(pixels, row, column, 0, int(profile[step] * strength + 0.5))


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
            reach = (look.CAST_RADIUS + look.CAST_BLUR) * r
            _paint_blob(pixels, clip, cast_x, cast_y, reach, look.CAST_PROFILE, look.CAST_SHADE * opacity)
        reach = (look.CONTACT_RADIUS + look.CONTACT_BLUR) * r
        _paint_blob(pixels, clip, x, y, reach, look.CONTACT_PROFILE, look.CONTACT_SHADE * opacity)
