"""What a table is made of: cloth under a pool of light, wood with its grain, pockets. Kernels on pixels.

Lengths are px of the picture unless named otherwise; colours are (3,) float64, 0 to 255.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import kernel
from game.ui.raster.pixels import OPAQUE, clip_bounds, lay

LIGHT_HALF = 0.79  # m; the pool of light is even over this half length
LIGHT_SHIFT = 0.11  # m; its middle lies so far towards the upper rail
SHADE_TOP, SHADE_SIDE, SHADE_BOTTOM = 0.030, 0.023, 0.021  # m; reach of the cushions' shade on the cloth
GRAIN_ACROSS = 110.0  # 1/m; streaks of the wood, 30 times as long as broad
DRAWN_AT = 403.0  # px/m; the scale at which lines were drawn one pixel wide
CORNER = 0.048  # m; radius of the frame's corners
BOARD_BROAD, BOARD_LONG, JOINT = 0.16, 1.9, 0.003  # m, of the floor's boards
FLOOR_GRAIN = 55.0  # 1/m across the boards
POOL_IN, POOL_FADES = 0.25, 0.75  # m; the light on the floor begins to fade within the frame, and how fast


@kernel
def _random(i: int, j: int, seed: int) -> float:
    """A number 0 to 1 that belongs to a lattice point: the same in every run."""
    h = (i * 374761393 + j * 668265263 + seed * 144269504) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return (h ^ (h >> 16)) / 4294967296.0


@kernel
def _noise(x: float, y: float, seed: int) -> float:
    """Value noise 0 to 1, smooth between lattice points."""
    i, j = math.floor(x), math.floor(y)
    a, b = x - i, y - j
    a, b = a * a * (3.0 - 2.0 * a), b * b * (3.0 - 2.0 * b)
    low = _random(i, j, seed) * (1.0 - a) + _random(i + 1, j, seed) * a
    high = _random(i, j + 1, seed) * (1.0 - a) + _random(i + 1, j + 1, seed) * a
    return low * (1.0 - b) + high * b


@kernel
def _channel(value: float) -> int:
    """A colour channel as an integer 0 to 255."""
    return int(min(255.0, max(0.0, value + 0.5)))


@kernel
def _packed(red: float, green: float, blue: float) -> int:
    """Three channels as a colour 0xRRGGBB."""
    return (_channel(red) << 16) | (_channel(green) << 8) | _channel(blue)


@kernel
def _shade(away: float, reach: float, strength: float) -> float:
    """What a cushion leaves of the light, ``away`` m from it."""
    return 1.0 - strength * max(0.0, 1.0 - abs(away / reach))


@kernel
def _span(middle: float, reach: float, limit: int) -> tuple[int, int]:
    """First pixel, and the one after the last, whose middle lies within ``reach`` of a place."""
    return max(0, math.ceil(middle - reach - 0.5)), min(limit, math.floor(middle + reach - 0.5) + 1)


@kernel
def paint_cloth(pixels: Any, box: Any, scale: float, cushion: float, felt: Any) -> None:
    """The bed under its lamp. ``box``: middle x, y and half sides x, y of the bed, px; ``scale`` px/m.

    Where the cushions, ``cushion`` px broad, will lie the cloth goes on; ``felt`` is its colour.
    """
    middle_x, middle_y, half_x, half_y = box[0], box[1], box[2] / scale, box[3] / scale  # px, px, m, m
    reach_x, reach_y = box[2] + cushion, box[3] + cushion
    top, bottom = _span(middle_y, reach_y, pixels.shape[0])
    left, right = _span(middle_x, reach_x, pixels.shape[1])
    far, shaded = np.empty(max(right - left, 0)), np.empty(max(right - left, 0))
    for column in range(left, right):
        x = (column + 0.5 - middle_x) / scale
        dx = max(0.0, abs(x) - LIGHT_HALF * half_x / 1.27)
        far[column - left] = dx * dx
        shaded[column - left] = _shade(half_x - abs(x), SHADE_SIDE, 0.25)
    for row in range(top, bottom):
        y = (middle_y - row - 0.5) / scale
        dy = y - LIGHT_SHIFT
        upper, lower = _shade(half_y - y, SHADE_TOP, 0.27), _shade(half_y + y, SHADE_BOTTOM, 0.19)
        for column in range(left, right):
            light = 0.40 + 0.74 * 0.91 / (1.0 + far[column - left] + dy * dy)
            fuzz = _random(column, row, 1) + _random((column + row) >> 1, (column - row) >> 1, 2) - 1.0
            b = light * upper * lower * shaded[column - left] * (1.0 + 0.028 * fuzz)
            pixels[row, column] = OPAQUE | _packed(felt[0] * b, felt[1] * b, felt[2] * b)


@kernel
def _timber(along: float, across: float, seed: int) -> float:
    """Grain, about 0 to 1, of a rail at metres along and across it."""
    broad = _noise(across * GRAIN_ACROSS, along * GRAIN_ACROSS / 30.0, seed)
    fine = _noise(across * GRAIN_ACROSS * 3.1, along * GRAIN_ACROSS / 12.0, seed + 7)
    return 0.5 + 1.3 * (0.76 * broad + 0.24 * fine - 0.5)


@kernel
def _frame_depth(x: float, y: float, half_x: float, half_y: float, corner: float) -> float:
    """How far inside a box with round corners a point lies."""
    qx, qy = abs(x) - half_x + corner, abs(y) - half_y + corner
    ox, oy = max(qx, 0.0), max(qy, 0.0)
    return corner - math.sqrt(ox * ox + oy * oy) - min(max(qx, qy), 0.0)


@kernel
def _wood(x: float, y: float, outer: float, inner: float, slack: float, scale: float) -> Any:
    """Grain, brightness and gleam of the frame at (x, y) m; ``outer``, ``inner`` px from its edges."""
    if slack > 0.0:
        grain = _timber(x, y, 11 if y > 0.0 else 12)
        edge, gleam, rim = (0.31, 0.20, 1.05) if y > 0.0 else (0.02, 0.06, 0.52)
    else:
        grain = _timber(y, x, 13 if x > 0.0 else 14)
        edge, gleam, rim = (0.12, 0.13, 0.76) if x > 0.0 else (0.05, 0.12, 0.72)
    unit = max(1.0, scale / DRAWN_AT)  # a line of the drawing at 1280 x 720
    bevel = min(1.0, max(0.0, 2.0 - 0.5 * outer / unit))
    outline = min(1.0, max(0.0, unit + 0.5 - outer))
    brightness = (1.0 + edge * bevel) * (1.0 - outline) + rim * outline
    if inner < 3.0 * unit:
        brightness *= 0.90
    if abs(slack) < 0.6 * unit:
        brightness *= 0.62  # the mitre
    return grain, brightness, gleam * min(1.0, max(0.0, 0.5 * unit + 0.5 - abs(outer - 1.5 * unit)))


@kernel
def paint_glow(pixels: Any, middle_x: float, middle_y: float, color: int, lift: float) -> None:
    """A floor of one colour, a little lighter (``lift`` of 255) round a place, fading over the picture."""
    wide, high = 0.5 * pixels.shape[1], 1.0 * pixels.shape[0]
    for row in range(pixels.shape[0]):
        v = (row + 0.5 - middle_y) / high
        for column in range(pixels.shape[1]):
            u = (column + 0.5 - middle_x) / wide
            more = lift / (1.0 + 3.5 * (u * u * u * u + v * v)) + 0.6 * _random(column, row, 3) - 0.3
            pixels[row, column] = (
                OPAQUE
                | (_channel((color >> 16 & 0xFF) + more) << 16)
                | (_channel((color >> 8 & 0xFF) + more) << 8)
                | _channel((color & 0xFF) + more)
            )


@kernel
def _tone(x: float, y: float, row: int, number: int) -> float:
    """Brightness, about 1, of a board of the floor at (x, y) m: its own, and its grain."""
    grain = _noise(x * 3.1 + 7.0 * number, y * FLOOR_GRAIN, 23) - 0.5
    return 0.82 + 0.30 * _random(row, number, 22) + 0.22 * grain


@kernel
def paint_floor(pixels: Any, box: Any, scale: float, wood: Any, dark: Any) -> None:
    """Floor boards in the pool of light of the table's lamp, but for what the table hides.

    ``box``: middle x, y and half sides x, y of the table with its frame, px; ``scale`` px/m. ``wood``: the
    boards' colour under the lamp; ``dark``: what there is far from it.
    """
    half_x, half_y = box[2] / scale, box[3] / scale
    inside = 0.1 * min(half_x, half_y)  # the frame's round corners show a little of the floor
    joint = max(0.5 * JOINT, 0.5 / scale)
    for row in range(pixels.shape[0]):
        y = (row + 0.5 - box[1]) / scale
        dy = max(0.0, abs(y) - half_y + POOL_IN)
        beside = abs(y) < half_y - inside
        board = math.floor(y / BOARD_BROAD)
        across = y - board * BOARD_BROAD
        at_side = min(across, BOARD_BROAD - across) < joint
        shift, last, tone = _random(board, 0, 21), 0, 0.0
        for column in range(pixels.shape[1]):
            x = (column + 0.5 - box[0]) / scale
            if beside and abs(x) < half_x - inside:
                continue
            number = math.floor(x / BOARD_LONG + shift)
            if number != last or tone == 0.0 or column % 8 == 0:  # it changes slowly along a board
                tone, last = _tone(x, y, board, number), number
            along = x - (number - shift) * BOARD_LONG
            at_joint = at_side or min(along, BOARD_LONG - along) < joint
            dx = max(0.0, abs(x) - half_x + POOL_IN)
            light = 1.0 / (1.0 + (dx * dx + dy * dy) / (POOL_FADES * POOL_FADES))
            lit = light * tone * (0.45 if at_joint else 1.0) + 0.02 * (_random(column, row, 3) - 0.5)
            pixels[row, column] = OPAQUE | _packed(
                dark[0] + lit * (wood[0] - dark[0]),
                dark[1] + lit * (wood[1] - dark[1]),
                dark[2] + lit * (wood[2] - dark[2]),
            )


@kernel
def _wood_color(
    px: float,
    py: float,
    outer: float,
    inner: float,
    slack: float,
    scale: float,
    dark: Any,
    light: Any,
    glow: float,
) -> int:
    """Colour of the frame at a place px from the middle of the bed (x right, y up)."""
    grain, b, gleam = _wood(px / scale, py / scale, outer, inner, slack, scale)
    b *= glow
    red = (dark[0] + grain * (light[0] - dark[0])) * b
    green = (dark[1] + grain * (light[1] - dark[1])) * b
    blue = (dark[2] + grain * (light[2] - dark[2])) * b
    if inner <= max(1.0, scale / DRAWN_AT):
        red, green, blue = 37.0, 30.0, 22.0  # the joint to the cushion
    return _packed(
        red + gleam * (255.0 - red), green + gleam * (205.0 - green), blue + gleam * (165.0 - blue)
    )


@kernel
def paint_wood(
    pixels: Any, box: Any, scale: float, cushion: float, wood: float, inks: Any, glow: float
) -> None:
    """The frame round the cloth; ``box``, ``scale`` and ``cushion`` as for the cloth.

    ``wood`` px is its breadth, ``inks`` (2, 3) the colours of dark and light wood, ``glow`` its brightness.
    """
    middle_x, middle_y, reach_x, reach_y = box[0], box[1], box[2] + cushion, box[3] + cushion
    frame_x, frame_y = reach_x + wood, reach_y + wood
    corner = min(CORNER * scale, 0.9 * wood)
    top, bottom = max(0, math.floor(middle_y - frame_y)), min(pixels.shape[0], math.ceil(middle_y + frame_y))
    left, right = max(0, math.floor(middle_x - frame_x)), min(pixels.shape[1], math.ceil(middle_x + frame_x))
    first, behind = _span(middle_x, reach_x, pixels.shape[1])  # columns of the cloth
    upper, below = _span(middle_y, reach_y, pixels.shape[0])
    for row in range(top, bottom):
        py = middle_y - row - 0.5
        beside = upper <= row < below and first < behind
        for part in range(2 if beside else 1):
            begin, end = (left, first if beside else right) if part == 0 else (behind, right)
            for column in range(begin, end):
                px = column + 0.5 - middle_x
                outer = _frame_depth(px, py, frame_x, frame_y, corner)
                if outer > -0.5:
                    slack = (abs(py) - reach_y) - (abs(px) - reach_x)  # > 0 on the long rails
                    inner = max(abs(px) - reach_x, abs(py) - reach_y)
                    color = _wood_color(px, py, outer, inner, slack, scale, inks[0], inks[1], glow)
                    lay(pixels, row, column, color, outer + 0.5)


@kernel
def _ring_share(distance: float, radius: float, width: float) -> float:
    """Coverage of a ring's line."""
    away = abs(distance - radius)
    return min(1.0, max(0.0, 0.5 * width + 0.5 - away))


