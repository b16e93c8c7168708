"""How the burning cloth is drawn: the yard in its light, the cloth, embers, flames, smoke, ashes, match."""

from __future__ import annotations

import numpy as np
import pygame

from game.arrays import Floats, Singles
from game.physics.cloth import layout
from game.scenes.burning_cloth import ashes as ash
from game.scenes.burning_cloth.air import LOOK
from game.scenes.burning_cloth.ashes import X as ASH_X
from game.scenes.burning_cloth.ashes import Y as ASH_Y
from game.scenes.burning_cloth.model import BurningClothModel, BurningClothState
from game.scenes.burning_cloth.picture.cloth import COLD, HOTTEST, ClothPicture
from game.scenes.burning_cloth.picture.sheet_painter import GLOW_FROM, GLOW_TO
from game.scenes.burning_cloth.picture.yard import SOURCES, Yard, light_on_yard
from game.scenes.burning_cloth.tables import HALF, TALL
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.painting.boards import paint_quads
from game.worlds.painting.flames import HEAT_STOPS, draw_firelight, glow_stops

BOX = ((-HALF, 0.0), (HALF, TALL))
SMOKE = {True: pygame.Color(64, 62, 64), False: pygame.Color(104, 100, 98)}
SPARSE = 3  # of patches in each direction that throw a soft light


