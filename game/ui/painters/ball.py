"""All balls of a table, shaded and rolling, straight into the pixels: one sample a pixel.

For each pixel of a ball: the unit normal, its place in the ball's own frame (number, stripe or spots), light
from two long lamps and from the cloth. Then their mirror images. Last, the share of the pixel that the ball
covers. All shadows are laid before all balls. ``ball_picture`` is the plain numpy twin; colours, markings and
lamps are in ``ball_look``.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import pygame

from game.compiler.decorator import kernel
from game.ui.painters import ball_look as look
from game.ui.painters.ball_shadow import LARGEST_RADIUS, lamp_offset, paint_shadows
from game.ui.raster.pixels import blend, clip_bounds, is_drawable, weight_of

Array = np.ndarray


@kernel
def _share(depth: float) -> float:
    """Covered share of a pixel that lies ``depth`` px inside an edge."""
    return min(1.0, max(0.0, 0.5 + depth))


@kernel
def _soft_strip(distance: float, half: float, soft: float) -> float:
    """Share of a window ``soft`` wide that a strip of half width ``half`` covers."""
    return max(0.0, min(half, distance + 0.5 * soft) - max(-half, distance - 0.5 * soft)) / soft


@kernel
def _digit(texture: Any, number: int, x: float, y: float) -> float:
    """Coverage 0 to 1 of the number's digits at a place of its disc, between the texture's pixels."""
    side = texture.shape[1]
    scale = side * look.DISC_IN_TEXTURE / look.DISC
    column, row = 0.5 * side + x * scale - 0.5, 0.5 * side - y * scale - 0.5
    if not (-1.0 < column < side and -1.0 < row < side):
        return 0.0
    i, j = math.floor(column), math.floor(row)
    a, b = column - i, row - j
    total = 0.0
    for dj in range(2):
        for di in range(2):
            if 0 <= i + di < side and 0 <= j + dj < side:
                part = (a if di == 1 else 1.0 - a) * (b if dj == 1 else 1.0 - b)
                total += part * texture[number, j + dj, i + di]
    return total / 255.0


@kernel
def resin(texture: Any, number: int, x: float, y: float, z: float, px: float) -> Any:
    """Colour in linear light of the resin at a unit vector of the ball's frame; ``px`` pixels a radius."""
    red, green, blue = look.BASE[number, 0], look.BASE[number, 1], look.BASE[number, 2]
    if number >= look.SNOOKER_RED:
        return red, green, blue
    if number == 0 or number >= look.NUMBERS:
        red_ball = number == look.CAROM_RED
        ink_red = look.RED_BALL_INK[0] if red_ball else look.SPOT_INK[0]
        ink_green = look.RED_BALL_INK[1] if red_ball else look.SPOT_INK[1]
        ink_blue = look.RED_BALL_INK[2] if red_ball else look.SPOT_INK[2]
        most = max(abs(x), max(abs(y), abs(z)))
        cover = _share((look.SPOT - math.sqrt(max(0.0, 1.0 - most * most))) * px)
        red += cover * (ink_red - red)
        green += cover * (ink_green - green)
        blue += cover * (ink_blue - blue)
        return red, green, blue
    from_pole = x * x + y * y
    disc = 0.0
    if (look.DISC * look.DISC - from_pole) * px > -1.2:  # else farther than the soft edge reaches
        disc = _share((look.DISC - math.sqrt(from_pole)) * px)
    white = disc
    if number > 8:
        white = max(disc, _share((abs(y) - look.STRIPE) * px))
    red += white * (look.WHITE[0] - red)
    green += white * (look.WHITE[1] - green)
    blue += white * (look.WHITE[2] - blue)
    if disc > 0.0:
        ink = disc * _digit(texture, number, -x if z < 0.0 else x, y)
        red += ink * (look.INK[0] - red)
        green += ink * (look.INK[1] - green)
        blue += ink * (look.INK[2] - blue)
    return red, green, blue


@kernel
def beam_of(lamp: int, place_x: float, place_y: float) -> Any:
    """A lamp as a ball sees it: unit vector to its nearest point, its middle (x, y), half its sides and blur
    over its height, and its strength. The place is in metres from the table's middle, x right, y up.
    """
    dx, dy, lx, ly = lamp_offset(lamp, place_x, place_y)
    height = look.LAMPS[lamp, 4]
    length = math.sqrt(lx * lx + ly * ly + height * height)
    half_x, half_y = look.LAMPS[lamp, 2] / height, look.LAMPS[lamp, 3] / height
    towards = (lx / length, ly / length, height / length)
    return (*towards, dx / height, dy / height, half_x, half_y, 0.06 / height, look.LAMPS[lamp, 5])


