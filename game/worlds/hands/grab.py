"""Which solid lies under a point; tools that take it there and pull, as a spring does, or push it.

The world of such a hand has ``solids``, an ``anchor`` (a body that touches nothing and never moves) and
``loose()``: the bodies (n,) that a hand may take.
"""

from __future__ import annotations

import numpy as np

from game.arrays import Longs, Point
from game.physics.kernels import elementary, elementwise
from game.physics.solids import SolidWorld
from game.physics.solids.arrays.state import DISC, SEGMENT
from game.worlds.hands.hand import NOBODY, Hand, Use


def distance_to(world: SolidWorld, shape: int, point: Point) -> float:
    """From a point to a shape, m; negative within."""
    corners, radius = world.corners(shape), float(world.shapes.radii[shape])
    if world.shapes.kinds[shape] == DISC:
        return elementary.dist(point, corners[0]) - radius
    ends = np.roll(corners, -1, axis=0)
    along = ends - corners
    lengths = (along * along).sum(axis=1)
    at = np.clip(
        ((np.array(point) - corners) * along).sum(axis=1) / np.where(lengths > 0.0, lengths, 1.0), 0, 1
    )
    nearest = float(elementwise.hypot(*(corners + at[:, None] * along - point).T).min())
    if world.shapes.kinds[shape] == SEGMENT or len(corners) == 2:
        return nearest - radius
    sides = along[:, 0] * (point[1] - corners[:, 1]) - along[:, 1] * (point[0] - corners[:, 0])
    return (-nearest if (sides >= 0.0).all() else nearest) - radius


def body_at(world: SolidWorld, bodies: Longs, point: Point, reach: float) -> int:
    """The body of these that a point is in, else the nearest within reach (m); NOBODY if there is none."""
    rows = world.bodies
    near = elementwise.hypot(*(rows.positions[bodies] - point).T) <= rows.reaches[bodies] + reach
    best, found = reach, NOBODY
    for body in bodies[near].tolist():
        for shape in world.shapes_of(body).tolist():
            away = distance_to(world, shape, point)
            if away < best:
                best, found = away, body
    return found


HERTZ, DAMPING = 4.0, 0.9  # of the spring, of critical
STRENGTH = 600.0  # N for each kg of what is pulled
SHOVE = 4.0  # m/s that a push gives to the right; with Shift to the left
REACH = 0.02  # of the height in view: how near to a solid the pointer takes it


def grip(world: SolidWorld, anchor: int, body: int, point: Point) -> int:
    """The joint by which a hand holds a body at a point (m)."""
    mass = 1.0 / float(world.bodies.inverse_masses[body])
    return world.add_joint("mouse", anchor, body, point, hertz=HERTZ, damping=DAMPING, most=STRENGTH * mass)


def _body(hand: Hand) -> int:
    return body_at(hand.model.solids.world, hand.model.loose(), hand.at, hand.reach(REACH))


def _push(hand: Hand) -> str:
    body = _body(hand)
    if body == NOBODY:
        return "There is nothing to push there."
    hand.model.solids.world.set_velocity(body, (-SHOVE if hand.shift else SHOVE, 0.0), 0.0)
    return ""


def _take(hand: Hand) -> str:
    model, world = hand.model, hand.model.solids.world
    body = _body(hand)
    if body != NOBODY:
        hand.held = grip(world, model.anchor, body, hand.at)
    return ""


def _pull(hand: Hand) -> str:
    if hand.held != NOBODY:
        hand.model.solids.world.drag_to(hand.held, hand.at)
    return ""


def let_loose(hand: Hand) -> None:
    """For `Hand`, as what letting go does to the model."""
    if hand.held != NOBODY:
        hand.model.solids.world.remove_joint(hand.held)


GRAB, PUSH = Use(_take, _pull), Use(_push)
