"""Both laws for spheres in contact: momentum is kept, no energy is made."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.rigid import WINDOW
from game.physics.spheres import ledger
from game.physics.spheres.settings import LAWS, material_tables
from game.physics.spheres.spheres import SphereBodies
from tests.physics.spheres.colliding import BARE, RUBBING, row_of, sums, world_of

MOMENT = 1e-12  # s, so short that nothing but the collisions happens
KINDS = 3


def touching(random, count, flat):
    """Centres (count, 3) and radii of spheres, each in contact with one or two that were there before."""
    radii = random.uniform(0.3, 1.0, count)
    places = [np.zeros(3)]
    while len(places) < count:
        i = len(places)
        one = random.integers(i)
        way = random.normal(size=3) * ((1.0, 1.0, 0.0) if flat else 1.0)
        place = places[one] + (radii[one] + radii[i]) * way / np.linalg.norm(way)
        if i > 1 and random.random() < 0.7:  # rolled round the one until it meets another
            other = int(random.choice([k for k in range(i) if k != one]))
            place = met(places[one], places[other], radii[one] + radii[i], radii[other] + radii[i], place)
        gaps = [np.linalg.norm(place - p) - radii[k] - radii[i] for k, p in enumerate(places)]
        if min(gaps) > -1e-12:
            places.append(place)
    return np.array(places), radii


def met(a, b, reach_a, reach_b, near):
    """The place at both distances from a and b that is nearest to ``near``; ``near`` if there is none."""
    along = b - a
    distance = np.linalg.norm(along)
    along /= distance
    x = (distance**2 + reach_a**2 - reach_b**2) / (2.0 * distance)
    across = near - a - ((near - a) @ along) * along
    if not abs(x) < reach_a or not np.linalg.norm(across) > 1e-6:
        return near
    return a + x * along + math.sqrt(reach_a**2 - x**2) * across / np.linalg.norm(across)


def cluster(seed, count, mu, flat, law, **more):
    """A cluster with masses, velocities, spins and materials of its own; every pair its restitution."""
    random = np.random.default_rng(seed)
    places, radii = touching(random, count, flat)
    plane = (1.0, 1.0, 0.0) if flat else (1.0, 1.0, 1.0)
    bodies = SphereBodies(
        places, radii, random.normal(0.0, 2.0, (count, 3)) * plane, random.normal(0.0, 2.0, (count, 3)),
        masses=10.0 ** random.uniform(-1.0, 1.0, count), inertias="solid",
        kinds=random.integers(0, KINDS, count),
    )  # fmt: skip
    table = random.choice([0.0, 0.3, 0.8, 1.0], (KINDS + 1, KINDS + 1))
    tables = material_tables(np.maximum(table, table.T), mu, KINDS)
    effects = more.pop("effects", RUBBING)
    return world_of(bodies, tables=tables, effects=effects, law=law, correction="none", **more)


@pytest.mark.parametrize("law", LAWS)
@settings(max_examples=120, deadline=None)
@given(
    seed=st.integers(0, 2**32 - 1), count=st.integers(2, 12), mu=st.sampled_from((0.0, 0.2, 3.0)),
    flat=st.booleans(), rounds=st.sampled_from((1, 5, 200)),
)  # fmt: skip
def test_no_cluster_gains_energy(law, seed, count, mu, flat, rounds):
    """P and L kept to rounding, E never above what it was; also where too few rounds leave work undone."""
    world = cluster(seed, count, mu, flat, law, rounds=rounds)
    momentum, spin, energy = sums(world)
    world.step(MOMENT)
    after = sums(world)
    size = np.abs(world.bodies.state.momenta).sum() + 1.0
    assert np.abs(after[0] - momentum).max() <= 1e-12 * size
    assert np.abs(after[1] - spin).max() <= 1e-11 * size
    assert after[2] <= energy * (1.0 + 1e-12)


@pytest.mark.parametrize("law", LAWS)
def test_elastic_clusters_keep_their_energy(law):
    """e = 1, no friction: E to rounding, and when all is done no contact approaches any more."""
    for seed in range(60):
        world = cluster(seed, 8, 0.0, seed % 2 == 0, law, rounds=2_000)
        world.tables = material_tables(1.0, 0.0, KINDS)
        energy = sums(world)[2]
        world.step(MOMENT)
        assert sums(world)[2] == pytest.approx(energy, rel=1e-11)
        made = world.collisions
        world.step(MOMENT)
        assert world.collisions == made


def test_what_separates_waits_for_its_turn():
    """The second of three is hit and then meets the third, which was leaving it: 1, 0, 1/2 to 0, 1/2, 1."""
    world = world_of(row_of([1.0, 0.0, 0.5]), law="at-once")
    world.step(MOMENT)
    assert world.bodies.velocities[:, 0] == pytest.approx([0.0, 0.5, 1.0], abs=1e-14)
    assert (world.rounds, world.bounces, world.collisions) == (2, 2, 2)
    entries = world.ledger()
    assert entries[:, ledger.ONE].tolist() == [0.0, 1.0]
    assert entries[:, ledger.BEFORE] == pytest.approx([-1.0, -0.5])
    assert entries[:, ledger.AFTER] == pytest.approx([1.0, 0.5])
    assert np.abs(entries[:, ledger.CHANGE]).max() < 1e-15


def test_without_rebound_one_round_ends_all_approach():
    """e = 0: the nearest velocities that nothing forbids; those that leave faster are left alone."""
    world = world_of(row_of([1.0, 0.0, 0.25, 2.0]), law="at-once", restitution=0.0)
    world.step(MOMENT)
    assert world.bodies.velocities[:, 0] == pytest.approx([5 / 12, 5 / 12, 5 / 12, 2.0], abs=1e-13)
    assert world.rounds == 1


@pytest.mark.parametrize("e", [0.5, 0.9])
def test_bounces_without_end_are_ended(e):
    """A light sphere to and fro between two heavy ones: more rounds than there are, then no rebound."""
    world = world_of(
        row_of([3.0, 0.0, 0.5], masses=[50.0, 0.1, 70.0]), law="at-once", restitution=e, rounds=20
    )
    momentum, _, energy = sums(world)
    world.step(MOMENT)
    assert world.rounds == 20
    assert np.diff(world.bodies.velocities[:, 0]).min() >= -1e-12
    after = sums(world)
    assert after[0] == pytest.approx(momentum, abs=1e-11) and after[2] < energy


@pytest.mark.parametrize("e", [1.0, 0.5, 0.0])
def test_a_full_box_gains_nothing_in_ten_seconds(e):
    """60 discs that start in contact, walls with them: in no step does the energy rise.

    Without the warm start of resting contacts, whose old impulses are not those of a collision.
    """
    random = np.random.default_rng(1)
    places = [(0.5 + i % 8, 0.5 + i // 8) for i in range(60)]
    bodies = SphereBodies(places, np.full(60, 0.5), random.normal(0.0, 2.0, (60, 2)))
    world = world_of(
        bodies, restitution=e, window=(0, 0, 12, 12), effects=BARE | WINDOW, law="at-once", correction="none",
        warm=False,
    )  # fmt: skip
    energy = sums(world)[2]
    for _ in range(600):
        world.step(1.0 / 60.0)
        now = sums(world)[2]
        assert now <= energy * (1.0 + 1e-13)
        energy = now
    assert world.collisions > 300


def test_too_few_sweeps_gain_nothing():
    """Spheres within each other, masses from 1e-6 to 1e6 kg: sweeps end before the impulses fit together.

    As the sweeps leave them, they would raise the energy by 2e-7 of it.
    """
    random = np.random.default_rng(2089)
    count = int(random.integers(3, 14))
    places, radii = random.normal(0.0, 0.3, (count, 3)), random.uniform(0.3, 1.0, count)
    velocities, masses = random.normal(0.0, 2.0, (count, 3)), 10.0 ** random.uniform(-6.0, 6.0, count)
    bodies = SphereBodies(places, radii, velocities, masses=masses)
    world = world_of(bodies, law="at-once", restitution=1.0, correction="none", warm=False)
    momentum, _, energy = sums(world)
    world.step(MOMENT)
    after = sums(world)
    assert after[2] <= energy * (1.0 + 1e-12)
    assert after[0] == pytest.approx(momentum, rel=1e-12)
