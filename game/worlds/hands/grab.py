"""Tools that take a solid by a point of it and pull, as a spring of the hand's strength does, or push it.

The world of such a hand has ``solids``, an ``anchor`` (a body that touches nothing and never moves) and
``loose()``: the bodies (n,) that a hand may take.
"""

from __future__ import annotations

from game.arrays import Point
from game.physics.solids import SolidWorld
from game.worlds.hands.hand import NOBODY, Hand, Use
from game.worlds.hands.picking import body_at

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
