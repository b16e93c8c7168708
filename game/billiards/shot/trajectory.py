"""What came of a shot: events, the state at any moment, the end, a digest."""

from __future__ import annotations

import hashlib
import math
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.orientation import spin_in_segment, turn_in_segment, turns_at_starts
from game.billiards.laws.state import EVENTS, MOTIONS
from game.billiards.shot.shot import Shot
from game.physics.kernels import linear


class Event(NamedTuple):
    """One event: type (`state.EVENTS`), time (s), ids of the ball or balls and the element in it."""

    type: str
    time: float
    ids: tuple[str, ...]


class TableState(NamedTuple):
    """All balls at one time (s).

    positions, velocities (n, 2) SI; spins (n, 3) rad/s; motions (n,), numbers of `state.MOTIONS`.
    """

    time: float
    positions: Floats
    velocities: Floats
    spins: Floats
    motions: NDArray[np.int64]


@lean_kernel
def segment_rows_at(segments, order, starts, time, rows):
    """Row of the segment that each ball is on at a time, to rows (n,). order, starts as in `orientation`."""
    for ball in range(rows.shape[0]):
        low = starts[ball]
        high = starts[ball + 1]
        while high - low > 1:
            middle = (low + high) // 2
            if segments[order[middle], s.SEG_TIME] <= time:
                low = middle
            else:
                high = middle
        rows[ball] = order[low]


@lean_kernel
def states_at(segments, rows, time, radii, physics, out):
    """Closed form of each ball on its segment: x, y, vx, vy, wx, wy, wz to out (n, 7)."""
    for ball in range(rows.shape[0]):
        segment = segments[rows[ball]]
        t = max(time - segment[s.SEG_TIME], 0.0)
        ax = segment[s.SEG_AX]
        ay = segment[s.SEG_AY]
        out[ball, 0] = segment[s.SEG_X] + t * (segment[s.SEG_VX] + t * ax)
        out[ball, 1] = segment[s.SEG_Y] + t * (segment[s.SEG_VY] + t * ay)
        out[ball, 2] = segment[s.SEG_VX] + 2.0 * t * ax
        out[ball, 3] = segment[s.SEG_VY] + 2.0 * t * ay
        wx, wy, wz = spin_in_segment(segment, t, radii[ball], physics)
        out[ball, 4] = wx
        out[ball, 5] = wy
        out[ball, 6] = wz


@lean_kernel
def turns_at(segments, rows, time, radii, physics, starting, turns):
    """Quaternions at a time, from `starting` (s, 4), at their segments' starts, to turns (n, 4)."""
    for ball in range(rows.shape[0]):
        row = rows[ball]
        for k in range(4):
            turns[ball, k] = starting[row, k]
        turn_in_segment(
            segments[row], max(time - segments[row, s.SEG_TIME], 0.0), radii[ball], physics, turns[ball]
        )


