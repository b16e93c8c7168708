"""What is hot as it is seen: brightness temperatures against Planck's law, colours of black bodies."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from game.worlds.painting.flames import glow_inks, glow_stops
from game.worlds.painting.glowing import GlowLook, see_glowing

LOOK = GlowLook(dark=700.0, bright=1500.0, clear=0.02, opaque=5e-4, thick=4e-3, most=0.8, burns=900.0)
WAVE = 610e-9  # m


def planck(kelvin: float) -> float:
    """Radiance at WAVE, but for a factor."""
    return 1.0 / math.expm1(0.01438777 / (WAVE * kelvin))


def seen(kelvin: float, soot: float, edge: float = 1.0) -> tuple[float, float]:
    veil = np.full((1, 1, 2), 9.0, np.float32)
    see_glowing(LOOK, np.array([[kelvin]]), np.array([[soot]]), np.array([[edge]]), veil)
    return float(veil[0, 0, 0]), float(veil[0, 0, 1])


@pytest.mark.parametrize(("kelvin", "soot"), [(1100.0, 0.0), (1200.0, 1e-4), (1400.0, 1e-3), (1300.0, 0.1)])
def test_a_layer_is_as_bright_as_the_black_body_it_is_taken_for(kelvin, soot):
    _, light = seen(kelvin, soot)
    taken_for = LOOK.dark + light * (LOOK.bright - LOOK.dark)
    emissivity = 1.0 - math.exp(-(LOOK.clear + soot / LOOK.opaque))
    assert 0.0 < light < 1.0
    assert planck(taken_for) == pytest.approx(emissivity * planck(kelvin), rel=1e-3)
    assert seen(kelvin, soot, 0.5)[1] == pytest.approx(0.5 * light, rel=1e-6)


def test_what_is_cold_is_smoke_and_does_not_shine():
    assert seen(300.0, 2e-3) == pytest.approx((0.5, 0.0))
    assert seen(300.0, 1.0) == pytest.approx((0.8, 0.0), abs=1e-6)  # smoke never hides all
    assert seen(300.0, -1.0) == (0.0, 0.0)
    assert seen(3000.0, 1.0) == pytest.approx((0.0, 1.0))


def test_hotter_black_bodies_are_brighter_and_less_red():
    colors = [tuple(color)[:3] for _, color in glow_stops(700.0, 1500.0)]
    assert colors[0] == (0, 0, 0)
    for low, high in pairwise(colors[1:]):
        assert high[0] >= low[0] and high[1] >= low[1] and high[2] >= low[2]
        assert high[1] / high[0] >= low[1] / max(low[0], 1) - 0.02
    assert colors[-1][0] > colors[-1][1] > colors[-1][2]


def test_inks_are_the_stops_colours():
    stops = glow_stops(680.0, 1100.0)
    found = glow_inks(np.array([place for place, _ in stops]), 680.0, 1100.0)
    wanted = [color.r << 16 | color.g << 8 | color.b for _, color in stops]
    assert found.tolist() == wanted
