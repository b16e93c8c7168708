"""The lecture's billiard table: velocity added to position once a step, everything else repaired afterwards.

One step, as in the lecture (Peters 2004, chapter 3 of "Flash MX 2004 Games Most Wanted"): every ball moves by
v dt; a ball beyond a wall is put back and turned round; two balls that overlap are moved apart and exchange
the normal parts of their velocities; speeds shrink by a friction factor and stop below a minimum. Added to
it: substeps, so that a break does not tunnel (a ball moves at most half a radius in each); contacts solved
jointly, so that a symmetric break stays symmetric; pockets.

What it needs: relative speed x substep below two radii, else balls pass through one another. What it gives:
first order in the step; without friction and loss, momentum and energy to rounding between cushions.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.billiards.lecture_contacts import collide_in_index_order, collide_jointly
from game.billiards.lecture_state import (
    AUTOMATIC,
    BALL_COLLISIONS,
    EVENT_NAMES,
    EVENTS,
    FRAME_RATE,
    FRICTION,
    LECTURE_EFFECTS,
    MAX_BALLS,
    MAX_COORDINATE,
    MAX_SPEED,
    MAX_SUBSTEPS,
    MINIMUM_SPEED,
    NOT_FINITE,
    POCKETS,
    ROLLING,
    SUBSTEPS,
    WALLS,
    Array,
    ContactList,
    Journal,
    LectureGeometry,
    LectureModel,
    LectureSettings,
    LectureState,
    checked_column,
    checked_rows,
    geometry_of,
    scratch_for,
)
from game.billiards.lecture_walls import bounce_off_walls, swallow
from game.billiards.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table import Table
from game.physics.effects import EffectSet
from game.physics.jit import kernel

_WALLS, _BALLS, _FRICTION = WALLS.mask, BALL_COLLISIONS.mask, FRICTION.mask
_MINIMUM, _POCKETS, _ROLLING = MINIMUM_SPEED.mask, POCKETS.mask, ROLLING.mask


@kernel
def read_model(knobs):
    """The settings from an array of them."""
    return LectureModel(
        knobs[0],
        knobs[1],
        knobs[2],
        knobs[3],
        int(knobs[4]),
        int(knobs[5]),
        int(knobs[6]),
        int(knobs[7]),
        int(knobs[8]),
        int(knobs[9]),
        int(knobs[10]),
        int(knobs[11]),
    )


@kernel
def count_substeps(state, model, dt):
    """Number of substeps: as set, or so many that no ball moves over half of the least radius in one."""
    if model.substeps != AUTOMATIC:
        return model.substeps
    fastest = 0.0
    smallest = 1e300
    for i in range(state.radii.shape[0]):
        if state.in_play[i]:
            vx = state.velocities[i, 0]
            vy = state.velocities[i, 1]
            fastest = max(fastest, vx * vx + vy * vy)
            smallest = min(smallest, state.radii[i])
    needed = math.sqrt(fastest) * dt / (0.5 * smallest)
    if not needed < MAX_SUBSTEPS:
        return MAX_SUBSTEPS
    return max(1, math.ceil(needed))


@kernel
def roll(orientations, radii, rolled):
    """Turn each ball about the horizontal axis across its way, by way / radius; then forget the way."""
    for i in range(radii.shape[0]):
        way = math.sqrt(rolled[i, 0] * rolled[i, 0] + rolled[i, 1] * rolled[i, 1])
        if way > 0.0:
            half = 0.5 * way / radii[i]
            w = math.cos(half)
            s = math.sin(half) / way
            x = -s * rolled[i, 1]  # axis = z cross way
            y = s * rolled[i, 0]
            q = orientations[i]
            a = w * q[0] - x * q[1] - y * q[2]
            b = w * q[1] + x * q[0] + y * q[3]
            c = w * q[2] + y * q[0] - x * q[3]
            d = w * q[3] + x * q[2] - y * q[1]
            scale = 1.0 / math.sqrt(a * a + b * b + c * c + d * d)
            q[0] = a * scale
            q[1] = b * scale
            q[2] = c * scale
            q[3] = d * scale
        rolled[i, 0] = 0.0
        rolled[i, 1] = 0.0


@kernel
def slow_down(velocities, factor, minimum_speed):
    """Multiply velocities by a factor; what is slower than the minimum then stops."""
    for i in range(velocities.shape[0]):
        vx = velocities[i, 0] * factor
        vy = velocities[i, 1] * factor
        if vx * vx + vy * vy < minimum_speed * minimum_speed:
            vx = 0.0
            vy = 0.0
        velocities[i, 0] = vx
        velocities[i, 1] = vy


@kernel
def first_not_finite(offsets, velocities):
    """Row of the first ball whose position or velocity is not finite, or -1."""
    for i in range(offsets.shape[0]):
        total = offsets[i, 0] + offsets[i, 1] + velocities[i, 0] + velocities[i, 1]
        if not math.isfinite(total):
            return i
    return -1


@cache
def step_kernel(mask: int) -> Callable[..., Any]:
    """The step for the effects of a mask; what is not in it is not compiled in.

    Its arguments are the fields of LectureState, the model as numbers, the half width and length with
    cushions, jaws and pockets, the fields of LectureScratch, and dt: plain arrays, because handing over a
    NamedTuple from Python takes four times as long.
    """

    @kernel
    def step_table(
        offsets, velocities, orientations, in_play, pocketed_by, radii, inverse_masses,
        knobs, half, cushions, jaws, pockets,
        events, counters, rolled, links, columns, normals, work, sums, dt,
    ):  # fmt: skip
        state = LectureState(offsets, velocities, orientations, in_play, pocketed_by, radii, inverse_masses)
        geometry = LectureGeometry(half[0], half[1], cushions, jaws, pockets)
        model = read_model(knobs)
        journal = Journal(events, counters)
        contacts = ContactList(links[0], links[1], normals, columns[0], columns[1], columns[2], work, sums)
        counters[:] = 0
        substeps = count_substeps(state, model, dt)
        counters[SUBSTEPS] = substeps
        h = dt / substeps
        factor = 1.0
        if mask & _FRICTION:
            power = FRAME_RATE * h if model.friction_law == 0 else 1.0 / substeps
            factor = model.friction if power == 1.0 else model.friction**power
        for k in range(substeps):
            time = k * h
            for i in range(radii.shape[0]):
                for axis in range(2):
                    way = velocities[i, axis] * h
                    offsets[i, axis] += way
                    if mask & _ROLLING:
                        rolled[i, axis] += way
            if mask & _POCKETS:
                swallow(state, geometry, journal, h, time)
            if mask & _WALLS:
                bounce_off_walls(state, geometry, model, journal, False, time)
            if mask & _BALLS:
                if model.order == 0:
                    collide_jointly(state, geometry, model, contacts, journal, time)
                    if mask & _WALLS and model.walls_again != 0:
                        bounce_off_walls(state, geometry, model, journal, True, time)
                else:
                    collide_in_index_order(state, geometry, model, journal, time)
            if mask & (_FRICTION | _MINIMUM):
                slow_down(velocities, factor, model.minimum_speed if mask & _MINIMUM else 0.0)
        if mask & _ROLLING:
            roll(orientations, radii, rolled)
        counters[NOT_FINITE] = first_not_finite(offsets, velocities)

    return step_table


class TableEvent(NamedTuple):
    """One thing that happened in the last step.

    kind: ball-ball, cushion, jaw or pocket. ball; other: ball, or row of the cushion, jaw or pocket. time: s
    since the step began. speed: m/s at which they closed. impulse: N s. position: x, y in m.
    """

    kind: str
    ball: int
    other: int
    time: float
    speed: float
    impulse: float
    position: tuple[float, float]


class LectureTable:
    """A table with balls on it. Owns the arrays, checks what comes in, steps.

    table: rails and pockets. positions (n, 2) m in the table's frame. radii m and masses kg: one number, or
    one for each ball; mass inf is a ball that does not yield. effects: what is computed. settings: knobs.
    ValueError names what is wrong: numbers that are not finite, shapes, measures out of range.
    """

    def __init__(
        self,
        table: Table,
        positions: ArrayLike,
        radii: ArrayLike = BALL_RADIUS,
        masses: ArrayLike = BALL_MASS,
        velocities: ArrayLike | None = None,
        effects: EffectSet = LECTURE_EFFECTS,
        settings: LectureSettings | None = None,
    ) -> None:
        n = len(np.atleast_1d(np.asarray(positions)))
        if not 1 <= n <= MAX_BALLS:
            raise ValueError(f"positions: from 1 to {MAX_BALLS} balls, got {n}")
        self.table = table
        self.middle = np.array([0.5 * table.width, 0.5 * table.length])
        placed = checked_rows("positions", positions, n, 2, MAX_COORDINATE)
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
            radii=checked_column("radii", radii, n, 0.0, MAX_COORDINATE),
            inverse_masses=1.0 / checked_column("masses", masses, n, 1e-12, math.inf),
        )
        self._scratch = scratch_for(n)
        self._settings = LectureSettings() if settings is None else settings
        self._knobs = np.array(self._settings.model(), dtype=np.float64)
        self.effects = effects

    # -- what is computed, and how

    @property
    def effects(self) -> EffectSet:
        return self._effects

    @effects.setter
    def effects(self, effects: EffectSet) -> None:
        foreign = [effect.name for effect in effects if effect not in LECTURE_EFFECTS]
        if foreign:
            raise ValueError(f"effects: the lecture's table knows no {', '.join(foreign)}")
        geometry = geometry_of(self.table, POCKETS in effects)
        if WALLS not in effects:
            geometry = geometry._replace(cushions=np.empty((0, 6)), jaws=np.empty((0, 3)))
        self._effects = effects
        half = np.array([geometry.half_width, geometry.half_length])
        self._geometry = (half, geometry.cushions, geometry.jaws, geometry.pockets)
        self._step = step_kernel(effects.mask)

    @property
    def settings(self) -> LectureSettings:
        return self._settings

    def configure(self, **knobs: Any) -> None:
        """Change some knobs; ValueError names one that is out of range or unknown, and nothing changes."""
        unknown = sorted(set(knobs) - set(LectureSettings.__dataclass_fields__))
        if unknown:
            raise ValueError(
                f"{unknown[0]}: no such knob; there are {', '.join(LectureSettings.__dataclass_fields__)}"
            )
        self._settings = replace(self._settings, **knobs)
        self._knobs[:] = self._settings.model()

    # -- balls

    @property
    def positions(self) -> Array:
        """(n, 2) m in the table's frame; a new array."""
        return self.state.offsets + self.middle

    @property
    def velocities(self) -> Array:
        """(n, 2) m/s; the state's own array."""
        return self.state.velocities

    @property
    def masses(self) -> Array:
        """(n,) kg; inf for balls that do not yield."""
        with np.errstate(divide="ignore"):
            return 1.0 / self.state.inverse_masses

    def place(self, ball: int, position: ArrayLike) -> None:
        """Put a ball down at rest, in play again if it was not. ValueError if it is not on the bed."""
        row = self._row(ball)
        x, y = checked_rows("position", np.reshape(position, (1, -1)), 1, 2, MAX_COORDINATE)[0]
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
        """Take a ball out of play (not by way of a pocket)."""
        row = self._row(ball)
        self.state.velocities[row] = 0.0
        self.state.in_play[row] = False
        self.state.pocketed_by[row] = -1

    def is_clear(self, ball: int, position: ArrayLike) -> bool:
        """True if the ball could lie there: on the bed, touching no other ball in play."""
        row = self._row(ball)
        wish = checked_rows("position", np.reshape(position, (1, -1)), 1, 2, MAX_COORDINATE)[0]
        r = self.state.radii[row]
        edges = np.array([self.table.width, self.table.length])
        if (wish < r).any() or (wish > edges - r).any():
            return False
        apart = self.positions - wish
        reach = self.state.radii + r
        near = (apart[:, 0] ** 2 + apart[:, 1] ** 2 <= reach * reach) & self.state.in_play
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

    def step(self, dt: float) -> None:
        """Advance by dt s. ValueError if dt is not positive, finite, and at most 10 s."""
        if not 0.0 < dt <= 10.0:
            raise ValueError(f"dt: must be above 0 and at most 10 s, got {dt!r}")
        self._step(*self.state, self._knobs, *self._geometry, *self._scratch, float(dt))

    @property
    def counters(self) -> dict[str, int]:
        """Of the last step: events, events lost, substeps, pair tests, contacts, rounds, iterations."""
        names = ("events", "events_lost", "substeps", "pair_tests", "contacts", "rounds", "iterations")
        return dict(zip(names, self._scratch.counters[:7].tolist(), strict=True))

    @property
    def not_finite(self) -> int:
        """Row of the first ball that the last step left with a number that is not finite, or -1."""
        return int(self._scratch.counters[NOT_FINITE])

    @property
    def event_rows(self) -> Array:
        """Events of the last step, (k, 8): columns as named in lecture_state; positions from the middle."""
        return self._scratch.events[: self._scratch.counters[EVENTS]]

    @property
    def events(self) -> list[TableEvent]:
        """Events of the last step, in order."""
        mx, my = self.middle.tolist()
        return [
            TableEvent(
                EVENT_NAMES[int(row[0])],
                int(row[1]),
                int(row[2]),
                row[3],
                row[4],
                row[5],
                (row[6] + mx, row[7] + my),
            )
            for row in self.event_rows.tolist()
        ]

    # -- what is measured

    @property
    def moving(self) -> bool:
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
        depth = r[:, None] + r[None, :] - np.sqrt(apart[..., 0] ** 2 + apart[..., 1] ** 2)
        np.fill_diagonal(depth, 0.0)
        return max(0.0, float(depth.max(initial=0.0)))

    def _finite_masses(self) -> Array:
        w = self.state.inverse_masses
        return np.where(w > 0.0, 1.0 / np.where(w > 0.0, w, 1.0), 0.0)


def warm_ups(effects: EffectSet = LECTURE_EFFECTS) -> list[tuple[str, Callable[[], None]]]:
    """Named calls that compile the kernels of a table with these effects."""

    def compile_step() -> None:
        table = LectureTable(Table.bare(1.0, 2.0), [[0.2, 0.2], [0.6, 0.6]], effects=effects)
        table.step(0.01)

    return [("lecture table", compile_step)]
