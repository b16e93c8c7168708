"""Tracks and the balls that ride on them: laid, bent, kept, and written again as a level's."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from game.arrays import Floats, Point
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.solids.tracks import Curve, TrackSettings, TrackWorld
from game.physics.solids.tracks import motion as m
from game.stage import Parameters
from game.worlds.entries.tracks import TrackEntry, curve_of
from game.worlds.members.solids import substeps_of
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member

REACH = 0.6  # m, to the track on which a ball is seated


class Tracks(Member):
    """``riders``: all balls, as they ride and fly. chords: how many points a formula has, 0: as it says."""

    def __init__(
        self, entries: Sequence[TrackEntry], parameters: Parameters, active: EffectSet, chords: int = 0
    ):
        self.parameters, self.active, self.watch = parameters, active, Stopwatch()
        self.riders = TrackWorld([curve_of(entry, chords) for entry in entries], self._settings())

    def _settings(self) -> TrackSettings:
        pull = self.parameters.values["gravity"] if GRAVITY in self.active else 0.0
        return TrackSettings(substeps_of(self.parameters), (0.0, -pull))

    def change(self, name: str) -> None:
        self.riders.settings = self._settings()
        self.watch.clear()

    def change_effects(self, active: EffectSet) -> None:
        self.active = active
        self.change("")

    def lay(self, curves: list[Curve]) -> None:
        """Other tracks; balls find theirs by its place. ValueError for one that cannot be."""
        self.riders.set_curves(curves, REACH)

    def hold(self, ball: int, place: Point) -> None:
        """Put a ball somewhere, at rest and free."""
        row = self.riders.balls.rows[ball]
        row[m.X : m.Y + 1] = place
        row[m.VX : m.VY + 1], row[m.SPIN], row[m.SPEED] = 0.0, 0.0, 0.0
        self.riders.balls.pieces[ball] = m.FREE

    def rolling(self) -> Any:
        """(n,) which balls roll on a track."""
        return self.riders.balls.pieces[:, m.PIECE] != m.FREE

    def entries(self) -> tuple[TrackEntry, ...]:
        """The tracks as they are now, point by point."""
        return tuple(
            TrackEntry(
                points=tuple((float(x), float(y)) for x, y in np.asarray(curve.points)),
                closed=curve.closed, corner=curve.corner,
            )
            for curve in self.riders.curves
        )  # fmt: skip

    def state(self) -> tuple[Any, ...]:
        """Balls; points (v, 2) m of the tracks, first of each (k + 1,), whether closed and corner (k, 2)."""
        curves = self.riders.curves
        arrays = [np.asarray(curve.points, dtype=np.float64) for curve in curves]
        starts = np.cumsum([0, *(len(array) for array in arrays)]).astype(np.int64)
        kinds = np.array([(float(c.closed), c.corner) for c in curves]).reshape(-1, 2)
        return self.riders.state(), np.concatenate([np.zeros((0, 2)), *arrays]), starts, kinds

    def restore(self, fields: Iterator[Any]) -> None:
        balls, points, starts, kinds = (next(fields) for _ in range(4))
        _, points_now, starts_now, _ = self.state()
        if not (np.array_equal(starts_now, starts) and np.array_equal(points_now, points)):
            ends = starts.tolist()
            curves = [
                Curve(points[a:b].copy(), bool(closed), float(corner))
                for a, b, (closed, corner) in zip(ends[:-1], ends[1:], kinds.tolist(), strict=True)
            ]
            self.riders = TrackWorld(curves, self.riders.settings)
        self.riders.restore(balls)


def balls_between(
    now: Floats, before: Floats | None, alpha: float, jump: float = math.inf
) -> tuple[Floats, Floats]:
    """Places (n, 2) m and angles (n,) rad of balls, ``alpha`` of the way from rows of a state to now. Those
    that have moved by more than ``jump`` (m) were put where they are, and are there at once.
    """
    places, angles = now[:, m.X : m.Y + 1], now[:, m.ANGLE]
    if before is None or before.shape != now.shape:
        return places, angles
    moved = places - before[:, m.X : m.Y + 1]
    share = np.where(np.abs(moved).max(axis=1, initial=0.0) > jump, 0.0, 1.0 - alpha)
    places = places - share[:, None] * moved
    return places, angles - share * (angles - before[:, m.ANGLE])
