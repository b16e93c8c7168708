"""How the fireplace is drawn: the room in its light, wood that chars and glows, flames, smoke, sparks."""

from __future__ import annotations

import numpy as np
import pygame

from game.arrays import Floats, Longs
from game.physics.heat.nodes import FUEL, TEMPERATURE, WATER
from game.scenes.fireplace import tables
from game.scenes.fireplace.model import FireplaceModel, FireplaceState
from game.scenes.fireplace.room import Room
from game.scenes.fireplace.tables import BARS, UPRIGHTS
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.painting import boards
from game.worlds.painting.boards import paint_quads, placed
from game.worlds.painting.flames import FLAME, HEAT_STOPS, draw_firelight
from game.worlds.painting.inks import packed, shaded

BOX = ((-tables.HALF, 0.0), (tables.HALF, tables.TALL))
SMOKE = {True: pygame.Color(70, 66, 64), False: pygame.Color(96, 92, 90)}
IRON, IRON_LIT = pygame.Color(28, 26, 26), pygame.Color(74, 66, 60)
BARK, SAWN, CHAR, ASH = (112, 74, 46), (176, 128, 82), (26, 22, 21), (128, 122, 116)
COLD, HOT = 293.0, 1500.0  # K, of the view of temperatures
GLOW_FROM, GLOW_TO = 700.0, 1250.0  # K between which a piece begins to glow and is brightest
SPEED_STOPS = ((0.0, "stage"), (0.4, "body"), (0.7, "chalk"), (1.0, "text1"))
OXYGEN_STOPS = ((0.0, "vermilion"), (0.5, "amber"), (1.0, "chalk"))
CORE = (-1.0, -0.42, 1.0, 0.42)
LIT_EDGE = (-1.0, -1.0, 1.0, -0.2)


