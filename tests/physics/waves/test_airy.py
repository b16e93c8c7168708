"""Waves of all lengths on water of one depth: their speeds, their sum, what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.waves import AiryTank, wave_rate
from game.physics.waves.airy import add_cosines, find_shares


@pytest.mark.parametrize(
    ("length", "depth", "phase", "group"),
    [(2.0, 5.0, 1.7670936544119118, 0.8835468272072168), (4.0, 0.8, 2.304190282292868, 1.6242843911151723)],
)
def test_long_waves_run_ahead(length, depth, phase, group):
    k, e = math.tau / length, 1e-5
    assert wave_rate(k, depth) / k == pytest.approx(phase, rel=1e-12)
    assert (wave_rate(k + e, depth) - wave_rate(k - e, depth)) / (2.0 * e) == pytest.approx(group, rel=1e-8)
    assert phase < math.sqrt(9.81 * depth)


def test_cosines_are_found_and_added_up_again():
    level = np.random.default_rng(2).normal(size=37)
    shares, out = np.zeros(37), np.zeros(37)
    find_shares(level, shares)
    k, i = np.arange(37)[:, None], np.arange(37)[None]
    waves = np.cos(math.pi * k * (i + 0.5) / 37)
    naive = (waves @ level) * np.where(k[:, 0] > 0, 2.0, 1.0) / 37
    assert shares == pytest.approx(naive, abs=1e-12)
    add_cosines(shares, out)
    assert out == pytest.approx(level, abs=1e-11)


def test_a_hump_spreads_as_cauchy_and_poisson_say():
    """exp(-x²/2 s²) m of s 0.3 m on 1 m of water: -0.0954410 m at 3 m, 2 s after."""
    x = (np.arange(1600) + 0.5) * 0.025 - 20.0
    tank = AiryTank(np.exp(-0.5 * (x / 0.3) ** 2), 0.025, 1.0)
    assert tank.at(0.0) == pytest.approx(np.exp(-0.5 * (x / 0.3) ** 2), abs=1e-9)
    assert np.interp(3.0, x, tank.at(2.0)) == pytest.approx(-0.09544099322414444, abs=2e-4)


def test_on_shallow_water_all_run_alike():
    """d'Alembert: half of a long hump goes each way at sqrt(g h)."""
    x = (np.arange(800) + 0.5) * 0.25 - 100.0
    tank = AiryTank(np.exp(-0.5 * (x / 10.0) ** 2), 0.25, 0.05)
    way = math.sqrt(9.81 * 0.05) * 60.0
    expected = 0.5 * (np.exp(-0.5 * ((x - way) / 10.0) ** 2) + np.exp(-0.5 * ((x + way) / 10.0) ** 2))
    assert tank.at(60.0) == pytest.approx(expected, abs=1e-3)


def test_water_is_kept_and_a_wave_comes_back():
    n = 64
    level = 0.01 * np.cos(math.pi * 3 * (np.arange(n) + 0.5) / n)
    tank = AiryTank(level, 0.1, 0.5)
    period = math.tau / wave_rate(3 * math.pi / 6.4, 0.5)
    assert tank.at(period) == pytest.approx(level, abs=1e-12)
    assert tank.at(0.5 * period) == pytest.approx(-level, abs=1e-12)
    hump = AiryTank(np.exp(-((np.arange(n) - 20.0) ** 2) / 30.0), 0.1, 0.5)
    assert hump.at(7.3).sum() == pytest.approx(hump.at(0.0).sum(), rel=1e-10)


@pytest.mark.parametrize(
    "given",
    [([], 0.1, 1.0), ([math.nan], 0.1, 1.0), ([1.0], 0.0, 1.0), ([1.0], 0.1, -1.0), ([[1.0]], 0.1, 1.0)],
)
def test_nonsense_is_refused(given):
    with pytest.raises(ValueError, match=r"level|cell"):
        AiryTank(*given)


def test_a_flat_level_stays_flat():
    assert AiryTank(np.zeros(8), 0.1, 1.0).at(3.0) == pytest.approx(np.zeros(8))
