"""Balls as a pinhole camera sees them: each pixel's ray meets the sphere, and is lit as from above.

Shadows lie on the cloth. Each pixel of a ball has the resin that its ray meets: number, stripe or spots,
turned as the ball is. It is lit by the lamps and the cloth, and mirrors them.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, kernel
from game.ui.painters import ball_look as look
from game.ui.painters.ball import beam_of, diffuse, glare_of, resin, texture_stack, tone
from game.ui.painters.ball_shadow import lamp_offset
from game.ui.painters.perspective.eye import NEAREST, Eye
from game.ui.raster.pixels import blend, clip_bounds, weight_of

UNDER = 0.75  # share of the cloth's light that the underside of a ball does not get
SHADOW_FADE = 0.15  # m of height at which a shadow is half as dark


class RoomBalls(NamedTuple):
    """Balls in the room's frame: middles (n, 3) m, radii (n,) m, numbers (n,) int64 as of `ball_look`, turns
    (n, 3, 3) from the ball's frame to the room's, opacities (n,).
    """

    middles: Floats
    radii: Floats
    numbers: Any
    turns: Floats
    opacities: Floats


@inner_kernel
def _depth_of(eye: Any, x: float, y: float, z: float) -> Any:
    """Depth, offset to the right and upwards of a point from the eye, m."""
    dx, dy, dz = x - eye[0], y - eye[1], z - eye[2]
    ahead = eye[3] * dx + eye[4] * dy
    return (
        eye[5] * ahead - eye[6] * dz,
        eye[4] * dx - eye[3] * dy,
        eye[6] * ahead + eye[5] * dz,
    )


@inner_kernel
def _extent(across: float, depth: float, radius: float) -> Any:
    """First and last slope (px for a focal length of 1) at which a sphere is seen along one direction."""
    square = depth * depth - radius * radius
    reach = radius * math.sqrt(max(0.0, across * across + square))
    return (across * depth - reach) / square, (across * depth + reach) / square


@kernel
def paint_blob(
    pixels: Any, clip: Any, eye: Any, x: float, y: float, inner: float, outer: float, opacity: float
) -> None:
    """A round shadow on the cloth, full up to ``inner`` m and gone from ``outer`` m."""
    depth, aside, up = _depth_of(eye, x, y, 0.0)
    if depth < outer + NEAREST or opacity <= 0.0:
        return
    left, right = _extent(aside, depth, outer)
    low, high = _extent(up, depth, outer)
    focal, middle_x, middle_y = eye[7], eye[8], eye[9]
    x_low, y_low, x_high, y_high = clip_bounds(
        pixels, clip, middle_x + focal * left, middle_y - focal * high, middle_x + focal * right + 1.0,
        middle_y - focal * low + 1.0,
    )  # fmt: skip
    full, fall = weight_of(1.0, opacity), 1.0 / (outer * outer - inner * inner)
    for row in range(y_low, y_high):
        v = middle_y - row - 0.5
        down = eye[6] * focal - eye[5] * v
        if down <= 1e-9:
            continue
        t = eye[2] / down
        ahead = eye[5] * focal + eye[6] * v
        for column in range(x_low, x_high):
            u = column + 0.5 - middle_x
            px, py = eye[0] + t * (eye[3] * ahead + u * eye[4]), eye[1] + t * (eye[4] * ahead - u * eye[3])
            far = (px - x) * (px - x) + (py - y) * (py - y)
            share = min(1.0, max(0.0, (outer * outer - far) * fall))
            if share > 0.0:
                blend(pixels, row, column, 0, int(share * share * (3.0 - 2.0 * share) * full + 0.5))


@kernel
def paint_shadows_seen(pixels: Any, clip: Any, eye: Any, middles: Any, radii: Any, opacities: Any) -> None:
    """Of each ball the dark spot below it, and the shadow that the nearer lamp casts."""
    for i in range(middles.shape[0]):
        x, y, r = middles[i, 0], middles[i, 1], radii[i]
        above = max(0.0, middles[i, 2] - r)
        fade = opacities[i] / (1.0 + above / SHADOW_FADE)
        _, _, lx, ly = lamp_offset(0, x, y)
        shift = (look.CAST_SHIFT * r + above) / look.LAMPS[0, 4]
        wide = r + 0.35 * above
        paint_blob(
            pixels, clip, eye, x - shift * lx, y - shift * ly, look.CAST_INNER * wide,
            look.CAST_OUTER * wide, look.CAST_SHADE * fade,
        )  # fmt: skip
        paint_blob(
            pixels, clip, eye, x, y, look.CONTACT_INNER * r, look.CONTACT_OUTER * r,
            look.CONTACT_SHADE * fade / (1.0 + 4.0 * above / r),
        )  # fmt: skip


@inner_kernel
def _lit(normal: Any, ray: Any, skin: Any, beams: Any, felt: Any, radius: float) -> int:
    """Colour 0xRRGGBB of resin ``skin`` in linear light; unit normal, and unit ray from the eye."""
    nx, ny, nz = normal
    facing = max(0.0, -(ray[0] * nx + ray[1] * ny + ray[2] * nz))
    first, second = beams
    lit = first[8] * diffuse(nx * first[0] + ny * first[1] + nz * first[2])
    lit += second[8] * diffuse(nx * second[0] + ny * second[1] + nz * second[2])
    mx, my, mz = ray[0] + 2.0 * facing * nx, ray[1] + 2.0 * facing * ny, ray[2] + 2.0 * facing * nz
    glare = 0.0
    if mz > 0.02:
        steep = 1.0 / mz
        soft = 2.0 * steep * steep / radius
        glare = glare_of(mx * steep, my * steep, first, soft) + glare_of(mx * steep, my * steep, second, soft)
    rim = 1.0 - facing
    grazing = (1.0 - look.FRESNEL) * rim * rim * rim * rim * rim
    fresnel = look.FRESNEL + grazing
    away = min(1.0, 1.0 - nz)
    bounce = look.BOUNCE * away * math.sqrt(away) * (1.0 + UNDER * min(0.0, nz)) * (1.0 - grazing)
    falling = (look.AMBIENT + look.FROM_ABOVE * max(0.0, nz) + look.DIFFUSE * lit) * (1.0 - grazing)
    mirrored = 0.7 * fresnel * max(0.0, -mz)
    shine = fresnel * look.GLARE * glare
    color = tone(skin[0] * (falling + bounce * felt[0]) + mirrored * felt[0] + shine) << 16
    color |= tone(skin[1] * (falling + bounce * felt[1]) + mirrored * felt[1] + shine) << 8
    return color | tone(skin[2] * (falling + bounce * felt[2]) + mirrored * felt[2] + shine)


@kernel
def paint_sphere(pixels: Any, clip: Any, eye: Any, ball: Any, turn: Any, texture: Any, felt: Any) -> None:
    """One ball (x, y, z, radius m, number, opacity); turn (3, 3), felt (3,) in linear light."""
    x, y, z, radius, kind, opacity = ball
    number = int(kind)
    depth, aside, up = _depth_of(eye, x, y, z)
    if not depth > radius + NEAREST or not radius > 0.0 or not 0 <= number < look.KINDS:
        return
    left, right = _extent(aside, depth, radius)
    low, high = _extent(up, depth, radius)
    focal, middle_x, middle_y = eye[7], eye[8], eye[9]
    x_low, y_low, x_high, y_high = clip_bounds(
        pixels, clip, middle_x + focal * left - 1.0, middle_y - focal * high - 1.0,
        middle_x + focal * right + 1.0, middle_y - focal * low + 1.0,
    )  # fmt: skip
    rx, ry, rz = x - eye[0], y - eye[1], z - eye[2]
    square = rx * rx + ry * ry + rz * rz
    beams = (beam_of(0, x, y), beam_of(1, x, y))
    across = focal * radius / depth  # px
    pixel = depth / focal  # m
    for row in range(y_low, y_high):
        v = middle_y - row - 0.5
        ahead, drop = eye[5] * focal + eye[6] * v, eye[5] * v - eye[6] * focal
        for column in range(x_low, x_high):
            u = column + 0.5 - middle_x
            dx, dy, dz = eye[3] * ahead + u * eye[4], eye[4] * ahead - u * eye[3], drop
            size = 1.0 / math.sqrt(dx * dx + dy * dy + dz * dz)
            dx, dy, dz = dx * size, dy * size, dz * size
            along = dx * rx + dy * ry + dz * rz
            off = math.sqrt(max(0.0, square - along * along))
            cover = min(1.0, 0.5 + (radius - off) / pixel)
            if cover <= 0.0:
                continue
            inside = min(off, look.RIM * radius)
            t = along - math.sqrt(radius * radius - inside * inside)
            nx, ny, nz = t * dx - rx, t * dy - ry, t * dz - rz
            size = 1.0 / math.sqrt(nx * nx + ny * ny + nz * nz)
            nx, ny, nz = nx * size, ny * size, nz * size
            facing = max(look.SOFTEST, -(nx * dx + ny * dy + nz * dz))
            skin = resin(
                texture, number, turn[0, 0] * nx + turn[1, 0] * ny + turn[2, 0] * nz,
                turn[0, 1] * nx + turn[1, 1] * ny + turn[2, 1] * nz,
                turn[0, 2] * nx + turn[1, 2] * ny + turn[2, 2] * nz, across * facing,
            )  # fmt: skip
            color = _lit((nx, ny, nz), (dx, dy, dz), skin, beams, felt, across)
            blend(pixels, row, column, color, weight_of(cover, opacity))


def paint_balls_seen(pixels: Any, clip: Any, eye: Eye, balls: RoomBalls, felt: Floats) -> None:
    """Shadows on the cloth, then balls from the farthest to the nearest. felt (3,): in linear light."""
    numbers = eye.numbers()
    paint_shadows_seen(pixels, clip, numbers, balls.middles, balls.radii, balls.opacities)
    depths = eye.seen(balls.middles)[:, 2]
    for row in np.argsort(-depths, kind="stable").tolist():
        depth, radius = float(depths[row]), float(balls.radii[row])
        if depth <= radius + NEAREST or balls.opacities[row] <= 0.0:
            continue
        side = look.texture_side(min(eye.focal * radius / depth, 120.0))
        ball = (
            *balls.middles[row].tolist(), radius, float(balls.numbers[row]), float(balls.opacities[row]),
        )  # fmt: skip
        paint_sphere(pixels, clip, numbers, ball, balls.turns[row], texture_stack(_kept_side(side)), felt)


def _kept_side(side: int) -> int:
    """A side of a texture near to one that is asked for, of few: each has to be drawn once."""
    return next((kept for kept in (6, 9, 14, 22, 34, 56, 96, 160, 256) if kept >= side), 256)


def _warm_up() -> None:
    """Compile the kernels on a picture of 8 x 8 pixels."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    eye = Eye(0.0, 0.0, 1.0, 0.0, 0.7, 8.0, 4.0, 4.0)
    balls = RoomBalls(
        np.array(((1.0, 0.0, 0.03),)),
        np.full(1, 0.03),
        np.ones(1, np.int64),
        np.eye(3)[None].copy(),
        np.ones(1),
    )
    paint_balls_seen(pixels, clip, eye, balls, np.zeros(3))


WARM_UPS = [("paint_balls_seen", _warm_up)]
