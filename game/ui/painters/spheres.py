"""Lit spheres that cut through one another and turn: two tones in the octants of their own frame.

Looked at along parallel rays, so that a sphere is a disc whose depth is known at every pixel. First the
depths are laid, then the colours, from the back to the front: only what is seen is shaded, rims and the lines
where spheres meet are soft.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.physics.jit import kernel
from game.ui.raster_pixels import blend, clip_bounds, is_drawable, weight_of

Array = np.ndarray
LARGEST_RADIUS = 4_000.0  # px
NOWHERE = np.float32(-3e38)
LIGHT = (-0.46, 0.62, 0.635)  # unit vector towards the lamp: x right, y up, z to the viewer
HALF = (-0.2544, 0.3429, 0.9043)  # half way between lamp and viewer
AMBIENT, DIFFUSE, WRAP, SHINE = 0.42, 0.66, 0.25, 0.34
CONTRAST = 0.24  # of the octants
PLAIN_BELOW = 3.0  # px; a smaller sphere has no octants
SOFT = 1.5  # px of depth over which one sphere gives way to the other


@kernel
def lay_depths(depths: Any, clip: Any, points: Any, radii: Any) -> None:
    """Write how near the nearest sphere is at each pixel into ``depths`` (h, w) float32, px."""
    for i in range(points.shape[0]):
        x, y, z, r = points[i, 0], points[i, 1], points[i, 2], radii[i]
        if not (is_drawable(x) and is_drawable(y) and is_drawable(z) and 0.0 < r <= LARGEST_RADIUS):
            continue
        x_low, y_low, x_high, y_high = clip_bounds(depths, clip, x - r, y - r, x + r, y + r)
        inside = max(r - 0.5, 0.0) * max(r - 0.5, 0.0)
        for row in range(y_low, y_high):
            dy = row + 0.5 - y
            for column in range(x_low, x_high):
                dx = column + 0.5 - x
                squared = dx * dx + dy * dy
                if squared <= inside:
                    depth = z + math.sqrt(r * r - squared)
                    if depth > depths[row, column]:
                        depths[row, column] = depth


@kernel
def clear_depths(depths: Any, clip: Any, points: Any, radii: Any) -> None:
    """Take back what ``lay_depths`` wrote."""
    for i in range(points.shape[0]):
        x, y, r = points[i, 0], points[i, 1], radii[i]
        if is_drawable(x) and is_drawable(y) and 0.0 < r <= LARGEST_RADIUS:
            x_low, y_low, x_high, y_high = clip_bounds(depths, clip, x - r, y - r, x + r, y + r)
            for row in range(y_low, y_high):
                for column in range(x_low, x_high):
                    depths[row, column] = NOWHERE


@kernel
def octant_tone(nx: float, ny: float, nz: float, turn: Any, sharpness: float) -> float:
    """1 or -1 by the octant of a normal in the sphere's own frame, soft at the borders."""
    tone = 1.0
    for k in range(3):
        p = (turn[0, k] * nx + turn[1, k] * ny + turn[2, k] * nz) * sharpness
        tone *= max(-1.0, min(1.0, p))
    return tone


@kernel
def shade(color: int, nx: float, ny: float, nz: float, tone: float) -> int:
    """Colour 0xRRGGBB of a matt surface with a soft highlight."""
    facing = max(0.0, (nx * LIGHT[0] + ny * LIGHT[1] + nz * LIGHT[2] + WRAP) / (1.0 + WRAP))
    gloss = max(0.0, nx * HALF[0] + ny * HALF[1] + nz * HALF[2])
    gloss *= gloss
    gloss *= gloss
    gloss *= gloss
    gloss *= gloss
    gloss *= gloss
    light = (AMBIENT + DIFFUSE * facing) * (1.0 + 0.5 * CONTRAST * (tone - 1.0))
    shine = 255.0 * SHINE * gloss
    result = 0
    for shift in (16, 8, 0):
        value = light * ((color >> shift) & 255) + shine
        result |= int(min(value, 255.0)) << shift
    return result


