"""The night round the show, as a panorama about the fleet: sky, moon, ridges, hills, a town by the lake."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.arrays import Floats
from game.scenes.fireworks.eye import AWAY, EYE, Seen, at_infinity, on_circle
from game.scenes.fireworks.shore import FLEET_LAMPS, bank, crowd, draw_fleet, firs
from game.ui.canvas.canvas import Canvas
from game.ui.canvas.lights import night_sky, sky_picture

HALF = 900.0  # to each side of an outline: half of the way round
TOWN = 330.0  # m from the fleet to the far shore
STARS = 1_500  # all round
MOON = (math.radians(-17.5), math.radians(15.5))  # azimuth and height
MOON_RADIUS = 5.2  # m as seen: twice the true one, as one remembers it
MOON_HALOS = ((9.0, 0.5), (42.0, 0.16), (130.0, 0.06))  # radius m and strength of its light in the haze


GLOW = pygame.Color(255, 214, 170)  # of bursts on the land
MOONLIGHT = pygame.Color(238, 236, 222)


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
    ((0.0, _ink("0a1024")), (0.45, _ink("111c38")), (0.8, _ink("1f3154")), (1.0, _ink("3d5178"))),
    _ink("1f2d4a"), _ink("132039"), _ink("0a101f"), _ink("d8a050"), _ink("03060c"), _ink("0a1226"),
    (0.62, 0.70, 0.92, 0.06), 1.0, 0.72,
)  # fmt: skip
DUSK = Night(
    (
        (0.0, _ink("141d42")), (0.4, _ink("2b3566")), (0.72, _ink("5d4f80")), (0.9, _ink("a56a78")),
        (1.0, _ink("d58f6c")),
    ),
    _ink("564a72"), _ink("383758"), _ink("211f38"), _ink("a87c3c"), _ink("100f1e"), _ink("1a1c38"),
    (0.85, 0.7, 0.75, 0.085), 0.45, 0.78,
)  # fmt: skip


class Layer(NamedTuple):
    """An outline (n, 2) that goes all the way round: x from -HALF to HALF, y m as seen from straight before
    it. radius: m, of the circle about the fleet on which it lies.
    """

    points: Floats
    radius: float

    @property
    def azimuths(self) -> Floats:
        """(n,) radians."""
        return self.points[:, 0] * (math.pi / HALF)

    @property
    def heights(self) -> Floats:
        """(n,) m, true ones."""
        return EYE + (self.points[:, 1] - EYE) * (AWAY + self.radius) / AWAY


def _waves(seed: int, base: float, heights: tuple[float, ...], counts: tuple[int, ...]) -> Floats:
    """An outline of waves, each so many times round."""
    chance = np.random.default_rng(seed)
    x = np.arange(-HALF, HALF + 1.0, 4.0)
    y = np.full_like(x, base)
    for height, count in zip(heights, counts, strict=True):
        y += height * np.sin(math.pi * x * count / HALF + chance.uniform(0.0, 6.3))
    y += chance.normal(0.0, 0.12 * heights[-1], len(x))
    return np.stack((x, np.maximum(y, 0.5)), axis=1)


@lru_cache(maxsize=1)
def ridge() -> Layer:
    """Mountains far off."""
    return Layer(_waves(3, 30.0, (11.0, 6.0, 2.5, 1.2), (4, 11, 27, 78)), 5_600.0)


@lru_cache(maxsize=1)
def hills() -> Layer:
    """Wooded hills behind the town."""
    return Layer(_waves(8, 13.0, (5.0, 2.6, 0.9), (7, 19, 138)), 1_300.0)


@lru_cache(maxsize=1)
def town() -> tuple[Layer, Layer]:
    """Roofs along the far shore, a church among them, and their lit windows."""
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
    return Layer(np.array(points), TOWN), Layer(np.array(windows), TOWN)


class Landscape:
    """Paints what is behind the show and what is before it; keeps the sky's picture."""

    def __init__(self) -> None:
        self._sky: NDArray[np.uint32] = np.zeros((0, 0), np.uint32)
        self._made_for: tuple[object, ...] = ()

    def night(self, canvas: Canvas) -> Night:
        """The hour of the theme."""
        return DUSK if canvas.theme.name == "light" else NIGHT

    def behind(self, canvas: Canvas, seen: Seen, lit: float) -> None:
        """Sky, stars, moon, ridges, hills and town. lit: how strongly bursts light the land, 0 to 1."""
        night = self.night(canvas)
        self._draw_sky(canvas, night)
        self._draw_stars(canvas, seen, night.stars)
        self._draw_moon(canvas, seen)
        self._fill(canvas, seen, ridge(), night.ridge.lerp(GLOW, 0.05 * lit))
        self._fill(canvas, seen, hills(), night.hill.lerp(GLOW, 0.08 * lit))
        houses, windows = town()
        self._fill(canvas, seen, houses, night.town.lerp(GLOW, 0.10 * lit))
        x, near, along = on_circle(seen, TOWN, windows.azimuths)
        places = np.stack((x, EYE + near * (windows.heights - EYE)), axis=1)[along > 0.0]
        canvas.glow(places, _packed(night.window), 0, 0.05)

    def fleet(self, canvas: Canvas, seen: Seen, lit: float) -> None:
        """The pontoons with their mortars, before the smoke and the light."""
        night = self.night(canvas)
        lamps = draw_fleet(canvas, seen, night.bank.lerp(GLOW, 0.03 + 0.25 * lit))
        canvas.glow(lamps, FLEET_LAMPS, 2, 0.3)

    def before(self, canvas: Canvas, seen: Seen, lit: float) -> None:
        """The near bank with its trees and those who watch."""
        night = self.night(canvas)
        ink = night.bank.lerp(GLOW, 0.05 * lit)
        for tree in firs(seen):
            canvas.polygon(tree, fill=ink)
        canvas.polygon(bank(seen), fill=ink)
        for one in crowd(seen, canvas.camera.visible()):
            canvas.polygon(one, fill=ink)

    @staticmethod
    def _draw_stars(canvas: Canvas, seen: Seen, strength: float) -> None:
        places, colors, sizes = night_sky(STARS, 4, round(strength, 2))
        x, y, shown = at_infinity(
            seen, (2.0 * places[:, 0] - 1.0) * math.pi, 0.02 + 0.55 * (1.0 - places[:, 1])
        )
        canvas.glow(np.stack((x, y), axis=1)[shown], colors[shown], sizes[shown])

    @staticmethod
    def _draw_moon(canvas: Canvas, seen: Seen) -> None:
        x, y, shown = at_infinity(seen, np.array(MOON[:1]), np.array(MOON[1:]))
        if not shown[0]:
            return
        at = (float(x[0]), float(y[0]))
        canvas.circle(at, MOON_RADIUS, fill=MOONLIGHT)
        radii = np.array([radius for radius, _ in MOON_HALOS])
        shares = np.array([share for _, share in MOON_HALOS])
        canvas.soft_glow(np.tile(at, (len(radii), 1)), radii, _packed(MOONLIGHT), shares)

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
    def _fill(canvas: Canvas, seen: Seen, layer: Layer, ink: pygame.Color) -> None:
        """An outline, down to the shore, where it is seen."""
        x, near, along = on_circle(seen, layer.radius, layer.azimuths)
        points = np.stack((x, EYE + near * (layer.heights - EYE)), axis=1)[along > 0.0]
        if np.any(np.diff(points[:, 0]) < 0.0):  # it begins anew within what is seen
            start = int(np.argmin(np.diff(points[:, 0]))) + 1
            points = np.concatenate((points[start:], points[:start]))
        view = canvas.camera.visible()
        points = points[(points[:, 0] > view.left - 60.0) & (points[:, 0] < view.right + 60.0)]
        if len(points) > 1:
            points = np.concatenate((points, ((points[-1, 0], -1.0), (points[0, 0], -1.0))))
            canvas.polygon(points, fill=ink)


def _packed(ink: pygame.Color) -> int:
    return (ink.r << 16) | (ink.g << 8) | ink.b
