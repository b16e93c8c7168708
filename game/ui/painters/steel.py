"""Steel balls as they are seen: each pixel mirrors surroundings that are bright above and dark about its
horizon, the nearest lamp where that hangs, and a window on the left. Three small dots show how a ball turns.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.canvas.canvas import Canvas
from game.ui.raster.pixels import blend

DOT_AT, DOT = 0.62, 0.1  # of the radius: where the dots are, and how large
FULL = 256


class Room(NamedTuple):
    """What is mirrored, 0 to 255: red, green and blue of the ceiling, the horizon, the floor and the lamp;
    and how bright the window is.
    """

    above: tuple[float, float, float]
    horizon: tuple[float, float, float]
    below: tuple[float, float, float]
    lamp: tuple[float, float, float]
    window: float


DAY = Room((236.0, 240.0, 244.0), (84.0, 90.0, 98.0), (196.0, 184.0, 164.0), (60.0, 58.0, 50.0), 90.0)
NIGHT = Room((150.0, 152.0, 156.0), (24.0, 30.0, 42.0), (150.0, 112.0, 76.0), (190.0, 160.0, 110.0), 60.0)
LAMP_AT, LAMP_WIDE = 0.8, 2.4  # how far from the middle a lamp beside a ball is mirrored; how sharply


@inner_kernel
def mirrored(up, ceiling, horizon, floor):
    """One colour of the surroundings by the height (-1 to 1) in which it is seen."""
    if up >= 0.0:
        share = min(up * 3.0, 1.0)
        return horizon + (ceiling - horizon) * share * (0.72 + 0.28 * up)
    share = min(-up * 1.6, 1.0)
    return horizon + (floor - horizon) * share * share


@inner_kernel
def shade(u, v, c, s, lamp_x, lamp_y, room):
    """Colour 0xRRGGBB of a ball at (u, v) of its radius, v upwards; turned by (c, s); (lamp_x, lamp_y): where
    it mirrors a lamp.
    """
    n = math.sqrt(max(1.0 - u * u - v * v, 0.0))
    across, up = 2.0 * n * u, 2.0 * n * v
    glint = max(1.0 - 3.2 * math.sqrt((across + 0.5) ** 2 + (up - 0.66) ** 2), 0.0)
    away = math.sqrt((across - lamp_x) ** 2 + (up - lamp_y) ** 2)
    shine = min(2.5 * max(1.0 - LAMP_WIDE * away, 0.0), 1.0) + 0.35 * max(1.0 - away, 0.0)
    light = 0.62 + 0.38 * n
    p, q = c * u + s * v, c * v - s * u
    for k in range(3):
        turn = 2.0943951023931953 * k
        x, y = p - DOT_AT * math.cos(turn), q - DOT_AT * math.sin(turn)
        if x * x + y * y < DOT * DOT:
            light *= 0.5
    ink = 0
    for k in range(3):
        value = (
            mirrored(up, room[k], room[3 + k], room[6 + k]) * light
            + room[9 + k] * shine
            + room[12] * min(3.0 * glint, 1.0)
        )
        ink = ink << 8 | int(min(max(value, 0.0), 255.0))
    return ink


@inner_kernel
def nearest(x, y, lamps):
    """Where (x, y upwards) a ball at a place (px) mirrors the nearest lamp above it; lamps (k, 2) px."""
    best, right, above = 1e18, 0.0, 1.0
    for k in range(lamps.shape[0]):
        dx, dy = lamps[k, 0] - x, y - lamps[k, 1]
        away = dx * dx + dy * dy
        if dy > 0.0 and away < best:
            best, right, above = away, dx, dy
    length = math.sqrt(right * right + above * above)
    return LAMP_AT * right / length, LAMP_AT * above / length


@lean_kernel
def paint_steel(pixels, clip, places, radii, turns, lamps, room):
    """Balls at places (n, 2) px of radii (n,) px, turned by cosines and sines (n, 2); lamps (k, 2) px, one at
    least; surroundings (13,).
    """
    for i in range(radii.shape[0]):
        x, y, r = places[i, 0], places[i, 1], radii[i]
        if not (abs(x) < 1e6 and abs(y) < 1e6 and 0.3 < r < 1e4):
            continue
        lamp_x, lamp_y = nearest(x, y, lamps)
        top, bottom = max(math.floor(y - r - 1.0), clip[1]), min(math.ceil(y + r + 1.0), clip[3])
        left, right = max(math.floor(x - r - 1.0), clip[0]), min(math.ceil(x + r + 1.0), clip[2])
        for row in range(top, bottom):
            v = (y - row - 0.5) / r
            for column in range(left, right):
                u = (column + 0.5 - x) / r
                cover = r + 0.5 - r * math.sqrt(u * u + v * v)
                if cover > 0.0:
                    ink = shade(u, v, turns[i, 0], turns[i, 1], lamp_x, lamp_y, room)
                    blend(pixels, row, column, ink, int(min(cover, 1.0) * FULL))


def room_of(dark: bool) -> Floats:
    """The surroundings as the kernel reads them, (13,)."""
    one = NIGHT if dark else DAY
    return np.array([*one.above, *one.horizon, *one.below, *one.lamp, one.window])


def draw_steel(
    canvas: Canvas, places: Floats, radii: Floats, angles: Floats, lamps: Floats, dark: bool
) -> None:
    """Balls at (n, 2) m of radii (n,) m, turned by angles (n,) rad, in the light of lamps (k, 2) m."""
    seen = canvas.camera.visible()
    near = (
        (places[:, 0] + radii > seen.left) & (places[:, 0] - radii < seen.right)
        & (places[:, 1] + radii > seen.bottom) & (places[:, 1] - radii < seen.top)
    )  # fmt: skip
    if not near.any():
        return
    pixels, clip = canvas.raster_target
    turns = np.stack([np.cos(angles[near]), np.sin(angles[near])], axis=1)
    px = np.array(canvas.place_all(places[near]), dtype=np.float64)
    lights = np.array(canvas.place_all(lamps), dtype=np.float64)
    paint_steel(pixels, clip, px, radii[near] * canvas.pixels_per_unit, turns, lights, room_of(dark))


def warm_up_steel() -> None:
    """Compile what paints, on a tiny picture."""
    paint_steel(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.full((1, 2), 2.0), np.ones(1),
        np.array(((1.0, 0.0),)), np.array(((2.0, 0.0),)), room_of(True),
    )  # fmt: skip
