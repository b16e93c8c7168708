"""How the flow in a cavity is drawn."""

from __future__ import annotations

import numpy as np

from game.scenes.cavity.model import MEAN, WARM, CavityModel, CavityState
from game.scenes.cavity.published import EXTREMES, GHIA_U, GHIA_V, HEIGHTS, PLACES, WHERE, known_number
from game.ui.canvas.canvas import Canvas

SWING = 0.4  # m that a profile is drawn out for 1 m/s
STREAM = 0.12  # s of the way that a speck is drawn with
SPEED = ((0.0, "stage"), (0.35, "body"), (0.7, "chalk"), (1.0, "text1"))
SIGNED = ((0.0, "vermilion"), (0.5, "stage"), (1.0, "chalk"))
HEAT = ((0.0, "chalk"), (0.5, "stage"), (1.0, "vermilion"))


class CavityView:
    """Draws a model."""

    def __init__(self, model: CavityModel):
        self.model = model

    def draw(self, canvas: Canvas, previous: CavityState | None, alpha: float) -> None:
        """The field, specks ``alpha`` of the way from the state before to now, the profiles, the walls."""
        chosen = self.model.parameters
        self._draw_field(canvas)
        if chosen.tracers:
            specks = self.model.specks
            if previous is not None and previous.specks.shape == specks.shape:
                specks = previous.specks + alpha * (specks - previous.specks)
            way = self.model.gas.sample(specks)
            canvas.segments(specks - STREAM * way, specks, "text2", 1.2, alpha=0.55)
        if chosen.profiles:
            self._draw_profiles(canvas)
        self._draw_walls(canvas)

    def _draw_field(self, canvas: Canvas) -> None:
        gas, view = self.model.gas, self.model.parameters.view
        corner, opposite = (0.0, 0.0), (1.0, 1.0)
        if view == "speed":
            speed = np.hypot(*np.moveaxis(gas.velocity(), 2, 0))
            canvas.field(speed / max(self._scale(), 1e-9), corner, opposite, SPEED)
        elif view == "vorticity":
            canvas.field(0.5 + gas.vorticity()[1:, 1:] / (16.0 * self._scale()), corner, opposite, SIGNED)
        elif view == "pressure":
            canvas.field(0.5 + 2.5 * gas.pressure / self._scale() ** 2, corner, opposite, SIGNED)
        else:
            warm = (gas.field("temperature") - MEAN) / (2.0 * WARM)
            canvas.field(0.5 + warm, corner, opposite, HEAT)

    def _scale(self) -> float:
        """m/s that is drawn in the last colour."""
        if self.model.heated:
            return 0.35
        return max(abs(float(self.model.parameters.lid)), 0.05) * 0.75

    def _draw_profiles(self, canvas: Canvas) -> None:
        """Speeds on the centre lines; dots are Ghia's tables, rings the extremes that are known better."""
        y, u, x, v = self.model.profiles()
        canvas.line((0.5, 0.0), (0.5, 1.0), "text3", 1.0, dash=(4.0, 5.0))
        canvas.line((0.0, 0.5), (1.0, 0.5), "text3", 1.0, dash=(4.0, 5.0))
        canvas.polyline(np.stack([0.5 + SWING * u, y], axis=1), "green", 2.6)
        canvas.polyline(np.stack([x, 0.5 + SWING * v], axis=1), "amber", 2.6)
        chosen = self.model.parameters
        number = known_number(chosen.number, GHIA_U)
        if self.model.heated or number is None or chosen.lid <= 0.0:
            return
        lid = float(chosen.lid)
        for height, speed in zip(HEIGHTS, GHIA_U[number], strict=True):
            canvas.dot((0.5 + SWING * lid * speed, height), 3.6, "text1")
        for place, speed in zip(PLACES, GHIA_V[number], strict=True):
            canvas.dot((place, 0.5 + SWING * lid * speed), 3.6, "text1")
        low, most, least = EXTREMES[number]
        canvas.ring((0.5 + SWING * lid * low, WHERE[number][0]), 8.0, "vermilion", 2.0)
        canvas.ring((WHERE[number][1], 0.5 + SWING * lid * most), 8.0, "vermilion", 2.0)
        canvas.ring((WHERE[number][2], 0.5 + SWING * lid * least), 8.0, "vermilion", 2.0)

    def _draw_walls(self, canvas: Canvas) -> None:
        if self.model.heated:
            canvas.line((0.0, 0.0), (0.0, 1.0), "vermilion", 5.0)
            canvas.line((1.0, 0.0), (1.0, 1.0), "chalk", 5.0)
            canvas.line((0.0, 0.0), (1.0, 0.0), "text1", 3.0)
            canvas.line((0.0, 1.0), (1.0, 1.0), "text1", 3.0)
            return
        canvas.polyline(((0.0, 1.0), (0.0, 0.0), (1.0, 0.0), (1.0, 1.0)), "text1", 3.0)
        canvas.line((0.0, 1.0), (1.0, 1.0), "amber", 4.0)
        lid = float(self.model.parameters.lid)
        if lid:
            canvas.arrow((0.5 - 0.12 * lid, 1.035), (0.24 * lid, 0.0), "amber")
