"""The night round the show: sky, ridges, hills, a town by the lake, trees on the near bank."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.arrays import Floats
from game.ui.canvas.canvas import Canvas
from game.ui.canvas.lights import sky_picture

HALF = 900.0  # m, to each side of what is there


def _ink(words: str) -> pygame.Color:
    return pygame.Color(f"#{words}")


class Night(NamedTuple):
    """Colours of an hour: sky from above to the horizon, layers from far to near, water, light on smoke."""

    sky: tuple[tuple[float, pygame.Color], ...]
    ridge: pygame.Color
    hill: pygame.Color
    town: pygame.Color
    window: pygame.Color
    bank: pygame.Color
    water: pygame.Color
    ambient: tuple[float, float, float, float]
    stars: float
    mirror: float


NIGHT = Night(
    ((0.0, _ink("050814")), (0.45, _ink("0a1226")), (0.8, _ink("16243f")), (1.0, _ink("2e3f62"))),
    _ink("152038"), _ink("0d1628"), _ink("070b16"), _ink("a87838"), _ink("020408"), _ink("050914"),
    (0.55, 0.65, 0.9, 0.034), 1.0, 0.66,
)  # fmt: skip
DUSK = Night(
    (
        (0.0, _ink("141d42")), (0.4, _ink("2b3566")), (0.72, _ink("5d4f80")), (0.9, _ink("a56a78")),
        (1.0, _ink("d58f6c")),
    ),
    _ink("564a72"), _ink("383758"), _ink("211f38"), _ink("a87c3c"), _ink("100f1e"), _ink("1a1c38"),
    (0.85, 0.7, 0.75, 0.06), 0.45, 0.78,
)  # fmt: skip


class Layer(NamedTuple):
    """An outline (n, 2) m as seen from the middle, and how far it goes with the camera (1: all the way)."""

    points: Floats
    slide: float


def _waves(seed: int, base: float, heights: tuple[float, ...], lengths: tuple[float, ...]) -> Floats:
    chance = np.random.default_rng(seed)
    x = np.arange(-HALF, HALF + 1.0, 4.0)
    y = np.full_like(x, base)
    for height, length in zip(heights, lengths, strict=True):
        y += height * np.sin(2.0 * np.pi * x / length + chance.uniform(0.0, 6.3))
    y += chance.normal(0.0, 0.12 * heights[-1], len(x))
    return np.stack((x, np.maximum(y, 0.5)), axis=1)


@lru_cache(maxsize=1)
def ridge() -> Layer:
    """Mountains far off."""
    return Layer(_waves(3, 30.0, (11.0, 6.0, 2.5, 1.2), (430.0, 171.0, 67.0, 23.0)), 0.93)


@lru_cache(maxsize=1)
def hills() -> Layer:
    """Wooded hills behind the town."""
    return Layer(_waves(8, 13.0, (5.0, 2.6, 0.9), (260.0, 97.0, 13.0)), 0.75)


@lru_cache(maxsize=1)
def town() -> tuple[Layer, Floats]:
    """Roofs along the far shore, a church among them, and their lit windows (n, 2) m."""
    chance = np.random.default_rng(21)
    points: list[tuple[float, float]] = [(-HALF, 1.0)]
    windows: list[tuple[float, float]] = []
    x = -HALF + 4.0
    while x < HALF - 12.0:
        if chance.random() < 0.34:  # trees between the houses
            width = chance.uniform(5.0, 14.0)
            turn = np.linspace(0.0, np.pi, 7)
            tall = chance.uniform(2.0, 4.6)
            points += [(x + 0.5 * width * (1.0 - np.cos(t)), 0.8 + tall * np.sin(t)) for t in turn]
        else:
            width, wall = chance.uniform(5.0, 10.0), chance.uniform(2.4, 5.4)
            roof = wall + chance.uniform(1.2, 2.6)
            points += [(x, 0.8), (x, wall), (x + 0.5 * width, roof), (x + width, wall), (x + width, 0.8)]
            windows += [
                (x + chance.uniform(0.8, width - 0.8), chance.uniform(1.2, wall - 0.4))
                for _ in range(int(chance.integers(0, 4)))
            ]
        if -70.0 < x < -55.0:  # the church
            points += [
                (x + width, 6.0),
                (x + width + 2.0, 17.5),
                (x + width + 4.0, 6.0),
                (x + width + 4.0, 0.8),
            ]
            width += 4.0
        x += width + chance.uniform(0.0, 2.5)
    points.append((HALF, 1.0))
    return Layer(np.array(points), 0.13), np.array(windows)


@lru_cache(maxsize=1)
def firs() -> tuple[Layer, ...]:
    """Firs on the near bank, to the left and to the right: outlines of their own."""
    chance = np.random.default_rng(5)
    made = []
    for x, tall in (
        (-178.0, 74.0), (-160.0, 52.0), (-147.0, 62.0), (-133.0, 33.0), (-192.0, 60.0), (-122.0, 22.0),
        (146.0, 40.0), (158.0, 58.0), (173.0, 46.0), (188.0, 70.0), (137.0, 24.0),
    ):  # fmt: skip
        rows = 9
        left, right = [], []
        for row in range(rows):
            share = row / rows
            wide = 0.20 * tall * (1.0 - share) ** 1.15 * chance.uniform(0.85, 1.12)
            foot = -46.0 + tall * (0.07 + 0.93 * share)
            left += [(x - wide, foot), (x - 0.42 * wide, foot + 0.055 * tall)]
            right += [(x + wide * chance.uniform(0.85, 1.1), foot), (x + 0.42 * wide, foot + 0.055 * tall)]
        top = (x, -46.0 + 1.04 * tall)
        trunk = 0.018 * tall
        made.append(
            Layer(np.array([(x - trunk, -80.0), (x - trunk, left[0][1]), *left, top, *right[::-1],
                            (x + trunk, right[0][1]), (x + trunk, -80.0)]), -0.55)
        )  # fmt: skip
    return tuple(made)


class Landscape:
    """Paints what is behind the show and what is before it; keeps the sky's picture."""

    def __init__(self) -> None:
        self._sky: NDArray[np.uint32] = np.zeros((0, 0), np.uint32)
        self._made_for: tuple[object, ...] = ()

    def night(self, canvas: Canvas) -> Night:
        """The hour of the theme."""
        return DUSK if canvas.theme.name == "light" else NIGHT

    def behind(self, canvas: Canvas, lit: float) -> None:
        """Sky, stars, ridges, hills and town. lit: how strongly bursts light the land, 0 to 1."""
        night = self.night(canvas)
        self._draw_sky(canvas, night)
        canvas.stars(8.0, 520, 4, night.stars)
        glow = pygame.Color(255, 214, 170)
        far, near = ridge(), hills()
        self._fill(canvas, far, night.ridge.lerp(glow, 0.05 * lit))
        self._fill(canvas, near, night.hill.lerp(glow, 0.08 * lit))
        houses, windows = town()
        self._fill(canvas, houses, night.town.lerp(glow, 0.10 * lit))
        shift = houses.slide * canvas.camera.center[0]
        canvas.glow(windows + np.array((shift, 0.0)), _packed(night.window), 0, 0.04)

    def before(self, canvas: Canvas) -> None:
        """The near bank with its trees."""
        night = self.night(canvas)
        for tree in firs():
            self._fill(canvas, tree, night.bank, closed=True)

    def _draw_sky(self, canvas: Canvas, night: Night) -> None:
        width, height = canvas.rect.size
        wanted = (width, height, night)
        if self._made_for != wanted:
            self._made_for = wanted
            rows = 2 * height
            down = ((1.0, night.sky[-1][1]),)
            stops = tuple((0.5 + 0.5 * at if at > 0.0 else 0.0, ink) for at, ink in night.sky) + down
            stops = ((0.0, night.sky[0][1]), (0.35, night.sky[0][1]), *stops[1:])
            self._sky = sky_picture(stops, rows, min(width, 4 * 64))
        canvas.backdrop(self._sky, 6.0, 2 * height - 1)

    @staticmethod
    def _fill(canvas: Canvas, layer: Layer, ink: pygame.Color, closed: bool = False) -> None:
        """An outline, down to the shore unless it is closed, where it is seen."""
        seen = canvas.camera.visible()
        points = layer.points + np.array((layer.slide * canvas.camera.center[0], 0.0))
        if not closed:
            part = (points[:, 0] > seen.left - 30.0) & (points[:, 0] < seen.right + 30.0)
            points = points[part]
            if len(points) < 2:
                return
            points = np.concatenate((points, ((points[-1, 0], -1.0), (points[0, 0], -1.0))))
        canvas.polygon(points, fill=ink)


def _packed(ink: pygame.Color) -> int:
    return (ink.r << 16) | (ink.g << 8) | ink.b
