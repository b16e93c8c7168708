"""How smoke is drawn: smoke and flames, or a field of numbers; solids; arrows."""

from __future__ import annotations

import numpy as np
import pygame

from game.arrays import Floats
from game.scenes.smoke import model as m
from game.scenes.smoke.books import draw_books
from game.scenes.smoke.hand import SmokeHand
from game.scenes.smoke.model import SmokeModel
from game.scenes.smoke.parameters import DYES
from game.ui.canvas.canvas import Canvas
from game.ui.painters.wall import is_dark
from game.worlds.painting.flames import FlameLook, see_gas

BOX = ((0.0, 0.0), (m.WIDE, m.TALL))
FLAME = (
    (0.0, pygame.Color(0, 0, 0)), (0.16, pygame.Color(70, 8, 0)), (0.36, pygame.Color(196, 52, 4)),
    (0.6, pygame.Color(250, 130, 20)), (0.82, pygame.Color(255, 206, 92)), (1.0, pygame.Color(255, 246, 206)),
)  # fmt: skip
SMOKE_INK = {True: pygame.Color(206, 214, 222), False: pygame.Color(58, 66, 76)}
HEAT = ((0.0, "stage"), (0.3, "violet"), (0.6, "vermilion"), (0.85, "amber"), (1.0, "yellow"))
SPEED = ((0.0, "stage"), (0.4, "body"), (0.75, "chalk"), (1.0, "text1"))
SIGNED = ((0.0, "vermilion"), (0.5, "stage"), (1.0, "chalk"))
LINES = ((0.0, "stage"), (1.0, "text1"))
LOOK = FlameLook(
    glows=520.0, brightest=1300.0, bare=0.0, shining=2e-6, thick=8e-3, most=0.8, burns=520.0,
)  # fmt: skip
FULL = {
    "speed": 1.5,
    "vorticity": 25.0,
    "divergence": 0.5,
    "pressure": 0.5,
}  # m/s, 1/s, 1/s, m²/s²: last colour
DYE_INKS = {  # where a theme is dark, and light: half of blue and half of yellow is a green
    "blue": {True: pygame.Color(64, 170, 250), False: pygame.Color(16, 132, 224)},
    "pink": {True: pygame.Color(246, 122, 182), False: pygame.Color(222, 72, 142)},
    "yellow": {True: pygame.Color(250, 226, 80), False: pygame.Color(236, 190, 0)},
}  # fmt: skip
COVERS, MOST = 0.9, 0.94  # of what is behind: full smoke, and at most
EVERY = 0.09  # m from arrow to arrow
WORDS = {
    "temperature": "293 K dark to 1000 K bright", "speed": "0 to 1.5 m/s",
    "vorticity": "−25 to 25 per second",
    "divergence": "−0.5 to 0.5 per second", "pressure": "−0.6 to 0.6 Pa about the mean",
    "schlieren": "where the density changes",
}  # fmt: skip


