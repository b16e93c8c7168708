"""The marble run as a level makes it: built, changed by parameters and by gates that open."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.solids import Disc, Material, SolidSettings, SolidWorld
from game.physics.solids.tracks import DISC, Curve, TrackSettings, TrackWorld
from game.physics.solids.tracks.motion import FRICTION, X, Y
from game.scenes.metal.balls import Grips, change_worlds
from game.scenes.metal.gauges import (
    GAUGE_WIDTH,
    VALUE,
    balls_of,
)
from game.scenes.metal.level import MOST_BALLS, BallEntry, MetalContent
from game.scenes.metal.making import (
    add_floor,
    add_hanging,
    add_plug,
    add_seesaw,
    add_tower,
    add_track,
    cradle_places,
)
from game.scenes.metal.parameters import MetalParameters
from game.scenes.metal.tables import (
    BALL_WIDTH,
    BODY,
    DELAY,
    FREED,
    FROM_X,
    FROM_Y,
    GATE,
    GRIP,
    HIGHEST,
    NONE,
    NOT_YET,
    RIDES,
    ROD,
    STEEL,
    none_of,
)
from game.stage import ParameterError, Part
from game.worlds.entries.track_forms import curve_of
from game.worlds.hearing import HEARD_WIDTH
from game.worlds.stopwatch import Stopwatch

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
REACH = 0.6  # m, to the track on which a ball is seated
OFF_TRACKS = 0.0  # part of the speed that comes back from a track


class MetalMachine(Part):
    """Tracks, balls, gates and what is solid. time: s; changed: by a hand, so that it is no longer as the
    level says.

    world: of solids; riders: all balls, as they ride and fly; table: of balls, see `tables`.
    """

    def __init__(self, content: MetalContent, parameters: MetalParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        self.watch = Stopwatch()
        self.time, self.changed = 0.0, False
        self.world = SolidWorld(self._settings())
        curves = [curve_of(entry) for entry in content.tracks]
        self.riders = TrackWorld(curves, self._track_settings())
        self.table, self.heard = none_of(BALL_WIDTH), none_of(HEARD_WIDTH)
        self.gates = np.full(len(content.gates), NOT_YET)
        self.measured = balls_of(content)
        self.gauges = np.zeros((len(content.gauges), GAUGE_WIDTH))
        self.gauges[:, VALUE] = NOT_YET
        self._build()
        self.world.check_solver()

    # -- building -------------------------------------------------------------------------------------

    def _build(self) -> None:
        content, world = self.content, self.world
        nothing = Material(mask=0, category=0)
        self.anchor = world.add_body(Disc(0.01, material=nothing), kind="fixed")
        self.floor_ids = [add_floor(world, entry) for entry in content.floors]
        self.sides = np.zeros((0, 2), dtype=np.int64)
        self._lay_sides()
        self.plugs = np.array([add_plug(world, entry) for entry in content.plugs], dtype=np.int64)
        self.block_ids = [body for entry in content.towers for body in add_tower(world, entry)]
        self.block_starts = world.bodies.positions[self.block_ids].copy()
        self.seesaw_ids = [add_seesaw(world, self.anchor, entry) for entry in content.seesaws]
        self.wooden = [*self.block_ids, *self.seesaw_ids]
        self.wooden += [
            body
            for body, entry in zip(self.floor_ids, content.floors, strict=True)
            if entry.made_of in ("wood", "felt")
        ]
        for entry in content.balls:
            self.add(entry)
        for heap in content.heaps:
            for row in range(heap.counts[1]):
                for column in range(heap.counts[0]):
                    radius = heap.radius + heap.grows * ((row * heap.counts[0] + column) % 3)
                    pitch = 2.02 * (heap.radius + 2.0 * max(heap.grows, 0.0))
                    # every other row is shifted, so that none stands on top of another
                    x = heap.at[0] + pitch * (column + 0.25 * (row % 2))
                    self.add(BallEntry(at=(x, heap.at[1] + pitch * row), radius=radius))
        self.cradle_balls = [self._hang(number) for number in range(len(content.cradles))]
        change_worlds(world, self.riders, self.table, content.yards, self._grips())

    def _hang(self, number: int) -> list[int]:
        """The balls of a cradle; their numbers."""
        entry = self.content.cradles[number]
        found: list[int] = []
        gate = self._gate(entry.gate)
        for hung, place in cradle_places(entry):
            ball = self._add_row(BallEntry(at=place, radius=entry.radius))
            body, rod = add_hanging(self.world, self.anchor, hung, place, entry.radius)
            self.table[ball, [BODY, ROD]] = body, rod
            if len(found) < entry.lifted:
                self.world.set_kind(body, "fixed")
                self.table[ball, [GATE, FREED]] = gate, NOT_YET
            found.append(ball)
        return found

    def _gate(self, name: str) -> float:
        """Number of a gate. ValueError for one that there is not."""
        if not name:
            return NONE
        if name not in self.content.gates:
            raise ValueError(f"gate = {name!r}: there are {', '.join(self.content.gates) or 'none'}")
        return float(self.content.gates.index(name))

    def _lay_sides(self) -> None:
        """Tracks as balls in yards meet them."""
        for body in self.sides[:, 1].tolist():
            self.world.remove_body(body)
        grip, yards = self.parameters.friction, self.content.yards
        found = [
            (number, body)
            for number, curve in enumerate(self.riders.curves)
            for body in add_track(self.world, curve, yards, grip)
        ]
        self.sides = np.array(found, dtype=np.int64).reshape(-1, 2)

    def add(self, entry: BallEntry) -> int:
        """A ball; its number. ValueError."""
        ball = self._add_row(entry)
        if entry.seated:
            self.riders.put_down(ball, REACH)
            self.table[ball, [FROM_X, FROM_Y]] = self.riders.balls.rows[ball, X : Y + 1]
        return ball

    def _add_row(self, entry: BallEntry) -> int:
        if len(self.table) >= MOST_BALLS:
            raise ValueError(f"balls: there is room for {MOST_BALLS}")
        ball = self.riders.add_ball(
            entry.at, entry.radius, entry.velocity, share=DISC,
            mass=STEEL * math.pi * (entry.radius * entry.radius),
            friction=self.parameters.friction if entry.friction is None else entry.friction,
            restitution=OFF_TRACKS,
        )  # fmt: skip
        row = np.full(BALL_WIDTH, NONE)
        gate = self._gate(entry.gate)
        row[[BODY, GATE, DELAY, FREED, ROD]] = RIDES, gate, entry.delay, NOT_YET, NONE
        row[[FROM_X, FROM_Y, HIGHEST]] = *entry.at, entry.at[1]
        row[GRIP] = NONE if entry.friction is None else entry.friction
        if gate == NONE:
            row[FREED] = self.time
        self.table = np.concatenate([self.table, row[None]])
        return ball

    # -- changes --------------------------------------------------------------------------------------

    def _settings(self) -> SolidSettings:
        parameters = self.parameters
        try:
            return SolidSettings(
                effects=self.active,
                solver=parameters.solver,
                substeps=parameters.substeps_now(),
                gravity=(0.0, -parameters.gravity),
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None

    def _track_settings(self) -> TrackSettings:
        return TrackSettings(self.parameters.substeps_now(), (0.0, -self.gravity()))

    def _grips(self) -> Grips:
        return Grips(self.parameters.friction, self.parameters.restitution)

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        self.world.settings = self._settings()
        self.riders.settings = self._track_settings()
        self.watch.clear()
        if name in ("friction", "restitution"):
            self._change_grips()

    def _change_grips(self) -> None:
        shapes, parameters = self.world.shapes, self.parameters
        own = self.table[:, GRIP] != NONE
        self.riders.balls.rows[:, FRICTION] = np.where(own, self.table[:, GRIP], parameters.friction)
        loose = (self.table[:, BODY] != RIDES) & (self.table[:, ROD] == NONE)
        mine = np.isin(shapes.bodies, self.table[loose, BODY].astype(np.int64))
        shapes.frictions[mine | np.isin(shapes.bodies, self.sides[:, 1])] = parameters.friction
        shapes.restitutions[mine] = parameters.restitution

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.change_parameter("gravity")

    def lay(self, curves: list[Curve]) -> None:
        """Other tracks. ValueError for one that cannot be."""
        self.changed = True
        self.riders.set_curves(curves, REACH)
        self._lay_sides()

    # -- gates ----------------------------------------------------------------------------------------

    def open_next(self) -> bool:
        """Open the first gate that is closed; False if all are open."""
        closed = np.flatnonzero(self.gates == NOT_YET)
        if not len(closed):
            return False
        self.open(int(closed[0]))
        return True

    def open(self, gate: int) -> None:
        """Open a gate."""
        self.gates[gate] = self.time
        name = self.content.gates[gate]
        for k, plug in enumerate(self.content.plugs):
            if plug.gate == name and self.plugs[k] >= 0:
                self.world.remove_body(int(self.plugs[k]))
                self.plugs[k] = -1
        for entry, balls in zip(self.content.cradles, self.cradle_balls, strict=True):
            if entry.cut == name:
                for ball in balls:
                    self.untie(ball)

    def untie(self, ball: int) -> None:
        """Take a ball's rod away, if it has one."""
        if self.table[ball, ROD] != NONE:
            self.world.remove_joint(int(self.table[ball, ROD]))
            self.table[ball, ROD] = NONE
            self._change_grips()

    def _let_go(self) -> None:
        """Balls whose gate has been open for long enough."""
        table = self.table
        held = np.flatnonzero((table[:, FREED] == NOT_YET) & (table[:, GATE] >= 0.0))
        for ball in held.tolist():
            opened = self.gates[int(table[ball, GATE])]
            if opened != NOT_YET and self.time >= opened + table[ball, DELAY] - 1e-9:
                self.free(ball)

    def free(self, ball: int) -> None:
        """Let a ball go from where it is."""
        row = self.riders.balls.rows[ball]
        self.table[ball, [FREED, FROM_X, FROM_Y, HIGHEST]] = self.time, row[X], row[Y], row[Y]
        if self.table[ball, BODY] != RIDES:
            self.world.set_kind(int(self.table[ball, BODY]), "dynamic")

    def gravity(self) -> float:
        """m/s², as it acts now."""
        return self.parameters.gravity if GRAVITY in self.active else 0.0
