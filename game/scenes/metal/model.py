"""The marble run: what a hand does to it, a step, what is measured, its state."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementwise
from game.physics.solids import SolidState
from game.physics.solids.state import ASLEEP, DYNAMIC
from game.physics.solids.tracks import Curve, TrackState, TrackWorld
from game.physics.solids.tracks.motion import MASS, RADIUS, SPEED, SPIN, VX, VY, X, Y
from game.scenes.metal.balls import change_worlds, copy_loose, loosen
from game.scenes.metal.gauges import (
    MOVED,
    NOTE,
    SECOND,
    VALUE,
    Moment,
    drop_of,
    measure,
    names_of,
    rolls_on,
)
from game.scenes.metal.hearing import impacts, landings, remembered, rolling
from game.scenes.metal.level import GaugeEntry
from game.scenes.metal.machine import MetalMachine
from game.scenes.metal.tables import (
    BODY,
    FREED,
    FROM_X,
    FROM_Y,
    GATE,
    HIGHEST,
    NONE,
    NOT_YET,
    RIDES,
    ROD,
    STEEL,
)

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
REACH = 0.6  # m, to the track on which a ball is seated
CRAWL = 0.1  # m/s: a cradle's ball that is faster has been struck
OFF_TRACKS = 0.0  # part of the speed that comes back from a track


class ModelState(NamedTuple):
    """Both worlds; tracks as points (v, 2) m, where each begins, its kind; tables: see `tables`."""

    world: SolidState
    riders: TrackState
    points: Floats
    starts: Longs
    kinds: Floats  # (m, 2) closed, corner
    sides: Longs  # (k, 2) track and body, of tracks that reach into yards
    table: Floats
    gates: Floats
    plugs: Longs
    gauges: Floats
    heard: Floats


class MetalModel(MetalMachine):
    """The run as it goes on."""

    # -- what a hand does -----------------------------------------------------------------------------

    def hold(self, ball: int, place: tuple[float, float]) -> None:
        """Put a ball somewhere, at rest."""
        self.changed = True
        row = self.riders.balls.rows[ball]
        row[X : Y + 1] = place
        row[VX : VY + 1], row[SPIN], row[SPEED] = 0.0, 0.0, 0.0
        self.riders.balls.pieces[ball] = -1
        body = int(self.table[ball, BODY])
        if body >= 0:
            self.world.set_pose(body, place, float(self.world.bodies.angles[body]))
            if self.world.bodies.flags[body] & DYNAMIC:
                self.world.set_velocity(body, (0.0, 0.0), 0.0)

    def put_down(self, ball: int, reach: float) -> None:
        """After it was held: onto the nearest track, and measured from there."""
        if self.table[ball, BODY] == RIDES:
            self.riders.put_down(ball, reach)
        row = self.riders.balls.rows[ball]
        self.table[ball, [FROM_X, FROM_Y, HIGHEST]] = row[X], row[Y], row[Y]
        if self.table[ball, FREED] != NOT_YET:
            self.table[ball, FREED] = self.time
        for k, of in enumerate(self.measured):
            if of == ball:
                self.gauges[k] = NOT_YET, 0.0, 0.0

    def resize(self, ball: int, radius: float) -> None:
        """Another radius (m), as heavy as steel is; one that hangs keeps its own."""
        if self.table[ball, ROD] != NONE:
            return
        self.changed = True
        row = self.riders.balls.rows[ball]
        row[RADIUS], row[MASS] = radius, STEEL * math.pi * (radius * radius)
        if self.table[ball, BODY] != RIDES:
            self.world.remove_body(int(self.table[ball, BODY]))
            loosen(self.world, self.riders, self.table, ball, self._grips())
        else:
            self.riders.put_down(ball, 2.0 * radius)

    def remove(self, ball: int) -> None:
        """Take a ball out of the way: it lies nowhere, held for ever. Numbers of others stay."""
        self.changed = True
        self.untie(ball)
        if self.table[ball, BODY] != RIDES:
            self.world.remove_body(int(self.table[ball, BODY]))
        self.table[ball, [BODY, GATE, FREED]] = RIDES, NONE, NOT_YET
        self.riders.balls.rows[ball, X : Y + 1] = 0.0, -1e4
        self.riders.balls.pieces[ball] = -1

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float, held: int = -1) -> None:
        """One step; the ball ``held`` stays where it is."""
        self._let_go()
        table, riders = self.table, self.riders
        rows, pieces = riders.balls.rows.copy(), riders.balls.pieces.copy()
        still = table[:, FREED] == NOT_YET
        if 0 <= held < len(table):
            still[held] = True
            self.hold(held, (float(rows[held, X]), float(rows[held, Y])))
        with self.watch.time("step"):
            riders.step(dt)
            self.world.step(dt)
        self.time += dt
        if 0 <= held < len(table):
            self.hold(held, (float(rows[held, X]), float(rows[held, Y])))
        riders.balls.rows[still], riders.balls.pieces[still] = rows[still], pieces[still]
        loose = np.flatnonzero((table[:, BODY] != RIDES) & ~still)
        if len(loose):
            copy_loose(self.world, riders, table, loose)
        flew = (table[:, BODY] == RIDES) & ~still & ~rolls_on(pieces)
        self._listen(rows, flew, dt)
        change_worlds(self.world, riders, table, self.content.yards, self._grips())
        table[:, HIGHEST] = np.maximum(table[:, HIGHEST], riders.balls.rows[:, Y])
        self._measure(rows, rolls_on(pieces), dt)

    def _listen(self, before: Floats, flew: NDArray[np.bool_], dt: float) -> None:
        rows, began = self.riders.balls.rows, self.time - dt
        columns = [X, Y, VX, VY]
        rolls = rolls_on(self.riders.balls.pieces)
        speeds = np.where(rolls, np.abs(rows[:, SPEED]), 0.0)
        self.heard = remembered(
            self.heard,
            [
                impacts(self.world, began, self.wooden),
                landings(before[:, columns], rows[:, columns], flew, self.gravity() * dt, began),
                rolling(speeds, rows[:, X], self.time, dt),
            ],
            began,
        )

    def _measure(self, before: Floats, rolled: NDArray[np.bool_], dt: float) -> None:
        rows, rolls = self.riders.balls.rows, rolls_on(self.riders.balls.pieces)
        tracks = self.content.tracks
        for gauge, ball, noted in zip(self.content.gauges, self.measured, self.gauges, strict=True):
            track = tracks[gauge.track] if gauge.track < len(tracks) else None
            if gauge.measure == "drop":
                assert track is not None  # balls_of has seen to it
                noted[VALUE] = drop_of(track, self.table[ball], rows[ball])
            elif ball >= 0:
                now = Moment(
                    rows[ball], before[ball], bool(rolls[ball]), bool(rolled[ball]), self.table[ball],
                    self.time, dt, self.gravity(),
                )  # fmt: skip
                measure(gauge, noted, track, now)
            else:
                self._count(gauge, noted)

    def _count(self, gauge: GaugeEntry, noted: Floats) -> None:
        if gauge.measure == "inside" and gauge.box is not None:
            one, rows = gauge.box, self.riders.balls.rows
            x, y = rows[:, X], rows[:, Y]
            inside = (x >= one.left) & (x <= one.right) & (y >= one.bottom) & (y <= one.top)
            noted[VALUE] = np.count_nonzero(inside)
        elif gauge.measure == "fallen":
            noted[VALUE] = self.fallen()
        elif gauge.measure == "kept" and self.cradle_balls:
            first, last = self.cradle_balls[0][0], self.cradle_balls[0][-1]
            speeds = elementwise.hypot(*self.riders.balls.rows[[first, last], VX : VY + 1].T)
            if self.table[last, ROD] != NONE:
                noted[NOTE], noted[SECOND] = np.maximum(noted[[NOTE, SECOND]], speeds)
            swung = noted[NOTE] > CRAWL and noted[SECOND] > CRAWL
            noted[VALUE] = 100.0 * noted[SECOND] / noted[NOTE] if swung else NOT_YET

    # -- what is there --------------------------------------------------------------------------------

    def there(self) -> NDArray[np.bool_]:
        """Which balls have not been taken away."""
        found: NDArray[np.bool_] = (self.table[:, FREED] != NOT_YET) | (self.table[:, GATE] != NONE)
        return found

    def fallen(self) -> int:
        """How many blocks have left their place."""
        if not self.block_ids:
            return 0
        away = self.world.bodies.positions[self.block_ids] - self.block_starts
        return int(np.count_nonzero(elementwise.hypot(away[:, 0], away[:, 1]) > MOVED))

    def awake(self) -> int:
        """How many solids are computed."""
        return int(np.count_nonzero(self.world.bodies.flags & (DYNAMIC | ASLEEP) == DYNAMIC))

    def names(self) -> list[str]:
        """Of the balls that the level names or numbers."""
        return names_of(self.content)

    def state(self) -> ModelState:
        """All that later steps depend on."""
        arrays = [np.asarray(curve.points, dtype=np.float64) for curve in self.riders.curves]
        starts = np.cumsum([0, *(len(array) for array in arrays)]).astype(np.int64)
        return ModelState(
            self.world.state(), self.riders.state(),
            np.concatenate([np.zeros((0, 2)), *arrays]), starts,
            np.array([(float(c.closed), c.corner) for c in self.riders.curves]).reshape(-1, 2),
            self.sides, self.table, self.gates, self.plugs, self.gauges, self.heard,
        )  # fmt: skip

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        now = self.state()
        if not (np.array_equal(now.starts, state.starts) and np.array_equal(now.points, state.points)):
            ends = state.starts.tolist()
            curves = [
                Curve(state.points[a:b].copy(), bool(closed), float(corner))
                for a, b, (closed, corner) in zip(ends[:-1], ends[1:], state.kinds.tolist(), strict=True)
            ]
            self.riders = TrackWorld(curves, self.riders.settings)
        self.riders.restore(state.riders)
        self.world.restore(state.world)
        self.sides, self.table, self.gates = state.sides.copy(), state.table.copy(), state.gates.copy()
        self.plugs, self.gauges, self.heard = (
            state.plugs.copy(), state.gauges.copy(), state.heard.copy()
        )  # fmt: skip
