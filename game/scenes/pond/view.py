"""How a pond is drawn: its bank, the water, what floats on it, and what theory says."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pygame

from game.physics.waves.floats import FX, FY, RADIUS
from game.physics.waves.hull import HCOS, HSIN
from game.physics.waves.wave_particles import HEIGHT, X, Y
from game.scenes.pond.painting import bed_picture, find_slopes, paint_pond, tones_of
from game.scenes.pond.told import ring_now, ring_of, wedge, wedge_by_law
from game.scenes.pond.world import PondState, PondWorld
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand

BANK, BANK_NIGHT = pygame.Color(169, 148, 104), pygame.Color(59, 52, 40)
BUOY, STRIPE = pygame.Color(208, 68, 46), pygame.Color(244, 240, 230)
WOOD, DECK, KEEL, INSIDE = (
    pygame.Color(138, 90, 43),
    pygame.Color(200, 155, 95),
    pygame.Color(58, 36, 18),
    pygame.Color(91, 59, 28),
)
DARK, RIM, RIM_NIGHT = pygame.Color(4, 18, 28), pygame.Color(107, 90, 56), pygame.Color(43, 36, 24)
SHADOW, OFF = 0.28, np.array((0.08, -0.08))
CREST, TROUGH = 0xFFE0553A, 0xFF2C6FD0


class PondView:
    """Draws a world."""

    def __init__(self, model: PondWorld, hand: Hand):
        self.model, self.hand = model, hand
        self._slopes = np.zeros((3, *model.water.heights.shape), np.int32)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What theory is drawn, while it is known."""
        if not self.model.parameters.law:
            return []
        if ring_of(self.model) is not None:
            return [("line:yellow", "ring by the wave's speed", "")]
        if not math.isnan(wedge(self.model)):
            return [("line:yellow", "wedge, sin = c / U", "")]
        return []

    def draw(self, canvas: Canvas, previous: PondState | None, alpha: float) -> None:
        """The pond as it is now; floats ``alpha`` of the way from the state before."""
        model, night = self.model, is_dark(canvas)
        seen = canvas.camera.visible()
        bank = np.array(
            [
                (seen.left, seen.bottom),
                (seen.right, seen.bottom),
                (seen.right, seen.top),
                (seen.left, seen.top),
            ]
        )
        canvas.polygon(bank, fill=BANK_NIGHT if night else BANK)
        pixels, clip = canvas.raster_target
        water = model.water
        find_slopes(water.heights, water.cell, self._slopes)
        zero = canvas.place((0.0, 0.0))
        paint_pond(
            pixels,
            clip,
            self._slopes,
            bed_picture(),
            zero,
            canvas.pixels_per_unit,
            water.cell,
            tones_of(night),
        )
        width, height = water.size
        rim = np.array([(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)])
        canvas.polygon(rim, outline=RIM_NIGHT if night else RIM, width=5.0)
        if model.parameters.dots:
            self._draw_particles(canvas)
        self._draw_law(canvas)
        self._draw_floats(canvas, previous, alpha)
        if model.has_boat:
            self._draw_boat(canvas)

    def _draw_particles(self, canvas: Canvas) -> None:
        fields = self.model.water.fields
        inks = np.where(fields[HEIGHT] > 0.0, np.uint32(CREST), np.uint32(TROUGH))
        canvas.particles(np.ascontiguousarray(fields[[X, Y]].T), inks, 1.3)

    def _draw_law(self, canvas: Canvas) -> None:
        model = self.model
        if not model.parameters.law:
            return
        ring = ring_of(model)
        if ring is not None:
            radius = ring_now(model)[1][0]
            if math.isfinite(radius):
                canvas.circle((ring[0], ring[1]), radius, outline="yellow", width=1.6, dash=(7.0, 5.0))
        half = wedge_by_law(model)
        if math.isfinite(wedge(model)):
            c, s = model.boat.pose[[HCOS, HSIN]].tolist()
            bow, length = model.boat.bow(), 0.75 * model.water.size[1]
            for side in (-1.0, 1.0):
                turn = math.radians(180.0 + side * half)
                x = c * math.cos(turn) - s * math.sin(turn)
                y = s * math.cos(turn) + c * math.sin(turn)
                canvas.line(bow, (bow[0] + length * x, bow[1] + length * y), "yellow", 1.6, dash=(7.0, 5.0))

    def _draw_floats(self, canvas: Canvas, previous: PondState | None, alpha: float) -> None:
        rows = self.model.floats.rows
        if not len(rows):
            return
        places = rows[:, [FX, FY]]
        if previous is not None and previous.floats.rows.shape == rows.shape:
            before = previous.floats.rows[:, [FX, FY]]
            places = before + alpha * (places - before)
        radii = rows[:, RADIUS]
        canvas.discs(places + OFF, radii, DARK, SHADOW)
        canvas.discs(places, radii, BUOY)
        canvas.discs(places, 0.72 * radii, STRIPE)
        canvas.discs(places, 0.4 * radii, BUOY)
        canvas.discs(places + 0.24 * radii[:, None] * (-1.0, 1.0), 0.16 * radii, STRIPE, 0.75)

    def _draw_boat(self, canvas: Canvas) -> None:
        corners = self.model.boat.corners()
        middle = corners.mean(axis=0)
        canvas.polygon(corners + OFF, fill=DARK, fill_alpha=SHADOW)
        canvas.polygon(corners, fill=WOOD, outline=KEEL, width=2.0)
        canvas.polygon(middle + 0.78 * (corners - middle), fill=DECK)
        canvas.polygon(middle + 0.62 * (corners - middle), fill=INSIDE)
        c, s = self.model.boat.pose[[HCOS, HSIN]].tolist()
        across = np.array((-s, c))
        for part in (-0.22, 0.12):
            at = middle + part * np.array((c, s))
            canvas.line(tuple(at - 0.15 * across), tuple(at + 0.15 * across), DECK, 4.0)
