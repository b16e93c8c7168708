"""The cue stick and its shadow: turned wood under a lamp, one sample a pixel."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.compiler.decorator import kernel
from game.ui.painters.ball_look import LAMPS
from game.ui.raster.lines import column_within, inside_share, lean_of, row_span
from game.ui.raster.pixels import blend, bounds_of, is_drawable, weight_of

Array = np.ndarray
LENGTH = 1.47  # m
TIP_RADIUS, BUTT_RADIUS = 0.006, 0.0145  # m
TIP_HEIGHT = 0.029  # m above the cloth
LEAST_RISE = 0.035  # sine of the angle at which a cue lies when it is not raised
SHADE = 0.34  # opacity of the shadow

# The parts of the stick: end of each from the tip in metres, and its colour.
PARTS = np.array(
    (
        (0.0125, 0x3E, 0x8F, 0xD0),  # chalked leather
        (0.0385, 0xF0, 0xE9, 0xDC),  # ferrule
        (0.800, 0xD8, 0xAE, 0x74),  # maple shaft
        (0.815, 0xF0, 0xE9, 0xDC),  # joint: ivory, black, ivory
        (0.838, 0x1E, 0x22, 0x26),
        (0.848, 0xF0, 0xE9, 0xDC),
        (1.042, 0x4C, 0x2A, 0x20),  # forearm
        (1.300, 0x2C, 0x32, 0x3A),  # wrap
        (1.316, 0xF0, 0xE9, 0xDC),
        (1.440, 0x4A, 0x26, 0x1C),  # sleeve
        (1.456, 0xF0, 0xE9, 0xDC),
        (1.470, 0x1A, 0x1D, 0x20),  # rubber
    )
)
INLAY_FROM, INLAY_TO = 0.852, 0.990  # m; stripes of light wood in the forearm
INLAY_STRIPES = 1.5  # to each side
WRAP_PART = 7
WRAP_TURN = 0.010  # m; a turn of the linen


@kernel
def _wood_of(along: float, side: float, radius: float) -> Any:
    """Colour 0 to 255 of the stick, m from the tip and a share -1 to 1 across it; ``radius`` px there."""
    part = 0
    while part < PARTS.shape[0] - 1 and along > PARTS[part, 0]:
        part += 1
    red, green, blue = PARTS[part, 1], PARTS[part, 2], PARTS[part, 3]
    if INLAY_FROM < along < INLAY_TO:
        place = side * INLAY_STRIPES - math.floor(side * INLAY_STRIPES + 0.5)  # 0 in a stripe's middle
        away = abs(place) * radius / INLAY_STRIPES
        fade = min(1.0, 4.0 * (INLAY_TO - along) / (INLAY_TO - INLAY_FROM))
        light = fade * min(1.0, max(0.0, 0.2 * radius / INLAY_STRIPES + 0.5 - away))
        red, green, blue = (
            red + light * (214 - red),
            green + light * (176 - green),
            blue + light * (124 - blue),
        )
    elif part == WRAP_PART:
        turn = along / WRAP_TURN - math.floor(along / WRAP_TURN)
        fade = 0.72 if turn < 0.16 else 1.0
        red, green, blue = red * fade, green * fade, blue * fade
    return red, green, blue


@kernel
def _light_on(side: float, lift: float) -> Any:
    """Brightness and gleam of a round stick at a share across it; ``lift`` is how far that side looks up."""
    facing = math.sqrt(max(0.0, 1.0 - side * side))
    up = side * lift
    bright = 0.42 + 0.66 * max(0.0, 0.80 * facing + 0.52 * up)
    away = (up - 0.42) / 0.20 if abs(lift) > 0.3 else side / 0.20
    return bright, 0.34 * max(0.0, 1.0 - away * away)


@kernel
def _stick_color(metres: float, side: float, radius: float, lift: float) -> int:
    """Lit colour 0xRRGGBB of the stick at a place along and across it."""
    red, green, blue = _wood_of(metres, side, radius)
    bright, gleam = _light_on(side, lift)
    color = 0
    for channel in (red, green, blue):
        lit = channel * bright
        color = (color << 8) | int(min(255.0, lit + gleam * (255.0 - lit)))
    return color


@kernel
def paint_cue(
    pixels: Any,
    clip: Any,
    tip_x: float,
    tip_y: float,
    along_x: float,
    along_y: float,
    scale: float,
    breadth: float,
) -> None:
    """The stick from its tip along a unit vector to the butt; ``scale`` px/m along, ``breadth`` px/m across.

    They differ if the cue is raised and so looks shorter.
    """
    if not (is_drawable(tip_x) and is_drawable(tip_y) and 0.5 < scale < 1e6 and 0.5 < breadth < 1e6):
        return
    length = LENGTH * scale
    end_x, end_y = tip_x + along_x * length, tip_y + along_y * length
    reach = BUTT_RADIUS * breadth + 1.0
    first, last = inside_share(clip, tip_x, tip_y, end_x, end_y, reach + 1.0)
    if not first <= last:
        return
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    top = column_within(min(tip_y, end_y) - reach, y_low, y_high)
    bottom = column_within(max(tip_y, end_y) + reach + 1.0, y_low, y_high)
    lean, slack = lean_of(tip_x, tip_y, end_x, end_y, reach)
    for row in range(top, bottom):
        left, right = row_span(row + 0.5, tip_x, tip_y, end_x, end_y, reach, lean, slack)
        for column in range(column_within(left, x_low, x_high), column_within(right + 1.0, x_low, x_high)):
            dx, dy = column + 0.5 - tip_x, row + 0.5 - tip_y
            along = dx * along_x + dy * along_y
            across = dx * -along_y + dy * along_x
            metres = min(LENGTH, max(0.0, along / scale))
            radius = (TIP_RADIUS + (BUTT_RADIUS - TIP_RADIUS) * metres / LENGTH) * breadth
            cover = min(radius, abs(across) + 0.5) - max(-radius, abs(across) - 0.5)
            cover = min(1.0, max(0.0, cover)) * min(1.0, max(0.0, min(along, length - along) + 0.5))
            if cover <= 0.0:
                continue
            side = min(1.0, max(-1.0, across / radius))
            color = _stick_color(metres, side, radius, -along_x)
            blend(pixels, row, column, color, weight_of(cover, 1.0))


class ShadowEnd(NamedTuple):
    """One end of a shadow: its place, half breadth and blur, px."""

    x: float
    y: float
    half: float
    blur: float


@kernel
def paint_cue_shadow(pixels: Any, clip: Any, tip: Any, butt: Any, opacity: float) -> None:
    """A soft band between two ``ShadowEnd``s, whose half breadth and blur change evenly between them."""
    x0, y0, half0, blur0 = tip
    x1, y1, half1, blur1 = butt
    if not (is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1)):
        return
    if not (0.0 < half0 < 1e6 and 0.0 < half1 < 1e6 and 0.0 < blur0 < 1e6 and 0.0 < blur1 < 1e6):
        return
    dx, dy = x1 - x0, y1 - y0
    length = math.sqrt(dx * dx + dy * dy)
    reach = max(half0 + blur0, half1 + blur1)
    first, last = inside_share(clip, x0, y0, x1, y1, reach + 1.0)
    if not first <= last or length < 1.0:
        return
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    top = column_within(min(y0, y1) - reach, y_low, y_high)
    bottom = column_within(max(y0, y1) + reach + 1.0, y_low, y_high)
    lean, slack = lean_of(x0, y0, x1, y1, reach)
    for row in range(top, bottom):
        left, right = row_span(row + 0.5, x0, y0, x1, y1, reach, lean, slack)
        for column in range(column_within(left, x_low, x_high), column_within(right + 1.0, x_low, x_high)):
            px, py = column + 0.5 - x0, row + 0.5 - y0
            along = (px * dx + py * dy) / length
            share = min(1.0, max(0.0, along / length))
            beyond = max(0.0, max(-along, along - length))
            across = (py * dx - px * dy) / length
            half, blur = half0 + (half1 - half0) * share, blur0 + (blur1 - blur0) * share
            distance = math.sqrt(across * across + beyond * beyond)
            t = min(1.0, max(0.0, 0.5 * (half + blur - distance) / blur))
            # a blur wider than the band cannot be as dark as the band
            strength = opacity * min(1.0, 2.0 * half / blur) * t * t * (3.0 - 2.0 * t)
            weight = weight_of(strength, 1.0)
            if weight > 0:
                blend(pixels, row, column, 0, weight)


def draw_cue(
    pixels: Array,
    clip: Array,
    tip: tuple[float, float],
    direction: tuple[float, float],
    scale: float,
    elevation: float = 0.0,
    middle: tuple[float, float] | None = None,
    shadow_clip: Array | None = None,
) -> None:
    """Shadow and stick: ``tip`` px, ``direction`` on the screen from tip to butt, ``scale`` px/m.

    ``elevation`` rad raises the butt: the stick looks shorter and its shadow falls farther off. ``middle``
    px of the table's middle says where the lamp hangs; None means straight above. ``shadow_clip`` may keep
    the shadow on the table. Nothing is drawn for a direction or place that is not finite.
    """
    length = math.sqrt(direction[0] * direction[0] + direction[1] * direction[1])
    if not (0.0 < length < 1e12 and math.isfinite(tip[0]) and math.isfinite(tip[1]) and 1.0 < scale < 1e5):
        return
    ux, uy = direction[0] / length, direction[1] / length
    elevation = min(1.5, max(0.0, elevation)) if math.isfinite(elevation) else 0.0
    shortened = scale * math.cos(elevation)
    x1, y1 = tip[0] + ux * LENGTH * shortened, tip[1] + uy * LENGTH * shortened
    butt_height = TIP_HEIGHT + LENGTH * max(LEAST_RISE, math.sin(elevation))
    (a, b), (c, d) = (
        _shift(x, y, h, middle, scale) for x, y, h in ((*tip, TIP_HEIGHT), (x1, y1, butt_height))
    )
    below = clip if shadow_clip is None else shadow_clip
    near = ShadowEnd(tip[0] + a, tip[1] + b, TIP_RADIUS * scale, 0.008 * scale + 0.5)
    far = ShadowEnd(x1 + c, y1 + d, BUTT_RADIUS * scale, (0.015 + 0.12 * butt_height) * scale + 0.5)
    paint_cue_shadow(pixels, below, near, far, SHADE)
    paint_cue(pixels, clip, tip[0], tip[1], ux, uy, max(1.0, shortened), scale)


def _shift(
    x: float, y: float, height: float, middle: tuple[float, float] | None, scale: float
) -> tuple[float, float]:
    """How far px the shadow of a point ``height`` m above the cloth falls from below it."""
    if middle is None:
        return 0.12 * height * scale, 0.5 * height * scale
    lamp_x, lamp_y, half_x, _, lamp_height, _ = (float(value) for value in LAMPS[0])
    dx, dy = (x - middle[0]) / scale - lamp_x, (middle[1] - y) / scale - lamp_y
    dx -= min(max(dx, -half_x), half_x)
    share = height / max(0.1, lamp_height - height) * scale
    return dx * share, -dy * share


def _warm_up() -> None:
    """Compile the kernels of the cue."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    draw_cue(pixels, clip, (2.0, 2.0), (1.0, 0.5), 4.0)


WARM_UPS = [("paint_cue", _warm_up)]
