"""Verbs for light: stars of fireworks and sparks, soft glows, bloom, a still sky, water that mirrors."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray

from game.ui.canvas.base import CanvasBase, Token
from game.ui.look.look import Look
from game.ui.raster.glow import LARGEST, Bloom, add_lights, gather_glows, gather_lights, stamps_of
from game.ui.raster.projection import as_points
from game.ui.raster.water import mirror_rows, wave_table

GLOW_RADII = (1.5, 2.0, 3.0, 4.2, 6.0)  # design px of the sizes of small lights
SOFTNESS = 0.72  # of the bloom: share that a cell takes from the one before


class LightCanvas(CanvasBase):
    """What shines is added to the picture; `bloom` ends it by the light about all that shone."""

    def __init__(self, look: Look) -> None:
        super().__init__(look)
        self._bloom = Bloom()

    def glow(self, positions: Any, colors: Any, sizes: Any = 1, shares: Any = None) -> None:
        """Very many small lights, added: (n, 2), uint32 (n,) as strong as they shine, which of GLOW_RADII.

        shares (n,): how much each adds to the bloom (1: as one cell full of its colour); None: nothing.
        """  # fmt: skip
        mapped = self._map(positions)
        n = mapped.shape[0]
        inks = np.ascontiguousarray(np.broadcast_to(np.asarray(colors, np.uint32), (n,)))
        which = np.ascontiguousarray(np.broadcast_to(np.asarray(sizes, np.uint8), (n,)))
        stamps = stamps_of(tuple(min(radius * self.k, LARGEST) for radius in GLOW_RADII))
        flat = self._pixels.reshape(-1)
        add_lights(self._pixels, flat, self._clip, mapped, inks, which, *stamps)
        if shares is not None:
            light, left, top = self._cells()
            part = np.ascontiguousarray(np.broadcast_to(np.asarray(shares, np.float64), (n,)))
            gather_lights(light, left, top, mapped, inks, part)

    def soft_glow(self, positions: Any, radii: Any, colors: Any, shares: Any = 1.0) -> None:
        """Large soft lights for the next `bloom`: (n, 2), radii in world units, colours and strengths."""
        mapped = self._map(positions)
        n = mapped.shape[0]
        reach = np.ascontiguousarray(np.broadcast_to(np.asarray(radii, np.float64) * self._scale, (n,)))
        inks = np.ascontiguousarray(np.broadcast_to(np.asarray(colors, np.uint32), (n,)))
        part = np.ascontiguousarray(np.broadcast_to(np.asarray(shares, np.float64), (n,)))
        light, left, top = self._cells()
        gather_glows(light, left, top, mapped, reach, inks, part)

    def bloom(self, strength: float = 1.0, softness: float = SOFTNESS) -> None:
        """Add the light about what `glow` and `soft_glow` have drawn since the last one."""
        self._cells()
        self._bloom.shine(self._pixels, self._clip, float(strength), float(softness))

    def stars(self, horizon: float, count: int = 400, seed: int = 1, strength: float = 1.0) -> None:
        """A still sky above a height of the world: it stays where it is when the camera goes sideways."""
        left, _, right, bottom = (int(value) for value in self._clip)
        top = self._place((0.0, horizon))[1] - 0.9 * (bottom - int(self._clip[1]))
        places, colors, sizes = night_sky(count, seed, round(strength, 2))
        shown = places * (right - left, 0.9 * (bottom - int(self._clip[1]))) + (left, top)
        stamps = stamps_of(tuple(min(radius * self.k, LARGEST) for radius in GLOW_RADII))
        add_lights(
            self._pixels, self._pixels.reshape(-1), self._clip, as_points(shown), colors, sizes, *stamps
        )

    def water(
        self, shore: float, top: float, time: float, color: Token = "body", share: float = 0.6
    ) -> None:  # fmt: skip
        """Still water below a height of the world, which mirrors what is drawn so far, up to ``top``.

        time: s, for its waves; share: of the light that is mirrored.
        """
        x, shore_px = self._place((0.0, shore))
        above = shore_px - self._place((x, top))[1]
        below = max(float(self._clip[3]) - shore_px, 1.0)
        squeeze = min(max(above / below, 1.0), 6.0)
        mirror_rows(
            self._pixels, self._clip, float(shore_px), float(squeeze), wave_table(), float(time),
            self._ink(color)[0], float(share),
        )  # fmt: skip

    def backdrop(self, picture: NDArray[np.uint32], horizon: float, row: int) -> None:
        """Lay a picture (rows, columns) behind all, its ``row`` at a height of the world, over and over."""
        left, top, right, bottom = (int(value) for value in self._clip)
        first = row - round(self._place((0.0, horizon))[1]) + top
        rows = np.clip(np.arange(first, first + bottom - top), 0, picture.shape[0] - 1)
        columns = picture.shape[1]
        for start in range(left, right, columns):
            stop = min(start + columns, right)
            self._pixels[top:bottom, start:stop] = picture[rows, : stop - start]

    def _cells(self) -> tuple[NDArray[np.float32], float, float]:
        """The bloom's cells for this picture, and where they begin (px)."""
        left, top, right, bottom = (int(value) for value in self._clip)
        self._bloom.fit(right - left, bottom - top)
        return self._bloom.light, float(left), float(top)


@lru_cache(maxsize=8)
def night_sky(
    count: int, seed: int, strength: float
) -> tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint8]]:
    """Places (n, 2) in a unit square, more of them high up, colours and sizes of stars: few are bright."""
    chance = np.random.default_rng(seed)
    places = chance.random((count, 2))
    places[:, 1] = places[:, 1] ** 1.3
    bright = strength * (0.10 + 0.75 * chance.random(count) ** 5) * (1.0 - 0.75 * places[:, 1])
    warm = chance.normal(0.0, 0.1, count)
    channels = np.stack((1.0 + warm, np.full(count, 0.97), 1.0 - 1.3 * warm))
    red, green, blue = np.clip(255.0 * bright * channels, 0, 255).astype(np.uint32)
    sizes = (bright > 0.45 * strength).astype(np.uint8)
    return places, (red << 16) | (green << 8) | blue, sizes


def sky_picture(stops: tuple[tuple[float, pygame.Color], ...], rows: int, columns: int) -> NDArray[np.uint32]:
    """A sky (rows, columns) from top (0) to bottom (1) through colours, dithered against bands."""
    heights = np.linspace(0.0, 1.0, rows)
    grain = (np.array(((0, 8, 2, 10), (12, 4, 14, 6), (3, 11, 1, 9), (15, 7, 13, 5))) + 0.5) / 16.0
    tile = np.tile(grain, (rows // 4 + 1, columns // 4 + 1))[:rows, :columns]
    picture = np.full((rows, columns), 0xFF000000, np.uint32)
    for shift, channel in ((16, 0), (8, 1), (0, 2)):
        level = np.interp(heights, [stop[0] for stop in stops], [stop[1][channel] for stop in stops])
        picture |= np.clip(level[:, None] + tile, 0, 255).astype(np.uint32) << np.uint32(shift)
    return picture
