"""How leaves in a wind are drawn: park, basket, shadows, leaves, dust in the wind, and what teaches."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import pygame
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.plates import law, watch
from game.physics.plates.regimes import BORDERS
from game.scenes.leaves.basket import Basket
from game.scenes.leaves.foliage import Foliage, nearer, shifts_of
from game.scenes.leaves.landscape import DAY, Hour, Park
from game.scenes.leaves.model import DEPTH, LeavesModel, LeavesState
from game.scenes.leaves.told import names_of
from game.ui.canvas.canvas import Canvas
from game.worlds.hands.hand import Hand

MOTES, MOTE_STEPS, MOTE_S = 70, 10, 0.045  # of dust: how many, points and s of their way
COLORS = {watch.NOTHING: "text2", watch.FLUTTER: "chalk", watch.TUMBLE: "amber", watch.GLIDE: "green"}
MAP = (0.12, 1.05, 1.55, 0.62)  # m from the view's upper left corner: right, down; width, height of the map
LEAST, MOST = 0.3, 4.0  # inertias on it
RIM = 0.13  # m, half the depth of the basket's rim as it is seen


@lru_cache(maxsize=32)
def ring_of(basket: Basket, height: float, front: bool) -> Floats:
    """Half an ellipse (25, 2) about a basket at a height, m, before or behind its middle; read only."""
    turn = np.linspace(0.0, math.pi, 25)
    sign = -1.0 if front else 1.0
    places = np.stack(
        [basket.x + basket.half_at(height) * np.cos(turn), height + sign * RIM * np.sin(turn)], axis=1
    )
    places.flags.writeable = False
    return places


class LeavesView:
    """Draws a model and its hand."""

    def __init__(self, model: LeavesModel, hand: Hand):
        self.model, self.hand = model, hand
        self.park, self.foliage = Park(), Foliage()
        self._motes = np.random.default_rng(3).random((MOTES, 4))

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the marks mean."""
        return (
            ("arrow:green", "wind", ""),
            ("disc:chalk", "flutters", ""),
            ("disc:amber", "tumbles", ""),
            ("disc:green", "glides", ""),
        )

    def draw(self, canvas: Canvas, previous: LeavesState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state before to now."""
        model = self.model
        rows = model.plates.rows
        if previous is not None and previous.plates.rows.shape == rows.shape:
            rows = previous.plates.rows + alpha * (rows - previous.plates.rows)
        hour = self.park.hour(canvas)
        own, halves = model.own, model.plates.laws[law.HALF]
        self.park.behind(canvas)
        blades = model.wind.sample(self.park.blade_places, model.plates.time)
        self.park.grass(canvas, blades, front=False)
        self.foliage.shadows(canvas, rows, own, halves)
        own = nearer(model.basket, rows, own)
        within = model.basket.holds(rows[law.X], rows[law.Y])
        back = ~within & (own[:, DEPTH] > 0.1)
        seen = self.foliage.seen(rows, own, halves, hour.leaves)
        self.foliage.leaves(canvas, seen, back)
        self._basket_back(canvas, hour)
        self.foliage.leaves(canvas, seen, within, model.basket)
        self._basket_front(canvas, hour)
        self.foliage.leaves(canvas, seen, ~within & ~back)
        if model.parameters.streaks:
            self._dust(canvas, hour)
        self.park.grass(canvas, blades, front=True)
        if self.hand.start is not None:
            (x, y), (to_x, to_y) = self.hand.start, self.hand.at
            canvas.contact((x, y))
            canvas.arrow((x, y), (to_x - x, to_y - y), "chalk", "w")
        if canvas.teaching:
            self._teach(canvas, rows)

    # -- the basket -----------------------------------------------------------------------------------

    def _ring(self, height: float, front: bool) -> Floats:
        return ring_of(self.model.basket, height, front)

    def _basket_back(self, canvas: Canvas, hour: Hour) -> None:
        basket = self.model.basket
        foot = float(basket.half_at(0.0))
        shadow = np.array([(basket.x - 1.0 * foot, -0.05), (basket.x + 0.9 * foot, -0.07),
                           (basket.x + 0.2 * foot, 0.05), (basket.x - 2.1 * foot, 0.02)])  # fmt: skip
        canvas.polygon(shadow, fill=pygame.Color(20, 16, 8), fill_alpha=0.28)
        inside = np.concatenate([self._ring(basket.height, False), self._ring(0.02, True)[::-1]])
        canvas.polygon(inside, fill=hour.metal.lerp(pygame.Color(0, 0, 0), 0.55), fill_alpha=0.55)
        canvas.polyline(self._ring(basket.height, False), hour.metal, 4.0)
        self._slats(canvas, hour.metal.lerp(pygame.Color(0, 0, 0), 0.25), False)

    def _basket_front(self, canvas: Canvas, hour: Hour) -> None:
        basket = self.model.basket
        lit = hour.metal.lerp(pygame.Color(255, 230, 180), 0.22 if hour is DAY else 0.12)
        self._slats(canvas, hour.metal, True)
        for height in (0.03, 0.5 * basket.height):
            canvas.polyline(self._ring(height, True), hour.metal, 4.0)
        canvas.polyline(self._ring(basket.height, True), hour.metal, 6.0)
        canvas.polyline(self._ring(basket.height + 0.006, True), lit, 2.0)

    def _slats(self, canvas: Canvas, ink: pygame.Color, front: bool) -> None:
        basket = self.model.basket
        top, foot = self._ring(basket.height, front), self._ring(0.0, front)
        canvas.segments(top[1:-1:2], foot[1:-1:2], ink, 3.0 if front else 2.0)
        if front:
            lit = ink.lerp(pygame.Color(255, 235, 190), 0.2)
            off = np.array((-0.006, 0.0))
            canvas.segments(top[1:-1:2] + off, foot[1:-1:2] + off, lit, 0.9, 0.7)

    # -- the wind -------------------------------------------------------------------------------------

    def _dust(self, canvas: Canvas, hour: Hour) -> None:
        """Short pieces of the ways that dust takes in the wind of now; none where it is calm."""
        seen = canvas.camera.visible()
        time = self.model.plates.time
        phase = np.mod(self._motes[:, 2] + 0.7 * time, 1.0)
        turn = np.floor(self._motes[:, 2] + 0.7 * time)
        places = np.stack(
            [
                seen.left + np.mod(self._motes[:, 0] + 0.618 * turn, 1.0) * (seen.right - seen.left),
                0.08 + np.mod(self._motes[:, 1] + 0.414 * turn, 1.0) * (seen.top - 0.08),
            ],
            axis=1,
        )
        ways = np.empty((MOTE_STEPS, MOTES, 2))
        for k in range(MOTE_STEPS):
            ways[k] = places
            places = places + MOTE_S * self.model.wind.sample(places, time)
            places[:, 1] = np.maximum(places[:, 1], 0.02)
        length = np.hypot(*(ways[-1] - ways[0]).T)
        strength = np.clip(length / 0.8, 0.0, 1.0) * np.sin(math.pi * phase)
        at = np.minimum((phase * (MOTE_STEPS - 3)).astype(int), MOTE_STEPS - 4)
        number = np.arange(MOTES)
        ink = pygame.Color(255, 250, 230) if hour is DAY else pygame.Color(200, 204, 232)
        for group in range(4):
            part = (strength > 0.08 + 0.2 * group) & ((strength <= 0.28 + 0.2 * group) | (group == 3))
            for k in range(3):
                a, b = ways[at + k, number][part], ways[at + k + 1, number][part]
                if len(a):
                    canvas.segments(a, b, ink, 1.2 + 0.3 * k, 0.12 + 0.11 * group)

    # -- what teaches ---------------------------------------------------------------------------------

    def _teach(self, canvas: Canvas, rows: Floats) -> None:
        """Velocities of what flies by what it does, a name at one of each, the wind, and the map."""
        model = self.model
        seen = model.seen()
        for i in np.flatnonzero(model.flying()).tolist():
            canvas.arrow(
                rows[[law.X, law.Y], i], 0.12 * model.plates.velocities[i], COLORS[int(seen[i])], width=1.6
            )
        if not canvas.asked:  # else they have their rings
            self._names(canvas, rows, seen)
        x, y = np.meshgrid(np.linspace(-2.6, 2.6, 14), np.linspace(0.2, 2.4, 7))
        places = np.stack([x.ravel(), y.ravel()], axis=1)
        wind = model.wind.sample(places, model.plates.time)
        fast = np.hypot(*wind.T) > 0.25
        canvas.segments(places[fast], places[fast] + 0.09 * wind[fast], "green", 1.4, 0.55)
        canvas.discs(places[fast], canvas.px(1.8), "green", 0.55)
        self._map(canvas, seen)

    def _names(self, canvas: Canvas, rows: Floats, seen: NDArray[np.int64]) -> None:
        """Beside one leaf of each way what it is, what it does, and its inertia."""
        places = rows[[law.X, law.Y]].T + shifts_of(nearer(self.model.basket, rows, self.model.own))
        for i, words in names_of(self.model):
            place, color = places[i], COLORS[int(seen[i])]
            canvas.dot(place, 3.0, color)
            canvas.label(place, words, color, 13, "semibold", "left", (10.0, -10.0), clear=True)

    def _map(self, canvas: Canvas, seen: NDArray[np.int64]) -> None:
        off, down, wide, tall = MAP
        view = self.model.content.view
        left, bottom = view.left + off, view.top - down
        right, top = left + wide, bottom + tall
        plate = [(left, bottom), (right, bottom), (right, top), (left, top)]
        canvas.polygon(plate, fill="stage", fill_alpha=0.78)

        def at(inertia: float) -> float:
            return left + wide * math.log(min(max(inertia, LEAST), MOST) / LEAST) / math.log(MOST / LEAST)

        bands = ((LEAST, BORDERS[0], "chalk", "flutter"), (BORDERS[0], BORDERS[1], "amber", "tumble"),
                 (BORDERS[1], BORDERS[2], "vermilion", "irregular"),
                 (BORDERS[2], MOST, "chalk", ""))  # fmt: skip
        for low, high, color, words in bands:
            corners = [
                (at(low), bottom),
                (at(high), bottom),
                (at(high), bottom + tall),
                (at(low), bottom + tall),
            ]
            canvas.polygon(corners, fill=color, fill_alpha=0.2)
            if words:
                canvas.label((0.5 * (at(low) + at(high)), bottom + tall - 0.06), words, "text2", 11)
        for inertia in (0.5, 1.0, 2.0):
            canvas.label((at(inertia), bottom - 0.05), f"{inertia:g}", "text2", 11)
        canvas.label((left + 0.5 * wide, bottom - 0.14), "inertia I* of each leaf", "text2", 12)
        spins = np.clip(np.abs(self.model.plates.spins) / 25.0, 0.0, 1.0)
        for i, way in enumerate(seen.tolist()):
            inertia = float(self.model.plates.laws[law.MASS_Y, i]) - 1.0
            canvas.dot((at(inertia), bottom + 0.04 + 0.8 * tall * float(spins[i])), 3.6, COLORS[way])
