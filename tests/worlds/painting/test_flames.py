"""Gas as it is seen: cold soot is smoke, hot soot shines, hot gas without any a little."""

from __future__ import annotations

import numpy as np
import pytest

from game.worlds.painting.flames import FlameLook, flame_height, see_gas

LOOK = FlameLook(
    glows=500.0, brightest=1100.0, bare=0.25, shining=2e-4, thick=4e-3, most=0.8, burns=900.0
)  # fmt: skip


def seen(kelvin, soot, edge=1.0):
    """How thick the smoke and how bright the flame of one cell are."""
    veil = np.full((1, 1, 2), 9.0, np.float32)
    see_gas(LOOK, np.array([[kelvin]]), np.array([[soot]]), np.array([[edge]]), veil)
    return float(veil[0, 0, 0]), float(veil[0, 0, 1])


@pytest.mark.parametrize(
    ("kelvin", "soot", "smoke", "flame"),
    [
        (293.0, 0.0, 0.0, 0.0),
        (293.0, 2e-3, 0.5, 0.0),
        (293.0, 1.0, 0.8, 0.0),  # smoke never hides all
        (1100.0, 0.0, 0.0, 0.25),
        (1100.0, 1e-4, 0.0, 0.625),
        (3000.0, 1.0, 0.0, 1.0),
        (650.0, 2e-3, 0.25, 0.25),
        (293.0, -1.0, 0.0, 0.0),  # what carrying has made less than nothing
    ],
)
def test_smoke_and_flame_of_a_cell(kelvin, soot, smoke, flame):
    assert seen(kelvin, soot) == pytest.approx((smoke, flame), abs=1e-6)
    assert seen(kelvin, soot, 0.5) == pytest.approx((0.5 * smoke, 0.5 * flame), abs=1e-6)


def test_a_flame_is_as_high_as_what_burns():
    kelvin = np.full((8, 5), 300.0)
    assert flame_height(LOOK, kelvin, 0.1) == 0.0
    kelvin[3, 2] = 950.0
    assert flame_height(LOOK, kelvin, 0.1) == pytest.approx(0.4)