class FireplaceView:
    """Draws a model and its hand."""

    def __init__(self, model: FireplaceModel, hand: Hand):
        self.model, self.hand = model, hand
        self._room = Room()

    def legend(self) -> list[tuple[str, str, str]]:
        """What a view of the gas shows."""
        words = {
            "temperature": "293 K dark to 1500 K bright", "speed": "0 to 4 m/s",
            "oxygen": "none to fresh air",
        }  # fmt: skip
        view = self.model.parameters.view
        return [("square:amber", words[view], "")] if view in words else []

    def draw(self, canvas: Canvas, previous: FireplaceState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        dark = is_dark(canvas)
        model = self.model
        strength = min(1.0, (max(model.shine, 0.0) / 6.0e4) ** 0.5) + 0.25 * model.embers_shine()
        self._room.draw(canvas, dark, min(strength, 1.2))
        self._draw_grate(canvas, strength)
        places, turned = self._pieces_between(previous, alpha)
        self._draw_wood(canvas, places, turned, strength)
        self._draw_match(canvas)
        self._draw_gas(canvas, dark)
        self._draw_damper(canvas)
        self._draw_sparks(canvas)
        canvas.bloom(0.85 if dark else 0.5)
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

    def _draw_wood(self, canvas: Canvas, places: Floats, turned: Floats, strength: float) -> None:
        """Each piece in the colour of bark, char or ash, and what glows in it."""
        wood = self.model.wood
        if not wood.count:
            return
        table = wood.table
        left = np.clip(wood.nodes.nodes[FUEL, : wood.count] / table[:, tables.WHOLE], 0.0, 1.0)
        hot = np.clip(
            (wood.nodes.nodes[TEMPERATURE, : wood.count] - GLOW_FROM) / (GLOW_TO - GLOW_FROM), 0.0, 1.0
        )
        sizes = np.stack(
            [table[:, tables.HALF_LENGTH] * 1.04, table[:, tables.HALF_THICK] * table[:, tables.SCALE]],
            axis=1,
        )
        inks = self._bark(left, hot, strength)
        rim = sizes + canvas.px(1.1)
        paint_quads(canvas, placed(boards.WHOLE, rim, places, turned), shaded(inks, -0.5))
        paint_quads(canvas, placed(boards.WHOLE, sizes, places, turned), inks)
        for box, share in (((-1.0, -1.0, 1.0, -0.5), 0.35), ((-1.0, 0.55, 1.0, 1.0), 0.2)):
            paint_quads(canvas, placed(box, sizes, places, turned), shaded(inks, -0.6), share)
        paint_quads(canvas, placed(CORE, sizes, places, turned), shaded(inks, 0.16), 0.5)
        under = _embers(np.minimum(1.0, hot + 0.1))
        lit = np.asarray(np.clip(1.1 * hot, 0.0, 0.5))
        paint_quads(canvas, placed(LIT_EDGE, sizes, places, turned), under, lit)
        self._draw_embers(canvas, places, turned, sizes, hot)

    def _bark(self, left: Floats, hot: Floats, strength: float) -> Longs:
        """Colours (n,) of the pieces: bark, then char, at the end ash where it is cold, in the fire's
        light.
        """
        bark, char, ash = (np.array(color, dtype=np.float64) for color in (BARK, CHAR, ASH))
        wet = np.minimum(
            1.0, self.model.wood.nodes.nodes[WATER, : len(left)] / self.model.wood.table[:, tables.WHOLE]
        )
        charred = np.clip((1.0 - left) * 5.0 + 2.0 * hot, 0.0, 1.0)[:, None]
        grey = (np.clip(0.3 - left, 0.0, 0.3) / 0.3 * np.clip(1.0 - 2.0 * hot, 0.0, 1.0))[:, None]
        colors = bark * (1.0 - 0.35 * wet[:, None])
        colors = colors + (char - colors) * charred
        colors = colors + (ash - colors) * 0.75 * grey
        light = (0.55 + 0.6 * min(strength, 1.0)) * np.array((1.0, 0.92, 0.84))
        return packed(np.clip(colors * light, 0.0, 255.0))

    def _draw_embers(
        self, canvas: Canvas, places: Floats, turned: Floats, sizes: Floats, hot: Floats
    ) -> None:
        """Points that glow all over a hot piece, and their light."""
        glowing = np.flatnonzero(hot > 0.03)
        if not len(glowing):
            return
        per = 9
        seeds = (glowing[:, None] * 97 + np.arange(per)[None] * 31) % 211
        across = 2.0 * ((seeds * 0.61803) % 1.0) - 1.0
        along = 2.0 * ((seeds * 0.7548 + 0.3) % 1.0) - 1.0
        own = np.stack(
            [0.92 * across * sizes[glowing, 0, None], 0.8 * along * sizes[glowing, 1, None]], axis=2
        )
        c, s = turned[glowing, 0, None], turned[glowing, 1, None]
        at = np.stack([c * own[..., 0] - s * own[..., 1], s * own[..., 0] + c * own[..., 1]], axis=2)
        at += places[glowing][:, None]
        beat = 0.75 + 0.25 * np.sin(2.1 * self.model.time + 1.7 * seeds)
        inks = _embers(np.clip(hot[glowing][:, None] * beat, 0.0, 1.0).ravel()).astype(np.uint32)
        canvas.glow(at.reshape(-1, 2), inks, 2, 0.8)
        soft = _embers(hot[glowing]).astype(np.uint32)
        canvas.soft_glow(places[glowing], 3.2 * sizes[glowing, 0], soft, 0.55 * hot[glowing])

    def _draw_gas(self, canvas: Canvas, dark: bool) -> None:
        model, view = self.model, self.model.parameters.view
        if view == "fire":
            veil = model.air.veil()
            canvas.veil(veil, *BOX, SMOKE[dark], FLAME)
            draw_firelight(canvas, veil, tables.HALF, 16, 0.02, 2.6, 0.5)
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
        head = self.model.match.place(self.model.time)
        if head is None:
            return
        (x, y), (tx, ty) = head
        canvas.line((x, y), (tx, ty), pygame.Color(206, 170, 118), 0.011 * canvas.pixels_per_unit / canvas.k)
        canvas.circle((x, y), 0.009, pygame.Color(120, 30, 20) if not self.model.match.lit(self.model.time)
                      else pygame.Color(255, 220, 140))  # fmt: skip
        if self.model.match.lit(self.model.time):
            inks = np.array([0xFFB040], dtype=np.uint32)
            canvas.glow(np.array([[x, y]]), inks, 4, 1.0)
            canvas.soft_glow(np.array([[x, y + 0.02]]), np.array([0.16]), inks, 0.8)

    def _draw_sparks(self, canvas: Canvas) -> None:
        sparks = self.model.sparks.alive()
        if len(sparks):
            fade = np.clip(1.0 - sparks[:, 4] / sparks[:, 5], 0.0, 1.0)
            canvas.glow(sparks[:, :2], _embers(0.35 + 0.65 * fade).astype(np.uint32), 1, 0.9 * fade)

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


def _embers(hot: Floats) -> Longs:
    """Colours (n,) of what glows, 0 dull red to 1 yellow."""
    hot = np.clip(hot, 0.0, 1.0)
    red, green = 255.0 * np.minimum(1.0, 0.18 + 1.5 * hot), 255.0 * np.clip(0.85 * hot**1.5, 0.0, 1.0)
    return packed(np.stack([red, green, 255.0 * 0.35 * hot**3], axis=-1))


def _mixed(a: pygame.Color, b: pygame.Color, share: float) -> pygame.Color:
    return a.lerp(b, min(max(share, 0.0), 1.0))