@kernel
def diffuse(facing: float) -> float:
    """Light of unit strength on a surface by the cosine towards it, reaching past the terminator."""
    bright = (facing + look.WRAP) * 0.8
    return bright * math.sqrt(bright) if bright > 0.0 else 0.0


@kernel
def glare_of(rx: float, ry: float, beam: Any, soft: float) -> float:
    """Mirror image of a lamp where a ray (rx, ry, 1) from the ball meets its plane; ``soft`` is its blur."""
    wide = max(beam[7], soft)
    across = _soft_strip(ry - beam[4], beam[6], wide)
    if across <= 0.0:
        return 0.0
    return beam[8] * across * _soft_strip(rx - beam[3], beam[5], wide)


@kernel
def tone(light: float) -> int:
    """A channel 0 to 255 from linear light that is not negative."""
    return look.TONES[int(min(light, look.BRIGHTEST) * look.TONE_STEPS)]


@kernel(inline="always")  # forty numbers handed over for each pixel would cost a quarter more
def _shade(
    nx: float,
    ny: float,
    nz: float,
    number: int,
    turn: Any,
    beams: Any,
    texture: Any,
    felt: Any,
    radius: float,
) -> int:
    """Colour 0xRRGGBB of a ball where its unit normal is (nx, ny, nz); ``turn`` is a matrix row by row."""
    # tuples, not arrays: the compiler keeps them in registers, which halves the time
    first, second = beams
    px = turn[0] * nx + turn[3] * ny + turn[6] * nz
    py = turn[1] * nx + turn[4] * ny + turn[7] * nz
    pz = turn[2] * nx + turn[5] * ny + turn[8] * nz
    red, green, blue = resin(texture, number, px, py, pz, radius * max(look.SOFTEST, nz))
    lit = first[8] * diffuse(nx * first[0] + ny * first[1] + nz * first[2])
    lit += second[8] * diffuse(nx * second[0] + ny * second[1] + nz * second[2])
    down, glare = 1.0 - 2.0 * nz * nz, 0.0  # how far the mirrored ray points at the cloth
    if down < -0.02:
        steep = -1.0 / down
        rx, ry, soft = 2.0 * nz * nx * steep, 2.0 * nz * ny * steep, 2.0 * steep * steep / radius
        glare = glare_of(rx, ry, first, soft) + glare_of(rx, ry, second, soft)
    rim = 1.0 - nz
    grazing = (1.0 - look.FRESNEL) * rim * rim * rim * rim * rim
    fresnel = look.FRESNEL + grazing
    falling = (look.AMBIENT + look.FROM_ABOVE * nz + look.DIFFUSE * lit) * (1.0 - grazing)
    bounce = look.BOUNCE * rim * math.sqrt(rim) * (1.0 - grazing)
    mirrored = fresnel * max(0.0, down)
    shine = fresnel * look.GLARE * glare
    color = tone(red * (falling + bounce * felt[0]) + mirrored * felt[0] + shine) << 16
    color |= tone(green * (falling + bounce * felt[1]) + mirrored * felt[1] + shine) << 8
    return color | tone(blue * (falling + bounce * felt[2]) + mirrored * felt[2] + shine)


class LitBall(NamedTuple):
    """One ball under the lamps: its number, turn row by row, both lamps as it sees them, its opacity."""

    number: int
    turn: Any
    beams: Any
    opacity: float


@kernel
def _paint_ball(
    pixels: Any, clip: Any, x: float, y: float, radius: float, ball: Any, texture: Any, felt: Any
) -> None:
    """One ball; its turn goes from its frame to the screen's, felt is in linear light."""
    reach = radius + 0.5
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - reach, y - reach, x + reach, y + reach)
    inner = max(0.0, 1.0 - 0.5 / radius)  # of the radius: from here on the rim shows
    number, turn, beams, opacity = ball
    for row in range(y_low, y_high):
        v = (y - row - 0.5) / radius
        for column in range(x_low, x_high):
            u = (column + 0.5 - x) / radius
            squared = u * u + v * v
            cover, nx, ny = 1.0, u, v
            if squared > inner * inner:
                s = math.sqrt(squared)
                cover = _share((1.0 - s) * radius)
                if cover <= 0.0:
                    continue
                if s > look.RIM:
                    nx, ny = u * look.RIM / s, v * look.RIM / s
            nz = math.sqrt(max(0.0, 1.0 - nx * nx - ny * ny))
            color = _shade(nx, ny, nz, number, turn, beams, texture, felt, radius)
            blend(pixels, row, column, color, weight_of(cover, opacity))


