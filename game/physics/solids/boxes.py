"""Boxes about shapes, with a margin to move, so that pairs serve for several steps (Verlet 1967)."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import state

ROOM = 0.1  # of a body's reach
AHEAD = 2.0  # steps of its motion


@inner_kernel
def motion_ahead(bodies, i, numbers):
    """How far any point of a body may come in the next step, m."""
    vx, vy = bodies.velocities[i, 0], bodies.velocities[i, 1]
    pull = math.sqrt(numbers.gravity_x * numbers.gravity_x + numbers.gravity_y * numbers.gravity_y) * abs(
        bodies.gravity_scales[i]
    )
    pull += bodies.inverse_masses[i] * math.sqrt(
        bodies.forces[i, 0] * bodies.forces[i, 0] + bodies.forces[i, 1] * bodies.forces[i, 1]
    )
    speed = math.sqrt(vx * vx + vy * vy) + numbers.dt * pull
    return numbers.dt * (speed + abs(bodies.spins[i]) * bodies.reaches[i])


@inner_kernel
def has_outgrown(bodies, numbers):
    """True if a body may leave its boxes in the next step."""
    found = bodies.found
    for i in range(bodies.flags.shape[0]):
        if not bodies.flags[i] & (state.DYNAMIC | state.KEY_FRAMED):
            continue
        gone = abs(bodies.positions[i, 0] - found[i, 0]) + abs(bodies.positions[i, 1] - found[i, 1])
        gone += abs(bodies.angles[i] - found[i, 2]) * bodies.reaches[i]
        if gone + motion_ahead(bodies, i, numbers) > found[i, 3]:
            return True
    return False


@inner_kernel
def make_room(bodies, numbers):
    """Note where each body is, and how far it may go from there."""
    for i in range(bodies.flags.shape[0]):
        if not bodies.flags[i] & state.USED:
            continue
        bodies.found[i, 0], bodies.found[i, 1] = bodies.positions[i, 0], bodies.positions[i, 1]
        bodies.found[i, 2], bodies.found[i, 3] = bodies.angles[i], 0.0
        if bodies.flags[i] & (state.DYNAMIC | state.KEY_FRAMED):
            bodies.found[i, 3] = ROOM * bodies.reaches[i] + AHEAD * motion_ahead(bodies, i, numbers)


@inner_kernel
def make_boxes(bodies, shapes, pool, numbers):
    """Boxes of all shapes, as large as their bodies may go; and half the distance at which contacts begin."""
    for s in range(shapes.kinds.shape[0]):
        if shapes.kinds[s] == state.NONE:
            continue
        i = shapes.bodies[s]
        x, y, c, sine = (
            bodies.positions[i, 0],
            bodies.positions[i, 1],
            bodies.rotations[i, 0],
            bodies.rotations[i, 1],
        )
        x0, y0, x1, y1 = math.inf, math.inf, -math.inf, -math.inf
        first, last = shapes.starts[s], shapes.starts[s] + shapes.counts[s]
        if shapes.kinds[s] == state.SEGMENT:  # without ghosts
            first, last = first + 1, last - 1
        for k in range(first, last):
            px, py = pool.corners[k, 0], pool.corners[k, 1]
            px, py = x + c * px - sine * py, y + sine * px + c * py
            x0, y0, x1, y1 = min(x0, px), min(y0, py), max(x1, px), max(y1, py)
        room = shapes.radii[s] + bodies.found[i, 3] + 0.5 * numbers.near
        shapes.boxes[s, 0], shapes.boxes[s, 1] = x0 - room, y0 - room
        shapes.boxes[s, 2], shapes.boxes[s, 3] = x1 + room, y1 + room
