"""The park: a low sun behind trees, a lawn with a path, a bench, a lamp; by night the lamp is lit."""

from __future__ import annotations

import math
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.arrays import Floats
from game.ui.canvas.canvas import Canvas
from game.ui.canvas.lights import sky_picture
from game.ui.canvas.standing import Standing

HALF = 14.0  # m to each side of what is there
BEHIND = 0.34  # m above the lawn's front where it meets the trees
BENCH_X, LAMP_X, SUN = -1.75, 2.55, (0.55, 1.75)


def _ink(words: str) -> pygame.Color:
    return pygame.Color(f"#{words}")


class Hour(NamedTuple):
    """Colours of an hour: sky from above down, rows of trees from far to near, lawn from back to front, path,
    wood, metal. Then light of the sun or lamp, strength of it, and the light on leaves (r, g, b).
    """

    sky: tuple[tuple[float, pygame.Color], ...]
    trees: tuple[tuple[pygame.Color, ...], ...]
    lawn: tuple[pygame.Color, pygame.Color]
    path: pygame.Color
    wood: pygame.Color
    metal: pygame.Color
    light: tuple[int, float]
    leaves: tuple[float, float, float]


DAY = Hour(
    ((0.0, _ink("8fb4cc")), (0.45, _ink("d8d8c0")), (0.75, _ink("f6dca6")), (1.0, _ink("fbe9c4"))),
    (
        (_ink("cbbd97"), _ink("d3b888"), _ink("bfb592")),
        (_ink("c08a4a"), _ink("b8743c"), _ink("a8904e"), _ink("cf9a48")),
        (_ink("a0562a"), _ink("b86a2c"), _ink("8a5a30"), _ink("c8842f")),
    ),
    (_ink("a9ab5e"), _ink("67782f")), _ink("d8c59a"), _ink("6b452a"), _ink("3c6450"),
    (0xFFE2A0, 0.85), (1.0, 0.97, 0.90),
)  # fmt: skip
DUSK = Hour(
    ((0.0, _ink("0d1426")), (0.4, _ink("23294a")), (0.75, _ink("5c4560")), (1.0, _ink("a8644e"))),
    (
        (_ink("4a4058"), _ink("514357"), _ink("453d52")),
        (_ink("4e3438"), _ink("5a3a34"), _ink("443238"), _ink("5e4234")),
        (_ink("352426"), _ink("43291f"), _ink("2e2426"), _ink("4a3222")),
    ),
    (_ink("3c4a30"), _ink("1a251a")), _ink("4c4440"), _ink("3a271b"), _ink("2c463c"),
    (0xFFB45A, 0.75), (0.96, 0.88, 0.86),
)  # fmt: skip


class Crown(NamedTuple):
    """A tree: tufts of leaves, (k, 4): place m, radius m, light from 0 to 1; which of its row's colours, its
    row, its trunk (4, 2) m.
    """

    tufts: Floats
    shade: int
    row: int
    trunk: Floats


SLIDES = (0.72, 0.5, 0.28)  # how far each row of trees goes with the camera
FEET = (0.46, 0.42, 0.36)  # m at which their trunks stand


@lru_cache(maxsize=1)
def crowns() -> tuple[Crown, ...]:
    """Trees in three rows, the farthest first; each crown of many tufts, lit from where the sun stands."""
    chance = np.random.default_rng(18)
    made = []
    for row, (spacing, tall, wide, count) in enumerate(
        ((0.8, 1.1, 0.5, 170), (1.3, 1.6, 0.62, 330), (2.3, 2.5, 0.95, 620))
    ):
        x = -HALF
        while x < HALF:
            x += spacing * chance.uniform(0.6, 1.4)
            if row and abs(x - SUN[0]) < (0.9 if row == 1 else 2.0):
                continue  # the middle stays open to the sun
            height, half = tall * chance.uniform(0.8, 1.2), wide * chance.uniform(0.75, 1.15)
            base = FEET[row]
            middle = base + 0.64 * height
            away = np.sqrt(chance.random(count)) * 0.96
            turn = chance.uniform(0.0, math.tau, count)
            tufts = np.stack(
                [x + half * away * np.cos(turn), middle + 0.42 * height * away * np.sin(turn)], axis=1
            )
            radii = half * chance.uniform(0.08, 0.16, count) * (1.2 - 0.5 * away)
            toward = 1.0 if x < SUN[0] else -1.0
            light = (
                0.5
                + 0.32 * (toward * away * np.cos(turn) + away * np.sin(turn))
                + chance.normal(0.0, 0.10, count)
            )
            order = np.argsort(
                light + 0.4 * chance.random(count), kind="stable"
            )  # what is lit stands before what is not
            rows = np.concatenate([tufts, radii[:, None], np.clip(light, 0.0, 1.0)[:, None]], axis=1)[order]
            thick = 0.03 * height
            trunk = np.array(
                [
                    (x - thick, base - 0.1),
                    (x + thick, base - 0.1),
                    (x + 0.6 * thick, middle),
                    (x - 0.6 * thick, middle),
                ]
            )
            made.append(Crown(rows, int(chance.integers(0, 4)), row, trunk))
    return tuple(made)


