"""Balls of one stuff as they are seen: each pixel is lit by a lamp above on the left, three dots show how it
turns.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.canvas.canvas import Canvas
from game.ui.raster.pixels import blend

LIGHT = (-0.46, 0.62, 0.635)  # unit vector towards the lamp: x right, y up, z to the viewer
HALFWAY = (-0.2544, 0.3429, 0.9043)  # between the lamp and the viewer
AMBIENT, DIFFUSE, RIM = 0.30, 0.80, 0.16  # share of light from all sides, from the lamp, from behind
SHINE, HARD = 0.75, 5  # of the lamp's image, and how small it is: squarings of its cosine
DOT_AT, DOT, DOT_SHADE = 0.6, 0.12, 0.62  # of the radius: where dots are and how large; light left on them
FULL = 256


@inner_kernel
def lit(u, v, c, s, red, green, blue):
    """Colour 0xRRGGBB at (u, v) of the radius, v upwards, of a ball turned by (c, s); channels 0 to 255."""
    n = math.sqrt(max(1.0 - u * u - v * v, 0.0))
    light = AMBIENT + DIFFUSE * max(u * LIGHT[0] + v * LIGHT[1] + n * LIGHT[2], 0.0)
    light += RIM * (1.0 - n) * (1.0 - n) * max(v, 0.0)
    p, q = c * u + s * v, c * v - s * u
    for k in range(3):
        turn = 2.0943951023931953 * k
        x, y = p - DOT_AT * math.cos(turn), q - DOT_AT * math.sin(turn)
        if x * x + y * y < DOT * DOT:
            light *= DOT_SHADE
    glint = max(u * HALFWAY[0] + v * HALFWAY[1] + n * HALFWAY[2], 0.0)
    for _ in range(HARD):
        glint *= glint
    glint *= 255.0 * SHINE
    return (
        int(min(red * light + glint, 255.0)) << 16
        | int(min(green * light + glint, 255.0)) << 8
        | int(min(blue * light + glint, 255.0))
    )


@lean_kernel
def paint_spheres(pixels, clip, places, radii, turns, inks):
    """Balls at places (n, 2) px of radii (n,) px, turned by cosines and sines (n, 2); inks (n,) 0xRRGGBB."""
    for i in range(radii.shape[0]):
        x, y, r = places[i, 0], places[i, 1], radii[i]
        if not (abs(x) < 1e6 and abs(y) < 1e6 and 0.3 < r < 1e4):
            continue
        red, green, blue = float(inks[i] >> 16 & 255), float(inks[i] >> 8 & 255), float(inks[i] & 255)
        top, bottom = max(math.floor(y - r - 1.0), clip[1]), min(math.ceil(y + r + 1.0), clip[3])
        left, right = max(math.floor(x - r - 1.0), clip[0]), min(math.ceil(x + r + 1.0), clip[2])
        for row in range(top, bottom):
            v = (y - row - 0.5) / r
            for column in range(left, right):
                u = (column + 0.5 - x) / r
                cover = r + 0.5 - r * math.sqrt(u * u + v * v)
                if cover > 0.0:
                    ink = lit(u, v, turns[i, 0], turns[i, 1], red, green, blue)
                    blend(pixels, row, column, ink, int(min(cover, 1.0) * FULL))


def draw_spheres(canvas: Canvas, places: Floats, radii: Floats, turns: Floats, inks: Longs) -> None:
    """Balls at (n, 2) m of radii (n,) m, turned by cosines and sines (n, 2), of colours (n,) 0xRRGGBB."""
    if not len(radii):
        return
    pixels, clip = canvas.raster_target
    px = np.ascontiguousarray(canvas.place_all(places), dtype=np.float64)
    paint_spheres(pixels, clip, px, radii * canvas.pixels_per_unit, np.ascontiguousarray(turns), inks)


def warm_up_spheres() -> None:
    """Compile what paints, on a tiny picture."""
    paint_spheres(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.full((1, 2), 2.0), np.ones(1),
        np.array(((1.0, 0.0),)), np.zeros(1, np.int64),
    )  # fmt: skip
