"""Kernels of geometry: points, normals and curvature of pieces, ways along them, the nearest place."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary
from game.physics.solids.tracks import curves

FAR = 1e300
LEAST_RATIO = 0.02  # of the centre's way to the curve's, where a curve is nearly as tight as the ball


@inner_kernel
def place_on(rows, i, t, r):
    """Centre (x, y) of a ball that touches piece i at t, normal, curvature of its way, and dt by its way."""
    if rows[i, curves.KIND] == curves.VERTEX:
        phi = rows[i, curves.PHI] + rows[i, curves.SWEEP] * t
        nx, ny = elementary.cos(phi), elementary.sin(phi)
        return (
            rows[i, curves.CX] + r * nx,
            rows[i, curves.CY] + r * ny,
            nx,
            ny,
            -1.0 / r,
            -1.0 / (r * rows[i, curves.SWEEP]),
        )
    x = rows[i, curves.CX] + t * (
        rows[i, curves.CX + 1] + t * (rows[i, curves.CX + 2] + t * rows[i, curves.CX + 3])
    )
    y = rows[i, curves.CY] + t * (
        rows[i, curves.CY + 1] + t * (rows[i, curves.CY + 2] + t * rows[i, curves.CY + 3])
    )
    dx = rows[i, curves.CX + 1] + t * (2.0 * rows[i, curves.CX + 2] + 3.0 * t * rows[i, curves.CX + 3])
    dy = rows[i, curves.CY + 1] + t * (2.0 * rows[i, curves.CY + 2] + 3.0 * t * rows[i, curves.CY + 3])
    ex, ey = (
        2.0 * rows[i, curves.CX + 2] + 6.0 * t * rows[i, curves.CX + 3],
        2.0 * rows[i, curves.CY + 2] + 6.0 * t * rows[i, curves.CY + 3],
    )
    speed = math.sqrt(dx * dx + dy * dy)
    nx, ny = -dy / speed, dx / speed
    curvature = (dx * ey - dy * ex) / (speed * speed * speed)
    ratio = max(1.0 - r * curvature, LEAST_RATIO)
    return x + r * nx, y + r * ny, nx, ny, curvature / ratio, 1.0 / (ratio * speed)


@inner_kernel
def along(rows, i, t):
    """Length along the curve, m, for telling what is near."""
    return rows[i, curves.FROM] + t * (rows[i, curves.TO] - rows[i, curves.FROM])


@inner_kernel
def walk(rows, links, i, t, r, s):
    """Piece and t after the centre has gone s m along its way (negative: backwards)."""
    for _ in range(1000):
        k1 = place_on(rows, i, t, r)[5]
        k2 = place_on(rows, i, t + 0.5 * s * k1, r)[5]
        k3 = place_on(rows, i, t + 0.5 * s * k2, r)[5]
        k4 = place_on(rows, i, t + s * k3, r)[5]
        after = t + s * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0
        if 0.0 <= after <= 1.0:
            return i, after
        border = 1.0 if after > 1.0 else 0.0
        half, middle = 0.5 * (border - t), 0.5 * (border + t)
        reach = 0.7745966692414834 * half
        way = half * (
            5.0 / place_on(rows, i, middle - reach, r)[5]
            + 8.0 / place_on(rows, i, middle, r)[5]
            + 5.0 / place_on(rows, i, middle + reach, r)[5]
        ) / 9.0  # fmt: skip
        if abs(way) > abs(s):  # rounding: it ends just there
            return i, border
        s -= way
        i, t = (links[i, 1], 0.0) if border == 1.0 else (links[i, 0], 1.0)
    return i, t


@inner_kernel
def nearest_on(rows, i, x, y):
    """Distance m from piece i on its left, t and normal there; FAR if none of its normals meets the point."""
    if rows[i, curves.KIND] == curves.VERTEX:
        dx, dy = x - rows[i, curves.CX], y - rows[i, curves.CY]
        distance = math.sqrt(dx * dx + dy * dy)
        if distance == 0.0:
            return FAR, 0.0, 0.0, 0.0
        turn = rows[i, curves.PHI] - elementary.atan2(dy, dx)
        turn -= 2.0 * math.pi * math.floor(turn / (2.0 * math.pi))
        if turn > -rows[i, curves.SWEEP]:
            return FAR, 0.0, 0.0, 0.0
        return distance, -turn / rows[i, curves.SWEEP], dx / distance, dy / distance
    ax, ay = rows[i, curves.CX], rows[i, curves.CY]
    bx = ax + rows[i, curves.CX + 1] + rows[i, curves.CX + 2] + rows[i, curves.CX + 3]
    by = ay + rows[i, curves.CY + 1] + rows[i, curves.CY + 2] + rows[i, curves.CY + 3]
    wx, wy = bx - ax, by - ay
    t = min(max(((x - ax) * wx + (y - ay) * wy) / (wx * wx + wy * wy), 0.0), 1.0)
    off, speed, px, py, dx, dy = 0.0, 1.0, ax, ay, wx, wy
    for _ in range(10):
        px = ax + t * (rows[i, curves.CX + 1] + t * (rows[i, curves.CX + 2] + t * rows[i, curves.CX + 3]))
        py = ay + t * (rows[i, curves.CY + 1] + t * (rows[i, curves.CY + 2] + t * rows[i, curves.CY + 3]))
        dx = rows[i, curves.CX + 1] + t * (2.0 * rows[i, curves.CX + 2] + 3.0 * t * rows[i, curves.CX + 3])
        dy = rows[i, curves.CY + 1] + t * (2.0 * rows[i, curves.CY + 2] + 3.0 * t * rows[i, curves.CY + 3])
        ex = 2.0 * rows[i, curves.CX + 2] + 6.0 * t * rows[i, curves.CX + 3]
        ey = 2.0 * rows[i, curves.CY + 2] + 6.0 * t * rows[i, curves.CY + 3]
        speed = dx * dx + dy * dy
        off = (px - x) * dx + (py - y) * dy
        slope = speed + (px - x) * ex + (py - y) * ey
        after = min(max(t - off / (slope if slope > 0.1 * speed else speed), 0.0), 1.0)
        if after == t:
            break
        t = after
    length = math.sqrt(speed)
    if abs(off) > 1e-7 * length * (1.0 + length):  # beyond an end
        return FAR, 0.0, 0.0, 0.0
    nx, ny = -dy / length, dx / length
    distance = (x - px) * nx + (y - py) * ny
    return (distance if distance > 0.0 else FAR), t, nx, ny
