"""What the tests of colliding spheres share."""

from __future__ import annotations

import math

import numpy as np

from game.physics.effects import EffectSet
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.effects import COLLISIONS, FRICTION
from game.physics.spheres.settings import material_tables, surroundings_of
from game.physics.spheres.spheres import SphereBodies

BARE = EffectSet([COLLISIONS])
RUBBING = COLLISIONS | FRICTION


def world_of(bodies, *, restitution=1.0, friction=0.0, window=None, effects=BARE, **settings):
    """A world of these bodies; semi-implicit unless said otherwise."""
    around = surroundings_of(*([window] if window is not None else []), **settings.pop("around", {}))
    settings.setdefault("scheme", "semi-implicit")
    broad_phase = settings.pop("broad_phase", None)
    tables = settings.pop("tables", None) or material_tables(restitution, friction)
    return CollidingSpheres(bodies, around, tables, broad_phase, effects=effects, **settings)


def row_of(velocities, radius=0.5, **more):
    """Spheres in a row along x that contact, with velocities along it."""
    n = len(velocities)
    places = [(2.0 * radius * i, 0.0) for i in range(n)]
    return SphereBodies(places, np.full(n, radius), [(v, 0.0) for v in velocities], **more)


def two(normal, velocities, masses, turning=None, **more):
    """Two spheres of radius 0.5 in contact along a normal from the first to the second."""
    return SphereBodies([(0.0, 0.0, 0.0), normal], [0.5, 0.5], velocities, turning, masses=masses, **more)


def heap_of(count, columns, radius=0.43, seed=1):
    """Discs a little out of order, one to a square metre, from the ground up; and a window around them."""
    random = np.random.default_rng(seed)
    i = np.arange(count)
    shift = random.uniform(-0.05, 0.05, (count, 2))
    places = np.stack((0.5 + i % columns, 0.5 + i // columns), axis=1) + shift
    inertias = np.full(count, 0.5 * radius**2)
    bodies = SphereBodies(places, np.full(count, radius), inertias=inertias)
    return bodies, (0.0, 0.0, float(columns), 4.0 * (count // columns + 1))


def sums(world):
    """Momentum (3,), angular momentum about the origin (3,) and energy of motion, summed without loss."""
    bodies = world.bodies
    free = np.isfinite(bodies.composition.masses)
    momenta, spins = bodies.state.momenta[free], bodies.state.spins[free]
    orbital = np.cross(bodies.state.positions[free], momenta)
    energy = 0.5 * (momenta * bodies.velocities[free]).sum() + 0.5 * (spins * bodies.turning[free]).sum()
    return (
        np.array([math.fsum(column) for column in momenta.T]),
        np.array([math.fsum(column) for column in (orbital + spins).T]),
        float(energy),
    )
