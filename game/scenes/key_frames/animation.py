"""A motion made ready to be played: key-frames, path, timing; and the curves that show it."""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.animation import Easing, Keyframes, PiecewiseCubic, Playback
from game.physics.effects import EffectSet
from game.physics.kernels import elementary, elementwise, linear
from game.scenes.key_frames.editing import AUTOMATIC, as_rows
from game.scenes.key_frames.level import Motion

PLACE, ANGLE = (0, 1), 2  # columns of the values
PLOT_POINTS = 361
FINEST = 1e-5  # of the length of the path: no line is asked to be nearer
TOP_SPEED = 1e6  # m/s; a curve of speeds is cut there


class Settings(NamedTuple):
    """What else shapes a motion: interpolation, and the switches of the panel."""

    interpolation: str
    closed: bool
    shortest: bool
    along_path: bool
    easing: str


class Animation:
    """The box's place and angle at any part of the second."""

    def __init__(self, motion: Motion, settings: Settings, effects: EffectSet) -> None:
        self.motion, self.settings = motion, settings
        self.rows = as_rows(motion)
        rows = self.rows
        if settings.closed:
            again = self.rows[:1].copy()
            again[0, 0] += 1.0
            rows = np.concatenate((self.rows, again))
        times, values = motion.start + rows[:, 0], rows[:, 1:4].copy()
        values[:, ANGLE] = np.radians(values[:, ANGLE])
        known: dict[str, Any] = {
            "angles": (ANGLE,) if settings.shortest else (), "loop": settings.closed, "geometry": PLACE,
        }  # fmt: skip
        if settings.interpolation == "bezier":
            automatic = Keyframes(times, values, "parabolic", **known).automatic_handles()
            known["handles"] = _with_given(automatic, rows)
        self.track = Keyframes(times, values, settings.interpolation, **known)
        easing = Easing(motion.timing if settings.easing == "own" else settings.easing)
        self.easing = easing
        self.playback = Playback(self.track, PLACE, easing, effects, motion.start, motion.start + 1.0)

    def pose(self, part: float) -> Floats:
        """x, y (m) and angle (rad) at a part of the second."""
        return self.poses(np.array([part]))[0]

    def poses(self, parts: Floats) -> Floats:
        """The same at many parts (k,), (k, 3)."""
        times = self.playback.key_times(parts)
        found = self.track.sample(times)
        if self.settings.along_path:
            found[:, ANGLE] = self.playback.heading_at(times)
        return found

    def key_time(self, part: float) -> float:
        """Time (s, of the slider) of what is shown at a part of the second."""
        found = float(self.playback.key_times(part)) - self.motion.start
        return min(max(found % 1.0 if self.settings.closed and found != 1.0 else found, 0.0), 1.0)

    def velocity(self, part: float) -> Floats:
        """Velocity (m/s) of the place at a part of the second."""
        speed = float(self.playback.speed(part))
        if self.playback.spread:
            heading = float(self.playback.heading(part))
            return speed * np.array([elementwise.cos(heading), elementwise.sin(heading)])
        rate = self.track.rate(float(self.playback.key_times(part)))[:2]
        size = float(np.sqrt(linear.product(rate, rate)))
        return rate * (speed / size) if size > 0.0 else np.zeros(2)

    def handles(self) -> Floats:
        """Control points (n, 2, 2) before and after each key, m; NaN where there is no piece at that side."""
        n = len(self.rows)
        points = np.full((n, 2, 2), np.nan)
        if self.track.handles is None:
            return points
        places, offsets = self.rows[:, 1:3], self.track.handles[:n, :, :2]
        gaps = np.diff(self.track.times)
        for i in range(n):
            if i < len(gaps) and gaps[i] > 0.0:
                points[i, 1] = places[i] + offsets[i, 1]
            if i > 0 and gaps[i - 1] > 0.0:
                points[i, 0] = places[i] + offsets[i, 0]
        if self.settings.closed and gaps[-1] > 0.0:
            points[0, 0] = places[0] + self.track.handles[n, 0, :2]
        return points

    def gap(self, index: int, before: bool) -> float:
        """Duration (s) of the piece before or after a key; 0 if there is none."""
        gaps = np.diff(self.track.times)
        if before and index == 0:
            return float(gaps[-1]) if self.settings.closed else 0.0
        place = index - before
        return float(gaps[place]) if place < len(gaps) else 0.0

    # -- what is drawn ------------------------------------------------------------------------------

    def runs(self) -> list[PiecewiseCubic]:
        """The path without its jumps: runs of pieces that meet."""
        path = self.playback.path
        if path is None or self.track.interpolation == "nearest":
            return []
        breaks = np.flatnonzero(np.diff(self.track.times) == 0.0)
        edges = [-1, *breaks.tolist(), path.pieces]
        spans = [(a + 1, b) for a, b in pairwise(edges) if b > a + 1]
        return [PiecewiseCubic(path.controls[a:b]) for a, b in spans]

    def chains(self, tolerance: float) -> list[Floats]:
        """Lines (k, 2) within a tolerance (m) of the path; kept for the tolerance last asked for.

        On a very long path, which no screen shows whole, within a hundred thousandth of it.
        """
        tolerance = max(tolerance, FINEST * self.length)
        if self._chains[0] != tolerance:
            self._chains = (tolerance, [run.flatten(tolerance) for run in self.runs()])
        return self._chains[1]

    _chains: tuple[float, list[Floats]] = (0.0, [])

    @cached_property
    def parts(self) -> Floats:
        """Parts of the second (k,) at which curves over time are drawn."""
        return np.linspace(0.0, 1.0, PLOT_POINTS)

    @cached_property
    def speeds(self) -> Floats:
        """Speed (k,) m/s at those, at the end that on arrival."""
        return np.minimum(self.playback.speed(np.minimum(self.parts, 1.0 - 1e-9)), TOP_SPEED)

    @cached_property
    def arrivals(self) -> Floats:
        """Part of the second (n,) at which each key is reached first; NaN for one that never is."""
        shown = self.playback.key_times(self.parts) - self.motion.start
        before, after = shown[:-1], shown[1:]
        steady = np.abs(after - before) < 0.5  # not where a closed curve begins again
        found = np.full(len(self.rows), np.nan)
        for i, time in enumerate(self.rows[:, 0].tolist()):
            reached = np.flatnonzero(steady & ((before - time) * (after - time) <= 0.0))
            if len(reached):
                k = int(reached[0])
                rise = after[k] - before[k]
                share = (time - before[k]) / rise if rise != 0.0 else 0.0
                found[i] = self.parts[k] + share * (self.parts[k + 1] - self.parts[k])
        return found

    @cached_property
    def length(self) -> float:
        """Length of the path, m."""
        path = self.playback.path
        return path.length if path is not None and self.track.interpolation != "nearest" else 0.0

    @cached_property
    def velocity_jump(self) -> float:
        """Largest change of velocity at an inner key, m/s."""
        times = self.track.times
        inner = times[1:-1]
        if self.track.interpolation == "nearest" or not len(inner):
            return 0.0
        eased = self.track.path(PLACE)
        lengths = np.diff(times)
        smooth = (lengths[:-1] > 0.0) & (lengths[1:] > 0.0)
        ends = 3.0 * (eased.controls[:-1, 3] - eased.controls[:-1, 2]) / np.maximum(lengths[:-1, None], 1e-9)
        begins = 3.0 * (eased.controls[1:, 1] - eased.controls[1:, 0]) / np.maximum(lengths[1:, None], 1e-9)
        change = np.sqrt((elementary.square(begins - ends)).sum(axis=1))[smooth]
        return float(np.max(change, initial=0.0))


def _with_given(automatic: Floats, rows: Floats) -> Floats:
    """Handles (n, 2, 3) with the places of keys that have velocities of their own."""
    handles = automatic.copy()
    gaps = np.diff(rows[:, 0], prepend=rows[-1, 0] - 1.0, append=rows[0, 0] + 1.0)
    given = np.flatnonzero(rows[:, 8] != AUTOMATIC)
    handles[given, 0, :2] = -rows[given, 6:8] * (gaps[given, None] / 3.0)
    handles[given, 1, :2] = rows[given, 4:6] * (gaps[given + 1, None] / 3.0)
    return handles
