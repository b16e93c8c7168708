"""Lit spheres that cut through one another and turn: two tones in the octants of their own frame.

Looked at along parallel rays, so that a sphere is a disc whose depth is known at every pixel. First the
depths are laid, then the colours, from the back to the front: only what is seen is shaded, rims and the lines
where spheres meet are soft.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.compiler.decorator import kernel
from game.ui.raster.pixels import FULL, OPAQUE, blend, clip_bounds, is_drawable, weight_of

Array = np.ndarray
LARGEST_RADIUS = 4_000.0  # px
NOWHERE = np.float32(-3e38)
LIGHT = (-0.46, 0.62, 0.635)  # unit vector towards the lamp: x right, y up, z to the viewer
HALF = (-0.2544, 0.3429, 0.9043)  # half way between lamp and viewer
AMBIENT, DIFFUSE, WRAP, SHINE = 0.42, 0.66, 0.25, 0.34
CONTRAST = 0.24  # of the octants
OUTLINE_CORNERS = 60  # of the outline of a disc
PLAIN_BELOW = 3.0  # px; a smaller sphere has no octants
SOFT = 1.0  # px of depth over which one sphere gives way to the other


@kernel
def lay_depths(depths: Any, clip: Any, points: Any, radii: Any, seen: Any) -> None:
    """Write how near the nearest sphere is at each pixel into ``depths`` (h, w) float32, px.

    Spheres come from the back to the front; the front ones are laid first, so that the others are soon done.
    Writes into ``seen`` (n,) uint8 whether any of a sphere may be seen.
    """
    for i in range(points.shape[0] - 1, -1, -1):
        seen[i] = 0
        x, y, z, r = points[i, 0], points[i, 1], points[i, 2], radii[i]
        if not (is_drawable(x) and is_drawable(y) and is_drawable(z) and 0.0 < r <= LARGEST_RADIUS):
            continue
        x_low, y_low, x_high, y_high = clip_bounds(depths, clip, x - r, y - r, x + r, y + r)
        inside = max(r - 0.5, 0.0) * max(r - 0.5, 0.0)
        for row in range(y_low, y_high):
            dy = row + 0.5 - y
            rest = inside - dy * dy
            if rest < 0.0:
                continue
            half = math.sqrt(rest)
            first = max(x_low, int(max(x - half, 0.0)))
            for column in range(first, min(x_high, int(max(x + half + 1.0, 0.0)))):
                if depths[row, column] < z + r + SOFT:
                    dx = column + 0.5 - x
                    depth = z + math.sqrt(r * r - dx * dx - dy * dy)
                    if depths[row, column] < depth + SOFT:
                        seen[i] = 1
                    if depths[row, column] < depth:
                        depths[row, column] = depth


@kernel
def trace_outline(centers: Any, radii: Any, points: Any) -> None:
    """Write the outline of overlapping discs (n, 2), (n,) into ``points`` (n (OUTLINE_CORNERS + 2), 2).

    What lies in another disc is nan, which breaks a line.
    """
    place = 0
    for i in range(centers.shape[0]):
        for corner in range(OUTLINE_CORNERS + 2):
            angle = 2.0 * math.pi * corner / OUTLINE_CORNERS
            x = centers[i, 0] + radii[i] * math.cos(angle)
            y = centers[i, 1] + radii[i] * math.sin(angle)
            hidden = corner > OUTLINE_CORNERS  # the line ends with each disc
            for j in range(centers.shape[0]):
                dx, dy = x - centers[j, 0], y - centers[j, 1]
                inside = dx * dx + dy * dy < radii[j] * radii[j] * (1.0 - 1e-9)
                if inside and j != i:
                    hidden = True
                    break
            points[place, 0] = math.nan if hidden else x
            points[place, 1] = math.nan if hidden else y
            place += 1


@kernel
def clear_depths(depths: Any, clip: Any, points: Any, radii: Any) -> None:
    """Take back what ``lay_depths`` wrote: in the box about all spheres."""
    left, top, right, bottom = 1e9, 1e9, -1e9, -1e9
    for i in range(points.shape[0]):
        x, y, r = points[i, 0], points[i, 1], radii[i]
        if is_drawable(x) and is_drawable(y) and 0.0 < r <= LARGEST_RADIUS:
            left, top = min(left, x - r), min(top, y - r)
            right, bottom = max(right, x + r), max(bottom, y + r)
    x_low, y_low, x_high, y_high = clip_bounds(depths, clip, left, top, right, bottom)
    for row in range(y_low, y_high):
        for column in range(x_low, x_high):
            depths[row, column] = NOWHERE


@kernel
def octant_tone(nx: float, ny: float, nz: float, turn: Any, sharpness: float) -> float:
    """1 or -1 by the octant of a normal in the sphere's own frame, soft at the borders; turn: 9 numbers."""
    a = (turn[0] * nx + turn[3] * ny + turn[6] * nz) * sharpness
    b = (turn[1] * nx + turn[4] * ny + turn[7] * nz) * sharpness
    c = (turn[2] * nx + turn[5] * ny + turn[8] * nz) * sharpness
    return max(-1.0, min(1.0, a)) * max(-1.0, min(1.0, b)) * max(-1.0, min(1.0, c))


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
    red = int(min(light * ((color >> 16) & 255) + shine, 255.0))
    green = int(min(light * ((color >> 8) & 255) + shine, 255.0))
    blue = int(min(light * (color & 255) + shine, 255.0))
    return red << 16 | green << 8 | blue