@kernel
def _lay_liner(pixels: Any, row: int, column: int, d: float, radius: float, unit: float, brass: int) -> None:
    """Wood side of a pocket at a distance from its middle: shade, leather, its rim, brass."""
    lay(pixels, row, column, 0, 0.16 * (1.0 - abs(d - radius - 7.5 * unit) / (3.0 * unit)))
    lay(pixels, row, column, 0x2A211B, radius + 6.9 * unit + 0.5 - d)
    lay(pixels, row, column, 0x43362C, _ring_share(d, radius + 1.6 * unit, 1.8 * unit))
    lay(pixels, row, column, brass, _ring_share(d, radius + 6.4 * unit, 1.3 * unit))


@kernel
def paint_pocket(
    pixels: Any, clip: Any, x: float, y: float, radius: float, unit: float, wood: Any, brass: int
) -> None:
    """A hole, its leather liner and brass arc where it cuts the wood, shade where it cuts the cloth.

    ``unit`` px is a line of the drawing at 1280 x 720; the wood lies outside of the box ``wood`` (left, top,
    right, bottom px).
    """
    reach = radius + 12.0 * unit
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - reach, y - reach, x + reach, y + reach)
    for row in range(y_low, y_high):
        for column in range(x_low, x_high):
            px, py = column + 0.5, row + 0.5
            d = math.sqrt((px - x) * (px - x) + (py - y) * (py - y))
            if d > reach:
                continue
            if px < wood[0] or py < wood[1] or px > wood[2] or py > wood[3]:
                _lay_liner(pixels, row, column, d, radius, unit, brass)
            else:
                shade = max(0.0, 1.0 - max(0.0, d - radius) / (3.6 * unit))
                lay(pixels, row, column, 0, 0.62 * shade * shade)
                lay(pixels, row, column, 0x3F362E, 0.9 * _ring_share(d, radius - 0.2 * unit, unit))
            grey = int(8.0 - 5.0 * min(1.0, max(0.0, (radius - d) / (10.0 * unit))))
            hole = (grey << 16) | ((grey + 1) << 8) | (grey + 1)
            lay(pixels, row, column, hole, radius - 0.4 * unit + 0.5 - d)
