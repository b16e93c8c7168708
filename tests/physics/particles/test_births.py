"""Births and deaths: exact counts, instants within the step, changes of rate."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.fields import GRAVITY
from game.physics.particles import Emitter, ParticleSystem
from game.physics.particles.births import births_until


def run(system, dt, steps):
    for _ in range(steps):
        system.step(dt)
    return system


def fountain(rate=400.0, life=100.0, capacity=4000, seed=0, effects=GRAVITY | GRAVITY, **emitter):
    return ParticleSystem(
        capacity, emitters=[Emitter(rate=rate, **emitter)], effects=effects, life=life, seed=seed
    )


@pytest.mark.parametrize(("dt", "steps"), [(0.01, 337), (3.37, 1), (3.37 / 7, 7), (3.37 / 1000, 1000)])
def test_count_after_a_time_does_not_depend_on_the_step(dt, steps):
    """400/s for 3.37 s: 1348, exactly."""
    assert run(fountain(), dt, steps).born == 1348


@given(
    rate=st.integers(1, 100_000),
    steps=st.integers(0, 5_000),
    frequency=st.sampled_from((24, 60, 120, 240, 999)),
)
def test_births_until_is_the_floor_of_the_exact_product(rate, steps, frequency):
    now = steps * (1.0 / frequency)
    exact = Fraction(rate) * Fraction(steps, frequency)
    assert births_until(float(rate), 0.0, 0.0, now) == exact.numerator // exact.denominator


def test_mean_population_is_rate_times_life():
    """Little's law, here without any scatter: 400/s living 2.5 s are 1000."""
    system = run(fountain(life=2.5), 0.01, 400)
    assert len(system) == 1000
    assert system.born - system.died == 1000
    system.check()


def test_ages_are_evenly_spaced_whatever_the_step():
    ages = run(fountain(rate=333.0), 1 / 48, 48).ages
    assert np.allclose(np.diff(ages), -1.0 / 333.0, rtol=0, atol=1e-13)


@pytest.mark.parametrize("dt", [1 / 20, 1 / 60, 1 / 240])
def test_a_jet_has_no_clumps(dt):
    """Without drag, place is a smooth function of age: that of the parabola, to rounding."""
    system = run(fountain(rate=1000.0, spread=0.0, speed=8.0), dt, round(0.5 / dt))
    age = system.ages
    assert len(age) == 500
    assert np.allclose(system.positions[:, 1], 8.0 * age - 4.905 * age**2, rtol=0, atol=1e-12)


def test_a_particle_that_a_moving_nozzle_sends_out_starts_where_the_nozzle_was():
    system = ParticleSystem(
        100, emitters=[Emitter(rate=100.0, speed=0.0, spread=0.0)], effects=GRAVITY | GRAVITY
    )
    system.place_emitter(0, (1.0, 0.0))
    system.step(0.1)
    assert np.allclose(system.positions[:, 0], np.arange(1, 11) / 10, rtol=0, atol=1e-12)
    system.step(0.1)
    assert np.allclose(system.positions[10:, 0], 1.0, rtol=0, atol=1e-12)


@pytest.mark.parametrize("dt", [0.01, 0.07])
def test_a_change_of_rate_makes_neither_burst_nor_gap(dt):
    """The fraction of a particle that is under way counts on."""
    system = fountain(rate=10.0)
    run(system, dt, 25)
    phase = 10.0 * 25 * dt
    for rate in (0.0, 3.0, 1000.0, 7.0):
        system.change_emitter(0, Emitter(rate=rate))
        before = system.born
        run(system, dt, 20)
        phase += rate * 20 * dt
        assert abs(system.born - phase) <= 1.0 + 1e-9
        assert system.born - before <= rate * 20 * dt + 1.0
    assert system.born == int(phase + 1e-9)


def test_rate_nought_gives_birth_to_nobody():
    assert run(fountain(rate=0.0), 0.1, 50).born == 0


def test_directions_fill_the_spread_and_no_more():
    system = run(fountain(rate=4000.0, spread=0.3, axis=0.5, speed=5.0, effects=GRAVITY | GRAVITY), 1e-9, 1)
    system.step(0.9)
    v = system.velocities + np.stack([np.zeros(len(system)), 9.81 * system.ages], axis=1)
    angle = np.arctan2(v[:, 0], v[:, 1]) - 0.5
    assert np.max(np.abs(angle)) <= 0.3 + 1e-12
    n = len(angle)
    assert abs(angle.mean()) < 4 * 0.3 / np.sqrt(3 * n)
    assert abs(np.mean(angle**2) - 0.03) < 4 * np.sqrt(0.3**4 * 4 / 45 / n)
    assert np.allclose(np.linalg.norm(v, axis=1), 5.0, rtol=0, atol=1e-12)


def test_width_and_range_of_speed():
    system = run(fountain(rate=2000.0, spread=0.0, speed=5.0, speed_range=0.2, width=0.4), 1e-9, 1)
    system.step(0.5)
    x = system.positions[:, 0]
    speed = system.velocities[:, 1] + 9.81 * system.ages
    assert -0.2 <= x.min() < -0.19
    assert 0.19 < x.max() <= 0.2
    assert 4.0 <= speed.min() < 4.02
    assert 5.98 < speed.max() <= 6.0


def test_two_emitters_share_the_pool_in_the_order_of_birth():
    system = ParticleSystem(
        1000, emitters=[Emitter(rate=30.0), Emitter((3, 0), rate=71.0)], effects=GRAVITY | GRAVITY, life=0.7
    )
    run(system, 1 / 30, 90)
    system.check()
    assert system.born == 90 + 213
    assert len(system) == 21 + 50


def test_a_shorter_life_ends_those_alive():
    system = run(fountain(life=2.0), 0.01, 150)
    system.life = 0.5
    system.step(0.01)
    assert len(system) == 200
    system.check()
