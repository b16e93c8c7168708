"""One ball as a picture of its own, made with numpy: for chips, icons and while kernels still compile.

The same recipe as the kernel in ``ball``, which draws all balls of a table at once.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np
import pygame

from game.ui.painters import ball_look as look

Array = np.ndarray


def ball_picture(
    number: int,
    radius: float,
    rotation: Array,
    felt: pygame.Color,
    place: tuple[float, float] = (0.0, 0.0),
    subpixel: tuple[float, float] = (0.0, 0.0),
) -> pygame.Surface:
    """A ball on a transparent square of 2 ceil(radius) + 4 px, its middle at the square's (+ ``subpixel``).

    ``rotation`` (3, 3) turns the ball's frame into the screen's; ``felt`` is what the ball mirrors at its
    rim: the cloth, or the colour of the panel it lies on. ``place`` in metres from the middle of the table
    says how the lamps stand. ValueError for a number or radius that no ball has.
    """
    if not 0 <= number < look.KINDS:
        raise ValueError(f"ball: number {number!r} is not between 0 and {look.KINDS - 1}")
    turn = np.asarray(rotation, float).T

    def resin(normal: Array) -> Array:
        return _surface(number, radius, np.tensordot(turn, normal, 1), normal[2])

    return _picture(radius, resin, felt, place, subpixel)


def plain_ball_picture(radius: float, felt: pygame.Color) -> pygame.Surface:
    """A cue ball without spots, for the picture of where the tip strikes; as ``ball_picture``."""

    def resin(normal: Array) -> Array:
        return look.BASE[0].reshape(3, 1, 1) + np.zeros_like(normal)

    return _picture(radius, resin, felt, (0.0, 0.0), (0.0, 0.0))


def _picture(
    radius: float,
    resin: Callable[[Array], Array],
    felt: pygame.Color,
    place: tuple[float, float],
    subpixel: tuple[float, float],
) -> pygame.Surface:
    """A shaded ball; ``resin`` gives its colour in linear light at unit normals (3, n, n)."""
    if not 1.0 <= radius <= 400.0:
        raise ValueError(f"ball: radius {radius!r} px is not between 1 and 400")
    side = 2 * math.ceil(radius) + 4
    u = (np.arange(side) + 0.5 - 0.5 * side - subpixel[0])[:, None] / radius + np.zeros((1, side))
    v = -(np.arange(side) + 0.5 - 0.5 * side - subpixel[1])[None, :] / radius + np.zeros((side, 1))
    s = np.sqrt(u * u + v * v)
    inside = np.where(s > look.RIM, look.RIM / np.maximum(s, 1e-12), 1.0)
    normal = np.stack([u * inside, v * inside, np.zeros_like(u)])
    normal[2] = np.sqrt(1.0 - normal[0] ** 2 - normal[1] ** 2)
    felt_light = np.array([felt.r, felt.g, felt.b]) / 255.0
    light = _lit(resin(normal), normal, felt_light**2, place, radius)
    picture = pygame.Surface((side, side), pygame.SRCALPHA, 32)
    pixels = pygame.surfarray.pixels3d(picture)
    pixels[:] = look.toned(light).transpose(1, 2, 0)
    del pixels
    alpha = pygame.surfarray.pixels_alpha(picture)
    alpha[:] = np.rint(255.0 * np.clip(0.5 + (1.0 - s) * radius, 0.0, 1.0))
    del alpha
    return picture


@lru_cache(maxsize=128)
def ball_chip(number: int, radius: float, backdrop: tuple[int, int, int]) -> pygame.Surface:
    """A ball that shows its number a little to the right and up, for a row of chips; kept."""
    return ball_picture(number, radius, CHIP_TURN, pygame.Color(*backdrop))


def turned(x: float, y: float, z: float) -> Array:
    """Rotation matrix of a ball turned about the axis (x, y, z) by its length in rad (Rodrigues 1840)."""
    angle = math.sqrt(x * x + y * y + z * z)
    if not 0.0 < angle < 1e9:
        return np.eye(3)
    a, b, c = x / angle, y / angle, z / angle
    cross = np.array(((0.0, -c, b), (c, 0.0, -a), (-b, a, 0.0)))
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * (cross @ cross)


CHIP_TURN = turned(-0.10, 0.14, 0.0)


def _surface(number: int, radius: float, body: Array, facing: Array) -> Array:
    """Colour (3, ...) in linear light of the resin at unit vectors of the ball's frame."""
    px = radius * np.maximum(look.SOFTEST, facing)

    def share(depth: Array) -> Array:
        return np.clip(0.5 + depth * px, 0.0, 1.0)

    def over(below: Array, above: Array, cover: Array) -> Array:
        return below + cover * (above.reshape(3, 1, 1) - below)

    color = look.BASE[number].reshape(3, 1, 1) + np.zeros_like(body)
    if number >= look.SNOOKER_RED:
        return color
    if number == 0 or number >= look.NUMBERS:
        ink = look.RED_BALL_INK if number == look.CAROM_RED else look.SPOT_INK
        rim = np.sqrt(np.maximum(0.0, 1.0 - np.max(np.abs(body), axis=0) ** 2))
        return over(color, ink, share(look.SPOT - rim))
    x, y = np.where(body[2] < 0.0, -body[0], body[0]), body[1]
    disc = share(look.DISC - np.sqrt(x * x + y * y))
    white = np.maximum(disc, share(np.abs(body[1]) - look.STRIPE)) if number > 8 else disc
    color = over(color, look.WHITE, white)
    side = look.texture_side(radius)
    texture = np.pad(look.digit_texture(number, side), 1) / 255.0
    scale = look.DISC_IN_TEXTURE / look.DISC
    column = np.clip((0.5 + x * scale) * side + 0.5, 0.0, side + 0.999)
    row = np.clip((0.5 - y * scale) * side + 0.5, 0.0, side + 0.999)
    i, j = column.astype(int), row.astype(int)
    a, b = column - i, row - j
    upper = texture[j, i] * (1 - a) + texture[j, i + 1] * a
    lower = texture[j + 1, i] * (1 - a) + texture[j + 1, i + 1] * a
    return over(color, look.INK, (upper * (1 - b) + lower * b) * disc)


