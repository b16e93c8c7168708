"""The stroke: reference strikes, symmetry, limits."""

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.billiards.shot.cue import CUE_MASS, speed_ratio, strike
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from tests.paths import TESTS

STRIKES = json.loads((TESTS / "reference" / "strikes.json").read_text())
offsets = st.floats(-0.6, 0.6)


@pytest.mark.parametrize("case", STRIKES, ids=range(len(STRIKES)))
def test_reference_strike(case):
    result = strike(
        case["cue_speed"],
        math.radians(case["azimuth_deg"]),
        math.radians(case["elevation_deg"]),
        case["tip_left"],
        case["tip_up"],
        ball_mass=case["ball_mass"],
        ball_radius=case["ball_radius"],
        cue_mass=case["cue_mass"],
        cue_end_mass=case["cue_end_mass"],
    )
    assert result.velocity == pytest.approx(case["velocity"], rel=0.0, abs=1e-12)
    assert result.spin == pytest.approx(case["spin"], rel=0.0, abs=1e-12)


def test_a_centre_stroke_is_an_elastic_impact_of_cue_and_ball():
    velocity, spin = strike(2.0, 0.0)
    cue_after = (CUE_MASS * 2.0 - BALL_MASS * velocity[0]) / CUE_MASS
    before = 0.5 * CUE_MASS * 4.0
    after = 0.5 * CUE_MASS * cue_after**2 + 0.5 * BALL_MASS * velocity[0] ** 2
    assert after == pytest.approx(before, rel=1e-14)
    assert spin == (0.0, 0.0, 0.0)


@given(st.floats(0.1, 10.0), offsets, offsets)
def test_a_level_stroke_keeps_energy_and_angular_momentum(speed, left, up):
    velocity, spin = strike(speed, 0.3, 0.0, left, up, cue_end_mass=None)
    v = math.hypot(*velocity[:2])
    inertia = 0.4 * BALL_MASS * BALL_RADIUS**2
    # the impulse acts at the tip: I w = r x m v
    arm = BALL_RADIUS * math.hypot(left, up)
    assert inertia * math.sqrt(sum(w * w for w in spin)) == pytest.approx(
        arm * BALL_MASS * v, rel=1e-12, abs=1e-15
    )
    cue_after = speed - BALL_MASS * v / CUE_MASS
    after = 0.5 * CUE_MASS * cue_after**2 + 0.5 * BALL_MASS * v * v + 0.5 * inertia * sum(w * w for w in spin)
    assert after == pytest.approx(0.5 * CUE_MASS * speed**2, rel=1e-12)


@given(st.floats(0.1, 10.0), offsets, offsets, st.floats(0.0, 1.5))
def test_left_and_right_are_mirror_images(speed, left, up, elevation):
    one = strike(speed, 0.5 * math.pi, elevation, left, up)
    other = strike(speed, 0.5 * math.pi, elevation, -left, up)
    # mirrored in the y axis: a velocity's x turns round, a spin's y and z do
    flip = pytest.approx([-other.velocity[0], other.velocity[1]], rel=1e-12, abs=1e-12)
    assert list(one.velocity[:2]) == flip
    assert list(one.spin) == pytest.approx(
        [other.spin[0], -other.spin[1], -other.spin[2]], rel=1e-12, abs=1e-9
    )


def test_a_light_cue_end_squirts_less():
    angles = [
        math.atan2(*strike(2.0, 0.0, 0.0, 0.4, 0.0, cue_end_mass=m).velocity[1::-1])
        for m in (0.002, 0.006, 0.02)
    ]
    assert 0.0 > angles[0] > angles[1] > angles[2]
    assert math.atan2(*strike(2.0, 0.0, 0.0, 0.4, 0.0, cue_end_mass=None).velocity[1::-1]) == pytest.approx(
        0.0, abs=1e-15
    )


@pytest.mark.parametrize(
    ("arguments", "name"),
    [
        ((-1.0, 0.0), "cue_speed"),
        ((math.nan, 0.0), "cue_speed"),
        ((1.0, math.inf), "azimuth"),
        ((1.0, 0.0, -0.1), "elevation"),
        ((1.0, 0.0, 1.6), "elevation"),
        ((1.0, 0.0, 0.0, 0.8, 0.8), "misses the ball"),
        ((1.0, 0.0, 0.0, math.nan), "tip_left"),
    ],
)
def test_absurd_strokes_are_refused(arguments, name):
    with pytest.raises(ValueError, match=name):
        strike(*arguments)


@pytest.mark.parametrize("name", ["ball_mass", "ball_radius", "cue_mass", "cue_end_mass"])
def test_absurd_masses_are_refused(name):
    with pytest.raises(ValueError, match=name):
        strike(1.0, 0.0, **{name: 0.0})


@given(st.floats(0.05, 1.0), st.floats(0.2, 1.0))
def test_the_ratio_of_speeds_is_that_of_a_stroke_in_the_centre(ball_mass, cue_mass):
    struck = strike(1.0, 0.3, ball_mass=ball_mass, cue_mass=cue_mass)
    assert math.hypot(*struck.velocity) == pytest.approx(speed_ratio(ball_mass, cue_mass), rel=1e-14)
