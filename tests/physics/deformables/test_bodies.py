"""Depths and ways out, pushing, and soft bodies that come to rest."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.deformables import Mesh, MeshCollider, Pushing, SoftBodies, blob, mean_edge, store_of, strip
from game.physics.deformables.effects import MESH_CONTACTS, PUSHING, SELF_CONTACTS, SOFT
from game.physics.effects import EffectSet

ONLY_PUSHING = EffectSet([MESH_CONTACTS, SELF_CONTACTS, PUSHING])


def slab_in_slab(depth: float) -> tuple[SoftBodies, np.ndarray]:
    """A small block from above, so deep in a large one."""
    below, above = strip(4.0, 1.0, 1, 1), strip(0.8, 0.8, 4, 4)
    low, high = below.points - (0.0, 0.5), above.points + np.array((0.03, 0.4 - depth))
    store, points = store_of([Mesh(low, below.triangles), Mesh(high, above.triangles)])
    return SoftBodies(store, points, effects=ONLY_PUSHING), points


def test_depth_is_how_far_a_vertex_is_below_the_surface_and_out_is_up():
    """Also in the second ring, which no edge to the outside reaches: 0.25 deep, rows 0.2 apart."""
    bodies, points = slab_in_slab(0.25)
    bodies.detect()
    collider = bodies.collider
    small = np.flatnonzero(bodies.store.topology.mesh_of == 1)
    deep = small[(points[small, 1] < 0.0) & (np.abs(points[small, 0] - 0.03) < 0.3)]
    assert len(deep) == 6 and np.all(collider.inside[deep] == 1)
    depth, out_x, out_y, _, ring = collider.depths
    assert set(ring[deep]) == {1.0, 2.0} and collider.rings == 2
    assert depth[deep] == pytest.approx(-points[deep, 1], abs=1e-12)
    assert np.all(out_y[deep] > 0.999) and np.all(np.abs(out_x[deep]) < 1e-12)


def test_pushing_keeps_momentum_and_takes_the_depth_away():
    bodies, before = slab_in_slab(0.1)
    generator = np.random.default_rng(5)
    bodies.system.inverse_masses[:] = weights = generator.uniform(0.5, 2.0, bodies.store.vertices)
    bodies.system.fields[2:4, : bodies.store.vertices] = generator.normal(size=(2, bodies.store.vertices))
    speeds = bodies.system.velocities
    deepest = [bodies.deepest()]
    for _ in range(12):
        bodies.push()
        deepest.append(bodies.deepest())
    assert deepest[0] > 0.05 and deepest[-1] < 0.1 * deepest[0]
    assert ((bodies.points - before) / weights[:, None]).sum(axis=0) == pytest.approx(0.0, abs=1e-12)
    change = (bodies.system.velocities - speeds) / weights[:, None]
    assert change.sum(axis=0) == pytest.approx(0.0, abs=1e-11) and np.abs(change).max() > 0.1


def test_an_impact_is_inelastic_and_friction_slows_what_slides():
    for friction in (0.0, 0.5):
        bodies, points = slab_in_slab(0.05)
        bodies.set_steps(1, Pushing(0.0, friction))
        small = bodies.store.topology.mesh_of == 1
        bodies.system.inverse_masses[~small] = 0.0
        bodies.system.fields[2, :][: len(small)][small] = 3.0
        bodies.system.fields[3, :][: len(small)][small] = -1.0
        bodies.push()
        hit = small & (bodies.collider.depths[0] > 0.0) & (bodies.collider.depths[2] > 0.999)
        assert np.count_nonzero(hit) >= 3
        assert bodies.system.velocities[hit, 1] == pytest.approx(0.0, abs=1e-12)
        assert bodies.system.velocities[hit, 0] == pytest.approx(3.0 - friction, abs=1e-12)
        assert np.array_equal(bodies.points, points)  # a push of no stiffness moves nothing


def test_the_fixed_stay_and_a_switched_off_push_does_nothing():
    bodies, before = slab_in_slab(0.1)
    fixed = bodies.store.topology.mesh_of == 0
    bodies.system.inverse_masses[fixed] = 0.0
    bodies.push()
    assert np.array_equal(bodies.points[fixed], before[fixed])
    assert not np.array_equal(bodies.points[~fixed], before[~fixed])
    still, before = slab_in_slab(0.1)
    still.set_effects(EffectSet([MESH_CONTACTS, SELF_CONTACTS]))
    still.step(0.01)
    assert np.array_equal(still.points, before)


def test_a_blob_that_is_dropped_on_another_comes_to_rest_on_it():
    one = blob(0.15, 4)
    store, points = store_of([one, Mesh(one.points + np.array((0.01, 0.35)), one.triangles)])
    bodies = SoftBodies(
        store,
        points + np.array((0.0, 0.16)),
        20.0,
        floor=0.0,
        left=-0.18,
        right=0.18,
        iterations=8,
        damping=0.02,
    )
    bodies.set_steps(6, Pushing())
    for _ in range(180):
        bodies.step(1.0 / 60.0)
    upper = bodies.points[store.topology.mesh_of == 1]
    assert 0.35 < upper[:, 1].mean() < 0.47 and np.abs(bodies.points[:, 0]).max() < 0.19
    assert bodies.deepest() < 0.5 * bodies.mean_edge
    assert np.sqrt((bodies.system.velocities**2).sum(axis=1)).mean() < 0.2


def test_a_worm_that_falls_on_end_keeps_out_of_itself_only_with_self_contacts():
    mesh = strip(1.6, 0.07, 46, 2)
    store, points = store_of([mesh])
    upright = points[:, ::-1] * (-1.0, 1.0) + (0.0, 0.82)
    upright[:, 0] += 0.02 * points[:, 0]
    deepest = []
    for effects in (SOFT.known, SOFT.known.without(SELF_CONTACTS)):
        bodies = SoftBodies(store, upright, 100.0, rest=mesh.points, floor=0.0, iterations=4, effects=effects)
        bodies.set_steps(4, Pushing())
        look = MeshCollider(store, mean_edge(store, points), 1009)
        worst = 0.0
        for _ in range(60):
            bodies.step(1.0 / 60.0)
            look.find(bodies.points)
            worst = max(worst, float(look.depths[0].max()))
        deepest.append(worst)
    assert deepest[0] < 0.6 * deepest[1]


def test_a_state_that_is_taken_back_goes_on_alike():
    bodies, _ = slab_in_slab(0.1)
    bodies.set_effects(SOFT.known)
    kept = bodies.state()._replace(**{k: np.copy(v) for k, v in bodies.state()._asdict().items()})
    ends = []
    for _ in range(2):
        for _ in range(5):
            bodies.step(0.01)
        ends.append((bodies.points, bodies.collider.contact_keys.copy()))
        bodies.restore(kept)
    assert np.array_equal(ends[0][0], ends[1][0]) and np.array_equal(ends[0][1], ends[1][1])


def test_nonsense_is_refused():
    bodies, _ = slab_in_slab(0.1)
    for substeps, pushing, words in ((0, Pushing(), "substeps"), (1, Pushing(1.5), "stiffness"),
                                     (1, Pushing(0.5, float("nan")), "friction")):  # fmt: skip
        with pytest.raises(ValueError, match=words):
            bodies.set_steps(substeps, pushing)