class BurningClothView:
    """Draws a model and its hand."""

    def __init__(self, model: BurningClothModel, hand: Hand):
        self.model, self.hand = model, hand
        self._yard = Yard()
        self._cloth = ClothPicture(model)

    def legend(self) -> list[tuple[str, str, str]]:
        """What a view other than that of the eye shows."""
        words = {
            "heat": "cloth: 293 K dark to 1200 K bright", "saltpetre": "saltpetre: none to full",
            "gas": "gas: 293 K dark to 1200 K bright",
        }  # fmt: skip
        view = self.model.parameters.view
        return [("square:amber", words[view], "")] if view in words else []

    def draw(self, canvas: Canvas, previous: BurningClothState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        dark, model = is_dark(canvas), self.model
        veil = model.air.veil()
        glow = self._glow()
        light = self._shining(veil, glow)
        spread = light_on_yard(light)
        self._yard.draw(canvas, dark, spread)
        nodes = self._cloth.between(previous, alpha)
        self._cloth.draw(canvas, nodes, dark, light)
        if canvas.marks(model.parameters.marks):
            self._cloth.draw_threads(canvas, nodes)
        self._draw_match(canvas)
        if model.parameters.view == "gas":
            canvas.field((model.air.temperature - COLD) / (HOTTEST - COLD), *BOX, HEAT_STOPS, 0.85)
        elif model.parameters.view == "fire":
            self._draw_veil(canvas, veil, SMOKE[dark])
            self._draw_light(canvas, nodes, veil, glow)
        self._draw_ashes(canvas, dark)
        canvas.bloom(0.8 if dark else 0.45)
        self._draw_hand(canvas)

    # -- what shines ------------------------------------------------------------------------------------

    def _glow(self) -> Floats:
        """(rows, columns) 0 to 1: how bright each patch glows."""
        patches = self.model.cloth.patches
        return np.asarray(np.clip((patches[layout.HOT] - GLOW_FROM) / (GLOW_TO - GLOW_FROM), 0.0, 1.0))

    def _shining(self, veil: Singles, glow: Floats) -> Singles:
        """(SOURCES) how much light comes from blocks of the gas and the cloth in them, and the match."""
        rows, columns = SOURCES
        ny, nx = veil.shape[:2]
        across, up = np.arange(nx) * columns // nx, np.arange(ny) * rows // ny
        block = (up[:, None] * columns + across[None, :]).ravel()
        found = np.bincount(block, veil[..., 1].ravel(), rows * columns).reshape(SOURCES)
        found *= 0.5 * rows * columns / (nx * ny)
        b, a = np.nonzero(glow > 0.05)
        nodes = self.model.cloth.nodes
        x, y = (
            nodes[layout.X, b // layout.PER, a // layout.PER],
            nodes[layout.Y, b // layout.PER, a // layout.PER],
        )
        i = np.clip(((x + HALF) / (2.0 * HALF) * columns).astype(int), 0, columns - 1)
        j = np.clip((y / TALL * rows).astype(int), 0, rows - 1)
        area = self.model.cloth.size * self.model.cloth.size
        np.add.at(found, (j, i), glow[b, a] * (9.0 * area))
        match = self.model.match
        if match.lit(self.model.time):
            (x0, y0), _ = match.place(self.model.time)
            i0 = min(max(int((x0 + HALF) / (2.0 * HALF) * columns), 0), columns - 1)
            found[min(max(int(y0 / TALL * rows), 0), rows - 1), i0] += 0.16 * match.strength(self.model.time)
        return found.astype(np.float32)

    def _draw_veil(self, canvas: Canvas, veil: Singles, smoke: pygame.Color) -> None:
        """Flames and smoke, as far as there are any."""
        seen = np.max(veil, axis=2) > 0.002
        rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
        if not len(rows):
            return
        low, high = max(int(rows[0]) - 1, 0), min(int(rows[-1]) + 2, seen.shape[0])
        left, right = max(int(columns[0]) - 1, 0), min(int(columns[-1]) + 2, seen.shape[1])
        cell = self.model.air.cell
        canvas.veil(
            veil[low:high, left:right], (-HALF + cell * left, cell * low),
            (-HALF + cell * right, cell * high),
            smoke, glow_stops(LOOK.dark, LOOK.bright),
        )  # fmt: skip

    def _draw_light(self, canvas: Canvas, nodes: Floats, veil: Singles, glow: Floats) -> None:
        """The light about flames and embers."""
        draw_firelight(canvas, veil, HALF, 24, 0.03, 1.8, 0.45)
        b, a = np.nonzero(glow[::SPARSE, ::SPARSE] > 0.08)
        if len(b):
            b, a = b * SPARSE, a * SPARSE
            at = self._cloth.seen(nodes, b // layout.PER, a // layout.PER)
            inks = np.full(len(b), 0xFF6418, dtype=np.uint32)
            canvas.soft_glow(at, np.full(len(b), 0.045), inks, 0.5 * glow[b, a])
            lively = glow[b, a] * (0.7 + 0.3 * np.sin(9.0 * self.model.time + 2.4 * a + 1.7 * b))
            canvas.glow(at[lively > 0.5], np.uint32(0x8A3A08), 1, None)

    # -- match, ashes, hand -----------------------------------------------------------------------------

    def _draw_match(self, canvas: Canvas) -> None:
        model = self.model
        (x, y), (tx, ty) = model.match.place(model.time)
        wood = pygame.Color(206, 170, 118)
        canvas.line((x, y), (tx, ty), wood, 0.0075 * canvas.pixels_per_unit / canvas.k)
        strong = model.match.strength(model.time)
        burnt = model.match.used(model.time) or strong > 0.0
        canvas.circle((x, y), 0.0075, pygame.Color(36, 28, 26) if burnt else pygame.Color(168, 44, 30))
        if strong <= 0.0:
            return
        sway = 0.006 * float(np.sin(13.0 * model.time)) + 0.006 * float(model.air.flows[2])
        for high, wide, color, share in ((0.062, 0.013, (255, 120, 20), 0.6),
                                         (0.045, 0.0095, (255, 190, 70), 0.8),
                                         (0.026, 0.006, (255, 244, 200), 0.95)):  # fmt: skip
            high *= 0.8 + 0.3 * strong
            side = np.linspace(0.0, 1.0, 9)
            half = wide * np.sin(np.pi * np.sqrt(side)) ** 0.8
            lean = sway * side * side * (high / 0.062)
            rise = y - 0.008 + high * side
            outline = np.concatenate([
                np.stack([x + lean - half, rise], axis=1), np.stack([x + lean + half, rise], axis=1)[::-1],
            ])  # fmt: skip
            canvas.polygon(outline, fill=pygame.Color(*color), fill_alpha=share)
        inks = np.array([0xFFA040], dtype=np.uint32)
        canvas.soft_glow(np.array([[x, y + 0.02]]), np.array([0.13 * strong]), inks, 0.7)

    def _draw_ashes(self, canvas: Canvas, dark: bool) -> None:
        ashes = self.model.ashes.alive()
        if not len(ashes):
            return
        at = ashes[:, ASH_X : ASH_Y + 1]
        turn, size = ashes[:, ash.TURN], ashes[:, ash.SIZE]
        c, s = np.cos(turn) * size, np.sin(turn) * size
        flat = 0.35 + 0.65 * np.abs(np.sin(1.7 * turn))
        corners = np.stack([
            np.stack([-c + s * flat, -s - c * flat], 1), np.stack([c + s * flat, s - c * flat], 1),
            np.stack([c - s * flat, s + c * flat], 1), np.stack([-c - s * flat, -s + c * flat], 1),
        ], axis=1) * 0.5 + at[:, None]  # fmt: skip
        inks = np.full(len(ashes), 0x1A1716 if dark else 0x2C2826, dtype=np.int64)
        fade = np.clip((ashes[:, ash.LIFE] - ashes[:, ash.AGE]) / 3.0, 0.0, 1.0)
        paint_quads(canvas, corners.reshape(-1, 2), inks, 0.85 * fade)
        hot = np.clip(1.0 - ashes[:, ash.AGE] / ash.GLOWS_S, 0.0, 1.0)
        lit = hot > 0.05
        if lit.any():
            red, green = (255.0 * hot[lit]).astype(np.uint32), (110.0 * hot[lit] ** 2).astype(np.uint32)
            canvas.glow(at[lit], red << 16 | green << 8, 1, 0.6 * hot[lit])

    def _draw_hand(self, canvas: Canvas) -> None:
        point, tool = self.hand.point, self.model.parameters.tool
        if point is None:
            return
        if tool == "blow":
            canvas.arrow(point, np.array(self.hand.moved) * 0.25, "chalk")
        elif tool != "match":
            canvas.handle(point)