class Trajectory:
    """A played shot.

    rows (e, 4): the events as numbers: time (s), type, ball, ball or element. segments (s, 12): the stretches
    of the balls' paths, see `state`, in the table's frame. end (n, 11): the balls at end_time (s). If balls
    fly, both have two more columns, for heights and vertical speeds.
    """

    def __init__(self, shot: Shot, rows: Floats, segments: Floats, end: Floats, end_time: float) -> None:
        self.shot = shot
        self.rows = rows
        self.segments = segments
        self.end = end
        self.end_time = end_time

    @property
    def times(self) -> Floats:
        """Times of the events (e,), s."""
        return self.rows[:, 0]

    @cached_property
    def events(self) -> list[Event]:
        """Events in order of time, with the ids of the shot."""
        shot = self.shot
        elements = {
            s.BALL_CUSHION: shot.cushion_ids,
            s.BALL_JAW: shot.jaw_ids,
            s.BALL_POCKET: shot.pocket_ids,
        }
        events = []
        for time, number, ball, other in self.rows.tolist():
            code, i, j = int(number), int(ball), int(other)
            ids: tuple[str, ...] = (shot.ids[i],)
            if code == s.BALL_BALL:
                ids = (shot.ids[i], shot.ids[j])
            elif code in elements:
                ids = (shot.ids[i], elements[code][j])
            events.append(Event(EVENTS[code], time, ids))
        return events

    @cached_property
    def final(self) -> dict[str, tuple[float, float] | str]:
        """Where each ball ended, by id: (x, y) m, or "pocketed", or "off the table"."""
        places: dict[str, tuple[float, float] | str] = {}
        for name, row in zip(self.shot.ids, self.end.tolist(), strict=True):
            motion = int(row[s.IN_MOTION])
            places[name] = MOTIONS[motion] if motion in (s.POCKETED, s.OFF_TABLE) else (row[0], row[1])
        return places

    @cached_property
    def digest(self) -> str:
        """Hash of all events and the end: equal for equal bits."""
        hasher = hashlib.blake2b(digest_size=16)
        for array in (self.rows, self.end[:, : s.IN_COLUMNS]):
            hasher.update(np.ascontiguousarray(array).tobytes())
        return hasher.hexdigest()

    def state_at(self, time: float) -> TableState:
        """State at any time (s) in closed form; before 0 that of 0, after the end that of the end."""
        time = self._within(time)
        rows = self._rows_at(time)
        out = np.empty((len(rows), 7))
        states_at(self.segments, rows, time, self._radii, self.shot.constants, out)
        motions = self.segments[rows, s.SEG_MOTION].astype(np.int64)
        return TableState(time, out[:, 0:2], out[:, 2:4], out[:, 4:7], motions)

    def heights_at(self, time: float) -> Floats:
        """How high each ball is above where it lies on the slate (n,), m; time as in `state_at`."""
        return self.rises_at(time)[0]

    def rises_at(self, time: float) -> tuple[Floats, Floats]:
        """Heights (n,) m and vertical speeds (n,) m/s; time as in `state_at`."""
        n = len(self.end)
        if not self.shot.flies or not len(self.segments):
            return np.zeros(n), np.zeros(n)
        rows = self.segments[self._rows_at(self._within(time))]
        t = np.where(rows[:, s.SEG_MOTION] == s.AIRBORNE, self._within(time) - rows[:, s.SEG_TIME], 0.0)
        gravity = self.shot.physics.gravity
        return rows[:, s.SEG_Z] + t * (rows[:, s.SEG_VZ] - 0.5 * gravity * t), rows[:, s.SEG_VZ] - gravity * t

    def orientations_at(self, time: float, starting: ArrayLike | None = None) -> Floats:
        """Rotation matrices (n, 3, 3), ball to table, at a time (s); `starting` (n, 3, 3): at time 0."""
        time = self._within(time)
        rows = self._rows_at(time)
        q = np.empty((len(rows), 4))
        turns_at(self.segments, rows, time, self._radii, self.shot.constants, self._starting_turns, q)
        matrices = rotation_matrices(q)
        return (
            matrices if starting is None else linear.product(matrices, np.asarray(starting, dtype=np.float64))
        )

    def _within(self, time: float) -> float:
        if math.isnan(time):
            raise ValueError("time: must be a number, got nan")
        return min(max(float(time), 0.0), self.end_time)

    def _rows_at(self, time: float) -> NDArray[np.int64]:
        order, starts = self._by_ball
        rows = np.empty(len(self.end), np.int64)
        segment_rows_at(self.segments, order, starts, time, rows)
        return rows

    @cached_property
    def _radii(self) -> Floats:
        return np.ascontiguousarray(self.end[:, s.IN_RADIUS])

    @cached_property
    def _by_ball(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Rows of the segments ball by ball, and where each ball's begin."""
        balls = self.segments[:, s.SEG_BALL].astype(np.int64)
        order = np.argsort(balls, kind="stable").astype(np.int64)
        starts = np.concatenate([[0], np.cumsum(np.bincount(balls, minlength=len(self.end)))]).astype(
            np.int64
        )
        return order, starts

    @cached_property
    def _starting_turns(self) -> Floats:
        order, starts = self._by_ball
        turns = np.empty((len(self.segments), 4))
        turns_at_starts(self.segments, order, starts, self._radii, self.shot.constants, turns)
        return turns


def rotation_matrices(q: Floats) -> Floats:
    """Rotation matrices (n, 3, 3) of unit quaternions (n, 4), scalar first."""
    w, x, y, z = q.T
    rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
    return np.ascontiguousarray(np.moveaxis(np.array(rows), 2, 0))
