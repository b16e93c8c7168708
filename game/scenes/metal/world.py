"""The marble run: tracks, balls, gates and what is solid, stepped and measured."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Flags, Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.kernels import elementwise
from game.physics.solids import SolidState
from game.physics.solids.tracks import Curve, TrackState
from game.physics.solids.tracks import motion as m
from game.scenes.metal import gauges as g
from game.scenes.metal import making
from game.scenes.metal.balls import NONE, NOT_YET, RIDES, Balls
from game.scenes.metal.gauges import Moment, balls_of, drop_of, measure
from game.scenes.metal.hearing import MOST, impacts_now, landings, ridden
from game.scenes.metal.level import BallEntry, GaugeEntry, MetalContent
from game.scenes.metal.parameters import MetalParameters
from game.worlds.hearing import Heard
from game.worlds.members.solids import Solids
from game.worlds.members.tracks import Tracks
from game.worlds.rubbing import SILENT
from game.worlds.world import Member, World

MOVED = 0.3  # m: so far from where it stood a block has fallen
CRAWL = 0.1  # m/s: a cradle's ball that is faster has been struck


class MetalState(NamedTuple):
    """Solids; tracks and balls as `Tracks` keeps them; what `Sides`, `Balls` and `Machine` keep; sounds."""

    world: SolidState
    riders: TrackState
    points: Floats
    starts: Longs
    kinds: Floats
    sides: Longs
    table: Floats
    gates: Floats
    plugs: Longs
    gauges: Floats
    heard: Floats


class Sides(Member):
    """``rows`` (k, 2): track and body, of tracks that reach into yards."""

    kept = ("rows",)
    rows: Longs = np.zeros((0, 2), dtype=np.int64)


class Machine(Member):
    """gates (g,): s at which each opened, NOT_YET; plugs: bodies, -1 where one has gone; gauges (n, 3)."""

    kept = ("gates", "plugs", "gauges")

    def __init__(self, content: MetalContent, plugs: list[int]):
        self.gates: Floats = np.full(len(content.gates), NOT_YET)
        self.plugs: Longs = np.array(plugs, dtype=np.int64)
        self.gauges: Floats = np.zeros((len(content.gauges), g.GAUGE_WIDTH))
        self.gauges[:, g.VALUE] = NOT_YET


class MetalWorld(World):
    """changed: by a hand, so that it is no longer as the level says; held: ball in the hand, or -1;
    ridden: how balls roll on tracks.
    """

    state_type = MetalState
    content: MetalContent
    parameters: MetalParameters

    def __init__(self, content: MetalContent, parameters: MetalParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        self.changed, self.held, self.ridden = False, -1, SILENT
        self.solids, self.heard = Solids(parameters, active), Heard(MOST)
        self.tracks = Tracks(content.tracks, parameters, active)
        self.world = world = self.solids.world
        self.balls = Balls(world, self.tracks, content.yards, (parameters.friction, parameters.restitution))
        self.measured = balls_of(content)
        anchor = self.solids.anchor()
        self.floor_ids = [making.add_floor(world, entry) for entry in content.floors]
        self.sides = Sides()
        self._lay_sides()
        self.machine = Machine(content, [making.add_plug(world, entry) for entry in content.plugs])
        self.block_ids = [body for entry in content.towers for body in making.add_tower(world, entry)]
        self.block_starts = world.bodies.positions[self.block_ids].copy()
        self.seesaw_ids = [making.add_seesaw(world, anchor, entry) for entry in content.seesaws]
        floors = zip(self.floor_ids, content.floors, strict=True)
        soft = [body for body, entry in floors if entry.made_of in ("wood", "felt")]
        self.wooden = [*self.block_ids, *self.seesaw_ids, *soft]
        for entry in (*content.balls, *(ball for heap in content.heaps for ball in making.balls_of(heap))):
            self.add(entry)
        self.cradle_balls = [self._hang(anchor, number) for number in range(len(content.cradles))]
        self.balls.change_worlds()
        self.members = (self.solids, self.tracks, self.sides, self.balls, self.machine, self.heard)

    # -- building and changes -------------------------------------------------------------------------

    def add(self, entry: BallEntry) -> int:
        """A ball; its number. ValueError."""
        return self.balls.add(entry, self._gate(entry.gate), self.time)

    def _hang(self, anchor: int, number: int) -> list[int]:
        """The balls of a cradle; their numbers."""
        entry, found = self.content.cradles[number], list[int]()
        gate = self._gate(entry.gate)
        for hung, place in making.cradle_places(entry):
            ball = self.balls.add(BallEntry(at=place, radius=entry.radius), NONE, self.time)
            table = self.balls.table
            body, table.rod[ball] = making.add_hanging(self.world, anchor, hung, place, entry.radius)
            table.body[ball] = body
            if len(found) < entry.lifted:
                self.world.set_kind(body, "fixed")
                table.gate[ball], table.freed[ball] = gate, NOT_YET
            found.append(ball)
        return found

    def _gate(self, name: str) -> int:
        """Number of a gate. ValueError for one that there is not."""
        if not name:
            return NONE
        if name not in self.content.gates:
            raise ValueError(f"gate = {name!r}: there are {', '.join(self.content.gates) or 'none'}")
        return self.content.gates.index(name)

    def _lay_sides(self) -> None:
        """Tracks as balls in yards meet them."""
        for body in self.sides.rows[:, 1].tolist():
            self.world.remove_body(body)
        grip, yards = self.parameters.friction, self.content.yards
        found = [
            (number, body) for number, curve in enumerate(self.tracks.riders.curves)
            for body in making.add_track(self.world, curve, yards, grip)
        ]  # fmt: skip
        self.sides.rows = np.array(found, dtype=np.int64).reshape(-1, 2)

    def lay(self, curves: list[Curve]) -> None:
        """Other tracks. ValueError for one that cannot be."""
        self.changed = True
        self.tracks.lay(curves)
        self._lay_sides()

    def change_parameter(self, name: str) -> None:
        super().change_parameter(name)
        if name in ("friction", "restitution"):
            self._change_grips()

    def _change_grips(self) -> None:
        friction = self.parameters.friction
        mine = self.balls.set_grips(friction, self.parameters.restitution)
        self.solids.set_frictions([*mine, *self.sides.rows[:, 1].tolist()], friction)

    # -- gates ----------------------------------------------------------------------------------------

    def open_next(self) -> bool:
        """Open the first gate that is closed; False if all are open."""
        closed = np.flatnonzero(self.machine.gates == NOT_YET)
        if not len(closed):
            return False
        self.open(int(closed[0]))
        return True

    def open(self, gate: int) -> None:
        """Open a gate."""
        plugs = self.machine.plugs
        self.machine.gates[gate] = self.time
        name = self.content.gates[gate]
        for k, plug in enumerate(self.content.plugs):
            if plug.gate == name and plugs[k] >= 0:
                self.world.remove_body(int(plugs[k]))
                plugs[k] = -1
        for entry, balls in zip(self.content.cradles, self.cradle_balls, strict=True):
            if entry.cut == name:
                for ball in balls:
                    self.untie(ball)

    def untie(self, ball: int) -> None:
        """Take a ball's rod away, if it has one."""
        rods = self.balls.table.rod
        if rods[ball] != NONE:
            self.world.remove_joint(int(rods[ball]))
            rods[ball] = NONE
            self._change_grips()

    def _let_go(self) -> None:
        """Balls whose gate has been open for long enough."""
        table = self.balls.table
        for ball in np.flatnonzero((table.freed == NOT_YET) & (table.gate >= 0)).tolist():
            opened = self.machine.gates[table.gate[ball]]
            if opened != NOT_YET and self.time >= opened + table.delay[ball] - 1e-9:
                self.balls.free(ball, self.time)

    # -- what a hand does -----------------------------------------------------------------------------

    def put_down(self, ball: int, reach: float) -> None:
        """After it was held: onto the nearest track, and measured from there."""
        self.balls.put_down(ball, reach, self.time)
        for k, of in enumerate(self.measured):
            if of == ball:
                self.machine.gauges[k] = NOT_YET, 0.0, 0.0

    def remove(self, ball: int) -> None:
        """Take a ball out of the way."""
        self.changed = True
        self.untie(ball)
        self.balls.remove(ball)

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        """One step; the ball that is held stays where it is."""
        self._let_go()
        table, riders, held = self.balls.table, self.tracks.riders, self.held
        rows, pieces = riders.balls.rows.copy(), riders.balls.pieces.copy()
        rolled = self.tracks.rolling()
        still, holds = table.freed == NOT_YET, 0 <= held < len(table.body)
        place = (float(rows[held, m.X]), float(rows[held, m.Y])) if holds else (0.0, 0.0)
        if holds:
            still[held] = self.changed = True
            self.balls.hold(held, place)
        with self.solids.watch.time("step"):
            riders.step(dt)
            self.world.step(dt)
        self.time += dt
        if holds:
            self.balls.hold(held, place)
        riders.balls.rows[still], riders.balls.pieces[still] = rows[still], pieces[still]
        loose = np.flatnonzero((table.body != RIDES) & ~still)
        if len(loose):
            self.balls.copy_loose(loose)
        self._listen(rows, (table.body == RIDES) & ~still & ~rolled, dt)
        rides = rolled & self.tracks.rolling() & ~still
        self.ridden = ridden(rows, riders.balls.rows, rides, self.gravity() * dt, dt)
        self.balls.change_worlds()
        table.highest[:] = np.maximum(table.highest, riders.balls.rows[:, m.Y])
        self._measure(rows, rolled, dt)
        return ""

    def _listen(self, before: Floats, flew: Flags, dt: float) -> None:
        rows, began = self.balls.rows, self.time - dt
        columns = [m.X, m.Y, m.VX, m.VY]
        added = [
            impacts_now(self.world, began, self.wooden),
            landings(before[:, columns], rows[:, columns], flew, self.gravity() * dt, began),
        ]
        self.heard.remember(np.concatenate(added), began)

    def _measure(self, before: Floats, rolled: Flags, dt: float) -> None:
        rows, rolls, table = self.balls.rows, self.tracks.rolling(), self.balls.table
        tracks = self.content.tracks
        for gauge, ball, noted in zip(self.content.gauges, self.measured, self.machine.gauges, strict=True):
            track = tracks[gauge.track] if gauge.track < len(tracks) else None
            if gauge.measure == "drop":
                assert track is not None  # balls_of has seen to it
                noted[g.VALUE] = drop_of(track, table, ball, rows[ball])
            elif ball >= 0:
                now = Moment(
                    rows[ball], before[ball], bool(rolls[ball]), bool(rolled[ball]), table, ball, self.time,
                    dt, self.gravity(),
                )  # fmt: skip
                measure(gauge, noted, track, now)
            else:
                self._count(gauge, noted)

    def _count(self, gauge: GaugeEntry, noted: Floats) -> None:
        rows, table = self.balls.rows, self.balls.table
        if gauge.measure == "inside" and gauge.box is not None:
            one, x, y = gauge.box, rows[:, m.X], rows[:, m.Y]
            inside = (x >= one.left) & (x <= one.right) & (y >= one.bottom) & (y <= one.top)
            noted[g.VALUE] = np.count_nonzero(inside)
        elif gauge.measure == "fallen":
            noted[g.VALUE] = self.fallen()
        elif gauge.measure == "kept" and self.cradle_balls:
            first, last = self.cradle_balls[0][0], self.cradle_balls[0][-1]
            speeds = elementwise.hypot(*rows[[first, last], m.VX : m.VY + 1].T)
            if table.rod[last] != NONE:
                noted[g.NOTE], noted[g.SECOND] = np.maximum(noted[[g.NOTE, g.SECOND]], speeds)
            swung = noted[g.NOTE] > CRAWL and noted[g.SECOND] > CRAWL
            noted[g.VALUE] = 100.0 * noted[g.SECOND] / noted[g.NOTE] if swung else NOT_YET

    def fallen(self) -> int:
        """How many blocks have left their place."""
        if not self.block_ids:
            return 0
        away = self.world.bodies.positions[self.block_ids] - self.block_starts
        return int(np.count_nonzero(elementwise.hypot(away[:, 0], away[:, 1]) > MOVED))

    def place(self, ball: int) -> Point:
        """Of a ball, m."""
        x, y = self.balls.rows[ball, m.X : m.Y + 1].tolist()
        return x, y
