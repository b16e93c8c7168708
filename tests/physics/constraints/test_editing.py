"""Adding, taking away and cutting while the rest goes on; shapes; pairs that bounce."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.constraints import AREAS, CONTACTS, LINKS, PositionBasedDynamics, shapes
from game.physics.constraints.editing import (
    links_across,
    nearest_particle,
    topology_of,
    with_link,
    with_particle,
    without_particle,
)
from game.physics.fields import GRAVITY


def jelly():
    block = shapes.block((0, 0), 4, 3, 0.5)
    system = PositionBasedDynamics(
        *block[:3], areas=block.areas, effects=GRAVITY | LINKS | AREAS, iterations=3
    )
    for _ in range(10):
        system.step(1 / 60)
    return system


def test_a_particle_more_changes_nothing_else():
    system = jelly()
    more = with_particle(system, (5.0, 5.0), 0.25)
    assert more.count == system.count + 1
    assert np.array_equal(more.positions[:-1], system.positions)
    assert np.array_equal(more.velocities[:-1], system.velocities)
    assert more.inverse_masses[-1] == 0.25
    for _ in range(20):
        system.step(1 / 60)
        more.step(1 / 60)
    assert np.array_equal(more.positions[:-1], system.positions)
    more.check()


def test_a_particle_less_takes_its_links_and_outlines():
    system = jelly()
    less = without_particle(system, 5)
    pairs = system.links.pairs
    kept = np.all(pairs != 5, axis=1)
    assert less.links.pairs.tolist() == (pairs[kept] - (pairs[kept] > 5)).tolist()
    assert np.array_equal(less.links.rest, system.links.rest[kept])
    before, after = topology_of(system), topology_of(less)
    assert 0 < len(after.starts) < len(before.starts)
    assert np.array_equal(less.positions, np.delete(system.positions, 5, axis=0))
    less.step(1 / 60)
    less.check()


def test_links_are_made_once():
    system = with_particle(jelly(), (3.0, 1.0), 1.0)
    linked = with_link(system, system.count - 1, 0, 0.5, 1e-3)
    assert linked.links.rest[-1] == pytest.approx(math.dist((3, 1), linked.positions[0]))
    assert linked.links.stiffness[-1] == 0.5
    with pytest.raises(ValueError, match="linked already"):
        with_link(linked, 0, linked.count - 1)
    linked.cut(len(linked.torn) - 1)
    assert len(with_link(linked, 0, linked.count - 1).torn) == len(linked.torn) + 1


def test_the_last_particle_stays():
    with pytest.raises(ValueError, match="last"):
        without_particle(PositionBasedDynamics([(0, 0)]), 0)


def test_nearest_and_cut():
    system = PositionBasedDynamics([(0, 0), (2, 0), (2, 2)], 1.0, [(0, 1), (1, 2)])
    assert nearest_particle(system, (1.9, 0.1), 0.5) == 1
    assert nearest_particle(system, (1.0, 1.0), 0.5) == -1
    assert links_across(system, (1.0, -1.0), (1.0, 1.0)) == [0]
    assert links_across(system, (1.0, -1.0), (1.0, -0.1)) == []
    assert sorted(links_across(system, (1.0, -1.0), (3.0, 1.5))) == [0, 1] or links_across(
        system, (1.0, -1.0), (3.0, 1.5)
    ) in ([0], [1], [])
    # in two pieces that meet on the link, it is cut by exactly one of them
    pieces = links_across(system, (1.0, -1.0), (1.0, 0.0)) + links_across(system, (1.0, 0.0), (1.0, 1.0))
    assert pieces == [0]


@pytest.mark.parametrize(
    ("shape", "particles", "links", "areas"),
    [
        (shapes.rope((0, 0), (1, 0), 5), 6, 5, 0),
        (shapes.cloth((0, 0), 5, 4, 0.1), 20, 31, 0),
        (shapes.cloth((0, 0), 5, 4, 0.1, shear=True), 20, 55, 0),
        (shapes.block((0, 0), 5, 4, 0.1), 20, 55, 12),
        (shapes.bridge((0, 0), (5, 0), 5, 1.0, lamps=2), 18, 20, 0),
        (shapes.ring((0, 0), 1.0, 12), 12, 12, 1),
        (shapes.cradle((0, 0), 5, 0.1, 1.0, 0.5), 10, 5, 0),
    ],
)
def test_shapes_have_what_they_should(shape, particles, links, areas):
    assert len(shape.positions) == len(shape.inverse_masses) == particles
    assert len(shape.links) == links
    assert len(shape.areas) == areas
    system = PositionBasedDynamics(*shape[:3], areas=shape.areas)
    assert np.all(system.links.rest > 0.0)
    assert np.all(system.areas()[1] > 0.0)
    system.check()


def test_cloth_lies_as_its_index_says():
    net = shapes.cloth((1, 2), 7, 4, 0.5)
    index = shapes.cloth_index(7, 4)
    assert np.allclose(net.positions[index[2, 5]], (1 + 2.5, 2 - 1.0))
    lengths = np.linalg.norm(net.positions[net.links[:, 1]] - net.positions[net.links[:, 0]], axis=1)
    assert np.allclose(lengths, 0.5)


@pytest.mark.parametrize(
    "bad",
    [
        lambda: shapes.cloth((0, 0), 1, 4, 0.1),
        lambda: shapes.cloth((0, 0), 4, 4, 0.1, pins="x"),
        lambda: shapes.rope((0, 0), (1, 0), 10**6),
        lambda: shapes.ring((0, 0), 1, 1),
    ],
)
def test_absurd_shapes_are_refused(bad):
    with pytest.raises(ValueError, match="expected"):
        bad()


def test_a_shock_runs_through_a_row_of_touching_balls():
    """Five balls in a row, two come in: two go out, with their speed; momentum and energy are kept."""
    x = [-0.5, -0.4, 0.0, 0.1, 0.2, 0.3, 0.4]
    system = PositionBasedDynamics(
        [(v, 0) for v in x], velocities=[(2, 0), (2, 0)] + [(0, 0)] * 5,
        contacts=[(i, i + 1) for i in range(6)], distances=0.1, effects=CONTACTS | LINKS, substeps=8,
    )  # fmt: skip
    for _ in range(30):
        system.step(1 / 60)
    assert np.allclose(system.velocities[:, 0], [0, 0, 0, 0, 0, 2, 2], rtol=0, atol=1e-9)


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_restitution_of_a_pair_of_unequal_mass(e):
    system = PositionBasedDynamics(
        [(0, 0), (1, 0)], [1.0, 0.25], velocities=[(3, 0), (-1, 0)], contacts=[(0, 1)], distances=0.5,
        effects=CONTACTS | LINKS, restitution=e,
    )  # fmt: skip
    for _ in range(30):
        system.step(1 / 60)
    v = system.velocities[:, 0]
    assert v[1] - v[0] == pytest.approx(4.0 * e, abs=1e-9)
    assert v[0] + 4 * v[1] == pytest.approx(3 - 4, abs=1e-9)
    assert np.diff(system.positions[:, 0])[0] >= 0.5 - 1e-9
