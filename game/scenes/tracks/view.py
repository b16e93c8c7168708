"""How tracks and balls are drawn."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.physics.solids.tracks.curves import Pieces
from game.physics.solids.tracks.motion import ANGLE, RADIUS, VX, VY, X, Y
from game.scenes.tracks.hand import TrackHand
from game.scenes.tracks.model import COLOURS, SHOWN_BALLS, TRAIL, TracksModel, TracksState
from game.ui.canvas.canvas import PREDICTION_DASH, Canvas
from game.worlds.hands.curves import NOBODY
from game.worlds.painting.rails import lines_of

Floats = NDArray[np.float64]
WHAT_NEXT = {
    "ball": "click, drag and let go: a new ball", "draw": "draw a track", "bend": "drag a track",
    "delete": "click a ball or a track",
}  # fmt: skip


class TrackView:
    """Draws a model and its hand; keeps the lines of tracks until these change."""

    def __init__(self, model: TracksModel, hand: TrackHand):
        self.model, self.hand = model, hand
        self._of: Pieces | None = None
        self._lines: list[Floats] = []

    def legend(self) -> list[tuple[str, str, str]]:
        """What the tool in the hand does next."""
        tool = self.model.parameters.tool
        rows = [("line:chalk", "velocity", "")] if self.model.parameters.velocities else []
        return [*rows, ("ring:accent", WHAT_NEXT[tool], "")] if tool in WHAT_NEXT else rows

    def draw(self, canvas: Canvas, previous: TracksState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        canvas.grid(None, "xy")
        for line in self._tracks():
            canvas.polyline(line, "line2", 6.0)
            canvas.polyline(line, "text2", 2.6)
        if self.model.parameters.points:
            for curve in self.model.world.curves:
                canvas.particles(np.asarray(curve.points, dtype=np.float64), "amber", 2.2)
        rows = self.model.world.balls.rows
        places, angles = rows[:, X : Y + 1], rows[:, ANGLE]
        if previous is not None and previous.balls.rows.shape == rows.shape:
            before = previous.balls.rows
            places = before[:, X : Y + 1] + alpha * (places - before[:, X : Y + 1])
            angles = before[:, ANGLE] + alpha * (angles - before[:, ANGLE])
        if self.model.parameters.trails and len(rows) <= SHOWN_BALLS:
            self._draw_trails(canvas, places)
        self._draw_balls(canvas, places, angles)
        self._draw_hand(canvas)

    def _tracks(self) -> list[Floats]:
        """Each track as points along its smooth curve."""
        pieces = self.model.world.pieces
        if self._of is not pieces:
            self._of, self._lines = pieces, lines_of(pieces, self.model.world.curves)
        return self._lines

    def _draw_trails(self, canvas: Canvas, places: Floats) -> None:
        steps, trail = self.model.steps, self.model.trail
        count = min(steps, TRAIL)
        if count < 2:
            return
        order = (steps - count + np.arange(count)) % TRAIL
        for ball in range(trail.shape[1]):
            name = COLOURS[int(self.model.tints[ball]) & 255]
            line = np.concatenate([trail[order, ball], places[ball : ball + 1]])
            canvas.polyline(line, name, 1.4, alpha=0.5)

    def _draw_balls(self, canvas: Canvas, places: Floats, angles: Floats) -> None:
        rows, tints = self.model.world.balls.rows, self.model.tints
        for ball, (x, y) in enumerate(places.tolist()):
            name, r = COLOURS[int(tints[ball]) & 255], float(rows[ball, RADIUS])
            least = canvas.px(2.5)
            if r < least:
                canvas.dot((x, y), 3.5, name)
                continue
            fill = canvas.color(name).lerp(canvas.color("body"), 0.35)
            canvas.circle((x, y), r, fill, 1.0, name, 1.8)
            light = fill.lerp(canvas.color("text1"), 0.16)
            canvas.circle((x - 0.16 * r, y + 0.2 * r), 0.62 * r, light)
            turn = float(angles[ball])
            canvas.line((x, y), (x + r * math.cos(turn), y + r * math.sin(turn)), "text1", 1.4)
        if self.model.parameters.velocities:
            fastest = float(np.hypot(rows[:, VX], rows[:, VY]).max(initial=0.0))
            view = self.model.content.view
            if fastest > 0.0:
                scale = 0.15 * (view.top - view.bottom) / fastest
                for ball, place in enumerate(places.tolist()):
                    canvas.arrow(place, rows[ball, VX : VY + 1].tolist(), "chalk", None, scale)

    def _draw_hand(self, canvas: Canvas) -> None:
        hand = self.hand
        if len(hand.path) > 1:
            canvas.polyline(np.array(hand.path), "accent", 2.0)
        if hand.point is None:
            return
        if hand.held != NOBODY and hand.held < len(self.model.energies):
            canvas.ring(hand.point, 9.0, "amber", 1.8)
        elif hand.bent != NOBODY:
            canvas.circle(
                hand.point, self.model.parameters.bending, outline="amber", width=1.2, dash=PREDICTION_DASH
            )