def _lit(color: Array, normal: Array, felt: Array, place: tuple[float, float], radius: float) -> Array:
    """Light (3, ...) that leaves a surface of that colour towards the viewer."""
    nx, ny, nz = normal
    diffuse, glare = np.zeros_like(nx), np.zeros_like(nx)
    rx, ry, rz = 2.0 * nz * nx, 2.0 * nz * ny, 2.0 * nz * nz - 1.0
    up = np.maximum(rz, 1e-3)
    for x, y, half_x, half_y, height, strength in look.LAMPS:
        dx, dy = x - place[0], y - place[1]
        lx, ly = dx - min(max(dx, -half_x), half_x), dy - min(max(dy, -half_y), half_y)
        length = math.sqrt(lx * lx + ly * ly + height * height)
        facing = np.maximum(0.0, ((nx * lx + ny * ly + nz * height) / length + look.WRAP) * 0.8)
        diffuse += strength * facing**1.5
        soft = np.maximum(0.06, 2.0 * height / (radius * up * up))
        along = _strip(rx / up * height - dx, half_x, soft)
        across = _strip(ry / up * height - dy, half_y, soft)
        glare += np.where(rz > 0.02, strength * along * across, 0.0)
    rim = 1.0 - nz
    grazing = (1.0 - look.FRESNEL) * rim**5
    fresnel = look.FRESNEL + grazing
    falling = look.AMBIENT + look.FROM_ABOVE * nz + look.DIFFUSE * diffuse
    bounce = look.BOUNCE * rim**1.5
    mirrored = np.clip(-rz, 0.0, 1.0)
    matte = color * (falling + bounce * felt.reshape(3, 1, 1))
    return matte * (1.0 - grazing) + fresnel * (felt.reshape(3, 1, 1) * mirrored + look.GLARE * glare)


def _strip(distance: Array, half: float, soft: Array) -> Array:
    """Share of a window ``soft`` wide that a strip covers."""
    inside = np.minimum(half, distance + 0.5 * soft) - np.maximum(-half, distance - 0.5 * soft)
    return np.maximum(0.0, inside) / soft
