"""Numbers of moving fronts against roots of the textbook's equations, by scipy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import erf, erfc

from game.physics.heat.exact import neumann_number, stefan_number

ICE, WATER = (2.22, 1.15e-6), (0.556, 1.33e-7)  # W/(m K), m²/s


@pytest.mark.parametrize("start", [273.15, 275.0, 290.0, 320.0])
@pytest.mark.parametrize("latent", [3e7, 3.06e8])
def test_a_front_that_freezes_into_warm_water(start, latent):
    (k1, a1), (k2, a2) = ICE, WATER
    wall, melting = 263.15, 273.15

    def balance(x):
        solid = k1 * (melting - wall) * np.exp(-x * x) / (math.sqrt(math.pi * a1) * erf(x))
        y = x * math.sqrt(a1 / a2)
        liquid = k2 * (start - melting) * np.exp(-y * y) / (math.sqrt(math.pi * a2) * erfc(y))
        return solid - liquid - latent * x * math.sqrt(a1)

    wanted = brentq(balance, 1e-9, 3.0, xtol=1e-14)
    assert neumann_number(wall, start, melting, ICE, WATER, latent) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("stefan", [0.01, 0.3, 1.0, 4.0])
def test_a_front_that_melts_what_is_at_its_melting_point(stefan):
    wanted = brentq(lambda x: math.sqrt(math.pi) * x * np.exp(x * x) * erf(x) - stefan, 1e-9, 3.0, xtol=1e-14)
    assert stefan_number(stefan) == pytest.approx(wanted, rel=1e-9)
