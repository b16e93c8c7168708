"""Balls in two worlds: each by itself on tracks and in flight, or, in a yard, one solid among others.

What a ball has (place, velocity, spin) goes over unchanged, so nothing is gained or lost.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.solids import Disc, SolidWorld
from game.physics.solids.tracks import TrackWorld
from game.physics.solids.tracks.motion import ANGLE, FREE, PIECE, RADIUS, SPEED, SPIN, VX, VY, X, Y
from game.scenes.metal.level import Box
from game.scenes.metal.making import ball_material
from game.scenes.metal.tables import BODY, FREED, NOT_YET, RIDES, ROD

Floats = NDArray[np.float64]
LEAVING = 0.05  # m: so far beyond a yard it is no longer in it
LANDING = 0.25  # of its radius: so near to a track a ball that comes out of a yard is put on it


class Grips:
    """Friction and restitution of balls, as they are now."""

    def __init__(self, friction: float, restitution: float):
        self.friction, self.restitution = friction, restitution


def in_yards(yards: tuple[Box, ...], places: Floats, room: float = 0.0) -> NDArray[np.bool_]:
    """Which places (n, 2) m lie in a yard, or no farther than ``room`` from one."""
    found = np.zeros(len(places), dtype=bool)
    x, y = places[:, 0], places[:, 1]
    for one in yards:
        across = (x >= one.left - room) & (x <= one.right + room)
        found |= across & (y >= one.bottom - room) & (y <= one.top + room)
    return found


def loosen(world: SolidWorld, riders: TrackWorld, table: Floats, ball: int, grips: Grips) -> None:
    """Make a ball one of the solids."""
    row = riders.balls.rows[ball]
    table[ball, BODY] = world.add_body(
        Disc(float(row[RADIUS]), material=ball_material(grips.friction, grips.restitution)),
        row[X : Y + 1], float(row[ANGLE]), row[VX : VY + 1], float(row[SPIN]),
    )  # fmt: skip
    riders.balls.pieces[ball] = FREE


def take_back(world: SolidWorld, riders: TrackWorld, table: Floats, ball: int) -> None:
    """Let a ball ride or fly by itself again; on a track if it comes along one."""
    copy_loose(world, riders, table, np.array([ball]))
    world.remove_body(int(table[ball, BODY]))
    table[ball, BODY] = RIDES
    riders.put_down(ball, LANDING * float(riders.balls.rows[ball, RADIUS]))


def copy_loose(world: SolidWorld, riders: TrackWorld, table: Floats, loose: NDArray[np.int64]) -> None:
    """Where loose balls are, into their rows."""
    bodies, rows = table[loose, BODY].astype(np.int64), riders.balls.rows
    rows[loose, X : Y + 1] = world.bodies.positions[bodies]
    rows[loose, VX : VY + 1] = world.bodies.velocities[bodies]
    rows[loose, ANGLE] = world.bodies.angles[bodies]
    rows[loose, SPIN] = world.bodies.spins[bodies]
    rows[loose, SPEED] = 0.0
    riders.balls.pieces[loose] = FREE


def change_worlds(
    world: SolidWorld, riders: TrackWorld, table: Floats, yards: tuple[Box, ...], grips: Grips
) -> None:
    """Who has come into a yard or out of one; held balls stay as they are."""
    places = riders.balls.rows[:, X : Y + 1]
    rides, free = table[:, BODY] == RIDES, table[:, FREED] != NOT_YET
    for ball in np.flatnonzero(rides & free & in_yards(yards, places)).tolist():
        loosen(world, riders, table, ball, grips)
    gone = ~rides & (table[:, ROD] < 0.0) & ~in_yards(yards, places, LEAVING)
    for ball in np.flatnonzero(gone).tolist():
        take_back(world, riders, table, ball)


def riding(riders: TrackWorld) -> NDArray[np.bool_]:
    """Which balls roll on a track."""
    rolling: NDArray[np.bool_] = riders.balls.pieces[:, PIECE] != FREE
    return rolling
