"""The rigid body scene's state: what is remembered of it, how it is put back, and what a level file keeps."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.scenes.rigid_body.bodies import A
from game.scenes.rigid_body.level import FARTHEST, RigidContent, entries_of

if TYPE_CHECKING:
    from game.scenes.rigid_body.scene import RigidBodyScene

Array = NDArray[np.float64]
TRAIL = 400  # steps that the trail of L on its sphere goes back


class RigidState(NamedTuple):
    """What moves, of what it is made, and what is remembered of it."""

    rows: Array  # (3, 13)
    accounts: Array  # (3, 4)
    design: Array  # (n, 6)
    density: float  # kg/m³
    trail: Array  # (2, TRAIL, 3): direction of L in the body's frame, by step number modulo TRAIL


def state_of(scene: RigidBodyScene) -> RigidState:
    """The scene's own arrays, not copies."""
    bodies = scene.bodies
    return RigidState(bodies.rows, bodies.accounts, bodies.design, bodies.density, scene.trail)


def restore(scene: RigidBodyScene, state: RigidState) -> None:
    """Put a state back; bodies of another design are made anew."""
    scene.bodies.take(state.rows, state.design, float(state.density))
    np.copyto(scene.bodies.accounts, state.accounts)
    np.copyto(scene.trail, state.trail)
    scene.configure()


def _kept_within(vector: Array) -> tuple[float, float, float]:
    """What a level file keeps of a place or velocity: what is beyond `FARTHEST` stays there."""
    x, y, z = np.clip(vector, -FARTHEST, FARTHEST).tolist()
    return x, y, z


def content_of(scene: RigidBodyScene) -> RigidContent:
    """The spheres as they are now, in their own frame, with the motion that the body has."""
    body = scene.bodies.all[A]
    return RigidContent(
        spheres=entries_of(scene.bodies.design),
        place=_kept_within(body.position),
        orientation=tuple(body.orientation.tolist()),
        velocity=_kept_within(body.velocity),
        spin=_kept_within(body.angular_velocity),
        window=scene.content.window,
    )
