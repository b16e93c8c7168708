"""A tip that slips: where it begins, that nothing jumps there, and that no energy is made."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from game.billiards.shot.cue import CUE_END_MASS, CUE_MASS, strike
from game.billiards.shot.miscue import TipStroke, miscue, slip_limit, slips
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS

FRICTION = 0.65


def struck(stroke: TipStroke):
    """Velocity and spin (6,) of the ball, the hop into the slate left out."""
    blow = strike(*stroke, cue_end_mass=None)
    return np.array((*blow.velocity, *blow.spin))


def force_of(stroke: TipStroke) -> np.ndarray:
    """Unit vector along the cue: the force on the ball of one whose tip holds."""
    flat = math.cos(stroke.elevation)
    return np.array(
        [flat * math.cos(stroke.azimuth), flat * math.sin(stroke.azimuth), -math.sin(stroke.elevation)]
    )


def contact_of(stroke: TipStroke) -> np.ndarray:
    """Where the tip touches, radii from the middle of the ball."""
    along = force_of(stroke)
    left = np.array([-math.sin(stroke.azimuth), math.cos(stroke.azimuth), 0.0])
    up = np.cross(along, left)
    deep = math.sqrt(1.0 - stroke.tip_left**2 - stroke.tip_up**2)
    return stroke.tip_left * left + stroke.tip_up * up - deep * along


def test_a_chalked_tip_holds_up_to_about_half_a_radius():
    assert slip_limit(0.6) == pytest.approx(math.sin(math.atan(0.6)))
    assert 0.51 < slip_limit(0.6) < slip_limit(0.7) < 0.58
    assert not slips(0.0, 0.5, 0.6) and slips(0.0, 0.53, 0.6) and slips(-0.4, 0.4, 0.6)


OFFSETS = st.floats(-0.9, 0.9)


@given(OFFSETS, OFFSETS, st.floats(0.0, 1.0), st.floats(0.15, 0.9), st.floats(-3.0, 3.0))
def test_the_force_stays_in_the_cone_and_at_the_same_point(left, up, elevation, friction, azimuth):
    assume(left * left + up * up < 0.9)
    stroke = TipStroke(3.0, azimuth, elevation, left, up)
    made = miscue(stroke, friction)
    if not slips(left, up, friction):
        assert made == stroke
        return
    assert math.hypot(made.tip_left, made.tip_up) == pytest.approx(slip_limit(friction), rel=1e-9)
    assert 0.0 < made.cue_speed < stroke.cue_speed
    if made.elevation > 0.0:  # else the ball would be scooped up, which is left out
        assert contact_of(made) == pytest.approx(contact_of(stroke), abs=1e-9)
        inward = -contact_of(stroke)
        assert force_of(made) @ inward == pytest.approx(math.cos(math.atan(friction)), rel=1e-9)
        assert force_of(made) @ force_of(stroke) == pytest.approx(
            math.cos(math.asin(math.hypot(left, up)) - math.atan(friction)), rel=1e-9
        )


@pytest.mark.parametrize("way", [(1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (-0.6, -0.8)])
def test_nothing_jumps_where_the_tip_begins_to_slip(way):
    limit = slip_limit(FRICTION)
    before, after = (
        struck(miscue(TipStroke(3.0, 0.4, 0.2, way[0] * off, way[1] * off), FRICTION))
        for off in (limit - 1e-7, limit + 1e-7)
    )
    assert after == pytest.approx(before, rel=1e-4, abs=1e-4)


@pytest.mark.parametrize("off", [0.58, 0.7, 0.85, 0.95])
def test_no_energy_is_made_and_none_is_lost_but_to_the_slip(off):
    """Ball, cue and the cue's end together have what the cue brought: J = 2 V (u d) / (d K d)."""
    stroke = TipStroke(3.0, 0.0, 0.0, off, 0.0)
    made = miscue(stroke, FRICTION)
    ball = struck(made)
    inertia = 0.4 * BALL_MASS * BALL_RADIUS**2
    impulse = BALL_MASS * ball[:3]
    cue = 3.0 - impulse[0] / CUE_MASS
    end = -impulse[1] / CUE_END_MASS
    energy = 0.5 * (BALL_MASS * ball[:3] @ ball[:3] + inertia * ball[3:] @ ball[3:])
    energy += 0.5 * (CUE_MASS * cue * cue + CUE_END_MASS * end * end)
    assert energy == pytest.approx(0.5 * CUE_MASS * 9.0, rel=1e-9)


def test_a_miscue_sends_the_ball_away_from_the_tip_and_slower():
    left = miscue(TipStroke(3.0, 0.0, 0.0, 0.7, 0.0), FRICTION)
    assert left.azimuth == pytest.approx(-(math.asin(0.7) - math.atan(FRICTION)))
    high = miscue(TipStroke(3.0, 0.0, 0.0, 0.0, 0.7), FRICTION)
    assert high.elevation == pytest.approx(math.asin(0.7) - math.atan(FRICTION)) and high.azimuth == 0.0
    low = miscue(TipStroke(3.0, 0.0, 0.0, 0.0, -0.7), FRICTION)
    assert low.elevation == 0.0 and low.tip_up == pytest.approx(-slip_limit(FRICTION))
    with pytest.raises(ValueError, match="misses the ball"):
        miscue(TipStroke(3.0, 0.0, 0.0, 0.8, 0.7), FRICTION)
