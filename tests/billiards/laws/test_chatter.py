"""The rule that ends chatter: balls separate at the cost of their spin; nothing comes from nowhere."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.billiards.laws import impacts
from game.billiards.laws.contacts import chatter
from game.billiards.laws.state import (
    BALL_CUSHION,
    MASS,
    MET,
    NORMAL_Y,
    PHYSICS_COLUMNS,
    RADIUS,
    RAIL_COUNT,
    REPEATS,
    VX,
    VY,
    WX,
    WZ,
)

separate, least_separating_speed = (
    getattr(kernel, "py_func", kernel) for kernel in (chatter.separate, chatter.least_separating_speed)
)
ROWS = 64
speeds = st.floats(-2e-3, 2e-3)
spins = st.tuples(*[st.floats(-2.0, 2.0)] * 3)


def state_of(velocities, turning, masses, radius=0.03):
    state = np.zeros((ROWS, 2))
    state[VX : VY + 1] = np.transpose(velocities)
    state[WX : WZ + 1] = np.transpose(turning)
    state[MASS], state[RADIUS] = masses, radius
    return state


def energy(state, balls=2):
    v = (state[VX : VY + 1, :balls] ** 2).sum(axis=0)
    w = (state[WX : WZ + 1, :balls] ** 2).sum(axis=0)
    return (0.5 * state[MASS, :balls] * (v + 0.4 * state[RADIUS, :balls] ** 2 * w)).sum()


def test_the_speed_asked_for_grows_fourfold_up_to_a_limit():
    asked = [least_separating_speed(repeats) for repeats in range(chatter.ALLOWED_REPEATS, 20)]
    assert asked[:4] == pytest.approx([1e-6, 4e-6, 16e-6, 64e-6])
    assert max(asked) == asked[-1] == chatter.LARGEST_SPEED


@given(st.tuples(speeds, speeds), st.tuples(speeds, speeds), spins, spins, st.floats(-3.0, 3.0))
def test_two_balls_separate_at_the_cost_of_their_spin(first, second, spin, other_spin, angle):
    nx, ny = math.cos(angle), math.sin(angle)
    state = state_of((first, second), (spin, other_spin), (0.17, 0.25))
    before, energy_before = state.copy(), energy(state)
    separate(state, 0, 1, nx, ny, 1e-3)
    momentum = state[MASS] @ state[VX : VY + 1].T
    assert momentum == pytest.approx(before[MASS] @ before[VX : VY + 1].T, abs=1e-17)
    assert energy(state) <= energy_before * (1.0 + 1e-12)
    normal = np.array((nx, ny))
    was, now = ((s[VX : VY + 1, 1] - s[VX : VY + 1, 0]) @ normal for s in (before, state))
    if was >= 1e-3:
        assert np.array_equal(state, before)
        return
    assert was - 1e-15 <= now <= 1e-3 + 1e-15
    if now < 1e-3 - 1e-12:
        assert not state[WX : WZ + 1].any(), "all that there was is spent"
        assert energy(state) == pytest.approx(energy_before, rel=1e-9) or was < 0.0
    across = np.array((-ny, nx))
    assert across @ state[VX : VY + 1] == pytest.approx(across @ before[VX : VY + 1], abs=1e-15)


def test_a_contact_is_counted_whichever_ball_is_named_first():
    end_chatter = getattr(impacts.end_chatter, "py_func", impacts.end_chatter)
    state, pairs = np.zeros((ROWS, 3)), np.full((3, 3, 3), -1.0)
    soon = 0.5 * impacts.CHATTER_TIME
    for count, (i, j, now) in enumerate([(0, 2, 1.0), (2, 0, 1.0 + soon), (0, 2, 1.0 + 2.0 * soon)]):
        assert not end_chatter(state, pairs, i, j, 1.0, 0.0, now)
        assert pairs[REPEATS, 0, 2] == pairs[REPEATS, 2, 0] == count
        assert pairs[MET, 0, 2] == pairs[MET, 2, 0] == now
    end_chatter(state, pairs, 2, 0, 1.0, 0.0, 1.0 + 4.0 * impacts.CHATTER_TIME)
    assert pairs[REPEATS, 0, 2] == pairs[REPEATS, 2, 0] == 0.0


def test_a_ball_parts_from_a_rail():
    state = state_of(((0.0, 0.0), (9.0, 9.0)), ((0.0, 3.0, 0.0), (1.0, 1.0, 1.0)), (0.17, 0.17))
    before = energy(state, 1)
    separate(state, 0, -1, 0.0, 1.0, 2e-3)
    assert state[VY, 0] == pytest.approx(-2e-3)
    assert energy(state, 1) == pytest.approx(before, rel=1e-12)
    assert 0.0 < state[WX + 1, 0] < 3.0
    assert state[VX : VY + 1, 1].tolist() == [9.0, 9.0] and state[WX : WZ + 1, 1].tolist() == [1.0] * 3


LAST = chatter.LAST_REPEATS


@pytest.mark.parametrize(
    ("repeats", "spin", "stuck"), [(LAST, 0.0, True), (LAST, 9.0, False), (LAST - 1, 0.0, False)]
)
def test_a_ball_is_stuck_at_a_rail_when_no_spin_is_left_for_parting(monkeypatch, repeats, spin, stuck):
    state = state_of(((0.0, 0.0), (0.0, 0.0)), ((0.0, spin, 0.0), (0.0, 0.0, 0.0)), (0.17, 0.17))
    modes, rail = np.zeros((ROWS, 2), np.int64), np.zeros((1, 16))
    modes[RAIL_COUNT, 0], rail[0, NORMAL_Y] = repeats - 1, 1.0
    for name, plain in (("separate", separate), ("least_separating_speed", least_separating_speed)):
        monkeypatch.setattr(impacts, name, plain)
    monkeypatch.setattr(impacts, "bounce_off", lambda *_: None)  # at rest there is nothing to throw back
    hit_rail = getattr(impacts.hit_rail, "py_func", impacts.hit_rail)
    nothing, physics = np.zeros((0, 4)), np.zeros(PHYSICS_COLUMNS)
    assert hit_rail(state, modes, 0, BALL_CUSHION, 0, rail, nothing, physics) == stuck
    assert (state[VY, 0] > 0.0) == (spin > 0.0)
