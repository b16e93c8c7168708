"""Times of descent and limits of a loop, beside independent values."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids.tracks.descent import (
    arc_radius,
    arc_time,
    crossing_share,
    cycloid_through,
    cycloid_time,
    leaving_angle,
    line_time,
    loop_drop,
    rolling_acceleration,
)

G = 9.81


@pytest.mark.parametrize(
    ("width", "line", "cycloid"), [(2.0, 1.009638, 0.8055638), (0.5 * math.pi, 0.8407803, 0.7092517)]
)
def test_times_of_a_bead(width: float, line: float, cycloid: float) -> None:
    assert line_time(width, 1.0, G) == pytest.approx(line, rel=1e-6)
    assert cycloid_time(width, 1.0, G) == pytest.approx(cycloid, rel=1e-6)


def test_a_quarter_of_a_circle_takes_the_elliptic_integral() -> None:
    """sqrt(R/g) K(1/sqrt 2), K by the arithmetic and geometric mean (Gauss 1799)."""
    a, b = 1.0, math.sqrt(0.5)
    for _ in range(8):
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    assert arc_time(2.0, 2.0, G) == pytest.approx(math.sqrt(2.0 / G) * 0.5 * math.pi / a, rel=1e-13)


@pytest.mark.parametrize("time", [line_time, arc_time, cycloid_time])
def test_who_rolls_takes_longer_by_the_root_of_its_inertia(time) -> None:
    assert time(3.0, 2.0, G, 0.5) == pytest.approx(math.sqrt(1.5) * time(3.0, 2.0, G), rel=1e-14)
    assert time(3.0, 2.0, 4.0 * G) == pytest.approx(0.5 * time(3.0, 2.0, G), rel=1e-14)
    for values in ((0.0, 1.0, G, 0.0), (1.0, -1.0, G, 0.0), (1.0, 1.0, math.nan, 0.0), (1.0, 1.0, G, 1.5)):
        with pytest.raises(ValueError, match="expected"):
            time(*values)


@pytest.mark.parametrize("width", [0.3, 1.0, 1.7, 4.0])
def test_no_way_is_quicker_than_the_cycloid(width: float) -> None:
    best = cycloid_time(width, 1.0, G)
    assert best < arc_time(width, 1.0, G) or width == pytest.approx(0.0)
    assert best < line_time(width, 1.0, G)


@pytest.mark.parametrize("width", [0.4, 1.2, 3.0])
def test_curves_go_through_their_end(width: float) -> None:
    wheel, end = cycloid_through(width, 1.0)
    assert wheel * (end - math.sin(end)) == pytest.approx(width, rel=1e-12)
    assert wheel * (1.0 - math.cos(end)) == pytest.approx(1.0, rel=1e-12)
    radius = arc_radius(width, 1.0)
    assert math.hypot(width - radius, 1.0) == pytest.approx(radius, rel=1e-12)


def test_limits_of_a_loop() -> None:
    """11/4 and 27/10 of R - r for a disc and a sphere; at its limit a ball leaves at the very top."""
    assert loop_drop(1.0, 0.1, 0.5) == pytest.approx(2.475)
    assert loop_drop(1.0, 0.1, 0.4) == pytest.approx(2.43)
    assert loop_drop(1.0, 0.2, 0.0) == pytest.approx(2.0)
    assert rolling_acceleration(math.radians(30.0), G, 0.5) == pytest.approx(G / 3.0)
    for share in (0.0, 0.4, 0.5):
        limit = loop_drop(1.0, 0.1, share)
        assert leaving_angle(limit * (1.0 - 1e-9), 1.0, 0.1, share) == pytest.approx(0.0, abs=1e-3)
        assert math.isnan(leaving_angle(limit * 1.001, 1.0, 0.1, share))
        assert math.isnan(leaving_angle(0.8, 1.0, 0.1, share))
        assert leaving_angle(0.9, 1.0, 0.1, share) == pytest.approx(0.5 * math.pi)


@pytest.mark.parametrize("acceleration", [-3.0, 0.0, 5.0])
def test_a_crossing_is_found_within_its_step(acceleration: float) -> None:
    dt, speed = 0.1, 2.0
    for share in np.linspace(0.05, 0.95, 7).tolist():
        level = speed * share * dt + 0.5 * acceleration * (share * dt) ** 2
        end = speed * dt + 0.5 * acceleration * dt**2
        found = crossing_share(0.0, end, speed * dt, (speed + acceleration * dt) * dt, level)
        assert found == pytest.approx(share, abs=1e-9)
        back = crossing_share(0.0, -end, -speed * dt, -(speed + acceleration * dt) * dt, -level)
        assert back == pytest.approx(share, abs=1e-9)
