"""A sea of plane waves: dispersion in two dimensions, spectra beside their integrals, a point that moves."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.waves.sea import (
    ACROSS,
    ALONG,
    AMPLITUDE,
    LEVEL,
    LIFT,
    PHASE,
    RISE,
    SLOPE_X,
    SLOPE_Z,
    Sea,
    full_height,
    jonswap,
    pierson_moskowitz,
)


def one_wave(heading: float, count: int = 12, which: int = 7) -> Sea:
    sea = Sea(count, heading, seed=3)
    sea.rows[which, AMPLITUDE] = 0.4
    return sea


@pytest.mark.parametrize("heading", [0.0, 0.7, 2.5])
def test_a_crest_runs_at_the_speed_of_its_length_whatever_its_direction(heading: float) -> None:
    """c² = g / k on deep water (Airy 1845): after a time all is as it was, so much farther along."""
    sea = one_wave(heading)
    along, across = sea.rows[7, [ALONG, ACROSS]].tolist()
    number = math.hypot(along, across)
    points = np.random.default_rng(1).uniform(-30.0, 30.0, (40, 2))
    before = sea.at(points)[:, LEVEL]
    for _ in range(200):
        sea.step(0.0, sea.rows[:, AMPLITUDE].copy(), 0.0, 0.01)
    far = math.sqrt(9.81 / number) * 2.0
    moved = points + far * np.array((along, across)) / number
    assert np.abs(sea.at(moved)[:, LEVEL] - before).max() < 1e-10


def test_slopes_and_rates_are_those_of_the_level() -> None:
    sea = Sea(20, 0.5, seed=2)
    sea.rows[:, AMPLITUDE] = sea.goals("jonswap", 9.0, 2e4, 1.0)
    at, h = np.array([[1.3, -2.1]]), 1e-4
    here = sea.at(at)[0]
    for axis, column in ((0, SLOPE_X), (1, SLOPE_Z)):
        step = np.zeros((1, 2))
        step[0, axis] = h
        ahead, behind = sea.at(at + step)[0, LEVEL], sea.at(at - step)[0, LEVEL]
        assert (ahead - behind) / (2.0 * h) == pytest.approx(here[column], abs=1e-6)
    levels = []
    for _ in range(3):
        levels.append(sea.at(at)[0, LEVEL])
        middle = sea.at(at)[0] if len(levels) == 2 else None
        if middle is not None:
            kept = middle
        sea.step(0.0, sea.rows[:, AMPLITUDE].copy(), 0.0, 1e-3)
    assert (levels[2] - levels[0]) / 2e-3 == pytest.approx(kept[RISE], rel=1e-4)
    assert (levels[2] - 2.0 * levels[1] + levels[0]) / 1e-6 == pytest.approx(kept[LIFT], rel=1e-3)


def test_a_point_that_moves_sees_the_same_sea() -> None:
    still, moving = Sea(16, 0.3, seed=4), Sea(16, 0.3, seed=4)
    for sea in (still, moving):
        sea.rows[:, AMPLITUDE] = sea.goals("jonswap", 9.0, 2e4)
    for _ in range(300):
        still.step(0.0, still.rows[:, AMPLITUDE].copy(), 0.0, 1.0 / 60.0)
        moving.step(3.0, moving.rows[:, AMPLITUDE].copy(), 0.0, 1.0 / 60.0)
    x = np.linspace(-10.0, 10.0, 21)
    seen = moving.at(np.stack([x, 0.4 * x], axis=1))[:, LEVEL]
    there = still.at(np.stack([x + 15.0, 0.4 * x], axis=1))[:, LEVEL]
    assert np.abs(seen - there).max() < 1e-9


def test_a_turn_keeps_the_phases_where_the_boat_is() -> None:
    sea = one_wave(0.2)
    before = sea.at(np.zeros((1, 2)))[0, LEVEL]
    sea.turn(1.4)
    assert sea.at(np.zeros((1, 2)))[0, LEVEL] == pytest.approx(before, abs=1e-14)
    numbers = np.hypot(sea.rows[:-1, ALONG], sea.rows[:-1, ACROSS])
    assert np.abs(numbers - sea.numbers).max() < 1e-12


@pytest.mark.parametrize("wind", [5.0, 10.0, 20.0])
def test_a_full_sea_is_as_high_as_its_spectrum_in_closed_form(wind: float) -> None:
    sea = Sea(64, lengths=(0.02, 20_000.0))
    sea.rows[:, AMPLITUDE] = sea.goals("pierson-moskowitz", wind, 1.0)
    assert sea.significant() == pytest.approx(full_height(wind), rel=2e-3)
    assert full_height(wind) == pytest.approx(0.2092 * wind * wind / 9.81, rel=1e-3)


def test_pierson_and_moskowitz_peak_where_their_form_says() -> None:
    """dS/dw = 0: w = (4 0.74 / 5)^(1/4) g / U."""
    rates = np.linspace(0.3, 3.0, 200_001)
    peak = rates[np.argmax(pierson_moskowitz(rates, 10.0))]
    assert peak == pytest.approx((4.0 * 0.74 / 5.0) ** 0.25 * 0.981, rel=1e-4)


def test_jonswap_peaks_three_times_as_high_as_without_its_bump() -> None:
    wind, fetch = 10.0, 25_000.0
    peak = 22.0 * (9.81**2 / (wind * fetch)) ** (1.0 / 3.0)
    rates = np.array([peak, 4.0 * peak])
    found = jonswap(rates, wind, fetch)
    alpha = 0.076 * (wind**2 / (fetch * 9.81)) ** 0.22
    assert found[0] == pytest.approx(3.3 * alpha * 9.81**2 / peak**5 * math.exp(-1.25), rel=1e-9)
    assert found[1] == pytest.approx(alpha * 9.81**2 / rates[1] ** 5 * math.exp(-1.25 / 256.0), rel=1e-6)


def test_deeper_down_short_waves_are_felt_less() -> None:
    sea = one_wave(0.0)
    at, number = np.zeros((1, 2)), float(sea.numbers[7])
    up, down = sea.at(at)[0, LEVEL], sea.at(at, 0.5)[0, LEVEL]
    assert down == pytest.approx(up * math.exp(-0.5 * number), rel=1e-12)


def test_amplitudes_grow_towards_their_goals() -> None:
    sea = Sea(8)
    goals = sea.goals("jonswap", 10.0, 2e4, 2.0)
    assert goals[-1] == 1.0
    for _ in range(400):
        sea.step(0.0, goals, 0.05, 0.05)
    assert np.abs(sea.rows[:, AMPLITUDE] - goals).max() < 1e-8
    assert (sea.rows[:, PHASE] >= 0.0).all() and (sea.rows[:, PHASE] < 2.0 * math.pi + 1e-12).all()


def test_nonsense_is_refused() -> None:
    for arguments in ({"count": 0}, {"count": 4, "spread": -1.0}, {"count": 4, "lengths": (2.0, 1.0)}):
        with pytest.raises(ValueError):
            Sea(**arguments)
