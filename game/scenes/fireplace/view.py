"""How the fireplace is drawn: the room in its light, wood that chars and glows, flames, smoke, sparks."""

from __future__ import annotations

import numpy as np
import pygame

from game.arrays import Floats
from game.scenes.fireplace import tables
from game.scenes.fireplace.air import LOOK
from game.scenes.fireplace.model import FireplaceModel, FireplaceState
from game.scenes.fireplace.room import Room
from game.scenes.fireplace.tables import BARS, UPRIGHTS
from game.scenes.fireplace.wood_picture import DARK, WoodPicture, adapted
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.painting.flames import HEAT_STOPS, draw_firelight, glow_inks, glow_stops
from game.worlds.painting.sheets import Sheets

BOX = ((-tables.HALF, 0.0), (tables.HALF, tables.TALL))
SMOKE = {True: pygame.Color(70, 66, 64), False: pygame.Color(96, 92, 90)}
SMOKE_LIT = pygame.Color(150, 104, 74)
IRON, IRON_LIT = pygame.Color(28, 26, 26), pygame.Color(74, 66, 60)
COLD, HOT = 293.0, 1500.0  # K, of the view of temperatures
SPEED_STOPS = ((0.0, "stage"), (0.4, "body"), (0.7, "chalk"), (1.0, "text1"))
OXYGEN_STOPS = ((0.0, "vermilion"), (0.4, "amber"), (0.9, "violet"), (1.0, "stage"))


