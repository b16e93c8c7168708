"""Balls on tracks as a level makes them: stepped, changed by hand, measured by its gauges."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary
from game.physics.solids.tracks import Curve, TrackSettings, TrackState, TrackWorld
from game.physics.solids.tracks.motion import (
    BOUNCE,
    FREE,
    FRICTION,
    MASS,
    PIECE,
    RADIUS,
    SHARE,
    SPEED,
    SPIN,
    VX,
    VY,
    X,
    Y,
)
from game.scenes.tracks.level import BallEntry, GaugeEntry, TrackContent
from game.scenes.tracks.parameters import TrackParameters
from game.stage import Part
from game.worlds.entries.entry import Point
from game.worlds.entries.track_forms import curve_of
from game.worlds.stopwatch import Stopwatch

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
COLOURS = ("chalk", "green", "vermilion", "pink", "violet", "yellow", "amber")
OWN_FRICTION, OWN_RESTITUTION = 256, 512
TRAIL = 160  # places that are remembered of each ball
SHOWN_BALLS = 200  # most that have a trail
RIDERS = 50  # bits that a float holds, with some to spare
REACH = 0.6  # m, to the track on which a ball is seated
NOT_YET = 0.0


class TracksState(NamedTuple):
    """balls; tracks: points (v, 2) m, where each begins, its kind; what is remembered of balls and gauges."""

    balls: TrackState
    points: Floats
    starts: Longs
    kinds: Floats  # (m, 2) closed, corner
    tints: Longs
    energies: Floats  # (n,) J, of each ball when it was let go
    gauges: Floats  # (g, 3) value and two notes
    trail: Floats  # (TRAIL, n, 2)


class TracksModel(Part):
    """Balls and tracks. time s; steps: since the beginning."""

    def __init__(self, content: TrackContent, parameters: TrackParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        self.watch = Stopwatch()
        curves = [curve_of(entry, int(parameters.chords)) for entry in content.tracks]
        self.world = TrackWorld(curves, self._settings())
        self.tints: Longs = np.zeros(0, dtype=np.int64)
        self.energies: Floats = np.zeros(0)
        self.trail: Floats = np.zeros((TRAIL, 0, 2))
        for entry in content.balls:
            self.add(entry)
        for gauge in content.gauges:
            if gauge.of >= len(content.balls):
                raise ValueError(
                    f"gauges: {gauge.name!r} is of ball {gauge.of}; there are {len(content.balls)}"
                )
        self.gauges: Floats = np.zeros((len(content.gauges), 3))
        self.time, self.steps = 0.0, 0
        self._note_starts()

    def _settings(self) -> TrackSettings:
        pull = self.parameters.gravity if GRAVITY in self.active else 0.0
        return TrackSettings(self.parameters.substeps_now(), (0.0, -pull))

    def _note_starts(self) -> None:
        for k, gauge in enumerate(self.content.gauges):
            if gauge.measure == "arrives":
                self.gauges[k, 1] = math.copysign(1.0, gauge.level - self.world.balls.rows[gauge.of, X])

    # -- changes --------------------------------------------------------------------------------------

    def add(self, entry: BallEntry) -> int:
        """A ball; its number. ValueError."""
        parameters = self.parameters
        friction = parameters.friction if entry.friction is None else entry.friction
        bounce = parameters.restitution if entry.restitution is None else entry.restitution
        ball = self.world.add_ball(
            entry.position, entry.radius, entry.velocity, entry.spin,
            share=entry.share, mass=entry.mass, friction=friction, restitution=bounce,
        )  # fmt: skip
        tint = COLOURS.index(entry.colour)
        tint += OWN_FRICTION * (entry.friction is not None) + OWN_RESTITUTION * (
            entry.restitution is not None
        )
        self.tints = np.append(self.tints, tint)
        if entry.seated and self.world.put_down(ball, REACH) and entry.rolling:
            row = self.world.balls.rows[ball]
            row[SPIN] = -row[SPEED] / row[RADIUS]
        self.energies = np.append(self.energies, 0.0)
        place = self.world.balls.rows[ball, X : Y + 1]
        self.trail = np.concatenate([self.trail, np.broadcast_to(place, (TRAIL, 1, 2))], axis=1)
        self.note_energy(ball)
        return ball

    def note_energy(self, ball: int) -> None:
        """From now on its speed is compared with what this energy allows."""
        self.energies[ball] = float(self.world.energies()[ball].sum())

    def remove(self, ball: int) -> None:
        """Take a ball away."""
        self.world.remove_ball(ball)
        self.tints, self.energies = np.delete(self.tints, ball), np.delete(self.energies, ball)
        self.trail = np.delete(self.trail, ball, axis=1)

    def hold(self, ball: int, place: Point) -> None:
        """Put a ball somewhere, at rest and free."""
        row = self.world.balls.rows[ball]
        row[X : Y + 1] = place
        row[VX : VY + 1], row[SPIN], row[SPEED] = 0.0, 0.0, 0.0
        self.world.balls.pieces[ball] = FREE

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        self.world.settings = self._settings()
        rows = self.world.balls.rows
        if name == "friction":
            rows[self.tints & OWN_FRICTION == 0, FRICTION] = self.parameters.friction
        elif name == "restitution":
            rows[self.tints & OWN_RESTITUTION == 0, BOUNCE] = self.parameters.restitution
        elif name == "gravity":
            self.energies[:] = self.world.energies().sum(axis=1)
        self.watch.clear()

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.change_parameter("gravity")

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float, held: int) -> None:
        """One step; a ball that is held stays where it is."""
        balls = self.world.balls
        kept = None if held < 0 else (balls.rows[held].copy(), balls.pieces[held].copy())
        before = self.world.balls.rows[:, X : Y + 1].copy()
        on = self.world.balls.pieces[:, PIECE] != FREE
        with self.watch.time("step"):
            self.world.step(dt)
        if kept is not None:
            balls.rows[held], balls.pieces[held] = kept
        self.time += dt
        self.trail[self.steps % TRAIL] = self.world.balls.rows[:, X : Y + 1]
        self.steps += 1
        for k, gauge in enumerate(self.content.gauges):
            if gauge.measure == "past":
                self.gauges[k, 0] = np.count_nonzero(self.world.balls.rows[:, X] > gauge.level)
            elif gauge.measure == "rode":
                self._count_riders(self.gauges[k], gauge.level)
            elif gauge.of < len(on):
                self._measure(k, gauge, before[gauge.of], bool(on[gauge.of]), dt)

    def _measure(self, k: int, gauge: GaugeEntry, before: Floats, on: bool, dt: float) -> None:
        row, noted = self.world.balls.rows[gauge.of], self.gauges[k]
        x, y = row[X : Y + 1].tolist()
        moved = x - float(before[0])
        crossing = self.time - dt * (x - gauge.level) / moved if moved != 0.0 else self.time
        if gauge.measure == "arrives" and noted[0] == NOT_YET and (x - gauge.level) * noted[1] >= 0.0:
            noted[0] = crossing
        elif gauge.measure == "period" and float(before[0]) > gauge.level >= x:
            noted[0] = crossing - noted[1] if noted[1] > 0.0 else 0.0
            noted[1] = crossing
        elif gauge.measure == "leaves" and noted[0] == NOT_YET and on:
            if self.world.balls.pieces[gauge.of, PIECE] == FREE:
                noted[0] = math.degrees(elementary.atan2(abs(x - gauge.about[0]), y - gauge.about[1]))
        elif gauge.measure == "speed":
            noted[0] = elementary.hypot(row[VX], row[VY])
        elif gauge.measure == "high":
            noted[0] = y

    def _count_riders(self, noted: Floats, level: float) -> None:
        """noted: how many, and the numbers of those that flew or came, as bits."""
        flown, come = int(noted[1]), int(noted[2])
        balls = self.world.balls
        for ball in range(min(len(balls.rows), RIDERS)):
            if balls.rows[ball, X] > level and not flown >> ball & 1:
                come |= 1 << ball
            elif balls.pieces[ball, PIECE] == FREE and not come >> ball & 1:
                flown |= 1 << ball
        noted[:] = come.bit_count(), flown, come

    # -- what is there --------------------------------------------------------------------------------

    def exact_speed(self, ball: int) -> float:
        """m/s that the ball's energy allows at its height, if nothing ever slipped or struck."""
        row = self.world.balls.rows[ball]
        _, turning, height = self.world.energies()[ball].tolist()
        left = self.energies[ball] - height
        if self.world.balls.pieces[ball, PIECE] == FREE:
            return math.sqrt(max(0.0, 2.0 * (left - turning) / row[MASS]))
        share = row[SHARE] if row[FRICTION] > 0.0 else 0.0
        return math.sqrt(max(0.0, 2.0 * left / (row[MASS] * (1.0 + share))))

    def state(self) -> TracksState:
        """All that later steps depend on."""
        arrays = [np.asarray(curve.points, dtype=np.float64) for curve in self.world.curves]
        counts = np.cumsum([0, *(len(array) for array in arrays)]).astype(np.int64)
        return TracksState(
            self.world.state(),
            np.concatenate(arrays) if arrays else np.zeros((0, 2)),
            counts,
            np.array([(float(c.closed), c.corner) for c in self.world.curves]).reshape(-1, 2),
            self.tints, self.energies, self.gauges, self.trail,
        )  # fmt: skip

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        now = self.state()
        same = now.points.shape == state.points.shape and np.array_equal(now.starts, state.starts)
        if not same or not np.array_equal(now.points, state.points):
            ends = state.starts.tolist()
            self.world = TrackWorld(
                [
                    Curve(state.points[a:b].copy(), bool(closed), float(corner))
                    for a, b, (closed, corner) in zip(ends[:-1], ends[1:], state.kinds.tolist(), strict=True)
                ],
                self.world.settings,
            )
        self.world.restore(state.balls)
        self.tints, self.energies = state.tints.copy(), state.energies.copy()
        self.gauges, self.trail = state.gauges.copy(), state.trail.copy()
