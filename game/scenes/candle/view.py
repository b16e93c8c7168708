"""How the candle is drawn: a wall in its light, table, wax, flame and smoke, the glass before them."""

from __future__ import annotations

import numpy as np
import pygame

from game.scenes.candle.air import (
    AIR,
    CANDLE,
    HALF,
    HIGH,
    LOOK,
    RADIUS,
    RIM,
    ROOM,
    SINCE,
    SUPPLY,
    TALL,
    TOP,
    WALL,
)
from game.scenes.candle.world import CandleState, CandleWorld
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.members.burning_air import FRESH
from game.worlds.painting.boards import paint_quads, rects
from game.worlds.painting.flames import FIRELIGHT, HEAT_STOPS, draw_firelight, glow_stops
from game.worlds.painting.inks import color_of, scaled

BOX = ((-HALF, 0.0), (HALF, TALL))
SMOKE = {True: pygame.Color(128, 126, 130), False: pygame.Color(112, 110, 112)}
# by day and at night: wall, panel of the wall, table, its edge, wax, glass
TONES = (
    (0xB9B0A2, 0xA89F92, 0x9A6B42, 0x6E4A2C, 0xF2E8D2, 0xE8F4F6),
    (0x32343E, 0x2A2C36, 0x5A4030, 0x3A2A20, 0xC6BAA2, 0xBFD4DA),
)
BRIGHT, EMBER_S = 2600.0, 3.0  # W/m of a flame that lights all; s that a wick still glows
DEPTH = 0.05  # m: of the table in the picture
OXYGEN_STOPS = ((0.0, "vermilion"), (0.5, "amber"), (1.0, "chalk"))


