"""How tracks and balls are drawn."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.solids.tracks.curves import Pieces
from game.physics.solids.tracks.motion import RADIUS, VX, VY
from game.scenes.tracks.parameters import TOOLS
from game.scenes.tracks.world import BEYOND, COLOURS, TRAIL, TracksState, TracksWorld
from game.ui.canvas.canvas import Canvas
from game.worlds.hands.hand import Hand, legend_of
from game.worlds.hands.marks import draw_track_hand
from game.worlds.members.tracks import balls_between
from game.worlds.painting.rails import lines_of

SHOWN_BALLS = 200  # most that have a trail


class TrackView:
    """Draws a model and its hand; keeps the lines of tracks until these change."""

    def __init__(self, model: TracksWorld, hand: Hand):
        self.model, self.hand = model, hand
        self._of: Pieces | None = None
        self._lines: list[Floats] = []

    def legend(self) -> list[tuple[str, str, str]]:
        """What the tool in the hand does next."""
        rows = [("line:chalk", "velocity", "")] if self.model.parameters.velocities else []
        return [*rows, *legend_of(TOOLS, self.model.parameters.tool)]

    def draw(self, canvas: Canvas, previous: TracksState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        canvas.grid(None, "xy")
        for line in self._tracks():
            canvas.polyline(line, "line2", 6.0)
            canvas.polyline(line, "text2", 2.6)
        if self.model.parameters.points:
            for curve in self.model.tracks.riders.curves:
                canvas.particles(np.asarray(curve.points, dtype=np.float64), "amber", 2.2)
        rows = self.model.rows
        view = self.model.content.view  # a ball that comes back was at least so far beside it
        jump = BEYOND * min(view.right - view.left, view.top - view.bottom)
        places, angles = balls_between(rows, previous and previous.balls.rows, alpha, jump)
        if self.model.parameters.trails and len(rows) <= SHOWN_BALLS:
            self._draw_trails(canvas, places)
        self._draw_balls(canvas, places, angles)
        draw_track_hand(canvas, self.hand, 2.0)

    def _tracks(self) -> list[Floats]:
        """Each track as points along its smooth curve."""
        pieces = self.model.tracks.riders.pieces
        if self._of is not pieces:
            self._of, self._lines = pieces, lines_of(pieces, self.model.tracks.riders.curves)
        return self._lines

    def _draw_trails(self, canvas: Canvas, places: Floats) -> None:
        steps, trail = self.model.steps, self.model.balls.trail
        count = min(steps, TRAIL)
        if count < 2:
            return
        order = (steps - count + np.arange(count)) % TRAIL
        for ball in range(trail.shape[1]):
            name = COLOURS[int(self.model.balls.tints[ball]) & 255]
            line = np.concatenate([trail[order, ball], places[ball : ball + 1]])
            canvas.polyline(line, name, 1.4, alpha=0.5)

    def _draw_balls(self, canvas: Canvas, places: Floats, angles: Floats) -> None:
        rows, tints = self.model.rows, self.model.balls.tints
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
            if ball == self.model.inspected:
                canvas.circle((x, y), r + canvas.px(4.0), outline="accent", width=1.6, dash=(5.0, 4.0))
            canvas.line((x, y), (x + r * math.cos(turn), y + r * math.sin(turn)), "text1", 1.4)
        if self.model.parameters.velocities:
            fastest = float(np.hypot(rows[:, VX], rows[:, VY]).max(initial=0.0))
            view = self.model.content.view
            if fastest > 0.0:
                scale = 0.15 * (view.top - view.bottom) / fastest
                for ball, place in enumerate(places.tolist()):
                    canvas.arrow(place, rows[ball, VX : VY + 1].tolist(), "chalk", None, scale)
