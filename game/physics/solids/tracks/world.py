"""A world of tracks and balls: owns the arrays, checks what comes in, steps."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Ints
from game.physics.kernels import elementary, elementwise
from game.physics.solids.shapes import checked_number, checked_pair
from game.physics.solids.tracks import motion
from game.physics.solids.tracks.curves import TRACK, Curve, grid_of, pieces_of
from game.physics.solids.tracks.motion import settle_balls, step_balls

DISC, SPHERE = 0.5, 0.4  # I / (m r²)
MOST_BALLS = 20_000


class Balls(NamedTuple):
    """rows (n, BALL_WIDTH), pieces (n, 2): see `motion`."""

    rows: Floats
    pieces: Ints


class TrackState(NamedTuple):
    """All that later steps depend on beside the tracks."""

    rows: Floats
    pieces: Ints


@dataclass(frozen=True, slots=True)
class TrackSettings:
    """substeps of a step, 1 to 1000; gravity (x, y) m/s². ValueError, naming the field."""

    substeps: int = 4
    gravity: tuple[float, float] = (0.0, -9.81)

    def __post_init__(self) -> None:
        if (
            isinstance(self.substeps, bool)
            or not isinstance(self.substeps, int)
            or not 1 <= self.substeps <= 1000
        ):
            raise ValueError(f"substeps = {self.substeps!r}: expected a whole number, 1 to 1000")
        checked_pair("gravity", self.gravity)


class TrackWorld:
    """Balls on tracks, each by itself: they do not touch one another."""

    def __init__(self, curves: list[Curve] | None = None, settings: TrackSettings | None = None):
        self.settings = settings or TrackSettings()
        self.balls = Balls(np.zeros((0, motion.BALL_WIDTH)), np.zeros((0, 2), dtype=np.int32))
        self.curves: list[Curve] = []
        self._lay(list(curves or []))

    def _lay(self, curves: list[Curve]) -> None:
        self.pieces = pieces_of(curves)
        self.curves = curves
        self.grid = grid_of(self.pieces.boxes)

    def set_curves(self, curves: list[Curve], margin: float = 0.5) -> None:
        """Other tracks: balls stay on the ones of their number, if these moved by no more than margin m; none
        gets faster by it. ValueError: nothing is changed.
        """
        on = self.balls.pieces[:, motion.PIECE]
        tracks = np.full(len(on), motion.FREE, dtype=np.int32)
        rolling = on != motion.FREE
        tracks[rolling] = self.pieces.rows[on[rolling], TRACK].astype(np.int32)
        self._lay(list(curves))
        settle_balls(self.pieces, self.balls, tracks, float(margin))

    def add_ball(
        self, position: ArrayLike, radius: float, velocity: ArrayLike = (0.0, 0.0), spin: float = 0.0, *,
        share: float = DISC, mass: float = 1.0, friction: float = 0.6, restitution: float = 0.0,
    ) -> int:  # fmt: skip
        """A ball, free; its number. share: I/(m r²), above 0 to 1. ValueError for nonsense."""
        if len(self.balls.rows) >= MOST_BALLS:
            raise ValueError(f"balls: at most {MOST_BALLS}")
        row = np.zeros(motion.BALL_WIDTH)
        row[motion.X : motion.Y + 1] = checked_pair("position", position)
        row[motion.VX : motion.VX + 2] = checked_pair("velocity", velocity)
        row[motion.SPIN] = checked_number("spin", spin, -1e6, 1e6)
        row[motion.RADIUS] = checked_number("radius", radius, 1e-6, 1e4)
        row[motion.SHARE] = checked_number("share", share, 0.0, 1.0, above=True)
        row[motion.MASS] = checked_number("mass", mass, 0.0, 1e12, above=True)
        row[motion.FRICTION] = checked_number("friction", friction, 0.0, 1e9)
        row[motion.BOUNCE] = checked_number("restitution", restitution, 0.0, 1.0)
        self.balls = Balls(
            np.concatenate([self.balls.rows, row[None]]),
            np.concatenate([self.balls.pieces, np.full((1, 2), motion.FREE, dtype=np.int32)]),
        )
        return len(self.balls.rows) - 1

    def remove_ball(self, ball: int) -> None:
        """Take a ball away; later ones get its number and those after it. ValueError."""
        if not 0 <= ball < len(self.balls.rows):
            raise ValueError(f"ball {ball!r}: there is none of this number")
        rows, pieces = self.balls
        self.balls = Balls(np.delete(rows, ball, axis=0), np.delete(pieces, ball, axis=0))

    def put_down(self, ball: int, reach: float) -> bool:
        """Put a ball on the nearest track within reach m of touching it, as fast as it is; False: none."""
        one = Balls(self.balls.rows[ball : ball + 1], self.balls.pieces[ball : ball + 1])
        best = motion.FREE
        for track in range(len(self.curves)):
            before = one.rows.copy()
            settle_balls(self.pieces, one, np.array([track], dtype=np.int32), float(reach))
            if one.pieces[0, motion.PIECE] != motion.FREE:
                reach = float(
                    elementwise.hypot(
                        *(one.rows[0, motion.X : motion.Y + 1] - before[0, motion.X : motion.Y + 1])
                    )
                )
                best = track
            one.rows[:] = before
            one.pieces[:] = motion.FREE
        if best == motion.FREE:
            return False
        settle_balls(self.pieces, one, np.array([best], dtype=np.int32), reach * (1.0 + 1e-9) + 1e-12)
        return bool(one.pieces[0, motion.PIECE] != motion.FREE)

    def track_of(self, ball: int) -> int:
        """Number of the track that a ball rolls on, or FREE."""
        piece = int(self.balls.pieces[ball, motion.PIECE])
        return motion.FREE if piece == motion.FREE else int(self.pieces.rows[piece, TRACK])

    def step(self, dt: float) -> None:
        """One step of dt (s). ValueError; ArithmeticError if a ball's state is no longer finite."""
        length = checked_number("dt", dt, 0.0, 1e3, above=True)
        substeps = self.settings.substeps
        gravity = np.array(self.settings.gravity, dtype=np.float64)
        wrong = step_balls(self.pieces, self.grid, self.balls, gravity, length / substeps, substeps)
        if wrong != motion.FREE:
            raise ArithmeticError(f"ball {wrong}: not finite")

    def energies(self) -> Floats:
        """(n, 3) J of each ball: of its way, of its spin, of its height above y = 0."""
        rows = self.balls.rows
        mass, gravity = rows[:, motion.MASS], self.settings.gravity
        way = (
            0.5
            * mass
            * (rows[:, motion.VX] * rows[:, motion.VX] + rows[:, motion.VX + 1] * rows[:, motion.VX + 1])
        )
        turn = (
            0.5
            * mass
            * rows[:, motion.SHARE]
            * elementary.square(rows[:, motion.RADIUS] * rows[:, motion.SPIN])
        )
        height = -mass * (gravity[0] * rows[:, motion.X] + gravity[1] * rows[:, motion.Y])
        return np.stack([way, turn, height], axis=1)

    def state(self) -> TrackState:
        """The arrays themselves, not copies."""
        return TrackState(*self.balls)

    def restore(self, state: TrackState) -> None:
        """Be as when ``state`` was called (with the tracks of that time)."""
        self.balls = Balls(state.rows.copy(), state.pieces.copy())
