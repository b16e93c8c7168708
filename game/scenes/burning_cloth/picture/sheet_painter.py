"""Paints a cloth: two triangles for each mesh, eight where something is burnt or written, colours between."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.cloth import layout
from game.ui.raster.pixels import OPAQUE, blend

# columns of vertices: px, px, red, green, blue (0 to 255), share of the cloth that is left
PX, PY, RED, GREEN, BLUE, LEFT = range(6)
COLUMNS = 6
NOTHING, ALL = 0.14, 0.34  # shares between which it is thinner and thinner to be seen
LINEN, SALTED = (232.0, 222.0, 200.0), (204.0, 202.0, 196.0)
BROWN, BLACK = (112.0, 70.0, 36.0), (24.0, 20.0, 19.0)
GLOW_FROM, GLOW_TO = 620.0, 1050.0  # K between which it begins to glow and is brightest
SURE = 1e-6  # more than what rounding can take from a share between vertices
FLAT = 1e-6  # px² of a triangle that is not worth painting


@inner_kernel
def _is_plain(v: Any) -> bool:
    """True if a vertex hides what is behind it, in a colour that needs no clipping."""
    return (
        v[LEFT] > ALL + SURE and 0.0 <= v[RED] <= 255.0 and 0.0 <= v[GREEN] <= 255.0
        and 0.0 <= v[BLUE] <= 255.0
    )  # fmt: skip


@inner_kernel
def _triangle(pixels: Any, clip: Any, a: Any, b: Any, c: Any) -> None:
    """One between three vertices (COLUMNS,), row by row between the edge from the highest to the lowest
    corner and the two others.
    """
    ax, ay = a[PX], a[PY]
    bx, by, cx, cy = b[PX] - ax, b[PY] - ay, c[PX] - ax, c[PY] - ay
    det = bx * cy - cx * by
    if not abs(det) > FLAT:
        return
    # the corners by height, from the first one
    x0, y0, x1, y1, x2, y2 = 0.0, 0.0, bx, by, cx, cy
    if y1 < y0:
        x0, y0, x1, y1 = x1, y1, x0, y0
    if y2 < y1:
        x1, y1, x2, y2 = x2, y2, x1, y1
        if y1 < y0:
            x0, y0, x1, y1 = x1, y1, x0, y0
    first, last = max(math.ceil(y0 + ay - 0.5), clip[1]), min(math.ceil(y2 + ay - 0.5), clip[3])
    if first >= last:
        return
    whole, upper, lower = (x2 - x0) / (y2 - y0), (x1 - x0) / (y1 - y0), (x2 - x1) / (y2 - y1)
    part = 1.0 / det
    r0, g0, e0, s0 = a[RED], a[GREEN], a[BLUE], a[LEFT]
    r1, g1, e1, s1 = (
        (b[RED] - r0) * part,
        (b[GREEN] - g0) * part,
        (b[BLUE] - e0) * part,
        (b[LEFT] - s0) * part,
    )
    r2, g2, e2, s2 = (
        (c[RED] - r0) * part,
        (c[GREEN] - g0) * part,
        (c[BLUE] - e0) * part,
        (c[LEFT] - s0) * part,
    )
    rx, gx, ex, sx = r1 * cy - r2 * by, g1 * cy - g2 * by, e1 * cy - e2 * by, s1 * cy - s2 * by
    ry, gy, ey, sy = r2 * bx - r1 * cx, g2 * bx - g1 * cx, e2 * bx - e1 * cx, s2 * bx - s1 * cx
    plain = _is_plain(a) and _is_plain(b) and _is_plain(c)
    for y in range(first, last):
        at = y + 0.5 - ay
        one = x0 + (at - y0) * whole
        two = x0 + (at - y0) * upper if at < y1 else x1 + (at - y1) * lower
        start, end = (one, two) if one < two else (two, one)
        left, right = max(math.ceil(start + ax - 0.5), clip[0]), min(math.ceil(end + ax - 0.5), clip[2])
        away = left + 0.5 - ax
        red, green = r0 + away * rx + at * ry, g0 + away * gx + at * gy
        blue, share = e0 + away * ex + at * ey, s0 + away * sx + at * sy
        if plain:
            for x in range(left, right):
                pixels[y, x] = np.uint32(OPAQUE | int(red) << 16 | int(green) << 8 | int(blue))
                red, green, blue = red + rx, green + gx, blue + ex
            continue
        for x in range(left, right):
            if share > NOTHING:
                ink = (
                    (min(max(int(red), 0), 255) << 16) | (min(max(int(green), 0), 255) << 8)
                    | min(max(int(blue), 0), 255)
                )  # fmt: skip
                if share >= ALL:
                    pixels[y, x] = np.uint32(OPAQUE | ink)
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
                upper, lower = vertices[row, column + step], vertices[row + step, column]
                _triangle(pixels, clip, vertices[row, column], upper, lower)
                _triangle(pixels, clip, vertices[row + step, column + step], lower, upper)


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
            hot, fuel = _mean(patches, layout.HOT, b, a), _mean(patches, layout.FUEL, b, a) / dry
            salt, wet = _mean(patches, layout.SALT, b, a), min(_mean(patches, layout.WATER, b, a) / 0.15, 1.0)
            gone = 1.0 - min(max(fuel, 0.0), 1.0)
            scorch = 0.55 * min(max((hot - 430.0) / 170.0, 0.0), 1.0)
            brown = min(4.0 * gone + scorch, 1.0)
            black = min(max(3.0 * (gone - 0.1), 0.0), 1.0)
            glow = min(max((hot - GLOW_FROM) / (GLOW_TO - GLOW_FROM), 0.0), 1.0)
            own, warm = _between(shade, b, a), _between(fire, b, a)
            vertices[b, a, LEFT] = fuel + _mean(patches, layout.CHAR, b, a) / dry
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
        np.zeros((layout.PATCH_ROWS, 2, 2)),
        np.zeros((2, 2)),
        np.zeros((2, 2)),
        np.zeros((3, 3)),
        np.zeros((2, 3)),
        1.0,
        np.zeros((3, 3, COLUMNS)),
    )
