"""Forces by hand that act on spheres for a while, each at a point of a body."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.rigid import quaternion_conjugate, quaternion_rotate
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.spheres import SphereBodies

Place = tuple[float, float, float]


class Push(NamedTuple):
    """A force that acts: on a body, at a point of its own, so long."""

    body: int
    place: Place  # m from the body's centre, in its frame
    force: tuple[float, float, float]  # N
    left: float  # s


def point_of(bodies: SphereBodies, body: int, place: Place) -> Floats:
    """World position (3,) m of a point of a body."""
    state = bodies.state
    turned: Floats = state.positions[body] + quaternion_rotate(state.orientations[body], place)
    return turned


def place_of(bodies: SphereBodies, body: int, point: Floats) -> Place:
    """The opposite: where a point (3,) m of the world is in a body's frame, m from its centre."""
    state = bodies.state
    x, y, z = quaternion_rotate(
        quaternion_conjugate(state.orientations[body]), point - state.positions[body]
    ).tolist()
    return x, y, z


def apply_pushes(pushes: Iterable[Push], world: CollidingSpheres, dt: float) -> None:
    """Let forces act during the next step of dt (s); of one that ends within it, the share that is left."""
    for push in pushes:
        force = min(push.left / dt, 1.0) * np.array(push.force)
        world.apply_force(push.body, force, point_of(world.bodies, push.body, push.place))


def after_step(pushes: Iterable[Push], dt: float) -> list[Push]:
    """The forces that still act after a step of dt (s)."""
    return [push._replace(left=push.left - dt) for push in pushes if push.left > dt * (1.0 + 1e-9)]


def without_body(pushes: Iterable[Push], gone: int) -> list[Push]:
    """The forces on the other bodies, by their new numbers, after a body has been removed."""
    return [push._replace(body=push.body - (push.body > gone)) for push in pushes if push.body != gone]
