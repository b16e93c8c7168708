"""A landscape behind a world: a sky with its light, and hills that lie the farther back the less they move
with the camera.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Inks, Longs
from game.compiler.decorator import lean_kernel
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.ui.raster.pixels import blend
from game.worlds.painting.boards import paint_quads
from game.worlds.painting.inks import channels, mixed, opaque

USUAL_SCALE = 14.0  # px to a m, at which hills are as large as they say
LIFTED = 11.0  # m above the meadow: a camera there sees the hills where they say


class Hill(NamedTuple):
    """near: part of the camera's motion that it takes over. height: of its crest's waves, m; length m of the
    longest; base: share of the picture's height at which it lies; trees: height of its crowns, m.
    """

    near: float
    height: float
    length: float
    base: float
    trees: float


HILLS = (
    Hill(0.04, 5.5, 38.0, 0.60, 0.0),
    Hill(0.09, 4.2, 27.0, 0.68, 0.0),
    Hill(0.17, 2.6, 21.0, 0.76, 0.55),
    Hill(0.32, 1.6, 33.0, 0.86, 1.0),
)
BLADES, PASSES = 90, 1.8  # of grass before the world, across the picture; its motion over the world's
HAZE = (0.5, 0.42, 0.34, 0.2)  # at the foot of each


class Hour(NamedTuple):
    """Colours of the sky above and at the horizon, of its light, of hills from the farthest on, of grass and
    of the earth below. sun: where the light stands, shares of width and height; radius: share of the height.
    wide, near: how much it brightens the sky far from it and close to it; stars: how bright they are.
    """

    above: int
    horizon: int
    light: int
    hills: tuple[int, int, int, int]
    grass: int
    earth: int
    sun: tuple[float, float] = (0.77, 0.2)
    radius: float = 0.05
    wide: float = 0.42
    near: float = 0.5
    stars: float = 0.0


DAY = Hour(
    0x6FA8D6, 0xF6E3C4, 0xFFF6DC, (0xA9BFCB, 0x8FB0A6, 0x719A7B, 0x527F58), 0x7FA05A, 0x5A4632
)  # fmt: skip
NIGHT = Hour(
    0x0B1026, 0x3A3560, 0xF3EBD2, (0x2B2D52, 0x23294A, 0x1A2440, 0x121C33), 0x1C3A33, 0x0E1720,
    radius=0.045, wide=0.18, stars=1.0,
)  # fmt: skip
DUSK = Hour(
    0x1B2247, 0xF08A4B, 0xFFE2A8, (0x7C5470, 0x5C4262, 0x3C3150, 0x262640), 0x4A5A34, 0x1C1A18,
    (0.74, 0.5), 0.055, 0.62, 0.7, 0.4,
)  # fmt: skip


@lean_kernel
def paint_landscape(pixels, clip, sky, crests, shades, spans):
    """Lay the sky (h, w) and before it hills, whose crests (l, w) are px down from its upper edge.

    shades (l, h): the colour of each hill by rows. spans (l + 1, 2): rows in which the sky and then each hill
    may be seen.
    """
    left, top = clip[0], clip[1]
    width, height = min(clip[2] - left, sky.shape[1]), min(clip[3] - top, sky.shape[0])
    for y in range(spans[0, 0], min(spans[0, 1], height)):
        for x in range(width):
            pixels[top + y, left + x] = sky[y, x]
    for k in range(crests.shape[0]):
        for y in range(spans[k + 1, 0], min(spans[k + 1, 1], height)):
            ink = shades[k, y]
            for x in range(width):
                below = pixels[top + y, left + x]
                pixels[top + y, left + x] = ink if y >= crests[k, x] else below
        smooth_crest(pixels, left, top, crests[k], shades[k], height)


def spans_of(crests: Floats, height: int) -> Longs:
    """Rows (l + 1, 2) in which the sky and each hill may be seen: from the first to before the last."""
    low = np.concatenate([[0.0], np.floor(crests.min(axis=1))])
    covered = np.ceil(crests.max(axis=1)) + 1.0
    high = np.concatenate([np.minimum.accumulate(covered[::-1])[::-1], [float(height)]])
    return np.clip(np.stack([low, high], axis=1), 0.0, float(height)).astype(np.int64)


@lean_kernel
def smooth_crest(pixels, left, top, crest, shades, height):
    """Lay the part of a hill over the pixels that its crest goes through."""
    for x in range(crest.shape[0]):
        y = math.floor(crest[x])
        if 0 <= y < height:
            blend(pixels, top + y, left + x, int(shades[y]), int(256.0 * (y + 1.0 - crest[x])))


class Landscape:
    """Paints the background of a canvas; keeps the sky of its size and theme. ground: m, of the meadow; late:
    the hour at night.
    """

    def __init__(self, ground: float = 0.0, late: Hour = NIGHT) -> None:
        self._ground, self._late = ground, late
        self._key: object = None
        self._sky: Inks = np.zeros((1, 1), np.uint32)
        self._hues: Floats = np.zeros((1, 2, 3))

    def draw(self, canvas: Canvas) -> None:
        """Paint what lies behind the world."""
        pixels, clip = canvas.raster_target
        width, height = int(clip[2] - clip[0]), int(clip[3] - clip[1])
        if width <= 0 or height <= 0:
            return
        hour = self._late if is_dark(canvas) else DAY
        key = (width, height, hour)
        if key != self._key:
            self._key = key
            self._sky, self._hues = _sky(width, height, hour), _hues(hour)
        crests = _crests(canvas, width, height, self._ground)
        paint_landscape(
            pixels, clip, self._sky, crests, _shades(self._hues, crests, height), spans_of(crests, height)
        )

    def draw_front(self, canvas: Canvas) -> None:
        """Paint grass before the world, at the lower edge of the picture; it moves more than the world."""
        hour, seen = self._late if is_dark(canvas) else DAY, canvas.camera.visible()
        wide, tall = seen.right - seen.left, seen.top - seen.bottom
        gap = wide / BLADES
        k = np.arange(math.floor(PASSES * seen.left / gap), math.ceil((PASSES * seen.left + wide) / gap))
        x = seen.left + k * gap - PASSES * seen.left + gap * np.sin(7.3 * k)
        high = tall * (0.035 + 0.03 * np.abs(np.sin(0.13 * k)) + 0.03 * np.sin(2.9 * k) ** 2)
        tip, low = x + 0.4 * high * np.sin(1.7 * k), max(seen.bottom - self._ground + 0.1 * tall, 0.0)
        base = seen.bottom - 0.01 * tall - low  # a camera that rises leaves it below
        corners = [
            (x - 0.9 * gap, base),
            (x + 0.9 * gap, base),
            (tip + 0.1 * gap, base + high),
            (tip, base + high),
        ]
        quads = np.stack([np.stack(np.broadcast_arrays(*one), axis=1) for one in corners], axis=1)
        inks = mixed(np.full(len(k), hour.grass), hour.earth, 0.45 + 0.4 * np.sin(4.1 * k) ** 2)
        paint_quads(canvas, quads.reshape(-1, 2), inks)


def warm_up_landscape() -> None:
    """Compile what paints, on a tiny picture."""
    paint_landscape(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.zeros((4, 4), np.uint32),
        np.full((1, 4), 2.5), np.zeros((1, 4), np.uint32),
        np.array(((0, 4), (2, 4))),
    )  # fmt: skip


def _sky(width: int, height: int, hour: Hour) -> Inks:
    """Colours (h, w): a gradient, the sun or the moon with its glow, at night stars."""
    above, horizon, light = (channels(ink) for ink in hour[:3])
    y, x = np.mgrid[0:height, 0:width].astype(np.float64)
    down = np.clip(y / (0.8 * height), 0.0, 1.0)[..., None] ** 1.3
    colors = above + (horizon - above) * down
    away = np.hypot(x - hour.sun[0] * width, y - hour.sun[1] * height) / height
    if hour.stars:
        random = np.random.default_rng(7)
        for row, column, bright in zip(
            (random.random(160) ** 1.4 * 0.6 * height).astype(int), (random.random(160) * width).astype(int),
            random.uniform(0.2, 0.9, 160), strict=True,
        ):  # fmt: skip
            colors[row, column] += (light - colors[row, column]) * bright * hour.stars
    glow = hour.near * np.exp(-((away / 0.11) ** 2)) + hour.wide * np.exp(-away / 0.28)
    colors += (light - colors) * np.clip(glow, 0.0, 1.0)[..., None]
    disc = np.clip((hour.radius - away) * height + 0.5, 0.0, 1.0)
    colors += (light - colors) * disc[..., None]
    return opaque(colors)


def _hues(hour: Hour) -> Floats:
    """Colours (l, 2, 3) at the crest and at the foot of hills and meadow: haze lies at the feet."""
    rows = [
        (channels(ink), channels(ink) + (channels(hour.horizon) - channels(ink)) * haze)
        for ink, haze in zip(hour.hills, HAZE, strict=True)
    ]
    return np.array([*rows, (channels(hour.grass), channels(hour.earth))])


def _shades(hues: Floats, crests: Floats, height: int) -> Inks:
    """Colours (l, h) of hills by rows, from the mean of their crests downwards."""
    down = (np.arange(height) - crests.mean(axis=1)[:, None]) / (0.34 * height)
    share = np.clip(down, 0.0, 1.0)[..., None] ** 0.8
    return opaque(hues[:, None, 0] + (hues[:, None, 1] - hues[:, None, 0]) * share)


def _crests(canvas: Canvas, width: int, height: int, ground: float) -> Floats:
    """Crests (l, w), px down, of all hills and the meadow as the camera stands."""
    (x, y), scale = canvas.camera.center, canvas.pixels_per_unit
    across = np.arange(width) - 0.5 * width
    found = np.empty((len(HILLS) + 1, width))
    for k, hill in enumerate(HILLS):
        own = USUAL_SCALE * height / 720.0 * (scale / USUAL_SCALE) ** (0.35 + hill.near)
        u = across / own + hill.near * x * 1.6 + 17.0 * k
        wave = math.tau / hill.length
        crest = 0.55 * np.sin(wave * u) + 0.3 * np.sin(2.3 * wave * u + 1.0 + k)
        crest += 0.15 * np.sin(5.1 * wave * u + 2.0 * k)
        tall = hill.height * crest
        if hill.trees:
            tall += (
                hill.trees
                * (np.abs(np.sin(1.9 * u)) + 0.7 * np.abs(np.sin(3.1 * u + 0.7)))
                * (0.4 + 0.6 * np.clip(0.5 + 2.5 * (np.sin(0.37 * u + k) + 0.3), 0.0, 1.0))  # clearings
            )
        found[k] = height * hill.base + hill.near * (y - ground - LIFTED) * scale * 0.6 - own * tall
    _, foot = canvas.camera.to_screen(x, ground)
    found[-1] = foot - canvas.rect.top + 0.02 * scale * np.sin(across / scale * 9.0 + 9.0 * x)
    return found
