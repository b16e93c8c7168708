"""How the particle fountain is drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.physics.fields import DRAG, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import OBSTACLES, ParticleState, ParticleSystem
from game.physics.particles.in_between import Instant, Shown, Swarm, gather_touching, place_between
from game.scenes.fountain.exact import exact_envelope, open_nozzles
from game.scenes.fountain.hand import rim_handle
from game.scenes.fountain.model import FountainModel, SplitState
from game.scenes.fountain.panes import panes_of
from game.scenes.shared.insets import Zoom, draw_inset
from game.stage import Frame
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.raster.curves import thinned

FEW = 30  # particles that are drawn large: each is looked at by itself
MOST_STREAKS = 30_000  # with more particles than that there is no space for trails
TRAIL = 0.017  # s, of the fading dots behind a particle
THRICE_ROUND = (1.2, 1.5, 1.8, 2.4, 3.0, 4.5, 6.0, 7.5, 9.0, 12.0)
SPREAD_ARM = 0.85  # m, of the two lines that show the spread


class FountainView:
    """Draws a fountain; keeps the arrays that drawing needs."""

    def __init__(self, model: FountainModel):
        self.model = model
        self._places = np.zeros((0, 2))
        self._speeds = np.zeros((0, 2))
        self._trails = np.zeros((0, 2))
        self._in_contact = np.zeros((0, 2))
        self._shown_in_contact = self._in_contact

    def draw(self, canvas: Canvas, previous: ParticleState | SplitState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now; methods side by side."""
        model = self.model
        if not model.beside:
            self._draw_one(canvas, model.system, previous, alpha)
            return
        then: Sequence[ParticleState | SplitState | None] = (None,) * len(model.systems)
        if isinstance(previous, SplitState):
            then = (*previous.beside, previous)
        view = model.content.view
        middle = 0.5 * (view.bottom + view.top)
        for pane, system, before in zip(panes_of(model), model.systems, then, strict=True):
            low, high = (pane.left, view.bottom), (pane.right, view.top)
            centre = (0.5 * (pane.left + pane.right) - pane.shift, middle)
            with canvas.magnified(low, high, centre, 1.0):
                self._draw_one(canvas, system, before, alpha)
            canvas.line((pane.right, view.bottom), (pane.right, view.top), "line2", 1.0)
            foot = (0.5 * (pane.left + pane.right), view.bottom)
            canvas.label(foot, pane.title, "text1", 13, "semibold", "bottom", offset=(0.0, -6.0))

    def _draw_one(
        self,
        canvas: Canvas,
        system: ParticleSystem,
        previous: ParticleState | SplitState | None,
        alpha: float,
    ) -> None:
        """One of them, from the back to the front."""
        model, on = self.model, self.model.active
        if model.parameters.life < model.parameters.step_length:
            alpha = 1.0  # none lives through a step, so there is no way to go between two of them
        canvas.grid(None, "y")
        if GROUND in on:
            canvas.ground(model.content.floor)
        if WHIRL in on:
            self._draw_vortex(canvas)
        self._draw_envelope(canvas)
        for path in np.swapaxes(model.paths_so_far(), 0, 1):
            canvas.polyline(path, "ghost", 1.2)
        self._draw_particles(canvas, system, previous, alpha)
        if OBSTACLES in on:
            self._draw_stones(canvas)
            if len(self._shown_in_contact):
                canvas.particles(self._shown_in_contact, "amber", 2.2)
        for index in range(len(model.content.nozzles)):
            self._draw_nozzle(canvas, index)
        if WIND in on and (DRAG in on or QUADRATIC_DRAG in on):
            self._draw_wind(canvas)

    def draw_inset(
        self, canvas: Canvas, zoom: Zoom, previous: ParticleState | SplitState | None, alpha: float
    ) -> None:
        """The same in a corner, larger."""
        view = self.model.content.view
        frame = Frame(view.left, view.bottom, view.right, view.top)
        draw_inset(canvas, frame, zoom, lambda: self.draw(canvas, previous, alpha))

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean."""
        model = self.model
        rows = [("scale:slow:fast", "Speed", f"0 {self._top_speed():.3g} m/s")]
        if OBSTACLES in model.active and len(model.own):
            words = "in contact with the stone" if len(model.own) == 1 else "in contact with a stone"
            rows.append(("disc:amber", words, ""))
        if len(exact_envelope(model)):
            older = 0.0 < model.since > model.system.time_s - model.parameters.life
            rows.append(("dash:text1", "exact for those born since" if older else "exact envelope", ""))
        return rows

    def _top_speed(self) -> float:
        """m/s at the end of the colour scale, whose thirds are round as well."""
        content, parameters = self.model.content, self.model.parameters
        fall = math.sqrt(2.0 * parameters.gravity * max(content.view.top - content.floor, 0.0))
        return _round_up(max(parameters.speed, 0.5 * fall, 0.1))

    def _draw_particles(
        self, canvas: Canvas, system: ParticleSystem, before: ParticleState | SplitState | None, alpha: float
    ) -> None:
        self._reserve(system.capacity)
        if before is None or before.fields.shape != system.fields.shape:
            before = system.state()
        swarm, then = Swarm(system.fields, system.tags), Swarm(before.fields, before.tags)
        instant = Instant(alpha, self.model.parameters.step_length, system.time_s)
        shown = Shown(self._places, self._speeds, self._trails)
        first_step, rows, found = self.model.first_step_in_contact(), 0, 0
        for low, high in system.segments():
            begin = rows
            rows = place_between(swarm, then, low, high, instant, TRAIL, shown, rows)
            found = gather_touching(
                system.tags, self._places, low, high, first_step, begin, found, self._in_contact
            )
        places, speeds = self._places[:rows], self._speeds[:rows]
        self._shown_in_contact = self._in_contact[:found]
        colors = canvas.speed_colors(speeds, self._top_speed())
        if rows <= FEW:
            canvas.streaks(places, self._trails[:rows], colors, 3.5, TRAIL)
        elif rows <= MOST_STREAKS:
            canvas.streaks(places, self._trails[:rows], colors, seconds=TRAIL)
        else:
            canvas.particles(places, colors, 1.0)

    def _reserve(self, capacity: int) -> None:
        """Make the arrays large enough for so many particles."""
        if len(self._places) < capacity:
            self._places = np.zeros((capacity, 2))
            self._speeds = np.zeros((capacity, 2))
            self._trails = np.zeros((capacity, 2))
            self._in_contact = np.zeros((capacity, 2))

    def _draw_envelope(self, canvas: Canvas) -> None:
        model, frame = self.model, self.model.content.view
        curve = exact_envelope(model)
        if not len(curve):
            return
        named = False
        for row in open_nozzles(model):
            points = curve + row[:2]
            points = points[points[:, 1] >= model.content.floor - 0.2]
            line = thinned(points, canvas.px(0.1))
            canvas.polyline(line, "text1", 1.4, dash=EXACT_DASH, alpha=0.75)
            right = points[(points[:, 0] > row[0] + 1.6) & (points[:, 0] < frame.right - 1.0)]
            if len(right) and not named and canvas.teaching and len(model.content.nozzles) == 1:
                place = right[0]
                words = "exact envelope of free flight"
                canvas.label(tuple(place), words, "text1", anchor="left", offset=(14.0, -10.0))
                named = True

    def _draw_stones(self, canvas: Canvas) -> None:
        for x, y, radius, _, _, e in self.model.system.solids.rows.tolist():
            canvas.circle((x, y), radius, "body", 1.0, "text2", 2.0)
            if not canvas.teaching:
                continue
            handle = rim_handle(x, y, radius)
            canvas.line((x, y), handle, "text2", 1.4)
            canvas.dot((x, y), 2.5, "text1")
            canvas.handle(handle)
            if radius * canvas.pixels_per_unit > 34.0 * canvas.k:
                canvas.label((x, y), f"r {radius:.2f} m", "text1", offset=(0.0, 11.0), halo=False)
                canvas.label((x, y), f"e {e:.2f}", "text1", offset=(0.0, 25.0), halo=False)

    def _draw_nozzle(self, canvas: Canvas, index: int) -> None:
        model = self.model
        x, y, _, _, axis, spread = model.system.state().emitters[index, :6].tolist()
        ux, uy = math.sin(axis), math.cos(axis)
        body = [(-0.13, -0.13), (0.13, -0.13), (0.1, 0.0), (-0.1, 0.0)]
        corners = np.array([(x + a * uy + b * ux, y - a * ux + b * uy) for a, b in body])
        canvas.polygon(corners, fill="ghost", outline="text2", width=1.2)
        if not canvas.teaching:
            return
        if spread < 0.5 * math.pi and model.emitting:
            for side in (-1.0, 1.0):
                angle = axis + side * spread
                tip = (x + SPREAD_ARM * math.sin(angle), y + SPREAD_ARM * math.cos(angle))
                canvas.line((x, y), tip, "text1", 1.2, alpha=0.8)
            up = 0.5 * math.pi - axis
            canvas.arc((x, y), 0.82 * SPREAD_ARM, up - spread, up + spread, "text1", 1.2, alpha=0.8)
        edge = axis + min(spread, 0.5 * math.pi)
        place = (x + SPREAD_ARM * math.sin(edge), y + SPREAD_ARM * math.cos(edge))
        if index == 0:
            words = f"±{model.parameters.spread:.3g}°"
            canvas.label(place, words, "text1", size=13, anchor="left", offset=(14.0, 6.0))

    def _draw_wind(self, canvas: Canvas) -> None:
        frame, wind = self.model.content.view, self.model.parameters.wind
        middle = 0.5 * (frame.left + frame.right)
        length = 0.12 * (frame.right - frame.left)
        tail = (
            middle - 0.5 * math.copysign(length, wind),
            frame.top - 0.1 * (frame.top - frame.bottom),
        )
        part = wind / max(abs(wind), 4.0)
        canvas.arrow(tail, (part * length, 0.0), "green", "w")

    def _draw_vortex(self, canvas: Canvas) -> None:
        x, y = self.model.vortex_centre
        turn = math.copysign(1.0, self.model.parameters.whirl)
        for ring in range(1, 4):
            radius = 0.22 * ring
            start = 0.9 * ring
            canvas.arc((x, y), radius, start, start + turn * 4.6, "green", 1.4, alpha=0.9 - 0.2 * ring)
        if canvas.teaching:
            canvas.handle((x, y))
            canvas.label((x, y), "vortex", "green", offset=(0.0, -16.0))


def _round_up(speed: float) -> float:
    """The next speed that is three times a round number."""
    power = 10.0 ** math.floor(math.log10(speed))
    return next(factor * power for factor in THRICE_ROUND if factor * power >= speed * (1.0 - 1e-9))
