"""Which spheres may be in contact: every way to find them leads to the same flight."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from game.physics.broadphase import HierarchicalGrid, SweepAndPrune, UniformGrid
from game.physics.spheres.composition import Composition
from game.physics.spheres.effects import COLLISIONS, IMPACT_TIMES
from game.physics.spheres.spheres import MotionState, SphereBodies
from tests.physics.spheres.colliding import heap_of, world_of

PHASES = {
    "grid": lambda: UniformGrid((-2.0, -2.0), (10.0, 10.0), 1.0),
    "hierarchical": HierarchicalGrid,
    "sweep-and-prune": SweepAndPrune,
}


def cloud(phase, **settings):
    """Discs that fly about and meet at known instants."""
    bodies, window = heap_of(24, 6)
    bodies.set_velocities(np.random.default_rng(5).uniform(-4.0, 4.0, (24, 2)), np.zeros((24, 3)))
    broad_phase = phase() if phase else None
    return world_of(bodies, window=window, broad_phase=broad_phase, **settings)


@pytest.mark.parametrize("name", PHASES)
@pytest.mark.parametrize("effects", [COLLISIONS | COLLISIONS, COLLISIONS | IMPACT_TIMES])
def test_a_broad_phase_changes_no_bit(name, effects):
    plain, quick = (cloud(phase, effects=effects) for phase in (None, PHASES[name]))
    most = 0
    for _ in range(40):
        plain.step(1.0 / 60.0)
        quick.step(1.0 / 60.0)
        assert np.array_equal(plain.bodies.state.positions, quick.bodies.state.positions)
        most = max(most, plain.parts)
    assert plain.collisions == quick.collisions > 10
    assert plain.tests == plain.parts * 23 * 12 * (2 if IMPACT_TIMES in effects else 1)
    assert quick.tests < plain.tests
    if IMPACT_TIMES in effects:
        assert most > 1 and plain.overlap() < 1e-9


def test_all_spheres_in_one_place_need_more_capacity():
    """Every pair is in contact: ten times as many contacts as there was capacity for."""
    bodies = SphereBodies(np.full((40, 2), 0.5) + np.linspace(0.0, 1e-3, 40)[:, None], np.full(40, 1.0))
    world = world_of(bodies)
    world.step(1e-3)
    normals, who, impulses = world.contacts
    assert len(normals) == len(who) == len(impulses) == 40 * 39 // 2
    assert sorted(map(tuple, who.tolist())) == [(a, b) for a in range(40) for b in range(a + 1, 40)]
    assert world.overlap() > 1.9
    other = world_of(SphereBodies(np.full((40, 2), 0.5), np.full(40, 1.0)))
    other.restore(type(world.state())(*(np.copy(part) for part in world.state())))
    for one in (world, other):
        one.step(1e-3)
    assert np.array_equal(world.bodies.state.positions, other.bodies.state.positions)


def test_bodies_of_parts_are_what_they_were():
    bodies, _ = heap_of(5, 5)
    again = SphereBodies.of_parts(Composition(*bodies.composition), MotionState(*bodies.state))
    assert (again.count, again.single, again.alike) == (5, True, True)
    assert again.state.positions is bodies.state.positions
    joined = SphereBodies([(0.0, 0.0), (1.0, 0.0)], [0.5, 0.5], owners=[0, 0], inertias="solid")
    again = SphereBodies.of_parts(joined.composition, joined.state)
    assert (again.count, again.single, again.alike) == (1, False, False)
    assert again.places() == pytest.approx(np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]))


def test_spheres_turn_with_their_body():
    places = np.array([(0.0, 0.0, 0.0), (1.0, 0.2, -0.3), (0.1, 0.9, 0.4), (-0.2, 0.1, 1.1)])
    bodies = SphereBodies(places, [0.3] * 4, owners=[0] * 4, inertias="solid")
    assert bodies.places() == pytest.approx(places)
    turn = Rotation.from_euler("xyz", (0.7, -0.4, 1.1))
    centre = bodies.state.positions[0].copy()
    bodies.state.orientations[0] = turn.as_quat()[[3, 0, 1, 2]]  # scalar first
    bodies.state.positions[0] = (3.0, 2.0, 1.0)
    assert bodies.places() - bodies.state.positions[0] == pytest.approx(turn.apply(places - centre))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"positions": []}, "positions: expected at least one"),
        ({"positions": [(0.0,), (1.0,)]}, "positions: expected rows of two or three"),
        ({"positions": [(0.0, np.nan), (0.0, 0.0)]}, "positions: expected finite numbers"),
        ({"velocities": [(0.0, 0.0)]}, "velocities: expected 2 rows, got 1"),
        ({"radii": [1.0, 0.0]}, "radii: expected 1e-09 to"),
        ({"radii": [1.0, 1.0, 1.0]}, "radii: expected one number, or one for each of 2"),
        ({"kinds": [0, -1]}, "kinds: expected whole numbers from 0"),
        ({"kinds": [0.5, 0.0]}, "kinds: expected whole numbers"),
        ({"kinds": [0, 1, 0]}, "kinds: expected whole numbers from 0"),
        ({"owners": [0, 0.5]}, "owners: expected whole numbers"),
        ({"owners": [0, 2]}, "owners: expected a body 0, 1, ..."),
        ({"owners": [0, 0], "masses": [1.0, np.inf]}, "masses: spheres joined to a body"),
        ({"inertias": "hollow"}, "inertias = 'hollow': one of unit, solid"),
        ({"inertias": [1.0, 0.0]}, "inertias: expected numbers above 0"),
        ({"inertias": np.ones((2, 2, 2))}, "inertias: expected one number or finite tensor"),
        ({"inertias": [np.eye(3), -np.eye(3)]}, r"inertias\[1\]: must be symmetric and positive"),
        ({"inertias": [1e-12 * (np.eye(3) + np.eye(3, k=1))] * 2}, r"inertias\[0\]: must be symmetric"),
        ({"orientations": [(1.0, 0.0, 0.0)]}, "orientations: expected 2 quaternions"),
        ({"orientations": [(0.0, 0.0, 0.0, 0.0)] * 2}, "orientations: a quaternion without length"),
        ({"masses": [1.0, np.inf], "velocities": [(0.0, 0.0), (1.0, 0.0)]}, "stays where it is"),
    ],
)
def test_what_no_body_is_made_of(arguments, message):
    with pytest.raises(ValueError, match=message):
        SphereBodies(**{"positions": [(0.0, 0.0), (3.0, 0.0)], "radii": 1.0, **arguments})
