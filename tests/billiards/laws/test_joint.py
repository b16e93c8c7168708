"""Joint impacts against closed forms, an enumerating twin, and invariants."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.billiards.laws.joint import (
    ContactGraph,
    joint_scratch,
    solve_complementarity,
    solve_joint_impulses,
)
from game.billiards.table.rack import eight_ball_rack
from game.billiards.table.table import Table

EPS = 2.0**-52
R = 0.028575


def touching(positions, slop=1e-9):
    """Contacts (first, second, normals) of equal balls that touch."""
    found = []
    for a, b in itertools.combinations(range(len(positions)), 2):
        d = positions[b] - positions[a]
        distance = math.sqrt(d[0] * d[0] + d[1] * d[1])
        if distance < 2.0 * R + slop:
            found.append((a, b, d / distance))
    first = np.array([c[0] for c in found], dtype=np.int64)
    second = np.array([c[1] for c in found], dtype=np.int64)
    return first, second, np.array([c[2] for c in found]).reshape(-1, 2)


def collide(contacts, velocities, inverse_masses, restitution=1.0, join_resting=False):
    first, second, normals = contacts
    count = len(first)
    velocities = np.array(velocities, dtype=np.float64)
    impulses = np.empty(count)
    scratch = joint_scratch(len(velocities), count)
    rounds = solve_joint_impulses(
        count,
        ContactGraph(first, second, np.ascontiguousarray(normals)),
        np.full(count, restitution) if np.isscalar(restitution) else restitution,
        np.array(inverse_masses, dtype=np.float64),
        velocities,
        impulses,
        join_resting,
        scratch,
    )
    return velocities, impulses, rounds


def line_of(n):
    return np.array([[2.0 * R * k, 0.0] for k in range(n)])


def first_moves(n, velocity=(1.0, 0.0)):
    velocities = np.zeros((n, 2))
    velocities[0] = velocity
    return velocities


def energy(velocities, inverse_masses):
    return math.fsum(0.5 * v @ v / w for v, w in zip(velocities, inverse_masses, strict=True) if w > 0.0)


@pytest.mark.parametrize("join_resting", [False, True])
def test_one_ball_onto_two(join_resting):
    a = math.pi / 6.0
    positions = np.array(
        [[0, 0], [2 * R * math.cos(a), 2 * R * math.sin(a)], [2 * R * math.cos(a), -2 * R * math.sin(a)]]
    )
    velocities, _, _ = collide(touching(positions), first_moves(3), np.ones(3), join_resting=join_resting)
    speed = 2.0 * math.sqrt(3.0) / 5.0
    expected = [
        [-0.2, 0.0],
        [speed * math.cos(a), speed * math.sin(a)],
        [speed * math.cos(a), -speed * math.sin(a)],
    ]
    assert np.abs(velocities - expected).max() < 64 * EPS


@pytest.mark.parametrize("n", [2, 3, 5, 20])
def test_cradle_sends_off_the_last_ball(n):
    velocities, _, rounds = collide(touching(line_of(n)), first_moves(n), np.ones(n))
    assert np.abs(velocities - first_moves(n)[::-1]).max() < 8 * n * EPS
    assert rounds == n - 1


def test_cradle_with_resting_contacts_joined():
    velocities, _, rounds = collide(touching(line_of(3)), first_moves(3), np.ones(3), join_resting=True)
    assert np.abs(velocities[:, 0] - [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]).max() < 64 * EPS
    assert rounds == 1


@pytest.mark.parametrize("e", [0.0, 0.5, 0.95, 1.0])
def test_two_balls_of_any_mass(e):
    m1, m2, v1, v2 = 2.0, 3.0, 3.0, -1.0
    velocities, impulses, _ = collide(touching(line_of(2)), [[v1, 0.4], [v2, -0.7]], [1 / m1, 1 / m2], e)
    j = (1.0 + e) * (v1 - v2) / (1.0 / m1 + 1.0 / m2)
    assert impulses[0] == pytest.approx(j, rel=8 * EPS)
    assert np.abs(velocities - [[v1 - j / m1, 0.4], [v2 + j / m2, -0.7]]).max() < 32 * EPS


def test_ball_pressed_on_a_wall_stays_and_the_other_rebounds():
    first, second = np.array([0, 1]), np.array([1, -1])
    normals = np.array([[1.0, 0.0], [1.0, 0.0]])
    velocities, impulses, _ = collide((first, second, normals), [[5.0, 0.0], [0.0, 0.0]], [1.0, 1.0])
    assert np.abs(velocities - [[-5.0, 0.0], [0.0, 0.0]]).max() < 64 * EPS
    assert np.abs(impulses - [10.0, 10.0]).max() < 128 * EPS


def test_resting_and_opening_contacts_get_nothing():
    velocities, impulses, rounds = collide(
        touching(line_of(3)), [[-1.0, 0.0], [0.0, 0.0], [0.0, 2.0]], np.ones(3)
    )
    assert rounds == 0
    assert not impulses.any()
    assert (velocities == [[-1.0, 0.0], [0.0, 0.0], [0.0, 2.0]]).all()


def test_what_cannot_move_takes_no_harm():
    velocities, _, _ = collide(touching(line_of(2)), [[1.0, 0.0], [0.0, 0.0]], [1.0, 0.0])
    assert (velocities == [[-1.0, 0.0], [0.0, 0.0]]).all()
    velocities, _, _ = collide(touching(line_of(2)), [[1.0, 0.0], [0.0, 0.0]], [0.0, 0.0])
    assert (velocities == [[1.0, 0.0], [0.0, 0.0]]).all()


def enumerate_solution(matrix, demand):
    """Naive twin: try every set of contacts that push."""
    n = len(demand)
    for size in range(n + 1):
        for active in itertools.combinations(range(n), size):
            chosen = list(active)
            impulses = np.zeros(n)
            impulses[chosen] = np.linalg.lstsq(matrix[np.ix_(chosen, chosen)], demand[chosen], rcond=None)[0]
            if (impulses >= -1e-9).all() and (matrix @ impulses - demand >= -1e-9).all():
                return impulses
    raise AssertionError("no solution")


masses = st.floats(0.25, 4.0)
speeds = st.floats(-4.0, 4.0)


@st.composite
def clusters(draw):
    """Up to five contacts with random normals among up to four balls and walls, random motion."""
    n = draw(st.integers(1, 4))
    pairs = [(a, b) for a in range(n) for b in (*range(a + 1, n), -1)]
    chosen = draw(st.lists(st.sampled_from(pairs), min_size=1, max_size=5, unique=True))
    angles = [draw(st.floats(0.0, 2.0 * math.pi)) for _ in chosen]
    normals = np.array([[math.cos(a), math.sin(a)] for a in angles])
    velocities = np.array([[draw(speeds), draw(speeds)] for _ in range(n)])
    inverse = np.array([1.0 / draw(masses) for _ in range(n)])
    first = np.array([a for a, _ in chosen], dtype=np.int64)
    second = np.array([b for _, b in chosen], dtype=np.int64)
    return (first, second, normals), velocities, inverse


def jacobian(contacts, n):
    """Closing speeds are rows @ velocities."""
    rows = np.zeros((len(contacts[0]), n, 2))
    for i, (a, b, normal) in enumerate(zip(*contacts, strict=True)):
        rows[i, a] = normal
        if b >= 0:
            rows[i, b] = -normal
    return rows.reshape(len(rows), -1)


@given(clusters())
def test_complementarity_against_enumeration(cluster):
    contacts, velocities, inverse = cluster
    rows = jacobian(contacts, len(inverse))
    matrix = rows @ np.diag(np.repeat(inverse, 2)) @ rows.T
    demand = np.maximum(rows @ velocities.ravel(), 0.0)
    count = len(demand)
    scratch = joint_scratch(len(inverse), count)
    scratch.contacts[:, 0] = demand
    scratch.contacts[:, 1] = 1.0
    moved, impulses = np.zeros((len(inverse), 2)), np.zeros(count)
    used = solve_complementarity(count, ContactGraph(*contacts), inverse, moved, impulses, scratch, 200_000)
    if used == 200_000:
        return  # normals that contradict each other: a compromise is all that can be had
    assert (impulses >= 0.0).all()
    slack = matrix @ impulses - demand
    size = 1.0 + np.abs(impulses).max() * np.abs(matrix).max()
    assert slack.min() > -1e-9 * size
    assert np.abs(impulses * slack).max() < 1e-8 * size * size
    assert np.abs(moved.ravel() + np.repeat(inverse, 2) * (rows.T @ impulses)).max() < 1e-12 * size
    if np.linalg.cond(matrix) < 1e4:
        assert np.abs(impulses - enumerate_solution(matrix, demand)).max() < 1e-6 * size


@given(clusters(), st.floats(0.0, 1.0), st.booleans())
def test_invariants(cluster, e, join_resting):
    contacts, velocities, inverse = cluster
    after, impulses, _ = collide(contacts, velocities, inverse, e, join_resting)
    assert np.isfinite(after).all()
    assert (impulses >= 0.0).all()
    before = energy(velocities, inverse)
    assert energy(after, inverse) <= before * (1.0 + 1e-12)
    wall = np.zeros(2)
    for j, b, normal in zip(impulses, contacts[1], contacts[2], strict=True):
        if b < 0:
            wall -= j * normal
    change = ((after - velocities) / inverse[:, None]).sum(axis=0)
    size = np.abs(velocities / inverse[:, None]).sum() + impulses.sum()
    assert np.abs(change - wall).max() <= 16 * len(inverse) * EPS * size


@pytest.mark.parametrize("e", [0.0, 0.5, 0.95, 1.0])
@pytest.mark.parametrize("join_resting", [False, True])
def test_rack_is_struck_alike_on_both_sides_under_any_numbering(e, join_resting):
    positions = eight_ball_rack(Table.pool())
    positions[:, 0] = np.round((positions[:, 0] - 0.635) * 2.0**40) / 2.0**40
    positions[0] = positions[1] - [0.0, 2.0 * R]
    velocities, inverse = first_moves(16, (0.0, 8.0)), np.full(16, 5.0)
    after, _, _ = collide(touching(positions), velocities, inverse, e, join_resting)
    for i, (x, y) in enumerate(positions):
        image = np.flatnonzero((positions[:, 0] == -x) & (positions[:, 1] == y))[0]
        assert after[i, 0] == -after[image, 0]
        assert after[i, 1] == after[image, 1]
    order = np.random.default_rng(5).permutation(16)
    shuffled, _, _ = collide(touching(positions[order]), velocities[order], inverse, e, join_resting)
    assert (shuffled == after[order]).all()
    assert abs(math.fsum(after[:, 1]) - 8.0) < 64 * EPS * np.abs(after).sum()
    assert energy(after, inverse) <= energy(velocities, inverse) * (1.0 + 64 * EPS)
    if e == 1.0:
        assert energy(after, inverse) == pytest.approx(energy(velocities, inverse), rel=1e-13)


def test_contacts_that_differ_in_restitution_do_not_gain_energy():
    contacts = touching(line_of(4))
    before = np.array([[3.0, 0.0], [0.5, 0.0], [0.0, 0.0], [-2.0, 0.0]])
    inverse = np.array([1.0, 0.2, 5.0, 1.0])
    after, _, _ = collide(contacts, before, inverse, np.array([1.0, 0.1, 0.7]))
    assert energy(after, inverse) < energy(before, inverse)
    rows = jacobian(contacts, 4)
    assert (rows @ after.ravel()).max() <= 1e-12


def test_endless_impacts_end():
    """A light ball between two heavy ones that close: e < 1 makes it rebound for ever shorter times."""
    contacts = touching(line_of(3))
    after, _, rounds = collide(contacts, [[1.0, 0.0], [0.0, 0.0], [-1.0, 0.0]], [1.0, 1e3, 1.0], 0.5)
    assert rounds <= 2 * 2 + 16
    assert (jacobian(contacts, 3) @ after.ravel()).max() <= 1e-9


def test_walls_too_narrow_for_the_ball_end_in_a_compromise():
    """Both walls demand way: the ball ends where neither is favoured, in a bounded number of steps."""
    contacts = (np.array([0, 0]), np.array([-1, -1]), np.array([[1.0, 0.0], [-1.0, 0.0]]))
    scratch = joint_scratch(1, 2)
    scratch.contacts[:, 0] = [0.01, 0.01]
    scratch.contacts[:, 1] = 1.0
    moved = np.zeros((1, 2))
    used = solve_complementarity(2, ContactGraph(*contacts), np.ones(1), moved, np.zeros(2), scratch, 50)
    assert used == 50
    assert np.isfinite(scratch.contacts).all()
    assert not moved.any()


def test_scratch_refuses_negative_numbers():
    with pytest.raises(ValueError, match="joint scratch"):
        joint_scratch(-1, 3)
