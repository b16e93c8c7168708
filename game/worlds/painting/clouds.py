"""A sky of clouds that drift, the lower the slower, and that a storm covers from one side.

Rows of a sky are rings: each goes on at its own end, and is the shorter the higher it stands.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Singles
from game.compiler.decorator import lean_kernel
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.inks import channels, packed
from game.worlds.painting.shades import smoothstep

CELLS = 1024  # of the noise, across and down
FRONT = 0.55  # how much of a change of weather is still to come at one side when it is over at the other
SOFT = 0.25  # of it: how softly a cloud's edge lets the new weather in
SUN_SIZE = 0.038  # its radius, of the height over the horizon
BRIGHT = 32  # places of the colours by height


class Weather(NamedTuple):
    """Colours above, at the horizon, of clouds in light and in shade.

    cover: 0 to 1. fine: how much of the clouds is billows, 0 to 1, and not wide masses.
    """

    above: int
    low: int
    lit: int
    shade: int
    cover: float
    fine: float


class Sun(NamedTuple):
    """Shares of the width and of the height over the horizon; its colour; how bright the sky is about it."""

    across: float
    up: float
    ink: int
    bright: float


class Sky(NamedTuple):
    """Pixels (2, h, w) of fair weather and foul, how much is cloud in the top byte; when (h, w) the change
    comes; columns (h,) of each row's ring; light (h, W, 3) about the sun; colours (2, BRIGHT, 3) by height.
    """

    pixels: Longs
    turns: Singles
    rings: Longs
    glow: Longs
    bands: Floats


@lean_kernel
def paint_sky(pixels, clip, top, foot, sky, shift, weather, shine):
    """Rows from top to foot, the horizon. shift: px by which the highest clouds have gone; weather: 0 fair to
    1 foul; shine: of the sun."""
    tall = sky.turns.shape[0]
    fair, foul = weather <= 0.0, weather >= 1.0
    for row in range(max(top, clip[1]), min(foot, clip[3])):
        j = max(tall - (foot - row), 0)
        ring = sky.rings[j]
        go = shift * sky.rings[tall - 1] / ring
        i = int(go - ring * math.floor(go / ring))
        for column in range(clip[0], clip[2]):
            if foul:
                pixels[row, column] = sky.pixels[1, j, i] | 0xFF000000
            else:
                ink = sky.pixels[0, j, i]
                cloud, red, green, blue = ink >> 24, ink >> 16 & 255, ink >> 8 & 255, ink & 255
                if not fair:
                    new = (weather * (FRONT + SOFT) - sky.turns[j, i]) / SOFT
                    share = int(256.0 * min(max(new, 0.0), 1.0))
                    other = sky.pixels[1, j, i]
                    cloud += ((other >> 24) - cloud) * share >> 8
                    red += ((other >> 16 & 255) - red) * share >> 8
                    green += ((other >> 8 & 255) - green) * share >> 8
                    blue += ((other & 255) - blue) * share >> 8
                bare = int(shine * (256 - cloud * 3 // 4))
                k = column - clip[0]
                red = min(red + (bare * sky.glow[j, k, 0] >> 8), 255)
                green = min(green + (bare * sky.glow[j, k, 1] >> 8), 255)
                blue = min(blue + (bare * sky.glow[j, k, 2] >> 8), 255)
                pixels[row, column] = 0xFF000000 | red << 16 | green << 8 | blue
            i += 1
            if i == ring:
                i = 0


@lru_cache(maxsize=1)
def _noise() -> tuple[Singles, Singles]:
    """(CELLS, CELLS) of billows and of masses, mean 0 and spread 1, that go on at their sides."""
    random = np.random.default_rng(15)
    size = np.hypot(np.fft.fftfreq(CELLS)[:, None], np.fft.rfftfreq(CELLS)[None, :]) * CELLS

    def made(power: float, least: float) -> Singles:
        spectrum = np.fft.rfft2(random.standard_normal((CELLS, CELLS))) * (size + least) ** -power
        field = np.fft.irfft2(spectrum * (size > 1.0))
        return np.asarray(field / np.std(field), np.float32)

    billows = made(2.3, 9.0) - 0.35 * np.abs(made(2.2, 26.0))
    return (billows - billows.mean()) / billows.std(), made(2.6, 3.0)


def _sampled(field: Singles, down: Floats, rings: Longs, width: int) -> Singles:
    """(h, w) of a field: rows at ``down`` (h,) cells, each once about its ring."""
    across = np.arange(width)[None, :] * (CELLS / rings[:, None])
    j, i = np.floor(down).astype(np.int64), np.floor(across).astype(np.int64)
    q, p = (down - j)[:, None].astype(np.float32), (across - i).astype(np.float32)
    a, b, c, d = i % CELLS, (i + 1) % CELLS, (j % CELLS)[:, None], ((j + 1) % CELLS)[:, None]
    above = field[c, a] * (1.0 - p) + field[c, b] * p
    below = field[d, a] * (1.0 - p) + field[d, b] * p
    return np.asarray(above * (1.0 - q) + below * q)


@lru_cache(maxsize=4)
def sky_of(rows: int, width: int, kinds: tuple[Weather, Weather], sun: Sun) -> Sky:
    """A sky down to the horizon for a picture of that width."""
    up = 1.0 - (np.arange(rows) + 0.5) / rows  # of what is seen over the horizon
    near = 0.16 / (up + 0.16)  # 1 at the horizon
    rings = np.rint(width * (1.9 - 1.3 * near)).astype(np.int64)
    down = 260.0 * near / 0.16 * 0.9
    most = int(rings.max())
    billows, masses = (_sampled(one, down, rings, most) for one in _noise())
    pixels = np.empty((2, rows, most), np.int64)
    bands = np.empty((2, BRIGHT, 3))
    for n, kind in enumerate(kinds):
        above, low, lit, shade = (channels(ink).astype(np.float32) for ink in kind[:4])
        height = up[:, None, None].astype(np.float32)
        colors = low + (above - low) * np.minimum(height * 1.15, 1.0) ** 0.62
        field = kind.fine * billows + (1.0 - kind.fine) * masses
        edge = np.quantile(field[rows // 8 : -rows // 8], 1.0 - kind.cover)
        cover = smoothstep(edge - 0.15, edge + 0.9, field)[..., None]
        toward = (
            np.roll(field, -max(width // 90, 2), axis=1) * 0.6
            + np.roll(field, max(rows // 60, 1), axis=0) * 0.4
        )
        bright = np.clip(0.5 + 0.75 * kind.fine * (field - toward) + 0.42 * (0.75 - cover[..., 0]), 0.0, 1.0)[
            ..., None
        ]
        cloud = shade + (lit - shade) * bright
        haze = np.exp(-7.0 * height)
        cover = cover * (1.0 - 0.8 * haze)
        cloud = cloud + (low - cloud) * haze
        colors = colors + (cloud - colors) * cover
        colors = np.clip(colors, 0.0, 255.0)
        pixels[n] = packed(colors) | (cover[..., 0] * 255.0).astype(np.int64) << 24
        means = colors.reshape(rows, -1, 3).mean(axis=1)
        # by the root of the sine of height: what is seen is the lowest third of the sky
        at = np.minimum(np.linspace(0.0, 1.0, BRIGHT) ** 2 * 2.2, 1.0) * (rows - 1)
        bands[n] = means[::-1][at.astype(np.int64)]
    turns = 0.5 * smoothstep(-1.5, 1.5, masses) * FRONT
    turns += 0.5 * FRONT * (np.arange(most) / rings[:, None])
    x = (np.arange(width) - sun.across * width) / rows
    y = up[:, None] - sun.up
    far = np.sqrt(x[None, :] ** 2 + 1.5 * y * y)
    strong = sun.bright * (0.55 * np.exp(-3.4 * far) + 0.75 * np.exp(-11.0 * far))
    disc = 2.4 * smoothstep(1.15 * SUN_SIZE, 0.85 * SUN_SIZE, np.sqrt(x[None, :] ** 2 + y * y))
    flare = np.minimum(channels(sun.ink) * (strong + disc)[..., None], 500.0).astype(np.int32)
    return Sky(
        pixels, np.asarray(turns, np.float32), rings, flare, bands,
    )  # fmt: skip


def draw_sky(
    canvas: Canvas, horizon: float, sky_kinds: tuple[Weather, Weather], sun: Sun, shift: float, weather: float
) -> Sky | None:
    """The sky of a canvas down to the world's height ``horizon``. None: it is out of the picture."""
    pixels, clip = canvas.raster_target
    _, y = canvas.place((0.0, horizon))
    left, top, right, bottom = (int(one) for one in clip)
    foot = min(max(int(y) + 8, top), bottom)
    if right <= left or foot <= top:
        return None
    tall = max(foot - top, int(0.62 * (bottom - top)))
    tall = -(-tall // 64) * 64  # kept while the camera moves a little
    sky = sky_of(tall, right - left, sky_kinds, sun)
    paint_sky(pixels, clip, top, foot, sky, shift, weather, max(1.0 - 1.5 * weather, 0.0))
    return sky


def warm_up_sky() -> None:
    """Compile what paints, on a tiny picture."""
    sky = Sky(
        np.zeros((2, 4, 8), np.int64), np.zeros((4, 8), np.float32), np.full(4, 8),
        np.zeros((4, 8, 3), np.int32),
        np.zeros((2, BRIGHT, 3)),
    )  # fmt: skip
    paint_sky(np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64), 0, 4, sky, 0.0, 0.5, 1.0)