class ScreenBalls(NamedTuple):
    """Balls on the screen, later ones on top.

    ``points`` (n, 2) px, ``radii`` (n,) px, ``numbers`` (n,) int64 0 to 18 (see `ball_look`; others are
    left out), ``turns`` (n, 3, 3) from the ball's frame to the screen's (x right, y up, z to the viewer),
    ``opacities`` (n,); None: all solid.
    """

    points: Any
    radii: Any
    numbers: Any
    turns: Any
    opacities: Any = None

    def check(self) -> int:
        """How many balls there are. ValueError if the arrays do not fit each other."""
        count = len(self.points)
        if self.points.shape != (count, 2) or self.radii.shape != (count,) or self.numbers.shape != (count,):
            raise ValueError("balls: points (n, 2), radii (n,) and numbers (n,) must have one n")
        if self.turns.shape != (count, 3, 3):
            raise ValueError(f"balls: turns must be ({count}, 3, 3), not {self.turns.shape}")
        return count


@kernel
def paint_balls(pixels: Any, clip: Any, balls: Any, places: Any, texture: Any, felt: Any) -> None:
    """Balls (with opacities) whose radius asks for this digit texture.

    ``places`` (n, 2) m from the table's middle, ``texture`` (16, side, side) uint8, ``felt`` (3,) light.
    """
    points, radii, numbers, turns, opacities = balls
    ground = (felt[0], felt[1], felt[2])
    for i in range(points.shape[0]):
        x, y, radius, number = points[i, 0], points[i, 1], radii[i], numbers[i]
        if not (is_drawable(x) and is_drawable(y) and 0.5 <= radius <= LARGEST_RADIUS):
            continue
        if not 0 <= number < look.KINDS:
            continue
        t = turns[i]
        turn = (t[0, 0], t[0, 1], t[0, 2], t[1, 0], t[1, 1], t[1, 2], t[2, 0], t[2, 1], t[2, 2])
        total = places[i, 0] + places[i, 1]
        for entry in turn:
            total += entry
        if not is_drawable(total):  # nan anywhere, and no table index is safe
            continue
        if min(look.LARGEST_TEXTURE, max(look.SMALLEST_TEXTURE, int(2.2 * radius + 0.5))) != texture.shape[1]:
            continue
        beams = (beam_of(0, places[i, 0], places[i, 1]), beam_of(1, places[i, 0], places[i, 1]))
        _paint_ball(pixels, clip, x, y, radius, LitBall(number, turn, beams, opacities[i]), texture, ground)


@lru_cache(maxsize=8)
def texture_stack(side: int) -> Array:
    """Digit textures (16, side, side) uint8 of all balls."""
    return np.stack([look.digit_texture(number, side) for number in range(look.NUMBERS)])


class BallPainter:
    """Draws the balls of one table; ``felt`` is the cloth's colour, which they mirror."""

    def __init__(self, felt: pygame.Color) -> None:
        self._felt = np.array([felt.r, felt.g, felt.b]) / 255.0
        self._felt *= self._felt
        self._places = np.zeros((0, 2))
        self._opaque = np.ones(0)
        self._sides: tuple[int, ...] = ()
        self._radii = b""

    def draw(
        self,
        pixels: Array,
        clip: Array,
        balls: ScreenBalls,
        middle: tuple[float, float],
        scale: float,
        shadows: bool = True,
    ) -> None:
        """Shadows, then balls.

        ``middle`` px is where the table's middle lies on the screen and ``scale`` its px per metre: they
        place the lamps. ValueError if the arrays do not fit each other, or for a scale that is not positive.
        """
        count = balls.check()
        if not (math.isfinite(scale) and scale > 0.0):
            raise ValueError(f"balls: scale {scale!r} px/m is not positive and finite")
        if count != self._places.shape[0]:
            self._places, self._opaque = np.zeros((count, 2)), np.ones(count)
        places = self._places
        np.subtract(balls.points, middle, out=places)
        places *= (1.0 / scale, -1.0 / scale)
        if balls.opacities is None:
            balls = balls._replace(opacities=self._opaque)
        if shadows:
            paint_shadows(pixels, clip, balls.points, balls.radii, places, balls.opacities)
        for side in self._texture_sides(balls.radii):
            paint_balls(pixels, clip, balls, places, texture_stack(side), self._felt)

    def _texture_sides(self, radii: Array) -> tuple[int, ...]:
        """Sides of the textures that these radii need, from small to large."""
        if radii.tobytes() != self._radii:
            self._radii = radii.tobytes()
            usable = [float(r) for r in radii if 0.5 <= r <= LARGEST_RADIUS]
            self._sides = tuple(sorted({look.texture_side(r) for r in usable}))
        return self._sides


def _warm_up() -> None:
    """Compile the kernels on a picture of 8 x 8 pixels."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    painter = BallPainter(pygame.Color(0, 0, 0))
    ball = ScreenBalls(np.full((1, 2), 4.0), np.full(1, 2.0), np.ones(1, np.int64), np.eye(3)[None].copy())
    painter.draw(pixels, clip, ball, (4.0, 4.0), 100.0)


WARM_UPS = [("paint_balls", _warm_up)]