class FireplaceView:
    """Draws a model and its hand."""

    def __init__(self, model: FireplaceModel, hand: Hand):
        self.model, self.hand = model, hand
        self._room, self._wood = Room(), WoodPicture()
        self._sheets = Sheets(LOOK, model.air.gas.grid.shape, model.air.cell)

    def legend(self) -> list[tuple[str, str, str]]:
        """What a view of the gas shows."""
        words = {
            "temperature": "293 K dark to 1500 K bright", "speed": "0 to 4 m/s",
            "oxygen": "none orange, dark as in fresh air",
        }  # fmt: skip
        view = self.model.parameters.view
        return [("square:amber", words[view], "")] if view in words else []

    def draw(self, canvas: Canvas, previous: FireplaceState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        dark = is_dark(canvas)
        model = self.model
        strength = min(1.0, (max(model.shine, 0.0) / 9.0e4) ** 0.5) + 0.14 * model.embers_shine()
        self._room.draw(canvas, dark, min(strength, 1.2))
        self._draw_grate(canvas, strength)
        places, turned = self._pieces_between(previous, alpha)
        bright = adapted(model.shine)
        self._wood.draw(canvas, model.wood, (places, turned), strength, dark, bright)
        self._draw_match(canvas)
        self._draw_gas(canvas, dark, strength)
        self._draw_damper(canvas)
        self._draw_sparks(canvas, bright)
        canvas.bloom(0.7 if dark else 0.4)
        if canvas.marks(model.parameters.marks):
            self._draw_marks(canvas, places)
        self._draw_hand(canvas)

    # -- where things are -----------------------------------------------------------------------------

    def _pieces_between(self, previous: FireplaceState | None, alpha: float) -> tuple[Floats, Floats]:
        """Places (n, 2) m of the pieces, cosines and sines (n, 2) of their angles."""
        table, rows = self.model.wood.table, self.model.wood.world.bodies
        bodies = table[:, tables.BODY].astype(np.int64)
        places, angles = rows.positions[bodies], rows.angles[bodies]
        if previous is not None and np.array_equal(
            previous.wood.table[:, tables.BODY], table[:, tables.BODY]
        ):
            before = previous.wood.world.bodies
            places = places - (1.0 - alpha) * (places - before.positions[bodies])
            angles = angles - (1.0 - alpha) * (angles - before.angles[bodies])
        return places, np.stack([np.cos(angles), np.sin(angles)], axis=1)

    # -- what stands there ----------------------------------------------------------------------------

    def _draw_grate(self, canvas: Canvas, strength: float) -> None:
        """Andirons: two uprights with feet, and the bars between them, seen from their ends."""
        lit = _mixed(IRON, IRON_LIT, min(strength, 1.0))
        for x in UPRIGHTS:
            canvas.line((x, 0.0), (x, 0.27), IRON, 2.2 * tables.BAR * canvas.pixels_per_unit / canvas.k)
            canvas.circle((x, 0.285), 1.9 * tables.BAR, IRON, outline=lit, width=1.0)
            canvas.line((x, 0.0), (x, 0.26), lit, 1.0)
        low = tables.GRATE - 1.6 * tables.BAR
        canvas.line(
            (UPRIGHTS[0], low), (UPRIGHTS[1], low), IRON, 1.4 * tables.BAR * canvas.pixels_per_unit / canvas.k
        )
        for x in BARS:
            canvas.circle((x, tables.GRATE), tables.BAR, IRON, outline=lit, width=1.0)

    def _draw_gas(self, canvas: Canvas, dark: bool, strength: float) -> None:
        model, view = self.model, self.model.parameters.view
        if view == "fire":
            air = model.air
            veil = self._sheets.veil(air.temperature, air.gas.field("soot"), air.edge, model.time)
            smoke = SMOKE[dark].lerp(SMOKE_LIT, 0.7 * min(strength, 1.0))
            canvas.veil(veil, *BOX, smoke, glow_stops(LOOK.dark, LOOK.bright))
            draw_firelight(canvas, veil, tables.HALF, 16, 0.02, 3.0, 0.22)
        elif view == "temperature":
            canvas.field((model.air.temperature - COLD) / (HOT - COLD), *BOX, HEAT_STOPS, 0.9)
        elif view == "speed":
            canvas.field(model.air.speeds() / 4.0, *BOX, SPEED_STOPS, 0.9)
        else:
            canvas.field(model.air.fresh(), *BOX, OXYGEN_STOPS, 0.9)

    def _draw_damper(self, canvas: Canvas) -> None:
        """Two plates that close the flue from both sides."""
        for plate in self.model.air.plates():
            canvas.polygon(plate, fill=IRON, outline=IRON_LIT, width=1.0)

    def _draw_match(self, canvas: Canvas) -> None:
        if self.model.match.hidden(self.model.time):
            return
        (x, y), (tx, ty) = self.model.match.place(self.model.time)
        canvas.line((x, y), (tx, ty), pygame.Color(206, 170, 118), 0.011 * canvas.pixels_per_unit / canvas.k)
        canvas.circle((x, y), 0.009, pygame.Color(120, 30, 20) if not self.model.match.lit(self.model.time)
                      else pygame.Color(255, 220, 140))  # fmt: skip
        if self.model.match.lit(self.model.time):
            inks = np.array([0xFFB040], dtype=np.uint32)
            canvas.glow(np.array([[x, y]]), inks, 4, 1.0)
            canvas.soft_glow(np.array([[x, y + 0.02]]), np.array([0.16]), inks, 0.8)

    def _draw_sparks(self, canvas: Canvas, bright: float) -> None:
        sparks = self.model.sparks.alive()
        if len(sparks):
            fade = np.clip(1.0 - sparks[:, 4] / sparks[:, 5], 0.0, 1.0)
            inks = glow_inks(0.35 + 0.65 * fade, DARK, bright).astype(np.uint32)
            canvas.glow(sparks[:, :2], inks, 1, 0.9 * fade)

    def _draw_marks(self, canvas: Canvas, places: Floats) -> None:
        """The temperature of each piece, where there is space for it."""
        for number in range(0, self.model.wood.count, 2):
            kelvin = float(self.model.wood.nodes.temperature[number])
            canvas.label(places[number], canvas.figure(number, f"{kelvin:.0f} K"), "text1", 11)

    def _draw_hand(self, canvas: Canvas) -> None:
        point = self.hand.point
        if point is None:
            return
        tool = self.model.parameters.tool
        if tool == "blow":
            canvas.arrow(point, np.array(self.hand.moved) * 0.25, "chalk")
        elif tool != "match":
            canvas.handle(point)


def _mixed(a: pygame.Color, b: pygame.Color, share: float) -> pygame.Color:
    return a.lerp(b, min(max(share, 0.0), 1.0))
