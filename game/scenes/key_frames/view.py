"""How the key-framing scene is drawn: path, onion skin, keys, the box, the timeline, the timing curve."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.animation import CONSTANT_SPEED, EASING, mix_rotations
from game.scenes.key_frames.animation import Animation
from game.scenes.key_frames.box import UNIT_BOX, box_corners, turning_handle
from game.scenes.key_frames.document import NOTHING
from game.scenes.key_frames.live_formula import draw_live_formula
from game.scenes.key_frames.model import KeyFrameModel
from game.scenes.key_frames.parameters import SHORT
from game.scenes.key_frames.timeline import Places, places_of, x_of
from game.ui.canvas.canvas import PREDICTION_DASH, Canvas
from game.ui.look.numerals import quantity

MOST_POSES = 40  # keys that are drawn as boxes; more would hide each other
MOST_TIMES = 14  # keys whose times are written
ARROW_SECONDS = 0.06  # s of motion that the arrow of velocity shows
LONGEST_ARROW = 2.2  # m
TALLEST = 6.0  # times the mean speed; faster moments leave the plot of speeds


def shades(canvas: Canvas, color: str, strengths: Floats) -> NDArray[np.uint32]:
    """A colour over the stage in several strengths (k,), 0 to 1."""
    over, under = canvas.color(color), canvas.color("stage")
    mixed = np.zeros(len(strengths))
    for channel, place in zip((0, 1, 2), (65536.0, 256.0, 1.0), strict=True):
        mixed += place * np.rint(under[channel] + strengths * (over[channel] - under[channel]))
    return mixed.astype(np.uint32)


class KeyFramingView:
    """Draws the model; keeps nothing but the times of the timing curve."""

    def __init__(self, model: KeyFrameModel) -> None:
        self._model, self._shown = model, model.parameters
        self._parts = np.linspace(0.0, 1.0, 61)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the marks mean."""
        keys = len(self._model.motion.keys)
        rows = [
            ("box:text1", "box now", f"{self._model.player.present():.2f} s"),
            ("ring:accent", "key-frames", str(keys)),
        ]
        if self._shown.onion:
            rows.append(("box:ghost", "onion skin", str(self._shown.onion)))
        if self._shown.interpolation != "nearest" and keys + self._shown.closed > 1:
            rows.append(("line:chalk", "path", f"{self._model.animation().length:.3g} m"))
        if self._shown.compare != "none":
            rows.append(("dash:pink", SHORT[self._shown.compare].lower(), ""))
        if self._shown.matrices:
            rows.append(("box:vermilion", "matrices mixed", ""))
        return rows

    def draw(self, canvas: Canvas) -> None:
        """All of it, from the back to the front."""
        animation, places = self._model.animation(), places_of(self._model.motion.view)
        canvas.grid(None, "")
        if self._shown.compare != "none":
            self._draw_compared(canvas)
        self._draw_path(canvas, animation)
        self._draw_onion(canvas, animation)
        if self._shown.interpolation == "bezier":
            self._draw_handles(canvas, animation)
        self._draw_keys(canvas)
        self._draw_box(canvas, animation)
        self._draw_timeline(canvas, animation, places)
        if self._shown.formula:
            view = self._model.motion.view
            draw_live_formula(canvas, self._model, (view.right, view.top))
        if EASING in self._model.active:
            self._draw_timing(canvas, animation, places)

    # -- on the stage -------------------------------------------------------------------------------

    def _draw_path(self, canvas: Canvas, animation: Animation) -> None:
        places = animation.track.values[:, :2]
        times = animation.track.times
        jumps = (
            np.flatnonzero(np.diff(times) == 0.0)
            if self._shown.interpolation != "nearest"
            else range(len(times) - 1)
        )
        for i in jumps:
            canvas.line(tuple(places[i]), tuple(places[i + 1]), "ghost", 1.2, dash=(2.0, 6.0))
        for chain in animation.chains(self._shown.tolerance):
            canvas.polyline(chain, "chalk", 2.2)
            if self._shown.corners:
                canvas.particles(chain, "text1", 2.4)

    def _draw_compared(self, canvas: Canvas) -> None:
        other = self._model.animation(self._shown.compare)
        for chain in other.chains(self._shown.tolerance):
            canvas.polyline(chain, "pink", 1.6, dash=PREDICTION_DASH)
        corners = box_corners(other.pose(self._model.player.shown_part()), self._model.motion.box)
        canvas.polygon(corners, outline="pink", width=1.6)

    def _draw_onion(self, canvas: Canvas, animation: Animation) -> None:
        count = int(self._shown.onion)
        if not count:
            return
        parts = (np.arange(count) + 0.5) / count
        apart = np.abs(parts - self._model.player.shown_part())
        apart = np.minimum(apart, 1.0 - apart) if self._shown.closed else apart
        strengths = 0.2 + 0.4 * np.maximum(0.0, 1.0 - apart / 0.25)
        order = np.argsort(strengths, kind="stable")  # the nearest in time on top
        corners = box_corners(animation.poses(parts[order]), self._model.motion.box)
        inks = np.repeat(shades(canvas, "ghost", strengths[order]), 4)
        canvas.segments(corners.reshape(-1, 2), np.roll(corners, -1, axis=1).reshape(-1, 2), inks, 1.2)

    def _draw_handles(self, canvas: Canvas, animation: Animation) -> None:
        for key, pair in zip(self._model.motion.keys, animation.handles(), strict=True):
            for point in pair:
                if np.isfinite(point).all():
                    canvas.line(key.position, tuple(point), "green", 1.4)
                    canvas.dot(tuple(point), 4.5, "stage")
                    canvas.ring(tuple(point), 4.5, "green", 2.0)

    def _draw_keys(self, canvas: Canvas) -> None:
        keys, box = self._model.motion.keys, self._model.motion.box
        poses = [(*key.position, math.radians(key.angle)) for key in keys]
        boxed = 0 < len(keys) <= MOST_POSES and self._shown.turning == "keys"
        boxes = box_corners(poses, box) if boxed else np.zeros((0, 4, 2))
        for i, key in enumerate(keys):
            chosen = i == self._model.document.chosen
            if boxed:
                color = "amber" if chosen else "text2"
                canvas.polygon(boxes[i], outline=color, width=1.4, alpha=1.0 if chosen else 0.7)
                tip = turning_handle(box, *poses[i])
                canvas.line(key.position, tip, color, 1.2, alpha=1.0 if chosen else 0.5)
                canvas.dot(tip, 3.4, color)
            canvas.handle(key.position)
            if chosen:
                canvas.ring(key.position, 9.0, "amber", 1.8)
            if len(keys) <= MOST_TIMES:
                canvas.label(key.position, f"{key.time:.2f} s", "text2", 11, offset=(0.0, 15.0), clear=True)

    def _draw_box(self, canvas: Canvas, animation: Animation) -> None:
        x, y, angle = pose = self._model.pose.tolist()
        box = self._model.motion.box
        corners = box_corners(pose, box)
        canvas.polygon(corners, fill="body", fill_alpha=0.9, outline="text1", width=2.4)
        if self._shown.matrices:
            self._draw_mixed(canvas, animation)
        nose = (x + 0.5 * box[0] * math.cos(angle), y + 0.5 * box[0] * math.sin(angle))
        canvas.line((x, y), nose, "text1", 1.6)
        if self._shown.turning == "keys":
            tip = turning_handle(box, x, y, angle)
            canvas.line(nose, tip, "accent", 1.4)
            canvas.handle(tip)
        canvas.dot((x, y), 4.5, "amber")
        if self._shown.velocity and self._model.document.held == NOTHING:
            arrow = animation.velocity(self._model.player.shown_part()) * ARROW_SECONDS
            length = math.sqrt(float(arrow @ arrow))
            arrow = arrow * min(1.0, LONGEST_ARROW / length) if length > 0.0 else arrow
            canvas.arrow((x, y), tuple(arrow), "chalk", "v")

    def _draw_mixed(self, canvas: Canvas, animation: Animation) -> None:
        """The box by rotation matrices mixed between the keys on either side."""
        track = animation.track
        time = float(animation.playback.key_times(self._model.player.shown_part()))
        i = int(np.clip(np.searchsorted(track.times, time, side="right") - 1, 0, max(len(track) - 2, 0)))
        j = min(i + 1, len(track) - 1)
        length = float(track.times[j] - track.times[i])
        share = min(max((time - float(track.times[i])) / length, 0.0), 1.0) if length > 0.0 else 0.0
        mixed = mix_rotations(float(track.values[i, 2]), float(track.values[j, 2]), share)
        x, y, _ = self._model.pose.tolist()
        corners = (UNIT_BOX * self._model.motion.box) @ mixed.T + (x, y)
        canvas.polygon(corners, fill="vermilion", fill_alpha=0.28, outline="vermilion", width=2.0)

    # -- over time ----------------------------------------------------------------------------------

    def _draw_timeline(self, canvas: Canvas, animation: Animation, places: Places) -> None:
        band, plot = places.band, places.plot
        seen = canvas.camera.visible()
        _, top = canvas.camera.to_screen(0.0, band.top)
        below = max(round(top), canvas.rect.y)
        if below < canvas.rect.bottom:
            foot = (canvas.rect.x, below, canvas.rect.w, canvas.rect.bottom - below)
            canvas.surface.fill(canvas.color("panel"), foot)
        canvas.line((seen.left, band.top), (seen.right, band.top), "line", 1.0)
        self._draw_speeds(canvas, animation, places, self._model.player.present() < 0.3)
        canvas.line((plot.left, places.axis), (plot.right, places.axis), "line2", 1.6)
        for tenth in range(11):
            x = x_of(places, 0.1 * tenth)
            canvas.line(
                (x, places.axis), (x, places.axis - canvas.px(5.0 if tenth % 5 else 8.0)), "line2", 1.2
            )
            if tenth % 2 == 0:
                words = f"{0.1 * tenth:.1f}" if 0 < tenth < 10 else ("0" if tenth == 0 else "1 s")
                canvas.label((x, places.axis), words, "text3", 11, offset=(0.0, 16.0), halo=False)
        self._draw_marks(canvas, animation, places)
        self._draw_playhead(canvas, places)

    def _draw_playhead(self, canvas: Canvas, places: Places) -> None:
        """The present time, with its number at the side where there is room."""
        now = self._model.player.present()
        x, top = x_of(places, now), places.plot.top + canvas.px(6.0)
        canvas.line((x, places.axis), (x, top), "amber", 1.6)
        w, h = canvas.px(6.0), canvas.px(9.0)
        canvas.polygon(np.array([(x, top - h), (x + w, top), (x - w, top)]), fill="amber")
        side = "right" if now > 0.9 else "left"
        offset = (-10.0 if side == "right" else 10.0, -2.0)
        canvas.label((x, top), f"{now:.3f} s", "amber", 12, "semibold", side, offset, halo=False)

    def _draw_speeds(self, canvas: Canvas, animation: Animation, places: Places, aside: bool) -> None:
        """Speed over time; ``aside``: its words at the right, as the present time is written at the left."""
        plot = places.plot
        speeds = animation.speeds
        most = min(float(speeds.max()), TALLEST * float(speeds.mean()))
        scale = (plot.top - plot.bottom) / most if most > 0.0 else 0.0
        beyond = float(speeds.max()) > most
        speeds = np.minimum(speeds, most)
        x = plot.left + animation.parts * (plot.right - plot.left)
        curve = np.column_stack((x, plot.bottom + speeds * scale))
        area = np.concatenate((curve, [(plot.right, plot.bottom), (plot.left, plot.bottom)]))
        if most > 0.0:
            canvas.polygon(area, fill="chalk", fill_alpha=0.16)
            canvas.polyline(curve, "chalk", 1.6)
        words = (
            f"Speed, {'beyond' if beyond else 'up to'} {' '.join(quantity(most, 'm/s'))}"
            if most > 0.0
            else "Speed: nothing moves"
        )
        corner, anchor = ((plot.right, plot.top), "right") if aside else ((plot.left, plot.top), "left")
        canvas.label(corner, words, "text2", 12, anchor=anchor, offset=(0.0, -8.0), halo=False)

    def _draw_marks(self, canvas: Canvas, animation: Animation, places: Places) -> None:
        """Diamonds at the times of keys, and where each is reached if that is another time."""
        timed = EASING in self._model.active or CONSTANT_SPEED in self._model.active
        arrivals = animation.arrivals.tolist() if timed else []
        for i, key in enumerate(self._model.motion.keys):
            x = x_of(places, key.time)
            if timed and math.isfinite(arrivals[i]):
                there = (x_of(places, arrivals[i]), places.plot.bottom)
                canvas.line((x, places.axis), there, "text3", 1.0)
                canvas.dot(there, 2.6, "text2")
            size = canvas.px(6.5)
            diamond = [
                (x, places.axis + size),
                (x + size, places.axis),
                (x, places.axis - size),
                (x - size, places.axis),
            ]
            color = "amber" if i == self._model.document.chosen else "accent"
            canvas.polygon(np.array(diamond), fill=color, outline="panel", width=1.2)

    def _draw_timing(self, canvas: Canvas, animation: Animation, places: Places) -> None:
        box = places.timing
        frame = np.array([box.at(0, 0), box.at(1, 0), box.at(1, 1), box.at(0, 1)])
        canvas.polygon(frame, fill="panel", fill_alpha=0.9, outline="line2", width=1.0)
        canvas.line(box.at(0, 0), box.at(1, 1), "line2", 1.0, dash=(4.0, 4.0))
        x1, y1, x2, y2 = self._model.document.timing()
        curve = np.column_stack((self._parts, animation.easing(self._parts)))
        canvas.line(box.at(0, 0), box.at(x1, y1), "green", 1.4)
        canvas.line(box.at(1, 1), box.at(x2, y2), "green", 1.4)
        canvas.polyline(np.array([box.at(x, y) for x, y in curve]), "chalk", 2.2)
        for spot in (box.at(x1, y1), box.at(x2, y2)):
            canvas.dot(spot, 4.5, "stage")
            canvas.ring(spot, 4.5, "green", 2.0)
        now = self._model.player.shown_part()
        canvas.dot(box.at(now, float(animation.easing(now))), 4.0, "amber")
        canvas.label(box.at(0.0, 1.0), "Timing curve", "text2", 12, anchor="right", offset=(-8.0, 8.0))
