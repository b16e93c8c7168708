"""Spheres as they stand, as the content of a level file."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementary
from game.scenes.spheres.level import FARTHEST, MOST_WRITTEN, CollisionContent, SphereEntry, StringEntry
from game.scenes.spheres.model import CollisionModel


def content_of(model: CollisionModel) -> CollisionContent:
    """The spheres one by one; too many for that as their level has them.

    What is beyond `FARTHEST`, which no window shows, is kept there.
    """
    bodies, around, given = model.world.bodies, model.world.surroundings, model.content
    composition = bodies.composition
    if len(composition.radii) > MOST_WRITTEN:
        return given
    places, velocities, turning = (
        np.clip(rows, -FARTHEST, FARTHEST) for rows in (bodies.places(), bodies.velocities, bodies.turning)
    )
    shared = np.bincount(composition.owners) > 1
    own_mass = _masses_of_spheres(model)
    spheres = tuple(
        SphereEntry(
            position=tuple(place),
            radius=float(composition.radii[s]),
            velocity=tuple(velocities[body].tolist()),
            turning=tuple(turning[body].tolist()),
            orientation=tuple(bodies.state.orientations[body].tolist()),
            mass=None if math.isinf(own_mass[s]) else float(own_mass[s]),
            fixed=math.isinf(own_mass[s]),
            material=given.materials[composition.kinds[s]] if given.materials else None,
            body=body if shared[body] else None,
        )
        for s, (place, body) in enumerate(zip(places.tolist(), composition.owners.tolist(), strict=True))
    )
    ties = zip(around.hung.tolist(), around.strings.tolist(), strict=True)
    return CollisionContent(
        spheres=spheres,
        strings=tuple(StringEntry(sphere=sphere, tied=tuple(tie[:3]), length=tie[3]) for sphere, tie in ties),
        ledges=given.ledges,
        materials=given.materials,
        pairs=given.pairs,
        expected=given.expected,
        repeat=given.repeat,
        zoom=given.zoom,
        exact=given.exact,
        view=given.view,
    )


def _masses_of_spheres(model: CollisionModel) -> np.ndarray:
    """Mass (s,) kg of each sphere: a body's is shared by volume, as all of it has one density."""
    composition = model.world.bodies.composition
    volumes = elementary.cube(composition.radii)
    whole = np.bincount(composition.owners, weights=volumes)
    shares: np.ndarray = composition.masses[composition.owners] * (volumes / whole[composition.owners])
    return shares
