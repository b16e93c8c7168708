"""Chatter that no spin pays for: wedged balls stop as one body, and every shot comes to an end."""

import math

import numpy as np
import pytest

from game.billiards import Physics, Table, eight_ball_rack, make_shot, simulate
from game.billiards.exact.settling import JOINED, settle_group
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.state import (
    FLOAT_ROWS,
    INTEGER_ROWS,
    MASS,
    MEMBER,
    MOTION,
    RADIUS,
    SLIDING,
    VX,
    VY,
    WX,
    WZ,
    X,
)
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from tests.billiards.exact.exact_checks import audit

R = BALL_RADIUS
POOL = Table.pool()
OPEN = Table.open()
BARE = Table.bare(1.27, 2.54)


def break_shot(seed, ball_restitution, cushion_restitution):
    """A break from anywhere behind the line, with any spin."""
    rng = np.random.default_rng(seed)
    racked = eight_ball_rack(POOL, gap=1e-4, seed=seed)
    racked[0, 0] += rng.uniform(-0.3, 0.3)
    speed = rng.uniform(2.0, 10.0)
    way = np.array([racked[1:, 0].mean(), 1.905]) - racked[0]
    aim = math.atan2(way[1], way[0]) + rng.uniform(-0.01, 0.01)
    physics = Physics(ball_restitution=ball_restitution, cushion_restitution=cushion_restitution)
    shot = make_shot(POOL, racked, physics=physics)
    return shot.struck(0, (speed * math.cos(aim), speed * math.sin(aim)), rng.uniform(-60.0, 60.0, 3))


@pytest.mark.parametrize(
    ("ball", "cushion", "seeds"),
    [
        (0.5, 0.3, (8, 28, 53, 84, 100)),
        (0.5, 0.0, (23, 41, 143)),
        (0.5, 0.85, (330,)),
        (0.0, 0.85, (102, 126, 298)),
        (0.0, 0.0, (5, 8, 29, 37)),
    ],
)
def test_breaks_that_wedge_balls_in_a_mouth_come_to_an_end(ball, cushion, seeds):
    """Each of these breaks had above 20,000 events, and no end."""
    for seed in seeds:
        trajectory = simulate(break_shot(seed, ball, cushion))
        assert len(trajectory.times) < 6000, seed
        found = audit(trajectory)
        assert found.overlap <= 1e-9 * R and found.jump <= 1e-14
        assert found.energy_rise <= 1e-13 * found.energy


@lean_kernel
def settle(state, modes, i, cushions, jaws, physics):
    """The inner kernel, with an entrance."""
    return settle_group(state, modes, i, 0.0, cushions, jaws, physics)


def settled(table, places, velocities, masses=BALL_MASS, first=0):
    """State (rows, n) before and after ball `first` is settled with its group, and the group."""
    spins = np.linspace(-2.0, 2.0, 3 * len(places)).reshape(-1, 3)
    shot = make_shot(table, places, velocities, spins, masses=masses)
    state, modes = np.zeros((FLOAT_ROWS, len(places))), np.zeros((INTEGER_ROWS, len(places)), np.int64)
    state[X : WZ + 1] = shot.balls[:, :7].T
    state[RADIUS], state[MASS] = shot.balls[:, 7], shot.balls[:, 8]
    modes[MOTION] = SLIDING
    before = state.copy()
    ranges = shot.batch.ranges[0]
    cushions, jaws = (shot.batch.elements[ranges[k] : ranges[k + 1]] for k in range(2))
    count = settle(state, modes, first, cushions, jaws, shot.constants)
    return before, state, sorted(modes[MEMBER, :count].tolist())


def energy(state):
    v, w = (state[VX : VY + 1] ** 2).sum(axis=0), (state[WX : WZ + 1] ** 2).sum(axis=0)
    return float((0.5 * state[MASS] * (v + 0.4 * state[RADIUS] ** 2 * w)).sum())


def row_of(count, angle, gap=0.0):
    """Places of balls in a line, touching, in the middle of the table."""
    way = np.array([math.cos(angle), math.sin(angle)])
    return np.array([0.6, 1.2]) + (2.0 * R + gap) * np.arange(count)[:, None] * way


def test_away_from_rails_a_group_keeps_its_momentum():
    masses = np.array([0.17, 0.25, 0.11])
    velocities = np.array([[1e-3, 2e-3], [-2e-3, 5e-4], [3e-4, -1e-3]])
    before, after, group = settled(OPEN, row_of(3, 0.4), velocities, masses)
    assert group == [0, 1, 2]
    common = masses @ velocities / masses.sum()
    assert after[VX : VY + 1] == pytest.approx(np.repeat(common[:, None], 3, axis=1), rel=1e-9)
    assert np.ptp(after[VX]) == np.ptp(after[VY]) == 0.0, "they move alike"
    assert not after[WX : WZ + 1].any() and energy(after) < energy(before)


def test_what_is_further_off_stays_out():
    before, after, group = settled(OPEN, row_of(3, 0.0, gap=2.0 * JOINED), [(1e-3, 0.0)] * 3, first=1)
    assert group == [1]
    assert (after[:, [0, 2]] == before[:, [0, 2]]).all()


@pytest.mark.parametrize(("velocity", "wanted"), [((-1.0, 2.0), (0.0, 2.0)), ((1.0, 2.0), (1.0, 2.0))])
def test_a_rail_takes_what_goes_into_it(velocity, wanted):
    before, after, _ = settled(BARE, [(R, 1.0)], [velocity])
    assert after[VX : VY + 1, 0] == pytest.approx(wanted, rel=1e-11, abs=1e-15)
    assert energy(after) < energy(before)


def test_a_corner_takes_all():
    _, after, _ = settled(BARE, [(R, R), (R, 3.0 * R)], [(-1e-3, 1e-4), (-1e-3, -1e-3)])
    assert not after[VX : WZ + 1].any()


def test_between_facing_rails_only_the_way_along_them_is_left():
    table = Table.bare(4.0 * R, 2.0)
    _, after, group = settled(table, [(R, 1.0), (3.0 * R, 1.0)], [(-1e-3, 1e-3), (-2e-3, 3e-3)])
    assert group == [0, 1]
    assert after[VX : VY + 1] == pytest.approx(np.array([[0.0, 0.0], [2e-3, 2e-3]]), rel=1e-11)


def test_the_numbering_leaves_no_trace():
    rng = np.random.default_rng(3)
    places, velocities, masses = row_of(5, 0.7), rng.normal(0.0, 1e-3, (5, 2)), rng.uniform(0.1, 0.3, 5)
    seen = set()
    for k in range(20):
        order = rng.permutation(5)
        _, after, _ = settled(OPEN, places[order], velocities[order], masses[order], first=k % 5)
        seen.add((after[VX, 0], after[VY, 0]))
    assert len(seen) == 1
