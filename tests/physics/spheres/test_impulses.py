"""Single collisions against closed forms, and the hard cases of C13 that are about them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.spheres import ledger
from game.physics.spheres.effects import USUAL
from game.physics.spheres.settings import material_tables
from game.physics.spheres.spheres import SphereBodies
from tests.physics.spheres.colliding import RUBBING, row_of, sums, two, world_of

MOMENT = 1e-9  # s, so short that nothing but the collision happens
EPS = 2.0**-52
NORMAL = np.array((2.0, 1.0, 2.0)) / 3.0


def test_smooth_spheres_in_space():
    """m = 2, 3; v = (3, 1, 0), (-1, 0, 1); normal (2, 1, 2) / 3; e = 1/2: j = 4.2, loss 2.45 J."""
    world = world_of(two(NORMAL, [(3, 1, 0), (-1, 0, 1)], [2, 3]), restitution=0.5)
    world.step(MOMENT)
    assert np.allclose(world.bodies.velocities[0], (1.6, 0.3, -1.4), rtol=0, atol=1e-14)
    assert np.allclose(world.bodies.velocities[1], (-1 / 15, 7 / 15, 29 / 15), rtol=0, atol=1e-14)
    entry = world.ledger()[0]
    impulse = entry[ledger.JX : ledger.JZ + 1]
    assert np.allclose(impulse, 4.2 * NORMAL, rtol=0, atol=1e-14)
    assert entry[ledger.CHANGE] == pytest.approx(-2.45, abs=1e-14)
    assert entry[ledger.EXPECTED] == pytest.approx(-2.45, abs=1e-14)
    assert entry[ledger.LOST_MOMENTUM] < 1e-14 and entry[ledger.LOST_SPIN] < 1e-14


def compound():
    """A body of inertia diag(0.2, 1.2, 1.2) and mass 2 struck at (1, 0.5, 0) from above by a sphere.

    Two light spheres make the ends of the body: the one at (1, 0.4) is hit on its top.
    """
    bodies = SphereBodies(
        [(1, 0.4, 0), (-1, -0.4, 0), (1, 1.0, 0)],
        [0.1, 0.1, 0.5],
        [(0, 0, 0), (0, -4, 0)],
        masses=[1, 1, 1],
        owners=[0, 0, 1],
        inertias=[np.diag((0.2, 1.2, 1.2)), np.eye(3)],
    )
    return world_of(bodies, restitution=0.5)


def test_a_body_of_several_spheres_is_struck_off_its_centre():
    """j = 18/7, v_A' = (0, -9/7, 0), w_A' = (0, 0, -15/7), v_B' = (0, -10/7, 0)."""
    world = compound()
    world.step(MOMENT)
    assert np.allclose(world.bodies.velocities, [(0, -9 / 7, 0), (0, -10 / 7, 0)], rtol=0, atol=1e-8)
    assert np.allclose(world.bodies.turning[0], (0, 0, -15 / 7), rtol=0, atol=1e-8)
    assert world.ledger()[0, ledger.JY] == pytest.approx(18 / 7, abs=1e-8)
    assert world.ledger()[0, ledger.LOST_SPIN] < 1e-14


def test_friction_that_sticks():
    """Equal solid spheres: a slip u is stopped by m u / 7; on a wall by 2 m u / 7."""
    bodies = two((1, 0, 0), [(0.5, 0, 0), (-0.5, 0.7, 0)], 1.0, inertias="solid")
    world = world_of(bodies, restitution=0.0, friction=10.0, effects=RUBBING)
    world.step(MOMENT)
    assert world.ledger()[0, ledger.JY] == pytest.approx(-0.7 / 7.0, abs=1e-14)
    ball = SphereBodies([(0.0, 0.5)], [0.5], [(0.7, -1.0)], inertias="solid")
    world = world_of(ball, restitution=0.0, friction=10.0, window=(-9, 0, 9, 9), effects=USUAL, gravity=0.0)
    world.step(MOMENT)
    assert world.bodies.velocities[0, 0] == pytest.approx(0.7 - 2 * 0.7 / 7, abs=1e-12)
    rim = world.bodies.velocities[0, 0] + 0.5 * world.bodies.turning[0, 2]
    assert rim == pytest.approx(0.0, abs=1e-12)


def test_friction_that_slides_takes_mu_times_the_impulse():
    bodies = two((1, 0, 0), [(1, 0, 0), (-1, 9, 0)], 1.0, inertias="solid")
    world = world_of(bodies, restitution=0.5, friction=0.1, effects=RUBBING)
    world.step(MOMENT)
    assert world.ledger()[0, ledger.JX] == pytest.approx(1.5, abs=1e-14)
    assert world.ledger()[0, ledger.JY] == pytest.approx(-0.15, abs=1e-14)


speeds = st.floats(-5.0, 5.0).filter(lambda v: v == 0.0 or abs(v) > 1e-6)
vectors = st.tuples(speeds, speeds, speeds)