@cache
def inks_of(number: int, day: bool) -> tuple[pygame.Color, NDArray[np.uint32]]:
    """The colour of a tree's trunk, and those of its tufts (k,), by how much light falls on each."""
    crown, hour = crowns()[number], DAY if day else DUSK
    inks = hour.trees[crown.row]
    ink = inks[crown.shade % len(inks)]
    dark = ink.lerp(pygame.Color(24, 14, 16), 0.42)
    lit = ink.lerp(pygame.Color(*channels(hour.light[0])), 0.38 if day else 0.20)
    share = crown.tufts[:, 3:]
    low, middle, high = (np.array((one.r, one.g, one.b), dtype=np.float64) for one in (dark, ink, lit))
    hues = np.where(
        share < 0.5, low + 2.0 * share * (middle - low), middle + (2.0 * share - 1.0) * (high - middle)
    )
    return dark, np.ascontiguousarray(hues.astype(np.uint32) @ np.array((65536, 256, 1), dtype=np.uint32))


class Park:
    """Paints what is behind the leaves and before them."""

    def __init__(self) -> None:
        self._standing = Standing()
        self._sky: NDArray[np.uint32] = np.zeros((0, 0), np.uint32)
        self._made_for: tuple[object, ...] = ()
        chance = np.random.default_rng(4)
        n = 340
        self._blades = np.stack(
            [
                chance.uniform(-9.0, 9.0, n), chance.uniform(-0.40, 0.30, n), chance.uniform(0.03, 0.085, n),
                chance.uniform(0.0, math.tau, n),
            ],
            axis=1,
        )  # fmt: skip

    def hour(self, canvas: Canvas) -> Hour:
        """The hour of the theme."""
        return DAY if canvas.theme.name == "light" else DUSK

    def behind(self, canvas: Canvas) -> None:
        """Sky, sun, trees, lawn, path, bench and lamp."""
        self._standing.draw(canvas, self._paint_behind)

    def _paint_behind(self, canvas: Canvas) -> None:
        hour = self.hour(canvas)
        self._draw_sky(canvas, hour)
        shift = canvas.camera.center[0]
        sun = (SUN[0] + 0.9 * shift, SUN[1])
        color, strength = hour.light
        lit = hour is DAY
        canvas.soft_glow([sun, sun, sun], np.array((0.22, 0.75, 2.2)), color,
                         np.array((1.0, 0.5, 0.22)) * (strength if lit else 0.35))  # fmt: skip
        canvas.bloom(1.0)
        for number, crown in enumerate(crowns()):
            self._draw_tree(canvas, hour, number, SLIDES[crown.row] * shift)
        self._draw_lawn(canvas, hour)
        self._draw_bench(canvas, hour)
        self._draw_lamp(canvas, hour)
        # light through the gap between the trees, over the lawn
        canvas.soft_glow(
            [(SUN[0] + 0.5 * shift, 0.25)], np.array((1.6,)), color, np.array((0.25 if lit else 0.12,))
        )
        if not lit:
            spots = [(LAMP_X, 1.72), (LAMP_X, 1.72), (LAMP_X, 0.05)]
            canvas.soft_glow(spots, np.array((0.14, 0.8, 1.4)), color,
                             np.array((1.1, 0.45, 0.28)))  # fmt: skip
        canvas.bloom(0.8)

    def _draw_sky(self, canvas: Canvas, hour: Hour) -> None:
        width, height = canvas.rect.size
        wanted = (width, height, hour)
        if self._made_for != wanted:
            self._made_for = wanted
            self._sky = sky_picture(hour.sky, 2 * height, min(width, 256))
        canvas.backdrop(self._sky, BEHIND, 2 * height - 1)

    def _draw_tree(self, canvas: Canvas, hour: Hour, number: int, slide: float) -> None:
        crown, seen = crowns()[number], canvas.camera.visible()
        x = float(crown.trunk[0, 0]) + slide
        if not seen.left - 2.0 < x < seen.right + 2.0:
            return
        off = np.array((slide, 0.0))
        dark, colors = inks_of(number, hour is DAY)
        canvas.polygon(crown.trunk + off, fill=dark)
        canvas.discs(crown.tufts[:, :2] + off, crown.tufts[:, 2].copy(), colors)

    def _draw_lawn(self, canvas: Canvas, hour: Hour) -> None:
        seen = canvas.camera.visible()
        low = min(seen.bottom, -0.5) - 0.1
        back, front = hour.lawn
        heights = np.linspace(BEHIND + 0.06, low, 15)
        for k in range(14):
            ink = back.lerp(front, min(k / 11.0, 1.0))
            canvas.polygon(
                [(seen.left, heights[k]), (seen.right, heights[k]), (seen.right, heights[k + 1] - 0.01),
                 (seen.left, heights[k + 1] - 0.01)],
                fill=ink,
            )  # fmt: skip
        x = np.linspace(seen.left, seen.right, 24)
        top = 0.275 + 0.02 * np.sin(0.9 * x)
        path = np.concatenate(
            [np.stack([x, top], 1), np.stack([x, top - 0.06 - 0.012 * np.sin(1.7 * x)], 1)[::-1]]
        )
        canvas.polygon(path, fill=hour.path, fill_alpha=0.75)

    def _draw_bench(self, canvas: Canvas, hour: Hour) -> None:
        """A bench by the path."""
        x, y = BENCH_X, 0.16
        for left in (x - 0.52, x + 0.44):
            canvas.polygon(
                [(left, y), (left + 0.07, y), (left + 0.07, y + 0.34), (left, y + 0.34)], fill=hour.metal
            )
            canvas.polygon(
                [
                    (left + 0.01, y + 0.3),
                    (left + 0.05, y + 0.3),
                    (left + 0.01, y + 0.68),
                    (left - 0.03, y + 0.68),
                ],
                fill=hour.metal,
            )
        lit = hour.wood.lerp(pygame.Color(255, 220, 170), 0.25 if hour is DAY else 0.08)
        for k, (up, tall) in enumerate(((0.30, 0.05), (0.44, 0.06), (0.53, 0.06), (0.62, 0.06))):
            shift = -0.012 * k
            corners = [(x - 0.6 + shift, y + up), (x + 0.6 + shift, y + up), (x + 0.6 + shift, y + up + tall),
                       (x - 0.6 + shift, y + up + tall)]  # fmt: skip
            canvas.polygon(corners, fill=hour.wood)
            canvas.polygon([corners[3], corners[2], (corners[2][0], corners[2][1] - 0.015),
                            (corners[3][0], corners[3][1] - 0.015)], fill=lit)  # fmt: skip

    def _draw_lamp(self, canvas: Canvas, hour: Hour) -> None:
        x, y = LAMP_X, 0.12
        canvas.polygon(
            [(x - 0.07, y), (x + 0.07, y), (x + 0.025, y + 0.12), (x - 0.025, y + 0.12)], fill=hour.metal
        )
        canvas.polygon([(x - 0.02, y), (x + 0.02, y), (x + 0.014, 1.6), (x - 0.014, 1.6)], fill=hour.metal)
        glass = pygame.Color(*channels(hour.light[0])) if hour is DUSK else _ink("e9e2cc")
        canvas.polygon([(x - 0.06, 1.6), (x + 0.06, 1.6), (x + 0.09, 1.8), (x - 0.09, 1.8)], fill=glass)
        canvas.polygon([(x - 0.11, 1.8), (x + 0.11, 1.8), (x, 1.9)], fill=hour.metal)

    def grass(self, canvas: Canvas, wind: Floats, front: bool) -> None:
        """Blades that lean with the wind (k, 2) m/s at `blade_places`; those before the leaves, or behind."""
        hour = self.hour(canvas)
        part = (self._blades[:, 1] < -0.12) == front
        rows, push = self._blades[part], wind[part]
        feet = rows[:, :2]
        lean = np.clip(0.05 * push[:, 0] + 0.12 * np.sin(rows[:, 3]), -0.9, 0.9)
        scale = 2.0 if front else 1.0
        tips = feet + (scale * rows[:, 2])[:, None] * np.stack([np.sin(lean), np.cos(lean)], axis=1)
        back, fore = hour.lawn
        ink = (fore if front else back.lerp(fore, 0.6)).lerp(
            pygame.Color(225, 215, 110), 0.30 if hour is DAY else 0.20
        )
        canvas.segments(feet, tips, ink, 2.2 if front else 1.2, 0.8)

    @property
    def blade_places(self) -> Floats:
        """(k, 2) m of the blades' feet, lifted to where the wind takes them."""
        return np.stack([self._blades[:, 0], np.full(len(self._blades), 0.12)], axis=1)


def channels(ink: int) -> tuple[int, int, int]:
    """Channels of 0xRRGGBB."""
    return ink >> 16 & 255, ink >> 8 & 255, ink & 255
