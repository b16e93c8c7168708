"""The lecture's billiard table: velocity added to position once a step, everything else repaired afterwards.

One step, as in the lecture (Peters 2004, chapter 3 of "Flash MX 2004 Games Most Wanted"): every ball moves by
v dt. A ball beyond a wall is put back and turned round. Two balls that overlap are moved apart and exchange
the normal parts of their velocities. Speeds shrink by a friction factor and stop below a minimum. Added to
it: substeps, so that a break does not tunnel (a ball moves at most half a radius in each). Contacts solved
jointly, so that a symmetric break stays symmetric; pockets.

What it needs: relative speed x substep below two radii, else balls pass through one another. What it gives:
first order in the step; without friction and loss, momentum and energy to rounding between cushions.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.billiards.lecture import state
from game.billiards.lecture.events import TableEvent, table_events
from game.billiards.lecture.settings import DEFAULTS, MAX_SPEED, LectureSettings, lecture_settings
from game.billiards.lecture.state import (
    LECTURE,
    POCKETS,
    WALLS,
    LectureState,
    checked_column,
    checked_rows,
    geometry_of,
    scratch_for,
)
from game.billiards.lecture.step import step_kernel
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import Table
from game.physics.effects import Effect, EffectSet


class LectureTable:
    """A table with balls on it. Owns the arrays, checks what comes in, steps.

    table: rails and pockets. positions (n, 2) m in the table's frame. radii m and masses kg: one number, or
    one for each ball; mass inf is a ball that does not yield. effects: what is computed.
    settings: from `lecture_settings`, which checks them. ValueError names what is wrong: numbers that are
    not finite, shapes, measures out of range.
    """

    def __init__(
        self,
        table: Table,
        positions: ArrayLike,
        radii: ArrayLike = BALL_RADIUS,
        masses: ArrayLike = BALL_MASS,
        velocities: ArrayLike | None = None,
        effects: EffectSet | Effect = state.LECTURE_EFFECTS,
        settings: LectureSettings = DEFAULTS,
    ) -> None:
        n = len(np.atleast_1d(np.asarray(positions)))
        if not 1 <= n <= state.MAX_BALLS:
            raise ValueError(f"positions: from 1 to {state.MAX_BALLS} balls, got {n}")
        self.table = table
        self.middle = np.array([0.5 * table.width, 0.5 * table.length])
        placed = checked_rows("positions", positions, n, 2, state.MAX_COORDINATE)
        moving = (
            np.zeros((n, 2))
            if velocities is None
            else checked_rows("velocities", velocities, n, 2, MAX_SPEED)
        )
        self.state = LectureState(
            offsets=placed - self.middle,
            velocities=moving,
            orientations=np.tile([1.0, 0.0, 0.0, 0.0], (n, 1)),
            in_play=np.ones(n, dtype=np.bool_),
            pocketed_by=np.full(n, -1, dtype=np.int64),
            radii=checked_column("radii", radii, n, 0.0, state.MAX_COORDINATE),
            inverse_masses=1.0 / checked_column("masses", masses, n, 1e-12, math.inf),
        )
        self._scratch = scratch_for(n)
        self._settings = settings
        self._numbers = np.array(settings, dtype=np.float64)
        self._set_effects(EffectSet() | effects)

    # -- what is computed, and how

    @property
    def effects(self) -> EffectSet:
        """What is computed; ValueError for an effect that this table knows nothing of."""
        return self._effects

    @effects.setter
    def effects(self, effects: EffectSet | Effect) -> None:
        self._set_effects(EffectSet() | effects)

    def _set_effects(self, effects: EffectSet) -> None:
        foreign = [effect.name for effect in effects if effect not in state.LECTURE_EFFECTS]
        if foreign:
            raise ValueError(f"effects: the lecture's table knows no {', '.join(foreign)}")
        geometry = geometry_of(self.table, POCKETS in effects)
        if WALLS not in effects:
            geometry = geometry._replace(cushions=np.empty((0, 6)), jaws=np.empty((0, 3)))
        self._effects = effects
        half = np.array([geometry.half_width, geometry.half_length])
        self._geometry = (half, geometry.cushions, geometry.jaws, geometry.pockets)
        self._step = step_kernel(LECTURE.mask(effects), self._settings.order)

    @property
    def settings(self) -> LectureSettings:
        """The settings; give others, from `lecture_settings`, to change them."""
        return self._settings

    @settings.setter
    def settings(self, settings: LectureSettings) -> None:
        self._settings = settings
        self._numbers[:] = settings
        self._step = step_kernel(LECTURE.mask(self._effects), settings.order)

    # -- balls

    @property
    def positions(self) -> Floats:
        """(n, 2) m in the table's frame; a new array."""
        return self.state.offsets + self.middle

    @property
    def velocities(self) -> Floats:
        """(n, 2) m/s; the state's own array."""
        return self.state.velocities

    @property
    def masses(self) -> Floats:
        """(n,) kg; inf for balls that do not yield."""
        with np.errstate(divide="ignore"):
            return 1.0 / self.state.inverse_masses

    def place(self, ball: int, position: ArrayLike) -> None:
        """Put a ball down at a position (2,) m at rest, in play again if it was not.

        ValueError for a ball that there is not, or if it would not lie on the bed.
        """
        row = self._row(ball)
        x, y = checked_rows("position", np.reshape(position, (1, -1)), 1, 2, state.MAX_COORDINATE)[0]
        r = self.state.radii[row]
        if not (r <= x <= self.table.width - r and r <= y <= self.table.length - r):
            raise ValueError(f"position: ball {ball} at ({x:g}, {y:g}) would not lie on the bed")
        self.state.offsets[row] = (x, y) - self.middle
        self.state.velocities[row] = 0.0
        self.state.in_play[row] = True
        self.state.pocketed_by[row] = -1

    def strike(self, ball: int, velocity: ArrayLike) -> None:
        """Give a ball a velocity (2,) m/s. ValueError if it is not in play, or the speed is absurd."""
        row = self._row(ball)
        if not self.state.in_play[row]:
            raise ValueError(f"ball {ball}: is not in play")
        self.state.velocities[row] = checked_rows("velocity", np.reshape(velocity, (1, -1)), 1, 2, MAX_SPEED)[
            0
        ]

    def remove(self, ball: int) -> None:
        """Take a ball out of play (not through a pocket)."""
        row = self._row(ball)
        self.state.velocities[row] = 0.0
        self.state.in_play[row] = False
        self.state.pocketed_by[row] = -1

    def is_clear(self, ball: int, position: ArrayLike) -> bool:
        """True if the ball could lie at a position (2,) m: on the bed, in contact with no other ball in play.

        ValueError for a ball that there is not, or what is no position.
        """
        row = self._row(ball)
        wish = checked_rows("position", np.reshape(position, (1, -1)), 1, 2, state.MAX_COORDINATE)[0]
        r = self.state.radii[row]
        edges = np.array([self.table.width, self.table.length])
        if (wish < r).any() or (wish > edges - r).any():
            return False
        apart = self.positions - wish
        reach = self.state.radii + r
        near = (apart[:, 0] * apart[:, 0] + apart[:, 1] * apart[:, 1] <= reach * reach) & self.state.in_play
        near[row] = False
        return not near.any()

    def _row(self, ball: int) -> int:
        if (
            isinstance(ball, bool)
            or not isinstance(ball, int | np.integer)
            or not 0 <= ball < len(self.state.radii)
        ):
            raise ValueError(f"ball: must be from 0 to {len(self.state.radii) - 1}, got {ball!r}")
        return int(ball)

    # -- stepping

    def step(self, dt: float, steps: int = 1) -> None:
        """Advance by dt s, so many times. ValueError if dt is not positive and at most 10 s, or steps < 1.

        Events and counters afterwards are those of all these steps.
        """
        if not 0.0 < dt <= 10.0:
            raise ValueError(f"dt: must be above 0 and at most 10 s, got {dt!r}")
        if isinstance(steps, bool) or not isinstance(steps, int | np.integer) or steps < 1:
            raise ValueError(f"steps: must be a whole number from 1, got {steps!r}")
        self._step(*self.state, self._numbers, *self._geometry, *self._scratch, int(steps), float(dt))

    @property
    def counters(self) -> dict[str, int]:
        """Of the last call of `step`, by name: how much happened, and how much work it was."""
        names = ("events", "events_lost", "substeps", "pair_tests", "contacts", "rounds", "iterations")
        return dict(zip(names, self._scratch.counters[:7].tolist(), strict=True))

    @property
    def not_finite(self) -> int:
        """Row of the first ball that the last step left with a number that is not finite, or -1."""
        return int(self._scratch.counters[state.NOT_FINITE])

    @property
    def event_rows(self) -> Floats:
        """Events of the last step, (k, 8): columns as named in state.py; positions from the middle."""
        return self._scratch.events[: self._scratch.counters[state.EVENTS]]

    @property
    def events(self) -> list[TableEvent]:
        """Events of the last step, in order."""
        return table_events(self.event_rows, self.middle)

    # -- what is measured

    @property
    def moving(self) -> bool:
        """True while any ball has a velocity."""
        return bool(self.state.velocities.any())

    @property
    def momentum(self) -> tuple[float, float]:
        """kg m/s, of the balls in play that can move."""
        masses = self._finite_masses()
        return (
            math.fsum((masses * self.state.velocities[:, 0]).tolist()),
            math.fsum((masses * self.state.velocities[:, 1]).tolist()),
        )

    @property
    def energy(self) -> float:
        """Kinetic energy of translation, J."""
        v = self.state.velocities
        return math.fsum((0.5 * self._finite_masses() * (v[:, 0] * v[:, 0] + v[:, 1] * v[:, 1])).tolist())

    @property
    def deepest_overlap(self) -> float:
        """Deepest overlap of two balls in play, m; 0 if none."""
        rows = np.flatnonzero(self.state.in_play)
        p, r = self.state.offsets[rows], self.state.radii[rows]
        apart = p[:, None, :] - p[None, :, :]
        depth = (
            r[:, None] + r[None, :] - np.sqrt(apart[..., 0] * apart[..., 0] + apart[..., 1] * apart[..., 1])
        )
        np.fill_diagonal(depth, 0.0)
        return max(0.0, float(depth.max(initial=0.0)))

    def _finite_masses(self) -> Floats:
        w = self.state.inverse_masses
        return np.where(w > 0.0, 1.0 / np.where(w > 0.0, w, 1.0), 0.0)


def warm_ups(
    effects: EffectSet = state.LECTURE_EFFECTS, order: str = "joint"
) -> list[tuple[str, Callable[[], None]]]:
    """Named calls that compile the kernels of a table with these effects and order of contacts."""

    def compile_step() -> None:
        settings = lecture_settings(order=order)
        LectureTable(Table.bare(1.0, 2.0), [[0.2, 0.2], [0.6, 0.6]], effects=effects, settings=settings).step(
            0.01
        )

    return [(f"lecture table, {order}", compile_step)]