@settings(max_examples=60, deadline=None)
@given(
    axis=vectors.filter(lambda v: np.linalg.norm(v) > 0.1),
    a=vectors,
    b=vectors,
    spins=st.tuples(vectors, vectors),
    masses=st.tuples(st.floats(0.01, 100.0), st.floats(0.01, 100.0)),
    e=st.floats(0.0, 1.0),
    mu=st.sampled_from((0.0, 0.3, 50.0)),
)
def test_the_ledger_of_any_collision(axis, a, b, spins, masses, e, mu):
    """P and L conserved, v_n' = -e v_n, energy by J · mean velocity, and never gained."""
    normal = np.array(axis) / np.linalg.norm(axis)
    world = world_of(
        two(normal, [a, b], masses, spins, inertias="solid"), restitution=e, friction=mu, effects=RUBBING
    )
    before = sums(world)
    approach = float((np.array(b) - np.array(a)) @ normal)
    turning = world.bodies.turning.copy()
    world.step(MOMENT)
    after = sums(world)
    size = np.abs(world.bodies.state.momenta).sum() + max(masses) * 10.0 + before[2]
    assert np.abs(after[0] - before[0]).max() <= 1e-13 * size
    assert np.abs(after[1] - before[1]).max() <= 1e-13 * size + MOMENT * size
    assert after[2] <= before[2] * (1 + 1e-12)
    if approach < -1e-9:
        entry = world.ledger()[0]
        assert entry[ledger.AFTER] == pytest.approx(-e * entry[ledger.BEFORE], abs=1e-12)
        assert entry[ledger.CHANGE] == pytest.approx(entry[ledger.EXPECTED], abs=1e-12 * size)
        assert entry[ledger.LOST_MOMENTUM] <= 1e-13 * size
        assert entry[ledger.LOST_SPIN] <= 1e-13 * size
        if mu == 0.0:
            mass = 1.0 / (1.0 / masses[0] + 1.0 / masses[1])
            loss = 0.5 * (1.0 - e * e) * mass * approach * approach
            assert entry[ledger.CHANGE] == pytest.approx(-loss, abs=1e-12 * size)
            assert np.array_equal(world.bodies.turning, turning), "smooth spheres keep their spin"


def test_coincident_centres_separate():
    bodies = SphereBodies([(1, 1), (1, 1)], [0.3, 0.5])
    world = world_of(bodies)
    world.step(0.01)
    world.check()
    first, second = bodies.state.positions
    assert first[0] < 1.0 < second[0] and first[1] == second[1] == 1.0


def test_a_separating_contact_gets_no_impulse():
    world = world_of(row_of([-1.0, 2.0]))
    world.step(MOMENT)
    assert world.collisions == 0
    assert world.bodies.velocities[:, 0].tolist() == [-1.0, 2.0]


def test_several_contacts_of_two_bodies():
    """Two dumb-bells meet end on end: rounds until no contact approaches; with e = 1 no energy is lost."""
    bodies = SphereBodies(
        [(0, 1), (0, -1), (1, 1), (1, -1)], [0.5] * 4, [(2, 0), (-1, 0)], [(0, 0, 0.7), (0, 0, 0.2)],
        owners=[0, 0, 1, 1], inertias="solid",
    )  # fmt: skip
    world = world_of(bodies)
    before = sums(world)
    world.step(MOMENT)
    after = sums(world)
    assert after[2] == pytest.approx(before[2], rel=1e-13)
    assert np.allclose(after[0], before[0], rtol=0, atol=1e-13)
    assert np.allclose(after[1], before[1], rtol=0, atol=1e-8)
    assert world.collisions >= 2
    made = world.collisions
    world.step(MOMENT)
    assert world.collisions == made, "nothing approaches any more"


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("count", [2, 3, 5])
def test_newtons_cradle_in_turn(count, mirrored):
    """The last one leaves with all of it, in whichever direction contacts are looked at."""
    v = [1.0] + [0.0] * (count - 1)
    world = world_of(row_of([-x for x in v[::-1]] if mirrored else v))
    world.step(MOMENT)
    left = world.bodies.velocities[:, 0].tolist()
    assert (left if not mirrored else [-x for x in left[::-1]]) == v[::-1]


def test_newtons_law_at_once():
    world = world_of(row_of([1.0, 0.0, 0.0]), law="at-once")
    world.step(MOMENT)
    assert np.allclose(world.bodies.velocities[:, 0], (-1 / 3, 2 / 3, 2 / 3), rtol=0, atol=1e-13)
    assert sums(world)[2] == pytest.approx(0.5, abs=1e-13)


@pytest.mark.parametrize("how", [{}, {"law": "at-once"}, {"path": "planar"}])
@pytest.mark.parametrize("mu", [0.0, 0.4])
@pytest.mark.parametrize("e", [1.0, 0.6])
def test_the_shares_of_the_ledger_make_up_all_of_the_energy(how, mu, e):
    """One sphere onto two that contact, with spin, and a fourth behind them."""
    root = math.sqrt(0.75)
    places = [(0.0, 0.0), (root, 0.5), (root, -0.5), (root + 1.0, 0.5)]
    turning = [(0.0, 0.0, 3.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 0.0, 0.0)]
    bodies = SphereBodies(places, np.full(4, 0.5), [(2.0, 0.1)] + [(0.0, 0.0)] * 3, turning)
    world = world_of(bodies, restitution=e, friction=mu, effects=RUBBING, correction="none", **how)
    before = sums(world)[2]
    world.step(MOMENT)
    entries = world.ledger()
    assert len(entries) >= 3
    assert entries[:, ledger.CHANGE].sum() == pytest.approx(sums(world)[2] - before, abs=1e-13)
    assert np.allclose(entries[:, ledger.CHANGE], entries[:, ledger.EXPECTED], rtol=0, atol=1e-13)
    if "law" in how and e == 1.0 and mu == 0.0:
        assert entries[0, ledger.AFTER] == pytest.approx(-entries[0, ledger.BEFORE], abs=1e-13)


