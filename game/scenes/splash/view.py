"""How the splash is drawn: a garden out of focus, the water before it, what theory says dashed upon it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import pygame

from game.arrays import Singles
from game.scenes.splash.parameters import HIGH, TOOLS, WIDE
from game.scenes.splash.told import GAUGE, THROW, thrown
from game.scenes.splash.world import SplashState, SplashWorld
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand, legend_of
from game.worlds.painting.inks import color_of
from game.worlds.painting.liquid import LiquidPainter
from game.worlds.painting.shades import Light, bump, grid_of, in_two_lights, lay_lit, smoothstep, soft

GARDEN = ((-1.3, -0.5), (4.0, 2.4))  # m
SUN = (2.02, 1.12)  # m: where it stands low behind leaves
HEDGE = 0.74  # m: mean height of it
DAY_LIGHTS: tuple[Light, Light] = ((1.0, 1.0, 1.0), (0.85, 0.8, 0.7))
DUSK_LIGHTS: tuple[Light, Light] = ((0.2, 0.25, 0.36), (0.75, 0.52, 0.34))
STONE = (0x8A8378, 0x34343A)  # of the pool's floor and walls, by day, at dusk
DYE = 0xFFC46B
SOFT = 4  # means of the field, as craters draw the rows of particles far out


class SplashView:
    """Draws the pool between the last two steps."""

    def __init__(self, model: SplashWorld, hand: Hand):
        self.model, self.hand = model, hand
        self.painter = LiquidPainter(model.liquid, SOFT)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """Lines of theory, and what the hand does."""
        rows = []
        if self.model.measures.foreseen() is not None:
            rows.append(("line:amber", "ripples by dispersion alone (Airy 1841)", ""))
        if self._shows_limit():
            rows.append(("line:vermilion", "half round crater with all energy of the drop", ""))
        return [*rows, *legend_of(TOOLS, self.model.parameters.tool)]

    def _shows_limit(self) -> bool:
        return bool(self.model.parameters.law) and math.isfinite(self.model.measures.limit())

    def draw(self, canvas: Canvas, previous: SplashState | None, alpha: float) -> None:
        """All of it ``alpha`` of the way from the state before to now."""
        liquid, dark = self.model.liquid, is_dark(canvas)
        lay_lit(canvas, garden(), GARDEN, *(DUSK_LIGHTS if dark else DAY_LIGHTS))
        places = liquid.places
        if previous is not None and len(previous.liquid.places) == len(places):
            places = previous.liquid.places + alpha * (places - previous.liquid.places)
        self.painter.draw(canvas, places)
        self._draw_stone(canvas, color_of(STONE[dark]))
        self._draw_theory(canvas)
        self._draw_throw(canvas)
        if canvas.teaching:
            own = places[self.model.measures.first :]
            canvas.discs(own, 0.4 * math.sqrt(liquid.area), DYE)

    def _draw_stone(self, canvas: Canvas, ink: pygame.Color) -> None:
        """Floor and walls of the pool, as far as they are seen."""
        seen, edge = canvas.camera.visible(), float(self.model.parameters.depth) + 0.12
        if seen.bottom < 0.0:
            foot = seen.bottom
            corners = [(seen.left, foot), (seen.right, foot), (seen.right, 0.0), (seen.left, 0.0)]
            canvas.polygon(corners, ink)
        for a, b in ((seen.left, 0.0), (WIDE, seen.right)):
            if a < b:
                canvas.polygon([(a, 0.0), (b, 0.0), (b, min(edge, HIGH)), (a, min(edge, HIGH))], ink)

    def _draw_throw(self, canvas: Canvas) -> None:
        """The drop in the hand, and its velocity."""
        hand, speed = self.hand, thrown(self.hand)
        if hand.start is None or hand.verb != "drop":
            return
        canvas.circle(hand.start, float(self.model.parameters.size), outline="accent", width=2.0)
        if speed is not None:
            canvas.arrow(hand.start, speed, "accent", "v", 1.0 / THROW)

    def _draw_theory(self, canvas: Canvas) -> None:
        now = self.model.measures
        law = now.foreseen()
        if law is not None:
            canvas.polyline(np.stack([now.x, law], axis=1), "amber", 2.6, dash=(8.0, 5.0))
            canvas.line((GAUGE, now.level - 0.1), (GAUGE, now.level + 0.14), "text2", 1.2, dash=(3.0, 3.0))
        if self._shows_limit():
            turn = np.linspace(math.pi, math.tau, 60)
            arc = now.limit() * np.stack([np.cos(turn), np.sin(turn)], axis=1) + (now.at, now.level)
            canvas.polyline(arc, "vermilion", 2.0, dash=(7.0, 5.0))


@lru_cache(maxsize=1)
def garden() -> Singles:
    """Sky, a hedge, reeds, a low sun among them: far behind the pool, and out of focus."""
    x, y = grid_of(GARDEN, (232, 424))
    random = np.random.default_rng(16)
    up = np.clip((y - HEDGE) / (GARDEN[1][1] - HEDGE), 0.0, 1.0)[..., None]
    color = (1.0 - up) * np.array((206.0, 224.0, 226.0)) + up * np.array((118.0, 164.0, 204.0))
    noise = soft(random.standard_normal(x.shape), (8.0, 11.0)) * 22.0
    clouds = smoothstep(0.1, 1.4, soft(random.standard_normal(x.shape), (6.0, 30.0)) * 40.0) * up[..., 0]
    color += (255.0 - color) * (0.55 * clouds)[..., None]
    for lift, ink, rough in ((0.16, (122.0, 150.0, 140.0), 0.05), (0.0, (70.0, 104.0, 66.0), 0.09)):
        edge = HEDGE + lift + rough * np.sin(2.3 * x + 9.0 * lift) + rough * (noise + np.sin(7.1 * x + lift))
        cover = smoothstep(0.05, -0.05, y - edge)[..., None]
        color += cover * (np.array(ink) * (1.0 + 0.22 * noise)[..., None] - color)
    flame = 190.0 * bump(np.hypot(x - SUN[0], y - SUN[1]), 0.5) + 90.0 * bump(y - HEDGE, 0.4)
    for _ in range(46):  # light between leaves: discs, as out of focus
        a, b = float(random.uniform(-1.2, 3.9)), float(random.normal(HEDGE, 0.11))
        size = float(random.uniform(0.022, 0.05))
        disc = smoothstep(size, size - 0.016, np.hypot(x - a, y - b))
        flame += disc * float(random.uniform(20.0, 90.0)) * (0.35 + bump(a - SUN[0], 0.9))
    color, flame = soft(color, (2.2, 2.2)), soft(flame, (0.8, 0.8))
    warm = flame[..., None] * np.array((1.0, 0.86, 0.6))
    return in_two_lights(np.clip(color, 0.0, 255.0) * 0.88, np.clip(warm, 0.0, 255.0), np.ones(x.shape))
