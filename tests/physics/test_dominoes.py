"""The speed of a domino wave against published and independent values; the way of a block that slides."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.dominoes import domino_wave_speed, stopping_distance

GAPS = (0.2, 0.3, 0.4, 0.5, 0.6, 0.7)
# thickness, friction: speeds over sqrt(g h) at these gaps, by van Leeuwen's equations solved elsewhere
TABLE = {
    (0.16, 0.2): (1.4660, 1.3993, 1.3466, 1.2967, 1.2438, 1.1832),
    (0.16, 0.0): (1.9667, 1.8365, 1.7548, 1.6921, 1.6385, 1.5923),
    (0.16, 0.4): (1.1492, 1.1192, 1.0871, 1.0505, 1.0064, 0.9507),
    (0.10, 0.2): (1.5207, 1.4529, 1.4023, 1.3547, 1.3037, 1.2448),
    (0.25, 0.2): (1.2390, 1.2243, 1.1922, 1.1524, 1.1054, 1.0485),
}


@pytest.mark.parametrize(("thickness", "friction"), TABLE)
def test_the_wave_is_as_fast_as_van_leeuwen_has_it(thickness: float, friction: float) -> None:
    for gap, speed in zip(GAPS, TABLE[thickness, friction], strict=True):
        assert domino_wave_speed(gap, thickness, friction) == pytest.approx(speed, abs=1.01e-4)


@given(st.floats(0.15, 0.8), st.floats(0.05, 0.25), st.floats(0.0, 0.4))
def test_more_friction_makes_it_slower(gap: float, thickness: float, friction: float) -> None:
    assert domino_wave_speed(gap, thickness, friction + 0.05) < domino_wave_speed(gap, thickness, friction)


def test_no_wave_goes_on_where_friction_holds_it() -> None:
    assert math.isnan(domino_wave_speed(0.02, 0.5, 3.0))


@pytest.mark.parametrize(
    "numbers", [(0.0, 0.1, 0.2), (1.0, 0.1, 0.2), (0.3, 0.0, 0.2), (0.3, 0.1, -1.0), (math.nan, 0.1, 0.2)]
)
def test_nonsense_is_refused(numbers: tuple[float, float, float]) -> None:
    with pytest.raises(ValueError, match="="):
        domino_wave_speed(*numbers)


def test_a_block_stops_where_its_energy_is_spent() -> None:
    assert stopping_distance(6.0, 0.5, 0.0, 10.0) == pytest.approx(36.0 / 10.0)
    way, slope = stopping_distance(4.0, 0.6, 0.2), 0.2
    # what it had and what the slope gave is what friction took
    assert 8.0 + 9.81 * way * math.sin(slope) == pytest.approx(0.6 * 9.81 * way * math.cos(slope))


def test_a_block_on_a_slope_that_friction_cannot_hold_never_stops() -> None:
    assert stopping_distance(1.0, 0.2, math.atan(0.2) + 1e-9) == math.inf
    assert stopping_distance(0.0, 0.3, 0.1) == 0.0
    with pytest.raises(ValueError, match="out of range"):
        stopping_distance(-1.0, 0.2, 0.0)
