"""Parts of a substep: they end at impacts, add up to the whole, and come to an end."""

from __future__ import annotations

import math

import pytest

from game.physics.spheres.time_of_impact import IMPACTS_PER_SPHERE, MOMENT, MOST_IMPACTS, divide_at_impacts


def until(impacts: list[float]):
    """Times to these impacts (s since the beginning), for a clock that the parts drive."""
    clock = [0.0]

    def time_to_impact(left: float) -> float:
        ahead = [t - clock[0] for t in impacts if t > clock[0] + 1e-12]
        return min([left, *ahead])

    return clock, time_to_impact


@pytest.mark.parametrize("pause", [False, True])
def test_parts_end_at_impacts_and_add_up(pause: bool):
    clock, ask = until([0.25, 0.5])
    parts = []
    for h in divide_at_impacts(1.0, 2, pause, ask):
        parts.append(h)
        clock[0] += h
    assert math.fsum(parts) == pytest.approx(1.0, abs=1e-15)
    moment = [MOMENT] if pause else []
    assert parts == pytest.approx([0.25, *moment, 0.25 - sum(moment), *moment, 0.5 - sum(moment)], abs=1e-12)


@pytest.mark.parametrize("pause", [False, True])
def test_a_substep_without_an_impact_is_one_part(pause: bool):
    assert list(divide_at_impacts(0.01, 5, pause, lambda left: left)) == [0.01]


@pytest.mark.parametrize("spheres", [1, 10, 1000])
def test_impacts_without_end_do_not_stop_time(spheres: int):
    parts = list(divide_at_impacts(1.0, spheres, False, lambda left: 0.0))
    assert len(parts) == min(IMPACTS_PER_SPHERE * spheres, MOST_IMPACTS)
    assert set(parts[:-1]) == {MOMENT} and math.fsum(parts) == pytest.approx(1.0, abs=1e-13)