class SmokeView:
    """Draws a model and its hand."""

    def __init__(self, model: SmokeModel, hand: SmokeHand):
        self.model, self.hand = model, hand
        self._veil = np.zeros((*model.grid.shape, 2), np.float32)
        self._whole = np.ones(model.grid.shape)

    def legend(self) -> list[tuple[str, str, str]]:
        """What the picture shows."""
        view = self.model.parameters.view
        return [("square:chalk", WORDS[view], "")] if view in WORDS else []

    def draw(self, canvas: Canvas) -> None:
        """All of it."""
        dark = is_dark(canvas)
        view, cells = self.model.parameters.view, self.model.scalars
        if view == "smoke":
            self._draw_smoke(canvas, dark, cells)
        elif view == "temperature":
            canvas.field((cells[..., m.WARM] - m.ROOM) / (1000.0 - m.ROOM), *BOX, HEAT)
        elif view == "speed":
            flow = self.model.velocity()
            canvas.field(np.sqrt(flow[..., 0] ** 2 + flow[..., 1] ** 2) / FULL["speed"], *BOX, SPEED)
        elif view == "schlieren":
            canvas.field(self._schlieren(cells), *BOX, LINES)
        else:
            values = getattr(self.model, view)()
            canvas.field(0.5 + 0.5 * values / FULL[view], *BOX, SIGNED)
        for x, y, radius, _, _ in self.model.obstacles.rows.tolist():
            canvas.circle((x, y), radius, "body", outline="text3", width=1.6)
            canvas.circle((x - 0.3 * radius, y + 0.3 * radius), 0.35 * radius, "text1", 0.08)
        if self.model.parameters.arrows:
            self._draw_arrows(canvas)
        if self.model.parameters.books and canvas.teaching:
            draw_books(canvas, self.model)
        corners = ((0.0, 0.0), (m.WIDE, 0.0), (m.WIDE, m.TALL), (0.0, m.TALL))
        canvas.polygon(np.array(corners), outline="line2", width=1.4)
        if self.hand.point is not None:
            canvas.circle(self.hand.point, self.model.parameters.brush, outline="accent", width=1.4)

    def _draw_smoke(self, canvas: Canvas, dark: bool, cells: Floats) -> None:
        see_gas(LOOK, cells[..., m.WARM], cells[..., m.SOOT], self._whole, self._veil)
        dyed = np.clip(COVERS * cells[..., m.SMOKE], 0.0, 0.92)
        self._veil[..., 0] = np.minimum(self._veil[..., 0] + dyed, MOST)
        self._draw_dyes(canvas, dark, cells)
        canvas.veil(self._veil, *BOX, SMOKE_INK[dark], FLAME, dark)
        self._draw_light(canvas)

    def _draw_dyes(self, canvas: Canvas, dark: bool, cells: Floats) -> None:
        """Veils under that of smoke, so that each colour has its own share of what is seen, in any order.

        A veil leaves 1 - a of those below it; so that a share w is seen, its own a is w over what those above
        leave. Where shares come to more than MOST together, all are lessened alike.
        """
        if cells.shape[-1] == len(m.FIELDS):
            return
        shares = COVERS * np.clip(cells[..., len(m.FIELDS) :], 0.0, 1.0)
        sums = self._veil[..., 0] + np.sum(shares, axis=2)
        lessened = np.minimum(1.0, MOST / np.maximum(sums, MOST))
        self._veil[..., 0] *= lessened
        left, layers = 1.0 - self._veil[..., 0], []
        for k, name in enumerate(DYES):
            share = lessened * shares[..., k]
            layers.append((name, share / left))
            left = left - share
        nothing = np.zeros(left.shape)
        for name, share in reversed(layers):
            canvas.veil(np.stack([share, nothing], axis=2), *BOX, DYE_INKS[name][dark], FLAME, dark)

    def _draw_light(self, canvas: Canvas) -> None:
        light = self._veil[..., 1]
        block = max(light.shape[1] // 32, 1)
        rows, columns = light.shape[0] // block, light.shape[1] // block
        means = (
            light[: rows * block, : columns * block].reshape(rows, block, columns, block).mean(axis=(1, 3))
        )
        j, i = np.nonzero(means > 0.03)
        if len(j):
            step = m.WIDE / light.shape[1] * block
            at = np.stack([(i + 0.5) * step, (j + 0.5) * step], axis=1)
            inks = np.full(len(j), 0xFF8A30, dtype=np.uint32)
            canvas.soft_glow(at, np.full(len(j), 2.4 * step), inks, 0.4 * means[j, i])
        canvas.bloom(0.8)

    def _schlieren(self, cells: Floats) -> Floats:
        """How steep the density of hot gas is, and that of smoke a little: as a knife edge shows it."""
        density = m.ROOM / np.maximum(cells[..., m.WARM], 1.0) + 0.04 * cells[..., m.SMOKE]
        up, across = np.gradient(density, self.model.cell)
        return np.asarray(np.clip(0.2 + 0.06 * (across + up), 0.0, 1.0))

    def _draw_arrows(self, canvas: Canvas) -> None:
        flow, step = self.model.velocity(), max(round(EVERY / self.model.cell), 1)
        half = step // 2
        part = flow[half::step, half::step]
        x, y = self.model.grid.centres()
        tails = np.stack([x[half::step, half::step], y[half::step, half::step]], axis=2).reshape(-1, 2)
        tips = tails + 0.06 * part.reshape(-1, 2)
        canvas.segments(tails, tips, "amber", 1.3)
        canvas.particles(tips, "amber", 1.8)
