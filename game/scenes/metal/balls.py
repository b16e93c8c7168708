"""Balls in two worlds: each by itself on tracks and in flight, or, in a yard, one solid among others.

What a ball has (place, velocity, spin) goes over unchanged, so nothing is gained or lost.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from game.arrays import Flags, Floats, Longs, Point
from game.physics.solids import Disc, Material, SolidWorld
from game.physics.solids.arrays.state import DYNAMIC
from game.physics.solids.tracks import DISC
from game.physics.solids.tracks import motion as m
from game.scenes.metal.level import MOST_BALLS, BallEntry, Box
from game.scenes.metal.making import STEEL
from game.worlds.members.tracks import REACH, Tracks
from game.worlds.tables import NO_FLOATS, NO_LONGS, extended
from game.worlds.world import Member

RIDES, NONE, NOT_YET = -1, -1, -1.0
OFF_TRACKS = 0.0  # part of the speed that comes back from a track
LEAVING = 0.05  # m: so far beyond a yard it is no longer in it
LANDING = 0.25  # of its radius: so near to a track a ball that comes out of a yard is put on it


class Table(NamedTuple):
    """Of each ball: its body while it is loose (RIDES: it rolls on a track, or flies), gate that holds it
    (NONE), delay s after that, time at which it was let go (NOT_YET). Rod that it hangs on (NONE), where it
    was let go (m), highest place since (m), friction of its own (NONE: the parameter's).
    """

    body: Longs = NO_LONGS
    gate: Longs = NO_LONGS
    delay: Floats = NO_FLOATS
    freed: Floats = NO_FLOATS
    rod: Longs = NO_LONGS
    x: Floats = NO_FLOATS
    y: Floats = NO_FLOATS
    highest: Floats = NO_FLOATS
    grip: Floats = NO_FLOATS


class Balls(Member):
    """``table`` of all; their rows are those of the tracks' riders. grips: friction and restitution now."""

    kept = ("table",)

    def __init__(self, world: SolidWorld, tracks: Tracks, yards: Sequence[Box], grips: Point):
        self.world, self.tracks, self.yards, self.grips = world, tracks, yards, grips
        self.table = Table()

    @property
    def rows(self) -> Floats:
        """(n, columns), see `motion`."""
        return self.tracks.riders.balls.rows

    def add(self, entry: BallEntry, gate: int, time: float) -> int:
        """A ball that a gate holds, or none; its number. ValueError."""
        if len(self.table.body) >= MOST_BALLS:
            raise ValueError(f"balls: at most {MOST_BALLS}")
        ball = self.tracks.riders.add_ball(
            entry.at, entry.radius, entry.velocity, share=DISC, mass=_mass(entry.radius),
            friction=self.grips[0] if entry.friction is None else entry.friction, restitution=OFF_TRACKS,
        )  # fmt: skip
        freed, grip = time if gate == NONE else NOT_YET, NONE if entry.friction is None else entry.friction
        self.table = extended(
            self.table, [(RIDES, gate, entry.delay, freed, NONE, *entry.at, entry.at[1], grip)]
        )
        if entry.seated:
            self.tracks.riders.put_down(ball, REACH)
            self.table.x[ball], self.table.y[ball] = self.rows[ball, m.X : m.Y + 1]
        return ball

    # -- from one world into the other ----------------------------------------------------------------

    def loosen(self, ball: int) -> None:
        """Make a ball one of the solids."""
        row, shape = self.rows[ball], Material(STEEL, *self.grips)
        self.table.body[ball] = self.world.add_body(
            Disc(float(row[m.RADIUS]), material=shape), row[m.X : m.Y + 1], float(row[m.ANGLE]),
            row[m.VX : m.VY + 1], float(row[m.SPIN]),
        )  # fmt: skip
        self.tracks.riders.balls.pieces[ball] = m.FREE

    def _take_back(self, ball: int) -> None:
        """Let a ball ride or fly by itself again; on a track if it comes along one."""
        self.copy_loose(np.array([ball]))
        self._unbody(ball)
        self.tracks.riders.put_down(ball, LANDING * float(self.rows[ball, m.RADIUS]))

    def _unbody(self, ball: int) -> None:
        if self.table.body[ball] != RIDES:
            self.world.remove_body(int(self.table.body[ball]))
            self.table.body[ball] = RIDES

    def copy_loose(self, loose: Longs) -> None:
        """Where loose balls are, into their rows."""
        bodies, rows, now = self.table.body[loose], self.rows, self.world.bodies
        rows[loose, m.X : m.Y + 1] = now.positions[bodies]
        rows[loose, m.VX : m.VY + 1] = now.velocities[bodies]
        rows[loose, m.ANGLE], rows[loose, m.SPIN] = now.angles[bodies], now.spins[bodies]
        rows[loose, m.SPEED] = 0.0
        self.tracks.riders.balls.pieces[loose] = m.FREE

    def change_worlds(self) -> None:
        """Balls that have come into a yard or out of one; held balls stay as they are."""
        places, table = self.rows[:, m.X : m.Y + 1], self.table
        rides, free = table.body == RIDES, table.freed != NOT_YET
        for ball in np.flatnonzero(rides & free & in_yards(self.yards, places)).tolist():
            self.loosen(ball)
        gone = ~rides & (table.rod < 0) & ~in_yards(self.yards, places, LEAVING)
        for ball in np.flatnonzero(gone).tolist():
            self._take_back(ball)

    # -- what a hand does -----------------------------------------------------------------------------

    def hold(self, ball: int, place: Point) -> None:
        """Put a ball somewhere, at rest."""
        self.tracks.hold(ball, place)
        body = int(self.table.body[ball])
        if body >= 0:
            self.world.set_pose(body, place, float(self.world.bodies.angles[body]))
            if self.world.bodies.flags[body] & DYNAMIC:
                self.world.set_velocity(body, (0.0, 0.0), 0.0)

    def put_down(self, ball: int, reach: float, time: float) -> None:
        """After it was held: onto the nearest track, and measured from there."""
        if self.table.body[ball] == RIDES:
            self.tracks.riders.put_down(ball, reach)
        self._begin(ball)
        if self.table.freed[ball] != NOT_YET:
            self.table.freed[ball] = time

    def _begin(self, ball: int) -> None:
        """It is measured from where it is."""
        x, y = self.rows[ball, m.X : m.Y + 1]
        self.table.x[ball], self.table.y[ball], self.table.highest[ball] = x, y, y

    def resize(self, ball: int, radius: float) -> None:
        """Another radius (m), as heavy as steel is."""
        row = self.rows[ball]
        row[m.RADIUS], row[m.MASS] = radius, _mass(radius)
        if self.table.body[ball] != RIDES:
            self._unbody(ball)
            self.loosen(ball)
        else:
            self.tracks.riders.put_down(ball, 2.0 * radius)

    def remove(self, ball: int) -> None:
        """Take a ball out of the way: it lies nowhere, held for ever. Numbers of others stay."""
        self._unbody(ball)
        self.table.gate[ball], self.table.freed[ball] = NONE, NOT_YET
        self.rows[ball, m.X : m.Y + 1] = 0.0, -1e4
        self.tracks.riders.balls.pieces[ball] = m.FREE

    def free(self, ball: int, time: float) -> None:
        """Let a ball go from where it is."""
        self.table.freed[ball] = time
        self._begin(ball)
        if self.table.body[ball] != RIDES:
            self.world.set_kind(int(self.table.body[ball]), "dynamic")

    def set_grips(self, friction: float, restitution: float) -> list[int]:
        """Take over what is chosen; bodies of the loose ones that do not hang."""
        self.grips, table = (friction, restitution), self.table
        self.rows[:, m.FRICTION] = np.where(table.grip != NONE, table.grip, friction)
        mine = table.body[(table.body != RIDES) & (table.rod == NONE)]
        shapes = self.world.shapes
        shapes.restitutions[np.isin(shapes.bodies, mine)] = restitution
        found: list[int] = mine.tolist()
        return found

    # -- what there is --------------------------------------------------------------------------------

    def there(self) -> Flags:
        """Which have not been taken away."""
        found: Flags = (self.table.freed != NOT_YET) | (self.table.gate != NONE)
        return found


def _mass(radius: float) -> float:
    return STEEL * math.pi * (radius * radius)


def in_yards(yards: Sequence[Box], places: Floats, room: float = 0.0) -> Flags:
    """Which places (n, 2) m lie in a yard, or no farther than ``room`` from one."""
    found = np.zeros(len(places), dtype=bool)
    x, y = places[:, 0], places[:, 1]
    for one in yards:
        across = (x >= one.left - room) & (x <= one.right + room)
        found |= across & (y >= one.bottom - room) & (y <= one.top + room)
    return found