class CandleView:
    """Draws a model and its hand."""

    def __init__(self, model: CandleWorld, hand: Hand):
        self.model, self.hand = model, hand

    def legend(self) -> list[tuple[str, str, str]]:
        """What is shown of the gas, if it is not what the eye sees."""
        words = {"oxygen": "none to that of fresh air", "temperature": "293 K dark to 1800 K bright"}
        shown = self.model.parameters.shown
        return [("square:amber", words[shown], "")] if shown in words else []

    def draw(self, canvas: Canvas, previous: CandleState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        model, tones = self.model, TONES[is_dark(canvas)]
        light = min(max(model.power(), 0.0) / BRIGHT, 1.0) ** 0.5
        rim = float(model.air.flows[RIM])
        if previous is not None:
            before = float(previous.air.flows[RIM])
            rim = before + alpha * (rim - before)
        self._draw_room(canvas, tones, light)
        self._draw_glass(canvas, tones[5], rim, 0.06)
        self._draw_candle(canvas, tones[4], light)
        self._draw_gas(canvas, is_dark(canvas))
        if light > 0.03:
            at = np.array([(0.0, TOP + 0.03), (0.0, TOP + 0.02)])
            inks, parts = np.full(2, FIRELIGHT, np.uint32), light * np.array((0.5, 0.8))
            canvas.soft_glow(at, np.array((0.34, 0.07)), inks, parts)
        canvas.bloom(0.8 if is_dark(canvas) else 0.45)
        self._draw_rims(canvas, tones[5], rim, light)
        if canvas.marks(False):
            self._draw_marks(canvas)
        if self.hand.point is not None:
            canvas.ring(self.hand.point, 9.0, "amber", 2.0)

    def _draw_room(self, canvas: Canvas, tones: tuple[int, ...], light: float) -> None:
        """Wall with panels, lit from the candle; table with its edge and the shadow of the candle."""
        wall = scaled(tones[0], 0.75 + 0.4 * light)
        canvas.fill(color_of(wall))
        middles = np.arange(-6.0, 6.5) * 0.2
        panels = rects([(x - 0.085, 0.05, x + 0.085, 1.2) for x in middles])
        near = 0.7 + 0.5 * light / (1.0 + (middles / 0.3) ** 2)
        paint_quads(canvas, panels, np.array([scaled(tones[1], one) for one in near.tolist()]), 0.9)
        top = scaled(tones[2], 0.6 + 0.5 * light)
        paint_quads(canvas, rects((-3.0, -DEPTH, 3.0, 0.012)), top)
        paint_quads(canvas, rects((-3.0, -1.0, 3.0, -DEPTH)), scaled(tones[3], 0.7 + 0.4 * light))
        foot = np.array([(-1.3, -0.004), (1.3, -0.004), (2.2, -0.02), (-2.2, -0.02)]) * (CANDLE, 1.0)
        paint_quads(canvas, foot, 0x000000, 0.35)

    def _draw_candle(self, canvas: Canvas, wax: int, light: float) -> None:
        """Wax that shines through below the flame, the wick, its ember."""
        slices = 10
        edges = np.linspace(-0.006, TOP, slices + 1)
        for k in range(
            slices
        ):  # the flame's light goes some way into wax; each covers the one before: no seams
            share, low = 0.55 + 0.55 * light * (k / (slices - 1)) ** 2, edges[k]
            for left, right, tone in ((-1.0, 1.0, 0.74), (-1.0, 0.4, 1.0), (-1.0, -0.5, 0.82)):
                slice_ = rects((left * CANDLE, low, right * CANDLE, TOP))
                paint_quads(canvas, slice_, scaled(wax, share * tone))
        canvas.line((0.0, TOP), (0.0008, TOP + 0.008), color_of(0x1C1612), 0.0016 * canvas.pixels_per_unit)
        flows = self.model.air.flows
        ember = 1.0 if flows[SUPPLY] > 0.0 else max(1.0 - float(flows[SINCE]) / EMBER_S, 0.0)
        if ember > 0.0:
            canvas.circle((0.0008, TOP + 0.008), 0.0011, color_of(0xFF7A28), ember)

    def _draw_gas(self, canvas: Canvas, dark: bool) -> None:
        air, shown = self.model.air, self.model.parameters.shown
        if shown == "flame":
            veil = air.veil()
            canvas.veil(veil, *BOX, SMOKE[dark], glow_stops(LOOK.dark, LOOK.bright))
            draw_firelight(canvas, veil, HALF, 16, 0.02, 2.0, 0.18)
        elif shown == "oxygen":
            fresh = air.gas.field("oxygen") / air.gas.field("air") * (AIR / FRESH)
            canvas.field(fresh, *BOX, OXYGEN_STOPS, 0.6)
        else:
            canvas.field((air.temperature - ROOM) / 1500.0, *BOX, HEAT_STOPS, 0.85)

    def _walls(self, rim: float) -> np.ndarray:
        """Corners (12, 2) m of the glass: left, right, its bottom that is above."""
        flows = self.model.air.flows
        radius, top = float(flows[RADIUS]), rim + float(flows[HIGH])
        return rects([(-radius - WALL, rim, -radius, top + WALL), (radius, rim, radius + WALL, top + WALL),
                      (-radius, top, radius, top + WALL)])  # fmt: skip

    def _draw_glass(self, canvas: Canvas, ink: int, rim: float, share: float) -> None:
        """The pane behind the flame, and its shadow on the table."""
        flows = self.model.air.flows
        wide, top = float(flows[RADIUS]) + WALL, rim + float(flows[HIGH]) + WALL
        near = max(1.0 - rim / 0.2, 0.0)
        shadow = np.array([(-wide, -0.002), (wide, -0.002), (1.25 * wide, -0.024), (-1.25 * wide, -0.024)])
        paint_quads(canvas, shadow, 0x000000, 0.3 * near)
        paint_quads(canvas, rects((-wide, rim, wide, top)), ink, share)

    def _draw_rims(self, canvas: Canvas, ink: int, rim: float, light: float) -> None:
        """Walls of the glass as they catch the light, and its gleams."""
        corners = self._walls(rim)
        paint_quads(canvas, corners, ink, 0.22 + 0.14 * light)
        flows = self.model.air.flows
        radius, high = float(flows[RADIUS]), float(flows[HIGH])
        for x, wide, share in ((-0.78, 0.05, 0.28), (-0.66, 0.02, 0.2), (0.82, 0.03, 0.16)):
            gleam = (radius * (x - wide), rim + 0.1 * high, radius * (x + wide), rim + 0.9 * high)
            paint_quads(canvas, rects(gleam), 0xFFFFFF, share * (0.5 + 0.5 * light))

    def _draw_marks(self, canvas: Canvas) -> None:
        """Where the gas goes."""
        air, size = self.model.air, self.model.air.cell
        x, y = np.meshgrid(np.arange(-0.14, 0.15, 0.02), np.arange(0.01, TALL - 0.02, 0.02))
        points = np.stack([x.ravel(), y.ravel()], axis=1)
        wind = air.wind_at(points)
        fast = np.sqrt(np.sum(wind * wind, axis=1)) > 4.0 * size
        canvas.segments(points[fast], points[fast] + 0.03 * wind[fast], "chalk", 1.4, 0.8)
