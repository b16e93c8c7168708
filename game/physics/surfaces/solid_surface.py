"""A world of solids as a surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.physics.solids.arrays.state import (
    FIRST_POINT,
    IN_A_X,
    IN_B_X,
    NONE,
    NORMAL_IMPULSE,
    NORMAL_X,
    NORMAL_Y,
    POINT_WIDTH,
    POINTS,
    TANGENT_IMPULSE,
    TOUCHING,
)
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

    def held_up(self, bodies: NDArray[np.int64], dt: float) -> Floats:
        """By the impulses of the last substep, with which a solver begins the next (Catto 2005)."""
        world = self.world
        given = np.zeros((len(world.bodies.flags), 3))
        contacts, rows = world.contacts, world.bodies
        touching = contacts.marks[:, TOUCHING] == 1
        manifolds, marks = contacts.manifolds[touching], contacts.marks[touching]
        a, b = contacts.bodies[touching].T
        c, sine = rows.rotations[a].T
        x, y = manifolds[:, NORMAL_X], manifolds[:, NORMAL_Y]
        nx, ny = c * x - sine * y, sine * x + c * y
        for k in range(2):
            at = FIRST_POINT + k * POINT_WIDTH
            used = marks[:, POINTS] > k
            push, rub = used * manifolds[:, at + NORMAL_IMPULSE], used * manifolds[:, at + TANGENT_IMPULSE]
            jx, jy = push * nx + rub * ny, push * ny - rub * nx
            for one, sign, inside in ((a, -1.0, IN_A_X), (b, 1.0, IN_B_X)):
                x, y = manifolds[:, at + inside], manifolds[:, at + inside + 1]
                c, sine = rows.rotations[one].T
                turn = (c * x - sine * y) * jy - (sine * x + c * y) * jx
                np.add.at(given, one, sign * np.stack([jx, jy, turn], axis=1))
        return np.asarray(given[bodies] * (dt / world.settings.numbers(dt).h))

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike, during: float = 0.0) -> None:
        """An impulse N s at a point m; nothing to what is not dynamic.

        Given at once what gravity takes evenly, what floats or lies on a floor would hop in each step.
        """
        if not during > 0.0:
            self.world.push(body, point, impulse)
            return
        x, y = np.asarray(point, dtype=np.float64).tolist()
        fx, fy = (np.asarray(impulse, dtype=np.float64) / during).tolist()
        _, _, (cx, cy) = self.world.inverse_mass(body)
        self.world.add_force(body, (fx, fy), (x - cx) * fy - (y - cy) * fx)

    def heat(self, body: int, joule: float) -> None:
        """Heat J into a body."""
        self.warmth.add(body, joule, self.world.inverse_mass(body)[0])
