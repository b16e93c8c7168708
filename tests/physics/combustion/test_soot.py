"""How soot burns off: the law of Nagle and Strickland-Constable, and where it leaves smoke alone."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.combustion import Flames, GasFuel
from game.physics.combustion.soot import soot_loss, soot_rate_of


def law(kelvin: float, p: float) -> float:
    """kg/(m² s), written anew from the paper: mol/(cm² s) of carbon, calories, atm."""
    ka, kb = (
        20.0 * math.exp(-30e3 / (1.98720425864 * kelvin)),
        4.46e-3 * math.exp(-15.2e3 / (1.98720425864 * kelvin)),
    )
    kt, kz = (
        1.51e5 * math.exp(-97e3 / (1.98720425864 * kelvin)),
        21.3 * math.exp(4.1e3 / (1.98720425864 * kelvin)),
    )
    x = 1.0 / (1.0 + kt / (kb * p))
    return 12.011e-3 * 1e4 * (x * ka * p / (1.0 + kz * p) + kb * p * (1.0 - x))


@pytest.mark.parametrize("kelvin", [900.0, 1300.0, 1700.0, 2300.0])
@pytest.mark.parametrize("pressure", [1e-3, 0.05, 0.21])
def test_it_is_the_published_rate(kelvin: float, pressure: float) -> None:
    assert soot_loss(kelvin, pressure) == pytest.approx(law(kelvin, pressure), rel=1e-12)


def test_little_oxygen_burns_it_in_proportion_and_much_does_not() -> None:
    assert soot_loss(1500.0, 2e-10) == pytest.approx(2.0 * soot_loss(1500.0, 1e-10), rel=1e-3)
    assert soot_loss(1100.0, 0.2) < 1.2 * soot_loss(1100.0, 0.1)
    assert soot_loss(1500.0, 0.0) == 0.0


def test_smoke_lasts_and_soot_in_a_flame_does_not() -> None:
    """30 nm: gone within tenths of a second at 1,500 K in air, kept for hours at 700 K."""
    air = {kelvin: 0.27 * 293.15 / kelvin for kelvin in (700.0, 1500.0)}
    assert 5.0 < soot_rate_of(1500.0, air[1500.0], 30e-9) < 500.0
    assert soot_rate_of(700.0, air[700.0], 30e-9) < 1e-3


def test_a_step_takes_that_share_off_and_books_it() -> None:
    cells, size, dt = np.array([[[1400.0, 0.0, 0.03, 2e-3], [700.0, 0.0, 0.03, 2e-3]]]), 30e-9, 0.02
    flames = Flames(range(4), 0.5, GasFuel(soot_size=size, glow=0.0, soot_glow=0.0))
    flames.step(cells, dt, np.zeros((1, 2)))
    rate = law(1400.0, 0.03 * 8.314462618 * 1400.0 / (0.031999 * 101325.0)) * 6.0 / (1800.0 * size)
    assert cells[0, 0, 3] == pytest.approx(2e-3 * math.exp(-rate * dt), rel=1e-9)
    assert cells[0, 1, 3] > 0.9999 * 2e-3
    assert flames.books_now().soot_gone == pytest.approx(0.25 * (4e-3 - cells[..., 3].sum()), rel=1e-9)
