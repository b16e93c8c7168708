"""How the particle fountain is drawn."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.physics.fields import DRAG, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import OBSTACLES
from game.physics.particles.in_between import gather_touching, place_between
from game.scenes.fountain.hand import rim_handle
from game.scenes.fountain.readouts import exact_envelope, open_nozzles
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.raster.curves import thinned

if TYPE_CHECKING:
    from game.scenes.fountain.scene import Fountain

FEW = 30  # particles that are drawn large: each is looked at by itself
MOST_STREAKS = 30_000  # with more particles than that there is no room for trails
TRAIL = 0.017  # s, of the fading dots behind a particle
THRICE_ROUND = (1.2, 1.5, 1.8, 2.4, 3.0, 4.5, 6.0, 7.5, 9.0, 12.0)
SPREAD_ARM = 0.85  # m, of the two lines that show the spread


class FountainView:
    """Draws a fountain; keeps the arrays that drawing needs."""

    def __init__(self) -> None:
        self._places = np.zeros((0, 2))
        self._speeds = np.zeros((0, 2))
        self._trails = np.zeros((0, 2))
        self._touching = np.zeros((0, 2))
        self._shown_touching = self._touching

    def draw(self, scene: Fountain, canvas: Canvas, alpha: float) -> None:
        """All of it, from the back to the front."""
        canvas.grid(None, "y")
        if GROUND in scene.active:
            canvas.ground(scene.content.floor)
        if WHIRL in scene.active:
            self._draw_whirl(scene, canvas)
        self._draw_envelope(scene, canvas)
        self._draw_particles(scene, canvas, alpha)
        if OBSTACLES in scene.active:
            self._draw_stones(scene, canvas)
            if len(self._shown_touching):
                canvas.particles(self._shown_touching, "amber", 2.2)
        for index in range(len(scene.content.nozzles)):
            self._draw_nozzle(scene, canvas, index)
        if WIND in scene.active and (DRAG in scene.active or QUADRATIC_DRAG in scene.active):
            self._draw_wind(scene, canvas)

    def top_speed(self, scene: Fountain) -> float:
        """m/s at the end of the colour scale, whose thirds are round as well."""
        fall = math.sqrt(2.0 * scene.gravity * max(scene.frame().top - scene.content.floor, 0.0))
        return _round_up(max(scene.speed, 0.5 * fall, 0.1))

    def _draw_particles(self, scene: Fountain, canvas: Canvas, alpha: float) -> None:
        system = scene.system
        self._make_room(system.capacity)
        before = scene.previous
        same = before is not None and before.fields.shape == system.fields.shape
        fields, tags = (before.fields, before.tags) if same else (system.fields, system.tags)
        dt = scene.step_length
        since, rows, found = scene.touching_since(), 0, 0
        for low, high in system.segments():
            begin = rows
            rows = place_between(
                system.fields, fields, system.tags, tags, low, high, alpha, dt, system.time_s, TRAIL,
                self._places, self._speeds, self._trails, rows,
            )  # fmt: skip
            found = gather_touching(system.tags, self._places, low, high, since, begin, found, self._touching)
        places, speeds = self._places[:rows], self._speeds[:rows]
        self._shown_touching = self._touching[:found]
        colors = canvas.speed_colors(speeds, self.top_speed(scene))
        if rows <= FEW:
            canvas.streaks(places, self._trails[:rows], colors, 3.5, TRAIL)
        elif rows <= MOST_STREAKS:
            canvas.streaks(places, self._trails[:rows], colors, seconds=TRAIL)
        else:
            canvas.particles(places, colors, 1.0)

    def _make_room(self, capacity: int) -> None:
        if len(self._places) < capacity:
            self._places = np.zeros((capacity, 2))
            self._speeds = np.zeros((capacity, 2))
            self._trails = np.zeros((capacity, 2))
            self._touching = np.zeros((capacity, 2))

    def _draw_envelope(self, scene: Fountain, canvas: Canvas) -> None:
        curve = exact_envelope(scene)
        if not len(curve):
            return
        named = False
        for row in open_nozzles(scene):
            points = curve + row[:2]
            points = points[points[:, 1] >= scene.content.floor - 0.2]
            line = thinned(points, canvas.px(0.1))
            canvas.polyline(line, "text1", 1.4, dash=EXACT_DASH, alpha=0.75)
            frame = scene.frame()
            right = points[(points[:, 0] > row[0] + 1.6) & (points[:, 0] < frame.right - 1.0)]
            if len(right) and not named and len(scene.content.nozzles) == 1:
                place = right[0]
                words = "exact envelope of free flight"
                canvas.label(tuple(place), words, "text1", anchor="left", offset=(14.0, -10.0))
                named = True

    def _draw_stones(self, scene: Fountain, canvas: Canvas) -> None:
        for x, y, radius, _, _, e in scene.system.solids.rows.tolist():
            canvas.circle((x, y), radius, "body", 1.0, "text2", 2.0)
            handle = rim_handle(x, y, radius)
            canvas.line((x, y), handle, "text2", 1.4)
            canvas.dot((x, y), 2.5, "text1")
            canvas.handle(handle)
            if radius * canvas.pixels_per_unit > 34.0 * canvas.k:
                canvas.label((x, y), f"r {radius:.2f} m", "text1", offset=(0.0, 11.0), halo=False)
                canvas.label((x, y), f"e {e:.2f}", "text1", offset=(0.0, 25.0), halo=False)

    def _draw_nozzle(self, scene: Fountain, canvas: Canvas, index: int) -> None:
        x, y, _, _, axis, spread = scene.system.state().emitters[index, :6].tolist()
        ux, uy = math.sin(axis), math.cos(axis)
        body = [(-0.13, -0.13), (0.13, -0.13), (0.1, 0.0), (-0.1, 0.0)]
        corners = np.array([(x + a * uy + b * ux, y - a * ux + b * uy) for a, b in body])
        canvas.polygon(corners, fill="ghost", outline="text2", width=1.2)
        if spread < 0.5 * math.pi and scene.emitting:
            for side in (-1.0, 1.0):
                angle = axis + side * spread
                tip = (x + SPREAD_ARM * math.sin(angle), y + SPREAD_ARM * math.cos(angle))
                canvas.line((x, y), tip, "text1", 1.2, alpha=0.8)
            up = 0.5 * math.pi - axis
            canvas.arc((x, y), 0.82 * SPREAD_ARM, up - spread, up + spread, "text1", 1.2, alpha=0.8)
        edge = axis + min(spread, 0.5 * math.pi)
        place = (x + SPREAD_ARM * math.sin(edge), y + SPREAD_ARM * math.cos(edge))
        if index == 0:
            canvas.label(place, f"±{scene.spread:.3g}°", "text1", size=13, anchor="left", offset=(14.0, 6.0))

    def _draw_wind(self, scene: Fountain, canvas: Canvas) -> None:
        frame = scene.frame()
        middle = 0.5 * (frame.left + frame.right)
        length = 0.12 * (frame.right - frame.left)
        tail = (
            middle - 0.5 * math.copysign(length, scene.wind),
            frame.top - 0.1 * (frame.top - frame.bottom),
        )
        part = scene.wind / max(abs(scene.wind), 4.0)
        canvas.arrow(tail, (part * length, 0.0), "green", "w")

    def _draw_whirl(self, scene: Fountain, canvas: Canvas) -> None:
        x, y = scene.whirl_centre
        turn = math.copysign(1.0, scene.whirl)
        for ring in range(1, 4):
            radius = 0.22 * ring
            start = 0.9 * ring
            canvas.arc((x, y), radius, start, start + turn * 4.6, "green", 1.4, alpha=0.9 - 0.2 * ring)
        canvas.handle((x, y))
        canvas.label((x, y), "whirl", "green", offset=(0.0, -16.0))


def _round_up(speed: float) -> float:
    """The next speed that is three times a round number."""
    power = 10.0 ** math.floor(math.log10(speed))
    return next(factor * power for factor in THRICE_ROUND if factor * power >= speed * (1.0 - 1e-9))
