"""Spheres made and removed: other bodies, of the same arrays with rows more or fewer."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.physics.spheres.composition import Composition
from game.physics.spheres.settings import Surroundings
from game.physics.spheres.spheres import MotionState, SphereBodies


def joined(bodies: SphereBodies, new: SphereBodies) -> SphereBodies:
    """The bodies, and a new one of a single sphere after them."""
    pairs: Any = (
        zip(bodies.composition, new.composition, strict=True),
        zip(bodies.state, new.state, strict=True),
    )
    composition = Composition(*(np.concatenate(pair) for pair in pairs[0]))
    composition.owners[-1] = bodies.count
    state = MotionState(*(np.concatenate(pair) for pair in pairs[1]))
    return SphereBodies.of_parts(composition, state)


def without(bodies: SphereBodies, around: Surroundings, gone: int) -> tuple[SphereBodies, Surroundings]:
    """The bodies but for one, and the surroundings without its strings."""
    stay = bodies.composition.owners != gone
    kept = np.arange(bodies.count) != gone
    composition = Composition(
        *(part[kept] for part in bodies.composition[:3]), *(part[stay] for part in bodies.composition[3:])
    )
    composition.owners[composition.owners > gone] -= 1
    state = MotionState(*(part[kept] for part in bodies.state))
    number = np.cumsum(stay) - 1
    held = stay[around.hung]
    around = around._replace(hung=number[around.hung[held]], strings=around.strings[held])
    return SphereBodies.of_parts(composition, state), around
