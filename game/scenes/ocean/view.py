"""How the ocean is drawn: sky, sun, waves to the horizon, boat, spray, rain; the boat once more from
astern."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.waves.sea import LEVEL, SLOPE_Z
from game.physics.waves.sections import AREA, MIDDLE_Y, MIDDLE_Z
from game.scenes.ocean.boat import BEAM, LENGTH, SAILED, SPEED, STATIONS
from game.scenes.ocean.painting import SKIES, SUNS, light_of
from game.scenes.ocean.vessel import Vessel
from game.scenes.ocean.weather import DX, DY, DZ
from game.scenes.ocean.world import CREST, LOST, STORM, OceanState, OceanWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.painters.wall import is_dark
from game.worlds.hands.hand import Hand
from game.worlds.painting.clouds import BRIGHT, draw_sky
from game.worlds.painting.inks import color_of
from game.worlds.painting.sea.cuts import AWAY, HORIZON, Wake, projected, shrink
from game.worlds.painting.sea.painter import SeaPainter, Water

DRIFT = 7.0  # px/s of clouds
MIRRORED = 6.5  # m to both sides, in which the water mirrors the boat
WAVE_HIGH = 1.1  # m of the boat's waves at a Froude number of 1
INSET, INSET_M = 0.27, 4.6  # of the height in view; m across of what is seen from astern
GREY = 0xC9D4DA


class OceanView:
    """Draws a model and its hand."""

    def __init__(self, model: OceanWorld, hand: Hand):
        self.model, self.hand = model, hand
        self.vessel, self.painter = Vessel(model.boat), SeaPainter()
        self._asked = False

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean."""
        marks = [("disc:amber", "middle of mass", ""), ("disc:green", "middle of the water's lift", "")]
        return marks if self._asked or self.model.parameters.astern else []

    def draw(self, canvas: Canvas, previous: OceanState | None, alpha: float) -> None:
        """All of it, ``alpha`` of the way from the state ``previous`` to now."""
        model, late = self.model, is_dark(canvas)
        storm, sailed = float(model.air[STORM]), float(model.boat.pose[SAILED])
        seen = canvas.camera.visible()
        eye, sun = 0.5 * (seen.left + seen.right), SUNS[late]
        shift = DRIFT * canvas.k * model.time + 0.6 * sailed
        sky = draw_sky(canvas, HORIZON, SKIES[late], sun, shift, storm)
        tall = sky.turns.shape[0] / canvas.pixels_per_unit if sky is not None else 1.0
        to = (sun.across - 0.5) * (seen.right - seen.left), sun.up * tall, AWAY
        far = math.hypot(*to)
        light = light_of(late, storm, (to[0] / far, to[1] / far, to[2] / far))
        bands = sky.bands if sky is not None else np.zeros((2, BRIGHT, 3))
        rows, gravity, wind = model.sea.rows, model.gravity(), model.wind()
        water = Water(
            rows, light, bands[0] + storm * (bands[1] - bands[0]), gravity, math.hypot(*wind),
            np.array((math.fmod(sailed, 512.0), 0.0)), storm, self._wake(gravity),
        )  # fmt: skip
        self.painter.ripples.make(rows, wind, sailed, model.time)
        self.painter.paint(canvas, water, near=False)
        pose = self.vessel.pose(previous, alpha)
        pixels, clip = canvas.raster_target
        edges = [int(canvas.place((x, 0.0))[0]) for x in (-MIRRORED, MIRRORED)]
        left, right = (min(max(edge, int(clip[0])), int(clip[2])) for edge in edges)
        bare = pixels[:, left:right].copy()
        self._draw_drops(canvas, eye, True)
        self.vessel.draw(canvas, eye, pose, light, wind)
        self.painter.paint(canvas, water, True, bare, left)
        self._draw_drops(canvas, eye, False)
        self._draw_rain(canvas, eye, late)
        self._asked = canvas.asked
        if canvas.marks(False):
            self._draw_marks(canvas)
        if model.parameters.astern:
            self._draw_astern(canvas, pose)
        if self.hand.point is not None:
            canvas.ring(self.hand.point, 9.0, "amber", 2.0)

    def _wake(self, gravity: float) -> Wake:
        """Of the boat as it goes now."""
        speed = max(float(self.model.boat.pose[SPEED]), 0.0)
        froude = speed / math.sqrt(max(gravity, 0.1) * LENGTH)
        return Wake(-0.5 * LENGTH, 0.5 * LENGTH, 0.5 * BEAM, speed, WAVE_HIGH * min(froude, 0.6) ** 2)

    # -- what flies -------------------------------------------------------------------------------------

    def _draw_drops(self, canvas: Canvas, eye: float, behind: bool) -> None:
        drops = self.model.spray.drops
        drops = drops[(drops[:, DZ] > 0.0) == behind]
        if not len(drops):
            return
        at = projected(eye, drops[:, DX], drops[:, DY], drops[:, DZ])
        size = np.maximum(drops[:, 7] * shrink(drops[:, DZ]), canvas.px(0.7))
        speed = float(self.model.boat.pose[3])
        back = drops[:, :3] - 0.035 * (drops[:, 3:6] - (speed, 0.0, 0.0))
        canvas.discs(at, 3.2 * size, color_of(0xDCE8EE), 0.05)
        tails = projected(eye, back[:, 0], back[:, 1], back[:, 2])
        canvas.segments(at, tails, color_of(0xF4FAFC), 1.3, 0.35)
        canvas.discs(at, 0.5 * size, color_of(0xF8FCFF), 0.8)

    def _draw_rain(self, canvas: Canvas, eye: float, late: bool) -> None:
        rain = self.model.rain
        if not rain.falling:
            return
        drops = rain.drops[: rain.falling]
        one = projected(eye, drops[:, 0], drops[:, 1], drops[:, 2])
        speed = float(self.model.boat.pose[3])
        back = drops[:, :3] - 0.045 * (drops[:, 3:] - (speed, 0.0, 0.0))
        other = projected(eye, back[:, 0], back[:, 1], back[:, 2])
        near = drops[:, 2] < 6.0
        for part, width, veil in ((near, 1.3, 0.5), (~near, 0.8, 0.32)):
            canvas.segments(one[part], other[part], color_of(GREY if late else 0xE4ECEF), width, veil)

    # -- marks ------------------------------------------------------------------------------------------

    def _draw_marks(self, canvas: Canvas) -> None:
        """The cut of the sea through the boat, forces of wind and water, the crest that is followed."""
        model = self.model
        seen = canvas.camera.visible()
        x = np.linspace(seen.left, seen.right, 200)
        level = model.sea.at(np.stack([x, 0.0 * x], axis=1))[:, LEVEL]
        canvas.polyline(np.stack([x, level], axis=1), "text1", 1.4, dash=EXACT_DASH)
        drive = float(model.boat.forces[0])
        canvas.arrow(model.seen(0.0, 3.8, 0.0), (drive / 400.0, 0.0), "amber", "F", 1.0)
        canvas.arrow(model.seen(0.0, 9.4, 0.0), (0.3 * model.wind()[0], 0.0), "chalk", "w", 1.0)
        if model.air[CREST] != LOST:
            at = float(model.air[CREST])
            high = float(model.sea.at(np.array([[at, 0.0]]))[0, LEVEL])
            canvas.arrow((at, high + 0.4), (0.4 * model.swell_by_law(), 0.0), "green", "c", 1.0)

    def _draw_astern(self, canvas: Canvas, pose: Any) -> None:
        """The boat in cross section from astern, the wind from the left: water line, weight and lift."""
        seen = canvas.camera.visible()
        tall = seen.top - seen.bottom
        side = INSET * tall
        low = (seen.right - side - 0.025 * tall, seen.bottom + 0.2 * tall)
        high = (low[0] + side, low[1] + side)
        box = np.array((low, (high[0], low[1]), high, (low[0], high[1])))
        with canvas.within(low, high):
            canvas.polygon(box, fill="stage", fill_alpha=0.88)
            self._draw_section(
                canvas, (0.5 * (low[0] + high[0]), low[1] + 0.42 * side), side / INSET_M, pose, low, high
            )
        canvas.polygon(box, outline="line2", width=1.4)
        canvas.label((low[0], high[1]), "from astern", "text2", 12, anchor="topleft", offset=(7.0, 5.0))
        heel = math.degrees(math.remainder(pose[2], math.tau))
        words = f"{abs(heel):.0f}°"
        canvas.label(
            (high[0], high[1]), canvas.figure("heel", words), "text1", 13, "semibold", "topright", (-7.0, 5.0)
        )

    def _draw_section(self, canvas: Canvas, at: Any, scale: float, pose: Any, low: Any, high: Any) -> None:
        model, hull = self.model, self.model.boat.hull
        water = model.sea.at(np.zeros((1, 2)))[0]
        c, s = math.cos(pose[2]), math.sin(pose[2])

        def laid(points: Floats) -> Floats:
            y, z = points[:, 1], points[:, 0]
            return np.stack([at[0] + scale * (z * c + y * s), at[1] + scale * (y * c - z * s)], axis=1)

        base = at[1] + scale * (float(water[LEVEL]) - pose[0])
        slope = float(water[SLOPE_Z])
        half = 0.5 * (high[0] - low[0])
        surface = np.array(((low[0], base - slope * half), (high[0], base + slope * half)))
        canvas.polygon(np.array((low, (high[0], low[1]), surface[1], surface[0])), color_of(0x2C7DA0), 0.4)
        middle = hull.sections[STATIONS // 2]
        offset = np.array((0.0, -model.boat.middle_y))
        mast = laid(np.array([(0.0, 0.72), (0.0, 5.5)]) + offset)
        canvas.polyline(mast, color_of(0xC8964E), 3.0)
        canvas.polygon(
            laid(np.array([(-0.05, -0.5), (0.05, -0.5), (0.05, -1.2), (-0.05, -1.2)]) + offset), "text2"
        )
        canvas.polygon(laid(middle), "body", outline="text2", width=1.6)
        canvas.polyline(surface, "chalk", 1.8)
        areas = hull.cuts[:, AREA]
        total = float(np.sum(areas))
        canvas.arrow((at[0], at[1]), (0.0, -0.75 * scale), "amber", "", 1.0)
        canvas.dot((at[0], at[1]), 4.0, "amber")
        if total > 1e-6:
            z = float(np.sum(areas * hull.cuts[:, MIDDLE_Z])) / total
            y = float(np.sum(areas * hull.cuts[:, MIDDLE_Y])) / total
            lift = (at[0] + scale * z, at[1] + scale * y)
            canvas.arrow(lift, (-0.75 * scale * slope, 0.75 * scale), "green", "", 1.0)
            canvas.dot(lift, 4.0, "green")
        across = model.wind()[1]
        if abs(across) > 0.5:
            start = (low[0] + 0.06 * (high[0] - low[0]), low[1] + 0.78 * (high[1] - low[1]))
            canvas.arrow(start, (0.011 * across * (high[0] - low[0]), 0.0), "chalk", "", 1.0)
