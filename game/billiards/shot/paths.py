"""Points along the paths of balls, from the stretches of a played shot."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.lean import lean_kernel
from game.billiards.shot.trajectory import Trajectory

CURVED = 12  # points on a stretch that bends
FLIGHT = 17  # points on a flight
STRAIGHT = 1e-9  # m^2/s^3; velocity times acceleration across it, below which a stretch is straight


@lean_kernel
def trace_path(segments, order, first, last, start, end, out):
    """Points of one ball's path between two times to out (m, 2); how many. Its rows: order[first:last]."""
    count = 0
    for k in range(first, last):
        row = segments[order[k]]
        begins = row[s.SEG_TIME]
        ends = end
        if k + 1 < last:
            ends = min(end, segments[order[k + 1], s.SEG_TIME])
        t0 = max(begins, start)
        if ends < t0 or (ends == t0 and count > 0):
            continue
        vx = row[s.SEG_VX]
        vy = row[s.SEG_VY]
        ax = row[s.SEG_AX]
        ay = row[s.SEG_AY]
        pieces = CURVED if abs(vx * ay - vy * ax) > STRAIGHT else 1
        for piece in range(0 if count == 0 else 1, pieces + 1):
            if count == out.shape[0]:
                return count
            t = t0 + (ends - t0) * piece / pieces - begins
            out[count, 0] = row[s.SEG_X] + t * (vx + t * ax)
            out[count, 1] = row[s.SEG_Y] + t * (vy + t * ay)
            count += 1
    return count


class Paths:
    """Where the balls of a shot are, just before a moment, and on their paths; times in s."""

    def __init__(self, trajectory: Trajectory) -> None:
        self.segments = trajectory.segments
        balls = self.segments[:, s.SEG_BALL].astype(np.int64)
        count = len(trajectory.end)
        self.order = np.argsort(balls, kind="stable")
        self.starts = np.concatenate([[0], np.cumsum(np.bincount(balls, minlength=count))]).tolist()
        self._times = self.segments[self.order, s.SEG_TIME]
        self._points = np.empty((CURVED * len(self.order) + 2, 2))

    def moves(self, ball: int) -> bool:
        """True if a ball ever has a speed."""
        rows = self.order[self.starts[ball] : self.starts[ball + 1]]
        return bool(self.segments[rows, s.SEG_VX : s.SEG_VY + 1].any())

    def path(self, ball: int, start: float, end: float) -> Floats:
        """Points (n, 2) m of a ball's path between two times, n at least 1."""
        first, last = self.starts[ball], self.starts[ball + 1]
        count = trace_path(self.segments, self.order, first, last, start, end, self._points)
        return self._points[:count].copy()

    def stretch(self, ball: int, time: float) -> Floats:
        """The row of segments of a ball that ends at a time, or is not over then."""
        first, last = self.starts[ball], self.starts[ball + 1]
        k = max(int(np.searchsorted(self._times[first:last], time, side="left")) - 1, 0)
        return self.segments[self.order[first + k]]

    def in_air(self, ball: int, start: float, end: float, gravity: float) -> list[Floats]:
        """The flights of a ball between two times: points (FLIGHT, 3) m of each, with the height."""
        first, last = self.starts[ball], self.starts[ball + 1]
        times = [*self._times[first:last].tolist(), end]
        flights = []
        for k, row in enumerate(self.segments[self.order[first:last]]):
            begins, ends = max(times[k], start), min(times[k + 1], end)
            if row[s.SEG_MOTION] != s.AIRBORNE or begins >= ends:
                continue
            t = np.linspace(begins, ends, FLIGHT) - times[k]
            along = row[s.SEG_X : s.SEG_Y + 1] + t[:, None] * row[s.SEG_VX : s.SEG_VY + 1]
            flights.append(np.column_stack((along, row[s.SEG_Z] + t * (row[s.SEG_VZ] - 0.5 * gravity * t))))
        return flights

    def on_cloth(self, ball: int, start: float, end: float) -> list[Floats]:
        """The parts of a ball's path between two times that it does not fly: points (n, 2) m of each."""
        first, last = self.starts[ball], self.starts[ball + 1]
        times = [*self._times[first:last].tolist(), end]
        flies = (self.segments[self.order[first:last], s.SEG_MOTION] == s.AIRBORNE).tolist()
        parts, begins = [], start
        for k, flying in enumerate([*flies, True]):
            at = min(max(times[k], start), end)
            if flying and begins < at:
                parts.append(self.path(ball, begins, at))
            if flying:
                begins = min(max(times[min(k + 1, len(flies))], start), end)
        return parts

    def arriving(self, ball: int, time: float) -> tuple[tuple[float, float], tuple[float, float]]:
        """Place m and velocity m/s of a ball on the stretch that ends at a time."""
        row = self.stretch(ball, time)
        t = max(time - float(row[s.SEG_TIME]), 0.0)
        x, y, vx, vy, ax, ay = (
            float(row[c]) for c in (s.SEG_X, s.SEG_Y, s.SEG_VX, s.SEG_VY, s.SEG_AX, s.SEG_AY)
        )
        return (x + t * (vx + t * ax), y + t * (vy + t * ay)), (vx + 2.0 * t * ax, vy + 2.0 * t * ay)
