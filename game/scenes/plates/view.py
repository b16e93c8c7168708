"""How falling plates are drawn: blades by flashes, and the map of what plates of an inertia do."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.fields import GROUND
from game.physics.plates import law, watch
from game.physics.plates.regimes import BORDERS, THICKEST
from game.physics.plates.watch import NAMES
from game.scenes.plates import model as m
from game.scenes.plates.hand import PlatesHand
from game.scenes.plates.model import PlatesModel, PlatesState
from game.ui.canvas.canvas import Canvas

COLORS = {
    watch.NOTHING: "text2",
    watch.FLUTTER: "chalk",
    watch.TUMBLE: "amber",
    watch.CHAOS: "vermilion",
    watch.GLIDE: "green",
}
MAP_LEFT, MAP_RIGHT, MAP_LOW, MAP_HIGH = 1.02, 1.86, -0.40, 0.40  # m, where the map stands
LEAST, MOST = 0.08, 12.0  # inertias on the map
TOP = 0.5  # thickness at the upper edge of the map
BANDS = ((0.0, BORDERS[0], "chalk", "flutter"), (BORDERS[0], BORDERS[1], "amber", "tumble"),
         (BORDERS[1], BORDERS[2], "vermilion", "irregular"),
         (BORDERS[2], 1e9, "chalk", "flutter"))  # fmt: skip


class PlatesView:
    """Draws a model and its hand."""

    def __init__(self, model: PlatesModel, hand: PlatesHand):
        self.model, self.hand = model, hand

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the marks mean."""
        return (
            ("line:chalk", "flutters", ""),
            ("line:amber", "tumbles", ""),
            ("line:vermilion", "irregular", ""),
            ("line:green", "glides", ""),
        )

    def draw(self, canvas: Canvas, previous: PlatesState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state before to now."""
        rows = self.model.plates.rows
        if previous is not None and previous.plates.rows.shape == rows.shape:
            rows = previous.plates.rows + alpha * (rows - previous.plates.rows)
        regimes = [self.model.course(i).regime for i in range(rows.shape[1])]
        self._draw_tank(canvas)
        with canvas.within((m.LEFT, m.FLOOR), (m.RIGHT, m.CEILING)):
            if self.model.parameters.traces:
                self._draw_flashes(canvas, regimes)
            self._draw_plates(canvas, rows, regimes)
            self._draw_wind(canvas)
        if self.hand.drags:
            start = (self.hand.from_x, self.hand.from_y)
            canvas.contact(start)
            canvas.arrow(start, (self.hand.x - start[0], self.hand.y - start[1]), "chalk")
        self._draw_map(canvas, regimes)

    # -- the tank -------------------------------------------------------------------------------------

    def _draw_tank(self, canvas: Canvas) -> None:
        """Air that is lighter where the light comes in, walls and the ground."""
        down = np.linspace(0.0, 1.0, 24)[::-1]
        across = np.linspace(-1.0, 1.0, 32)
        light = np.exp(-2.2 * down)[:, None] * np.exp(-1.4 * (across - 0.3 * (down[:, None] - 0.5)) ** 2)
        canvas.field(light, (m.LEFT, m.FLOOR), (m.RIGHT, m.CEILING), ((0.0, "stage"), (1.0, "panel")))
        for x in (m.LEFT, m.RIGHT):
            canvas.line((x, m.FLOOR), (x, m.CEILING), "line2", 1.0)
        if GROUND in self.model.plates.effects:
            canvas.polygon(
                [(m.LEFT, m.FLOOR), (m.RIGHT, m.FLOOR), (m.RIGHT, m.FLOOR - 0.02), (m.LEFT, m.FLOOR - 0.02)],
                fill="body",
            )
            canvas.line((m.LEFT, m.FLOOR), (m.RIGHT, m.FLOOR), "text3", 1.6)
        for x0, y0, x1, y1 in self.model.content.walls:
            canvas.line((x0, y0), (x1, y1), "text2", 3.0)

    def _blades(self, poses: Floats, number: int) -> Floats:
        """Both halves (k, 3, 2) m of a plate in poses (k, 4): its left end, its middle, its right end."""
        half = float(self.model.plates.laws[law.HALF, number])
        x, y, theta, q = poses.T
        c, s = np.cos(theta), np.sin(theta)
        found = np.empty((len(poses), 3, 2))
        at = self.model.shown(np.stack([x, y], axis=1))
        for k, side in enumerate((-1.0, 0.0, 1.0)):
            px, py = side * half * np.cos(q), (abs(side) - 0.35) * half * np.sin(q)
            found[:, k, 0], found[:, k, 1] = at[:, 0] + c * px - s * py, at[:, 1] + s * px + c * py
        return found

    def _draw_flashes(self, canvas: Canvas, regimes: list[int]) -> None:
        flashed = self.model.flashed
        order = np.arange(max(flashed - m.FLASHES, 0), flashed) % m.FLASHES
        if not len(order):
            return
        for i, regime in enumerate(regimes):
            blades = self._blades(self.model.flashes[order, :, i], i)
            parts = np.array_split(np.arange(len(order)), 4)
            for k, part in enumerate(parts):
                ends = blades[part]
                strength = 0.10 + 0.13 * k
                canvas.segments(ends[:, 0], ends[:, 1], COLORS[regime], 1.3, strength)
                canvas.segments(ends[:, 1], ends[:, 2], COLORS[regime], 1.3, strength)

    def _draw_plates(self, canvas: Canvas, rows: Floats, regimes: list[int]) -> None:
        for i, regime in enumerate(regimes):
            left, middle, right = self._blades(rows[[law.X, law.Y, law.THETA, law.BEND], i][None], i)[0]
            thick = max(float(self.model.plates.laws[law.RADIUS, i]), canvas.px(1.6))
            width = 2.0 * thick / canvas.px(1.0)
            canvas.polyline(np.array([left, middle, right]), COLORS[regime], width + 1.6)
            canvas.polyline(np.array([left, middle, right]), "text1", max(width - 1.0, 1.4))
            if i == self.model.chosen:
                half = float(self.model.plates.laws[law.HALF, i])
                canvas.circle(0.5 * (left + right), 1.25 * half, outline="amber", width=1.4, alpha=0.8)
                if self.model.parameters.forces:
                    canvas.arrow(middle, 0.12 * self.model.plates.velocities[i], "chalk", "v")

    def _draw_wind(self, canvas: Canvas) -> None:
        """Arrows of the wind over the tank, where it blows."""
        x, y = np.meshgrid(
            np.linspace(m.LEFT + 0.09, m.RIGHT - 0.09, 11), np.linspace(m.FLOOR + 0.1, m.CEILING - 0.1, 7)
        )
        places = np.stack([x.ravel(), y.ravel()], axis=1)
        wind = self.model.wind.sample(places, self.model.plates.time)
        if float(np.max(np.abs(wind))) < 0.02:
            return
        for place, velocity in zip(places, 0.03 * wind, strict=True):
            canvas.arrow(place, velocity, "green", alpha=0.6, width=1.6)

    # -- the map --------------------------------------------------------------------------------------

    def _on_map(self, inertia: float, thickness: float) -> tuple[float, float]:
        share = math.log(min(max(inertia, LEAST), MOST) / LEAST) / math.log(MOST / LEAST)
        up = min(max(thickness, 0.0), TOP) / TOP
        return MAP_LEFT + share * (MAP_RIGHT - MAP_LEFT), MAP_LOW + up * (MAP_HIGH - MAP_LOW)

    def _draw_map(self, canvas: Canvas, regimes: list[int]) -> None:
        """Bands of what the usual coefficients do, up to where they hold, and a dot for each plate."""
        high = self._on_map(1.0, THICKEST)[1]
        for least, most, color, words in BANDS:
            x0, x1 = self._on_map(least, 0.0)[0], self._on_map(most, 0.0)[0]
            corners = [(x0, MAP_LOW), (x1, MAP_LOW), (x1, high), (x0, high)]
            canvas.polygon(corners, fill=color, fill_alpha=0.16)
            canvas.line((x1, MAP_LOW), (x1, high), "stage", 1.5)
            if x1 - x0 > 0.11:
                canvas.label((0.5 * (x0 + x1), high - 0.03), words, "text2", 12)
        canvas.label((self._on_map(1.34, 0.0)[0], high + 0.03), "tumble", "amber", 12)
        middle = 0.5 * (MAP_LEFT + MAP_RIGHT)
        canvas.label((middle, high + 0.08), f"borders as measured up to β = {THICKEST:g}", "text3", 12)
        for y in (high, MAP_HIGH):
            canvas.line((MAP_LEFT, y), (MAP_RIGHT, y), "line2", 1.0)
        for x in (MAP_LEFT, MAP_RIGHT):
            canvas.line((x, MAP_LOW), (x, MAP_HIGH), "line2", 1.0)
        for inertia in (0.1, 0.3, 1.0, 3.0, 10.0):
            x = self._on_map(inertia, 0.0)[0]
            canvas.line((x, MAP_LOW), (x, MAP_LOW - 0.012), "text3", 1.0)
            canvas.label((x, MAP_LOW - 0.035), f"{inertia:g}", "text3", 11)
        for thickness in (0.0, THICKEST, 0.25, TOP):
            y = self._on_map(1.0, thickness)[1]
            canvas.label((MAP_LEFT - 0.012, y), f"{thickness:g}", "text3", 11, anchor="right")
        canvas.label((0.5 * (MAP_LEFT + MAP_RIGHT), MAP_LOW - 0.075), "inertia I*", "text2", 12)
        canvas.label((MAP_LEFT, MAP_HIGH + 0.03), "thickness β", "text2", 12, anchor="left")
        for i, regime in enumerate(regimes):
            inertia, thickness, _, _ = self.model.numbers_of(i)
            at = self._on_map(inertia, thickness)
            canvas.dot(at, 5.0, COLORS[regime])
            canvas.ring(at, 5.0, "text1", 1.0)
            if i == self.model.chosen:
                canvas.ring(at, 9.0, "amber", 2.0)
        self._draw_words(canvas)

    def _draw_words(self, canvas: Canvas) -> None:
        """What the chosen plate does, in the paper's units, beside what it should be."""
        chosen = self.model.chosen
        if not 0 <= chosen < len(self.model.plates):
            return
        course = self.model.course(chosen)
        inertia, thickness, half, unit = self.model.numbers_of(chosen)
        name = {"": "on its way", "chaos": "irregular"}.get(NAMES[course.regime], NAMES[course.regime])
        rows = [f"I* {inertia:.3g}, β {thickness:.3g}: {name}"]
        spin, descent, period = self.model.reference(chosen)
        for words, value, exact, unit_of in (
            ("descent", course.descent / unit, descent, "U"),
            ("spin", abs(course.spin) * half / unit, spin, "U/a"),
            ("period", course.period * unit / half, period, "a/U"),
        ):
            if math.isfinite(value) and not (words == "spin" and value < 0.02):
                beside = f", reference {exact:.4f}" if math.isfinite(exact) else ""
                rows.append(f"{words} {value:.4f} {unit_of}{beside}")
        for line, words in enumerate(rows):
            said = canvas.figure(("plate", line), words)
            canvas.label(
                (MAP_LEFT, MAP_LOW - 0.12), said, "text1" if line == 0 else "text2", 13,
                "semibold" if line == 0 else "medium", "topleft", (0.0, 19.0 * line),
            )  # fmt: skip
