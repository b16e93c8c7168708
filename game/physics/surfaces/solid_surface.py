"""A world of solids as a surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from game.physics.solids.arrays.state import NONE
from game.physics.solids.world import SolidWorld
from game.physics.surfaces.solid_kernels import sample_solids
from game.physics.surfaces.surface import Sample, Warmth, checked_places, empty_sample


class SolidSurface:
    """Answers for all bodies of a world: discs, polygons, capsules, compounds, chains (thin, solid
    behind), but for bodies ``without``.
    """

    def __init__(self, world: SolidWorld, warmth: Warmth | None = None, without: ArrayLike = ()):
        self.world = world
        self.without = np.asarray(without, dtype=np.int64)
        self.warmth = warmth or Warmth()

    def sample(self, points: ArrayLike) -> Sample:
        """Of the nearest body at points (n, 2) m."""
        places = checked_places(points)
        found = empty_sample(len(places))
        world, shapes = self.world, self.world.shapes
        if len(self.without):
            hidden = np.zeros(len(world.bodies.flags), np.bool_)
            hidden[self.without] = True
            shapes = shapes._replace(kinds=np.where(hidden[shapes.bodies], NONE, shapes.kinds))
        sample_solids(
            places, world.bodies, shapes, world.pool, found.distance, found.normal, found.velocity,
            found.friction, found.body,
        )  # fmt: skip
        np.copyto(found.temperature, self.warmth.array(found.body))
        return found

    def inverse_mass(self, body: int) -> tuple[float, float, tuple[float, float]]:
        """1/m, 1/I and the centre of mass."""
        return self.world.inverse_mass(body)

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike) -> None:
        """An impulse N s at a point m; nothing to what is not dynamic."""
        self.world.push(body, point, impulse)

    def heat(self, body: int, joule: float) -> None:
        """Heat J into a body."""
        self.warmth.add(body, joule, self.world.inverse_mass(body)[0])
