"""Floors that fall on each other, by the law and by solids."""

from __future__ import annotations

import pytest

from game.lab.studies.collapse import fall_of
from game.physics.accretion import LIMIT, strike_times
from game.physics.solids import SolidSettings


@pytest.mark.parametrize(("floors", "seconds"), [(10, 3.513068), (40, 7.744194)])
def test_equal_floors_from_one(floors: int, seconds: float) -> None:
    """The top floor falls; the last way ends at the ground."""
    times = strike_times(1.0, [1.0] * (floors - 1) + [0.0], 3.0)
    assert times[-1] == pytest.approx(seconds, rel=1e-6)


def test_many_floors_without_a_mass_at_the_start_come_to_a_third_of_gravity() -> None:
    count, drop = 4_000, 0.01
    times = strike_times(1e-3, [1.0] * count, drop)
    half, last = times[count // 2 - 1], times[-1]  # what is left of the start is gone from the difference
    rate = (2.0 * drop * count) ** 0.5 - (drop * count) ** 0.5
    assert (rate / (last - half)) ** 2 == pytest.approx(LIMIT * 9.81, rel=2e-3)


def test_without_mass_floors_do_not_slow_it() -> None:
    assert strike_times(2.0, [0.0, 0.0, 0.0], 4.905) == pytest.approx([1.0, 2.0**0.5, 3.0**0.5])


@pytest.mark.parametrize("wrong", [(0.0, [1.0], 3.0, 9.81), (1.0, [-1.0], 3.0, 9.81), (1.0, [1.0], 0.0, 9.81),
                                   (1.0, [1.0], 3.0, 0.0)])  # fmt: skip
def test_nonsense_is_refused(wrong) -> None:
    with pytest.raises(ValueError, match="expected"):
        strike_times(*wrong)


def test_solids_fall_as_the_law_says() -> None:
    took, law = fall_of(SolidSettings(substeps=12), floors=6)
    assert took == pytest.approx(law, rel=0.01)
