"""Rule of every room that moves something: an effect that is off is its number at 0, to the bit."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.animation.easing import Easing
from game.physics.animation.effects import EASING
from game.physics.animation.keyframes import Keyframes
from game.physics.animation.playback import Playback
from game.physics.constraints import (
    AREAS,
    ATTACHMENTS,
    DAMPING,
    LINKS,
    TEARING,
    PositionBasedDynamics,
    shapes,
)
from game.physics.constraints.effects import CONTACTS
from game.physics.effects import EffectSet
from game.physics.fields import ATTRACTOR, DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import METHODS as FLIGHTS
from game.physics.particles import Forces, ParticleSystem
from game.physics.rigid import METHODS, PUSHES, ROTATION, WINDOW, RigidBody
from game.physics.spheres.collisions import CollidingSpheres
from game.physics.spheres.effects import COLLISIONS, FRICTION, LEDGES, STRINGS
from game.physics.spheres.settings import PATHS, material_tables, surroundings_of
from game.physics.spheres.spheres import SphereBodies

LAW = {
    "gravity": 9.81, "drag": 0.7, "quadratic_drag": 0.05, "wind_x": 2.0, "wind_y": -0.5, "whirl_x": 1.0,
    "whirl_y": 1.5, "whirl_strength": 1.3, "whirl_core": 0.4, "pull_x": 0.5, "pull_y": 0.2, "pull": 3.0,
}  # fmt: skip
FIELDS = GRAVITY | DRAG | QUADRATIC_DRAG | WIND | WHIRL | ATTRACTOR


def flown(effects, method, **numbers):
    random = np.random.default_rng(3)
    forces = Forces(**{**LAW, **numbers})
    system = ParticleSystem(50, effects=effects, method=method, forces=forces, life=1e9, substeps=2)
    system.add(random.uniform(-3, 3, (50, 2)), random.uniform(-5, 5, (50, 2)))
    for _ in range(20):
        system.step(0.02)
    return np.concatenate([system.positions, system.velocities])


@pytest.mark.parametrize("method", FLIGHTS)
@pytest.mark.parametrize(
    ("effect", "numbers"),
    [
        (GRAVITY, {"gravity": 0.0}),
        (DRAG, {"drag": 0.0}),
        (QUADRATIC_DRAG, {"quadratic_drag": 0.0}),
        (WIND, {"wind_x": 0.0, "wind_y": 0.0}),
        (WHIRL, {"whirl_strength": 0.0}),
        (ATTRACTOR, {"pull": 0.0}),
    ],
)
def test_particles(method, effect, numbers):
    off, naught = flown(FIELDS.without(effect), method), flown(FIELDS, method, **numbers)
    assert np.array_equal(off, naught)
    assert not np.array_equal(off, flown(FIELDS, method))


def tumbled(effects, method, pushed=True, **numbers):
    body = RigidBody.from_spheres(
        [(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.4, 0.1)], [0.5, 0.25, 0.3], 1.0,
        velocity=(1.0, 2.0, -0.5), angular_velocity=(0.3, 1.0, 2.0), method=method, effects=effects,
        **{"gravity": 9.81, "damping": 0.4, **numbers},
    )  # fmt: skip
    for _ in range(30):
        if pushed:
            body.apply_force((0.1, 0.2, 0.3), body.position + np.array((0.2, 0.0, 0.1)))
        body.step(0.01)
    return body.state.copy()


@pytest.mark.parametrize("method", METHODS)
def test_a_rigid_body(method):
    every = GRAVITY | DRAG | ROTATION | PUSHES
    full = tumbled(every, method)
    for effect, numbers in (
        (GRAVITY, {"gravity": 0.0}),
        (DRAG, {"damping": 0.0}),
        (PUSHES, {"pushed": False}),
        (WINDOW, {}),  # the box is beyond all that is reached
    ):
        off = tumbled(every.without(effect), method)
        assert np.array_equal(off, tumbled(every, method, **numbers))
        assert np.array_equal(off, full) == (effect is WINDOW)


def collided(effects, path, gravity=9.81, drag=0.3, friction=0.4, around=True, pushed=True):
    random = np.random.default_rng(8)
    places = np.array([(0.5 + i % 4, 0.5 + i // 4) for i in range(12)]) + random.uniform(-0.05, 0.05, (12, 2))
    bodies = SphereBodies(places, np.full(12, 0.45), random.normal(0.0, 2.0, (12, 2)))
    room = surroundings_of((0, 0, 4, 9), [(1.0, 3.2, 3.0, 3.6)]) if around else surroundings_of()
    world = CollidingSpheres(
        bodies, room, material_tables(0.5, friction), effects=effects, path=path, gravity=gravity, drag=drag
    )
    for _ in range(30):
        if pushed:
            world.apply_force(3, (1.0, 2.0, 0.0), (*places[3], 0.0))
        world.step(1.0 / 60.0)
    return np.concatenate([part.ravel() for part in bodies.state])


@pytest.mark.parametrize("path", PATHS[1:])
def test_colliding_spheres(path):
    every = GRAVITY | DRAG | ROTATION | WINDOW | PUSHES | COLLISIONS | FRICTION | LEDGES | STRINGS
    full = collided(every, path)
    for effect, numbers in (
        (GRAVITY, {"gravity": 0.0}),
        (DRAG, {"drag": 0.0}),
        (FRICTION, {"friction": 0.0}),
        (PUSHES, {"pushed": False}),
        (STRINGS, {}),  # nothing hangs
    ):
        off = collided(every.without(effect), path)
        assert np.array_equal(off, collided(every, path, **numbers)), effect.name
        assert np.array_equal(off, full) == (effect is STRINGS), effect.name
    without = every.without(WINDOW).without(LEDGES)
    assert np.array_equal(collided(without, path), collided(every, path, around=False))


def swung(effects, model, scheme, **numbers):
    cloth = shapes.cloth((0.0, 0.0), 5, 4, 0.2)
    weights = np.ones(len(cloth.positions))
    weights[0] = 0.0
    given = {
        "gravity": 9.81, "damping": 0.3, "stiffness": 0.9, "areas": [[1, 2, 7, 6]], "area_stiffness": 0.5,
        "contacts": [(3, 12)], "distances": 0.9, "stretch_limit": 0.02, "floor": -0.5, **numbers,
    }  # fmt: skip
    system = PositionBasedDynamics(
        cloth.positions, weights, cloth.links, effects=effects, model=model, scheme=scheme, iterations=4,
        compliances=1e-4, area_compliance=1e-3, **given,
    )  # fmt: skip
    for _ in range(25):
        system.step(1.0 / 60.0)
    return system.fields[:10, : system.count].copy()


@pytest.mark.parametrize("model", ["pbd", "xpbd"])
@pytest.mark.parametrize("scheme", ["euler", "bdf2"])
def test_linked_particles(model, scheme):
    every = GRAVITY | GROUND | LINKS | AREAS | ATTACHMENTS | TEARING | DAMPING | CONTACTS
    full = swung(every, model, scheme)
    cases = [
        (GRAVITY, {"gravity": 0.0}),
        (DAMPING, {"damping": 0.0}),
        (AREAS, {"areas": ()}),
        (CONTACTS, {"contacts": (), "distances": ()}),
        (TEARING, {"stretch_limit": 1e9}),
        (GROUND, {"floor": -1e6}),
    ]
    if model == "pbd":
        cases.append((AREAS, {"area_stiffness": 0.0}))
    for effect, numbers in cases:
        off = swung(every.without(effect), model, scheme)
        assert np.array_equal(off, swung(every, model, scheme, **numbers)), effect.name
        assert not np.array_equal(off, full), effect.name


def test_played_key_frames():
    track = Keyframes([0.0, 1.0, 3.0], [(0.0, 0.0), (1.0, 2.0), (4.0, 0.0)], "spline")
    parts = np.linspace(0.0, 1.0, 33)
    off = Playback(track, easing=Easing("ease"), effects=EffectSet())
    assert np.array_equal(off.sample(parts), Playback(track, easing=None, effects=EASING).sample(parts))
    assert not np.array_equal(
        off.sample(parts), Playback(track, easing=Easing("ease"), effects=EASING).sample(parts)
    )