class Sphere(NamedTuple):
    """One sphere: place and radius px, its turn row by row, colour."""

    x: float
    y: float
    z: float
    radius: float
    turn: Any
    color: int


@kernel
def _paint_sphere(pixels: Any, clip: Any, depths: Any, sphere: Any, alpha: float) -> None:
    """One sphere, where it is seen."""
    x, y, z, r, turn, color = sphere
    reach = r + 0.5
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - reach, y - reach, x + reach, y + reach)
    unit, inner = 1.0 / r, max(r - 0.5, 0.0) * max(r - 0.5, 0.0)
    sharpness = 0.8 * r if r >= PLAIN_BELOW else 0.0
    for row in range(y_low, y_high):
        dy = y - row - 0.5
        rest = reach * reach - dy * dy
        if rest <= 0.0:
            continue
        half = math.sqrt(rest)
        first = max(x_low, int(max(x - half, 0.0)))
        for column in range(first, min(x_high, int(max(x + half + 1.0, 0.0)))):
            if depths[row, column] - z - r >= SOFT:
                continue
            dx = column + 0.5 - x
            squared = dx * dx + dy * dy
            rise = math.sqrt(max(r * r - squared, 0.0))
            share = 1.0 - (depths[row, column] - z - rise) / SOFT
            if share <= 0.0:
                continue
            cover, scale = min(1.0, share), unit
            if squared > inner:
                length = math.sqrt(squared)
                cover *= min(1.0, max(0.0, reach - length))
                scale = 1.0 / max(length, r)
            nx, ny, nz = dx * scale, dy * scale, rise * unit
            tone = octant_tone(nx, ny, nz, turn, sharpness) if sharpness > 0.0 else 1.0
            shaded, weight = shade(color, nx, ny, nz, tone), weight_of(cover, alpha)
            if weight >= FULL:
                pixels[row, column] = shaded | OPAQUE
            else:
                blend(pixels, row, column, shaded, weight)


class ScreenSpheres(NamedTuple):
    """Spheres on the screen, from the back to the front.

    ``points`` (n, 3) px, z towards the viewer; ``radii`` (n,) px; ``turns`` (m, 3, 3) from a sphere's frame
    to the picture's (x right, y up, z to the viewer), of which sphere i has ``owners[i]``; ``colors`` (n,)
    uint32.
    """

    points: Any
    radii: Any
    turns: Any
    owners: Any
    colors: Any


@kernel
def paint_spheres(pixels: Any, clip: Any, depths: Any, spheres: Any, seen: Any, alpha: float) -> None:
    """Spheres from the back to the front; those behind others only where they are seen.

    ``depths`` (h, w) float32 and ``seen`` (n,) as ``lay_depths`` leaves them.
    """
    points, radii, turns, owners, colors = spheres
    for i in range(points.shape[0]):
        if not seen[i]:
            continue
        x, y, z, r = points[i, 0], points[i, 1], points[i, 2], radii[i]
        if not (is_drawable(x) and is_drawable(y) and is_drawable(z) and 0.0 < r <= LARGEST_RADIUS):
            continue
        t = turns[owners[i]]
        # a tuple, not an array: the compiler keeps it in registers
        turn = (t[0, 0], t[0, 1], t[0, 2], t[1, 0], t[1, 1], t[1, 2], t[2, 0], t[2, 1], t[2, 2])
        _paint_sphere(pixels, clip, depths, Sphere(x, y, z, r, turn, int(colors[i])), alpha)


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
        """Spheres as of ``ScreenSpheres``, in any order. ValueError if the arrays do not fit each other."""
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
        seen = np.ones(count, np.uint8)
        lay_depths(self._depths, clip, points, radii, seen)
        spheres = ScreenSpheres(
            points, radii, *(np.ascontiguousarray(a) for a in (turns, owners[order], colors[order]))
        )
        paint_spheres(pixels, clip, self._depths, spheres, seen, float(alpha))
        clear_depths(self._depths, clip, points, radii)


def _warm_up() -> None:
    """Compile the kernels on a picture of 8 x 8 pixels."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    SpherePainter().draw(
        pixels, clip, np.full((1, 3), 4.0), np.full(1, 3.0), np.eye(3)[None].copy(), np.zeros(1, np.int64),
        np.zeros(1, np.uint32),
    )  # fmt: skip


WARM_UPS = [("paint_spheres", _warm_up)]
