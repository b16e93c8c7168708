"""Paints a cloth: two triangles for each mesh, eight where something is burnt or written, colours between."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.physics.cloth.layout import CHAR, FUEL, HOT, PATCH_ROWS, SALT, WATER
from game.physics.kernels.lean import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend

# columns of vertices: px, px, red, green, blue (0 to 255), share of the cloth that is left
PX, PY, RED, GREEN, BLUE, LEFT = range(6)
COLUMNS = 6
NOTHING, ALL = 0.14, 0.34  # shares between which it is thinner and thinner to be seen
LINEN, SALTED = (232.0, 222.0, 200.0), (204.0, 202.0, 196.0)
BROWN, BLACK = (112.0, 70.0, 36.0), (24.0, 20.0, 19.0)
GLOW_FROM, GLOW_TO = 620.0, 1050.0  # K between which it begins to glow and is brightest
FLAT = 1e-6  # px² of a triangle that is not worth painting


@inner_kernel
def _triangle(pixels: Any, clip: Any, v: Any, a: Any, b: Any, c: Any) -> None:
    """One, by rows; a, b, c: row and column of its corners among the vertices."""
    ax, ay = v[a[0], a[1], PX], v[a[0], a[1], PY]
    bx, by = v[b[0], b[1], PX] - ax, v[b[0], b[1], PY] - ay
    cx, cy = v[c[0], c[1], PX] - ax, v[c[0], c[1], PY] - ay
    det = bx * cy - cx * by
    if not abs(det) > FLAT:
        return
    low, high = min(min(by, cy), 0.0) + ay, max(max(by, cy), 0.0) + ay
    first, last = max(math.ceil(low - 0.5), clip[1]), min(math.ceil(high - 0.5), clip[3])
    if first >= last:
        return
    r0, g0, b0, s0 = v[a[0], a[1], RED], v[a[0], a[1], GREEN], v[a[0], a[1], BLUE], v[a[0], a[1], LEFT]
    r1, g1 = v[b[0], b[1], RED] - r0, v[b[0], b[1], GREEN] - g0
    b1, s1 = v[b[0], b[1], BLUE] - b0, v[b[0], b[1], LEFT] - s0
    r2, g2 = v[c[0], c[1], RED] - r0, v[c[0], c[1], GREEN] - g0
    b2, s2 = v[c[0], c[1], BLUE] - b0, v[c[0], c[1], LEFT] - s0
    rx, gx, ex, sx = (
        (r1 * cy - r2 * by) / det,
        (g1 * cy - g2 * by) / det,
        (b1 * cy - b2 * by) / det,
        (s1 * cy - s2 * by) / det,
    )
    ry, gy, ey, sy = (
        (r2 * bx - r1 * cx) / det,
        (g2 * bx - g1 * cx) / det,
        (b2 * bx - b1 * cx) / det,
        (s2 * bx - s1 * cx) / det,
    )
    for y in range(first, last):
        at = y + 0.5 - ay
        start, end = math.inf, -math.inf
        for side in range(3):  # where the row crosses the edges
            x1, y1 = (0.0, 0.0) if side == 0 else ((bx, by) if side == 1 else (cx, cy))
            x2, y2 = (bx, by) if side == 0 else ((cx, cy) if side == 1 else (0.0, 0.0))
            if (y1 <= at) != (y2 <= at):
                x = x1 + (at - y1) * (x2 - x1) / (y2 - y1)
                start, end = min(start, x), max(end, x)
        if start > end:
            continue
        left, right = max(math.ceil(start + ax - 0.5), clip[0]), min(math.ceil(end + ax - 0.5), clip[2])
        away = left + 0.5 - ax
        red, green = r0 + away * rx + at * ry, g0 + away * gx + at * gy
        blue, share = b0 + away * ex + at * ey, s0 + away * sx + at * sy
        for x in range(left, right):
            if share > NOTHING:
                ink = (
                    (min(max(int(red), 0), 255) << 16) | (min(max(int(green), 0), 255) << 8)
                    | min(max(int(blue), 0), 255)
                )  # fmt: skip
                if share >= ALL:
                    pixels[y, x] = np.uint32(0xFF000000 | ink)
                else:
                    blend(pixels, y, x, ink, int(256.0 * (share - NOTHING) / (ALL - NOTHING)))
            red, green, blue, share = red + rx, green + gx, blue + ex, share + sx


@lean_kernel
def paint_sheet(pixels: Any, clip: Any, vertices: Any, drawn: Any) -> None:
    """vertices (2 ny + 1, 2 nx + 1, COLUMNS) float64: corners of meshes, and between them. drawn (ny, nx): 0
    not at all, 1 as a whole, 2 in quarters.
    """
    for j in range(drawn.shape[0]):
        for i in range(drawn.shape[1]):
            if drawn[j, i] == 0:
                continue
            parts = 1 if drawn[j, i] == 1 else 2
            step = 2 // parts
            for q in range(parts * parts):
                row, column = 2 * j + step * (q // parts), 2 * i + step * (q % parts)
                upper, lower = (row, column + step), (row + step, column)
                _triangle(pixels, clip, vertices, (row, column), upper, lower)
                _triangle(pixels, clip, vertices, (row + step, column + step), lower, upper)


@inner_kernel
def _mean(patches: Any, row: Any, b: Any, a: Any) -> Any:
    """Of the four patches about a corner."""
    low, high = max(b - 1, 0), min(b, patches.shape[1] - 1)
    left, right = max(a - 1, 0), min(a, patches.shape[2] - 1)
    return 0.25 * (
        patches[row, low, left]
        + patches[row, low, right]
        + patches[row, high, left]
        + patches[row, high, right]
    )


@inner_kernel
def _between(values: Any, b: Any, a: Any) -> Any:
    """At a corner of patches, of values at nodes."""
    j, i = b // 2, a // 2
    k, m = (b + 1) // 2, (a + 1) // 2
    return 0.25 * (values[j, i] + values[k, i] + values[j, m] + values[k, m])


@lean_kernel
def tint_sheet(patches: Any, shade: Any, fire: Any, linen: Any, light: Any, dry: Any, vertices: Any) -> None:
    """Colours of vertices: linen, what is written on it, scorch, char and embers, in the light of sky and
    fire.

    patches: see `physics.cloth.layout`; shade, fire (ny + 1, nx + 1): light of the sky by the normal, and
    of the fire; linen (2 ny + 1, 2 nx + 1): tint of the threads; light (2, 3): colours of sky and fire; dry
    kg/m².
    """
    for b in range(vertices.shape[0]):
        for a in range(vertices.shape[1]):
            hot, fuel = _mean(patches, HOT, b, a), _mean(patches, FUEL, b, a) / dry
            salt, wet = _mean(patches, SALT, b, a), min(_mean(patches, WATER, b, a) / 0.15, 1.0)
            gone = 1.0 - min(max(fuel, 0.0), 1.0)
            scorch = 0.55 * min(max((hot - 430.0) / 170.0, 0.0), 1.0)
            brown = min(4.0 * gone + scorch, 1.0)
            black = min(max(3.0 * (gone - 0.1), 0.0), 1.0)
            glow = min(max((hot - GLOW_FROM) / (GLOW_TO - GLOW_FROM), 0.0), 1.0)
            own, warm = _between(shade, b, a), _between(fire, b, a)
            vertices[b, a, LEFT] = fuel + _mean(patches, CHAR, b, a) / dry
            for k in range(3):
                color = (LINEN[k] + 0.8 * salt * (SALTED[k] - LINEN[k])) * linen[b, a]
                color += (BROWN[k] - color) * brown
                color += (BLACK[k] - color) * black
                color *= (1.0 - 0.3 * wet) * (own * light[0, k] + warm * light[1, k])
                if glow > 0.0:
                    lit = 255.0 * min(1.0, 2.2 * glow)
                    if k == 1:
                        lit = 190.0 * glow * math.sqrt(math.sqrt(glow))
                    elif k == 2:
                        lit = 70.0 * glow * glow * math.sqrt(glow)
                    color = max(color, lit)
                vertices[b, a, RED + k] = color


def warm_up_sheet() -> None:
    """Compile what paints, on a tiny picture."""
    paint_sheet(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.zeros((3, 3, COLUMNS)),
        np.ones((1, 1), np.int64),
    )  # fmt: skip
    tint_sheet(
        np.zeros((PATCH_ROWS, 2, 2)), np.zeros((2, 2)), np.zeros((2, 2)), np.zeros((3, 3)), np.zeros((2, 3)),
        1.0,
        np.zeros((3, 3, COLUMNS)),
    )  # fmt: skip
