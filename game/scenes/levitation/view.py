"""How the sound field and its grains are drawn."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.physics.acoustics.field import PHASE, STRENGTH, transfer
from game.physics.acoustics.grains import FOCUS_X, FOCUS_Y
from game.scenes.levitation.model import APART, TRAIL, WAVE, LevitationModel, LevitationState
from game.ui.canvas.canvas import Canvas

COLUMNS, ROWS = 140, 140  # cells of the field that is drawn
HALF = 0.5 * APART
FULL = 2_600.0  # Pa, drawn in the last colour at the usual strength
WAVES_PER_S = 0.8  # of the slowed wave that is drawn
PRESSURE = ((0.0, "stage"), (0.35, "body"), (0.7, "chalk"), (1.0, "text1"))
SIGNED = ((0.0, "vermilion"), (0.5, "stage"), (1.0, "chalk"))
DEPTH = ((0.0, "green"), (0.45, "body"), (0.55, "stage"), (1.0, "violet"))


class LevitationView:
    """Draws a model; keeps what each transducer adds to each cell, which does not change."""

    def __init__(self, model: LevitationModel):
        self.model = model
        self._heard: NDArray[np.complex64] | None = None

    def pressure(self) -> NDArray[np.complex64]:
        """The pressure (Pa) in the cells, (rows, columns), by the phases of now."""
        sources = self.model.levitator.array.sources
        if self._heard is None:
            steps = (np.arange(COLUMNS) + 0.5) / COLUMNS * APART - HALF
            places = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
            unit = sources.copy()
            unit[:, STRENGTH] = 1.0
            self._heard = transfer(unit, self.model.levitator.wave, places)
        turned = (sources[:, STRENGTH] * np.exp(1j * sources[:, PHASE])).astype(np.complex64)
        return np.asarray((self._heard @ turned).reshape(ROWS, COLUMNS))

    def draw(self, canvas: Canvas, previous: LevitationState | None, alpha: float, time: float) -> None:
        """All of it, ``alpha`` of the way from the state before to now."""
        self._draw_field(canvas, time)
        self._draw_rows(canvas)
        levitator = self.model.levitator
        places, focus = levitator.positions, levitator.focus
        if previous is not None and previous.grains.fields.shape == levitator.fields.shape:
            before = previous.grains.fields[:2].T
            places = before + alpha * (places - before)
            focus = previous.grains.focus + alpha * (focus - previous.grains.focus)
        if self.model.parameters.trails:
            self._draw_trails(canvas)
        if self.model.parameters.pattern == "focus":
            canvas.polyline(levitator.path[::4, :2], "text3", 1.0, dash=(4.0, 5.0))
            canvas.contact((float(focus[FOCUS_X]), float(focus[FOCUS_Y])))
        if self.model.parameters.forces and len(places):
            weight = levitator.grain.mass * 9.81
            for place, force in zip(places, levitator.sample(places)[:, 4:], strict=True):
                canvas.arrow(place, 0.004 * force / weight, "green")
        held = self.model.held()
        for place, carried in zip(places.tolist(), held.tolist(), strict=True):
            canvas.body(place, levitator.grain.radius, 0.0, "yellow" if carried else "text3")
        self._draw_scale(canvas)

    def _draw_field(self, canvas: Canvas, time: float) -> None:
        view, corner, opposite = self.model.parameters.view, (-HALF, -HALF), (HALF, HALF)
        if view == "nothing":
            return
        p = self.pressure()
        full = max(FULL * self.model.parameters.strength / 10.0, 1.0)
        if view == "pressure":
            canvas.field(np.abs(p) / full, corner, opposite, PRESSURE)
        elif view == "wave":
            turn = np.exp(np.complex64(-2j * math.pi * WAVES_PER_S * time))
            canvas.field(0.5 + 0.5 * (p * turn).real / full, corner, opposite, SIGNED)
        else:
            wave = self.model.levitator.wave
            cell = APART / COLUMNS
            up, right = np.gradient(p, cell)
            depth = wave.monopole * np.abs(p) ** 2 - wave.dipole * (np.abs(up) ** 2 + np.abs(right) ** 2)
            inner = depth[ROWS // 5 : -ROWS // 5, COLUMNS // 5 : -COLUMNS // 5]
            scale = max(float(np.percentile(np.abs(inner), 99.8)), 1e-30)
            canvas.field(0.5 + 0.5 * depth / scale, corner, opposite, DEPTH)

    def _draw_rows(self, canvas: Canvas) -> None:
        """Each transducer as a cup that opens to where it sends, its phase as a shade."""
        for source in self.model.levitator.array.sources:
            x, y, ax, ay, _, phase = source.tolist()
            wide, deep = 0.0042, 0.006
            corners = [
                (x + s * wide * ay - d * deep * ax, y - s * wide * ax - d * deep * ay)
                for s, d in ((-1, 0.1), (1, 0.1), (1, 1.0), (-1, 1.0))
            ]
            light = 0.5 + 0.5 * math.cos(phase)
            canvas.polygon(corners, "body", outline="line2")
            middle = (x - 0.55 * deep * ax, y - 0.55 * deep * ay)
            canvas.circle(middle, 0.0018, "amber", 0.15 + 0.85 * light)

    def _draw_trails(self, canvas: Canvas) -> None:
        steps, trail = self.model.steps, self.model.trail
        count = min(steps, TRAIL)
        if count < 2:
            return
        order = np.arange(steps - count, steps) % TRAIL
        for grain in range(trail.shape[1]):
            canvas.polyline(trail[order, grain], "yellow", 1.6, alpha=0.75)

    def _draw_scale(self, canvas: Canvas) -> None:
        """Half a wave, as long as it is, beside the rows."""
        left, bottom = -HALF + 0.004, -0.5 * HALF
        canvas.line((left, bottom), (left + 0.5 * WAVE, bottom), "text1", 2.0)
        canvas.label(
            (left + 0.5 * WAVE + 0.002, bottom), f"λ/2 = {500.0 * WAVE:.2f} mm", "text1", 12, anchor="left"
        )