def test_a_joint_collision_of_many_enters_the_last():
    """More contacts at once than the ledger has lines."""
    n = 400
    world = world_of(row_of([float(n - i) for i in range(n)]), law="at-once", rounds=1)
    world.step(MOMENT)
    assert world.collisions == n - 1 > len(world.ledger())
    assert world.ledger()[-1, ledger.ONE] == n - 2
    assert np.isfinite(world.ledger()).all()
    assert (world.ledger()[:, ledger.LOST_MOMENTUM] < 1e-12).all()


def test_mass_ratio_and_infinite_mass():
    for heavy in (1e6, math.inf):
        world = world_of(row_of([1.0, 0.0], masses=[1.0, heavy]), restitution=0.5)
        world.step(MOMENT)
        j = 1.5 / (1.0 + 1.0 / heavy)
        assert world.bodies.velocities[0, 0] == pytest.approx(1.0 - j, rel=1e-13)
        assert world.bodies.velocities[1, 0] == pytest.approx(j / heavy, rel=1e-13)
    world = world_of(row_of([1.0, 0.0], masses=[1e6, 1.0]))
    world.step(MOMENT)
    assert world.bodies.velocities[1, 0] == pytest.approx(2e6 / (1e6 + 1.0), rel=1e-13)


def test_grazing_makes_no_spin():
    bodies = two((1, 0, 0), [(0, 3, 0), (-1e-12, -3, 0)], 1.0)
    world = world_of(bodies, restitution=1.0, friction=0.5, effects=RUBBING)
    world.step(MOMENT)
    assert np.abs(bodies.turning).max() < 1e-12
    assert np.allclose(np.abs(bodies.velocities[:, 1]), 3.0, rtol=0, atol=1e-12)
    tangential = two((1, 0, 0), [(0, 3, 0), (0, -3, 0)], 1.0)
    world = world_of(tangential, friction=0.5, effects=RUBBING)
    world.step(MOMENT)
    assert world.collisions == 0 and not tangential.turning.any()


def test_spin_decides_at_the_contact_point():
    """Centres at rest to each other along the tangent, rims not: friction acts all the same."""
    bodies = two((1, 0, 0), [(1, 0, 0), (-1, 0, 0)], 1.0, [(0, 0, 4), (0, 0, 4)], inertias="solid")
    world = world_of(bodies, restitution=0.5, friction=10.0, effects=RUBBING)
    world.step(MOMENT)
    slip = bodies.velocities[1, 1] - bodies.velocities[0, 1] - 0.5 * bodies.turning[:, 2].sum()
    assert slip == pytest.approx(0.0, abs=1e-14)
    assert bodies.turning[:, 2] == pytest.approx([4 - 20 / 7, 4 - 20 / 7])
    equal = two((1, 0, 0), [(1, 0, 0), (-1, 0, 0)], 1.0, [(0, 0, 4), (0, 0, -4)], inertias="solid")
    world = world_of(equal, friction=10.0, effects=RUBBING)
    world.step(MOMENT)
    assert equal.turning[:, 2].tolist() == [4.0, -4.0], "as gears: no slip, no friction"


def test_restitution():
    for e in (0.0, 1.0):
        world = world_of(row_of([1.0, 0.0]), restitution=e)
        world.step(MOMENT)
        assert world.bodies.velocities[:, 0].tolist() == [0.5 - 0.5 * e, 0.5 + 0.5 * e]
    for e in (-0.1, 1.1, math.nan, math.inf):
        with pytest.raises(ValueError, match="restitution: expected 0 to 1"):
            material_tables(e, 0.0)


def test_restitution_and_friction_of_each_pair():
    """Three materials: each pair has its own."""
    e = np.full((4, 4), 0.5)
    e[0, 1] = e[1, 0] = 1.0
    e[0, 2] = e[2, 0] = 0.0
    for kind, after in ((0, 0.75), (1, 1.0), (2, 0.5)):
        bodies = row_of([1.0, 0.0], kinds=[0, kind])
        world = world_of(bodies, tables=material_tables(e, 0.0, 3))
        world.step(MOMENT)
        assert bodies.velocities[1, 0] == after
    with pytest.raises(ValueError, match="as b with a"):
        material_tables([[0.5, 0.1], [0.2, 0.5]], 0.0)
    with pytest.raises(ValueError, match="friction: expected one number, or 3 rows of 3"):
        material_tables(0.5, [0.1, 0.2], 2)
