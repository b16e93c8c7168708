"""A hull of sections: periods and arms beside closed forms, waves that are long, blows, energy."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.waves.sea import LEVEL, SLOPE_X, SLOPE_Z
from game.physics.waves.sections import (
    HEAVE,
    PITCH,
    ROLL,
    STRIKE,
    SURGE,
    HullSettings,
    SectionHull,
    box_sections,
    rounded_sections,
)

BARE = HullSettings(density=1000.0, added=0.0, leaving=0.0, strikes=0.0)


def beam(breadth: float = 1.0, height: float = 0.3, share: float = 0.5) -> SectionHull:
    mass = 1000.0 * breadth * height * share
    inertia = mass * (breadth**2 + height**2) / 12.0
    return SectionHull(box_sections(breadth, height, 0.5 * height), np.zeros(1), mass, (1.0, inertia), BARE)


def swing(hull: SectionHull, lifted: float, heel: float) -> float:
    """s of a swing that is let go, by small steps."""
    rest, dt = hull.afloat(), 1e-3
    up, rising, rolling, last, hits = rest + lifted, 0.0, 0.0, 0.0, []
    still = np.zeros((len(hull.stations), 5))
    for k in range(5000):
        found = hull.push((up, 0.0, heel, 0.0, rising, 0.0, rolling), still, hull.unknown, 9.81, dt)
        rising += dt * (found[0, HEAVE] / hull.mass - 9.81)
        rolling += dt * found[0, ROLL] / hull.inertia[1]
        up, heel = up + dt * rising, heel + dt * rolling
        now = up - rest if lifted else heel
        if last < 0.0 <= now:
            hits.append((k + 1.0 - now / (now - last)) * dt)
        last = now
    return float(np.diff(hits).mean())


def test_heave_and_roll_of_a_beam_are_those_of_its_hydrostatics() -> None:
    """Beam 1 m by 0.3 m, half as heavy as water: 2 π √(s h / g), 2 π √((b² + h²) / (12 g GM))."""
    hull = beam()
    assert hull.periods() == pytest.approx((0.7769462845773928, 0.8721600497040425), rel=1e-9)
    assert swing(hull, 0.01, 0.0) == pytest.approx(0.7769463, rel=1e-3)
    assert swing(hull, 0.0, 0.01) == pytest.approx(0.87216, rel=1e-3)


def test_the_metacentre_of_a_beam() -> None:
    """b² / 12 s h - h (1 - s) / 2."""
    assert beam(1.0, 0.5, 0.4).at_rest().metacentre == pytest.approx(1.0 / (12.0 * 0.2) - 0.5 * 0.3, rel=1e-9)


@pytest.mark.parametrize(
    ("share", "angle"), [(0.22, 13.67495), (0.24, 23.48549), (0.25, 26.56505), (0.26, 29.63048)]
)
def test_a_square_log_is_at_rest_where_its_arm_is_none(share: float, angle: float) -> None:
    """tan² = 12 s (1 - s) - 2."""
    log = beam(1.0, 1.0, share)
    angle = math.radians(angle)
    assert abs(log.arm(angle)) < 1e-6
    assert log.arm(angle - 0.02) < 0.0 < log.arm(angle + 0.02)


def test_a_flat_log_stands_below_a_fifth_of_water() -> None:
    """Up to a share of (3 - √3) / 6 = 0.2113 it floats flat."""
    assert beam(1.0, 1.0, 0.20).arm(0.01) > 0.0 > beam(1.0, 1.0, 0.2226).arm(0.01)


def test_upright_and_upside_down_there_is_no_arm() -> None:
    ends = np.array([(0.4, 0.3, 0.4), (0.6, 0.4, 0.4), (0.3, 0.3, 0.5)])
    hull = SectionHull(rounded_sections(ends), np.array((-1.0, 0.0, 1.0)), 400.0, (100.0, 60.0))
    for heel in (0.0, math.pi):
        assert abs(hull.arm(heel)) < 1e-9
    assert hull.arm(0.3) == pytest.approx(-hull.arm(-0.3), rel=1e-9)


def test_what_is_under_water_is_cut_out_exactly() -> None:
    """A beam half under a line of slope a: its weight in water, and a push along the slope."""
    hull, still = beam(), np.zeros((1, 5))
    still[0, SLOPE_Z], still[0, SLOPE_X], still[0, LEVEL] = 0.1, 0.05, 0.02
    found = hull.push((0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), still, hull.unknown, 9.81, 1e-3)
    area = 1.0 * (0.15 + 0.02)
    assert found[0, HEAVE] == pytest.approx(1000.0 * 9.81 * area, rel=1e-12)
    assert found[0, SURGE] == pytest.approx(-0.05 * 1000.0 * 9.81 * area, rel=1e-12)
    # a wedge of 0.1 of slope leans to where the water is higher
    z = 0.1 / 12.0 / area
    y = (0.5 * (0.02**2 - 0.15**2) + 0.5 * 0.1**2 / 12.0) / area
    assert found[0, ROLL] == pytest.approx(-1000.0 * 9.81 * area * (z + 0.1 * y), rel=1e-9)


def test_a_bow_under_water_lifts_the_bow() -> None:
    sections = box_sections(1.0, 0.4, 0.2, 5)
    hull = SectionHull(sections, np.linspace(-2.0, 2.0, 5), 1000.0, (900.0, 90.0), BARE)
    still = np.zeros((5, 5))
    found = hull.push((0.0, -0.02, 0.0, 0.0, 0.0, 0.0, 0.0), still, hull.unknown, 9.81, 1e-3)
    assert found[0, PITCH] == pytest.approx(1000.0 * 9.81 * 0.02 * 10.0, rel=2e-3)


def test_a_section_that_goes_in_is_struck_by_the_water_that_it_takes_along() -> None:
    """von Karman 1929: the rate of the added mass times the speed; out of the water nothing."""
    settings = HullSettings(density=1000.0, added=1.0, leaving=0.0, strikes=1.0)
    wedge = np.array([[(0.0, -0.5), (0.5, 0.0), (-0.5, 0.0)]])
    hull = SectionHull(wedge, np.zeros(1), 100.0, (1.0, 10.0), settings)
    still, dt, speed, deep = np.zeros((1, 5)), 1e-6, 2.0, 0.2
    before = np.array((2.0 * (deep - speed * dt),))
    hull.push((0.5 - deep, 0.0, 0.0, 0.0, -speed, 0.0, 0.0), still, before, 9.81, dt)
    rate = 1000.0 * math.pi / 8.0 * 2.0 * (2.0 * deep) * 2.0 * speed
    assert hull.cuts[0, STRIKE] == pytest.approx(rate * speed, rel=1e-4)
    hull.push((0.5 - deep, 0.0, 0.0, 0.0, speed, 0.0, 0.0), still, before, 9.81, dt)
    assert hull.cuts[0, STRIKE] == 0.0


def test_nonsense_is_refused() -> None:
    with pytest.raises(ValueError):
        SectionHull(np.zeros((1, 4)), np.zeros(1), 1.0, (1.0, 1.0))
    with pytest.raises(ValueError):
        SectionHull(box_sections(1.0, 1.0, 0.5), np.zeros(1), -1.0, (1.0, 1.0))
    with pytest.raises(ValueError):
        beam(share=1.2).afloat()
