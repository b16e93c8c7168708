"""The rigid body as it is, as the content of a level file."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.scenes.rigid_body.bodies import A
from game.scenes.rigid_body.level import FARTHEST, RigidContent, entries_of
from game.scenes.rigid_body.model import RigidModel


def _kept_within(vector: Floats) -> tuple[float, float, float]:
    """What a level file keeps of a place or velocity: what is beyond `FARTHEST` stays there."""
    x, y, z = np.clip(vector, -FARTHEST, FARTHEST).tolist()
    return x, y, z


def content_of(model: RigidModel) -> RigidContent:
    """The spheres as they are now, in their own frame, with the motion that the body has."""
    body = model.bodies.all[A]
    return RigidContent(
        spheres=entries_of(model.bodies.design),
        place=_kept_within(body.position),
        orientation=tuple(body.orientation.tolist()),
        velocity=_kept_within(body.velocity),
        spin=_kept_within(body.angular_velocity),
        window=model.content.window,
        expected=model.content.expected,
    )