@kernel
def paint_spheres(
    pixels: Any,
    clip: Any,
    depths: Any,
    points: Any,
    radii: Any,
    turns: Any,
    owners: Any,
    colors: Any,
    alpha: float,
) -> None:
    """Spheres from the back to the front; those behind others only where they are seen.

    ``points`` (n, 3) px, z towards the viewer; ``radii`` (n,) px; ``turns`` (m, 3, 3) from a sphere's frame
    to the picture's (x right, y up, z to the viewer), of which sphere i has ``owners[i]``; ``colors`` (n,)
    uint32; ``depths`` (h, w) float32 as ``lay_depths`` leaves them.
    """  # fmt: skip
    for i in range(points.shape[0]):
        x, y, z, r = points[i, 0], points[i, 1], points[i, 2], radii[i]
        if not (is_drawable(x) and is_drawable(y) and is_drawable(z) and 0.0 < r <= LARGEST_RADIUS):
            continue
        turn, color = turns[owners[i]], np.int64(colors[i])
        reach = r + 0.5
        x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - reach, y - reach, x + reach, y + reach)
        sharpness = 0.8 * r if r >= PLAIN_BELOW else 0.0
        for row in range(y_low, y_high):
            dy = y - row - 0.5
            for column in range(x_low, x_high):
                dx = column + 0.5 - x
                squared = dx * dx + dy * dy
                if squared >= reach * reach:
                    continue
                rise = math.sqrt(max(r * r - squared, 0.0))
                share = 1.0 - (depths[row, column] - z - rise) / SOFT
                if share <= 0.0:
                    continue
                cover = min(1.0, share)
                length = r
                if squared > (r - 0.5) * (r - 0.5):
                    length = math.sqrt(squared)
                    cover *= min(1.0, max(0.0, reach - length))
                    length = max(length, r)
                nx, ny, nz = dx / length, dy / length, rise / r
                tone = octant_tone(nx, ny, nz, turn, sharpness) if sharpness > 0.0 else 1.0
                blend(pixels, row, column, shade(color, nx, ny, nz, tone), weight_of(cover, alpha))


class SpherePainter:
    """Draws spheres; keeps the array of depths."""

    def __init__(self) -> None:
        self._depths = np.zeros((0, 0), np.float32)

    def draw(
        self,
        pixels: Array,
        clip: Array,
        points: Array,
        radii: Array,
        turns: Array,
        owners: Array,
        colors: Array,
        alpha: float = 1.0,
    ) -> None:
        """As ``paint_spheres``, in any order. ValueError if the arrays do not fit each other."""
        count = len(points)
        if points.shape != (count, 3) or any(a.shape != (count,) for a in (radii, owners, colors)):
            raise ValueError("spheres: points (n, 3), radii (n,), owners (n,), colors (n,) must have one n")
        if turns.ndim != 3 or turns.shape[1:] != (3, 3):
            raise ValueError(f"spheres: turns must be (m, 3, 3), not {turns.shape}")
        if count and not (int(owners.min()) >= 0 and int(owners.max()) < len(turns)):
            raise ValueError(f"spheres: owners must be 0 to {len(turns) - 1}")
        if self._depths.shape != pixels.shape:
            self._depths = np.full(pixels.shape, NOWHERE, np.float32)
        order = np.argsort(points[:, 2], kind="stable")
        points, radii = np.ascontiguousarray(points[order]), np.ascontiguousarray(radii[order])
        lay_depths(self._depths, clip, points, radii)
        paint_spheres(
            pixels, clip, self._depths, points, radii, np.ascontiguousarray(turns),
            np.ascontiguousarray(owners[order]), np.ascontiguousarray(colors[order]), float(alpha),
        )  # fmt: skip
        clear_depths(self._depths, clip, points, radii)


def _warm_up() -> None:
    """Compile the kernels on a picture of 8 x 8 pixels."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    SpherePainter().draw(
        pixels, clip, np.full((1, 3), 4.0), np.full(1, 3.0), np.eye(3)[None].copy(), np.zeros(1, np.int64),
        np.zeros(1, np.uint32),
    )  # fmt: skip


WARM_UPS = [("paint_spheres", _warm_up)]
