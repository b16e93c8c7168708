"""Draft, angle and metacentre of floating bodies beside closed forms and published tables."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.hydrostatics import curve_of, exact, make_floater, pose_at
from game.physics.hydrostatics.bodies import Ballast
from game.physics.hydrostatics.cut import cut
from game.physics.hydrostatics.stability import lowest_pose

SQUARE = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
TRIANGLE = [(0.0, -math.sqrt(3.0) / 3.0), (0.5, math.sqrt(3.0) / 6.0), (-0.5, math.sqrt(3.0) / 6.0)]
HOOK = [(-0.5, -0.4), (0.6, -0.4), (0.6, 0.5), (0.3, 0.5), (0.3, -0.1), (-0.5, -0.1)]


def beam(width: float, height: float, s: float):
    w, h = 0.5 * width, 0.5 * height
    return make_floater([(-w, -h), (w, -h), (w, h), (-w, h)], 1000.0 * s)


def stable_tilts(s: float) -> list[float]:
    """Of a square log, degrees of a side from the horizontal, 0 to 45."""
    poses = curve_of(make_floater(SQUARE, 1000.0 * s)).poses
    turned = (math.degrees(one.angle) % 90.0 for one in poses if one.stable)
    return sorted({round(min(one, 90.0 - one), 6) for one in turned})


@pytest.mark.parametrize(
    ("s", "tilt"),
    [
        (0.15, 0.0), (0.22, 13.674945403795052), (0.24, 23.485487021417867), (0.25, 26.56505117707799),
        (0.26, 29.630476198695682), (0.275, 36.52128685291386), (0.35, 45.0),
    ],
)  # fmt: skip
def test_a_square_log_tilts_as_huygens_found(s, tilt):
    assert stable_tilts(s) == pytest.approx([tilt], abs=1e-5)
    assert stable_tilts(1.0 - s) == pytest.approx([tilt], abs=1e-5)
    assert math.degrees(exact.square_log_tilt(s)) == pytest.approx(tilt, abs=1e-9)


@pytest.mark.parametrize(("limit", "angle"), [(0.21132486540518713, 0.0), (0.28125, 45.0)])
def test_flat_and_corner_up_end_at_their_limits(limit, angle):
    sign = -1.0 if angle == 0.0 else 1.0
    steady, tipping = limit + sign * 1e-3, limit - sign * 1e-3
    assert pose_at(make_floater(SQUARE, 1000.0 * steady), math.radians(angle)).height > 0.0
    assert pose_at(make_floater(SQUARE, 1000.0 * tipping), math.radians(angle)).height < 0.0


def test_a_beam_has_its_metacentre_where_bouguer_says():
    found = pose_at(beam(1.0, 0.5, 0.6), 0.0)
    assert found.height == pytest.approx(0.17777777777777778, rel=1e-12)
    assert exact.beam_metacentre(1.0, 0.5, 0.6) == pytest.approx(found.height, rel=1e-12)
    assert exact.least_beam(0.6) == pytest.approx(1.2, rel=1e-12)
    assert pose_at(beam(1.21, 1.0, 0.6), 0.0).stable and not pose_at(beam(1.19, 1.0, 0.6), 0.0).stable


@pytest.mark.parametrize(("s", "tilt"), [(0.4, 60.0), (0.55, 14.477512185929914)])
def test_a_triangle_lies_where_its_energy_is_least(s, tilt):
    pose = lowest_pose(curve_of(make_floater(TRIANGLE, 1000.0 * s)))
    turned = math.degrees(pose.angle) % 120.0
    assert min(turned, 120.0 - turned) == pytest.approx(tilt, abs=1e-4)


@pytest.mark.parametrize(
    ("s", "deep", "wide"),
    [(0.3, 0.1360616980418996, 0.3790086729493919), (0.9, 0.33740976522650823, 0.2906445005183886)],
)
def test_a_disc_is_as_deep_as_its_segment(s, deep, wide):
    assert exact.disc_draft(0.2, s) == pytest.approx((deep, wide), rel=1e-9)
    turn = 2.0 * math.pi * np.arange(2000) / 2000
    disc = make_floater(0.2 * np.stack([np.cos(turn), np.sin(turn)], axis=1), 1000.0 * s)
    pose = pose_at(disc, 0.3)
    assert (pose.draft, pose.width) == pytest.approx((deep, wide), rel=1e-4)
    assert curve_of(disc).neutral


def test_what_is_denser_sinks():
    curve = curve_of(make_floater(SQUARE, 1001.0))
    assert not curve.poses and not curve.arms.any() and not pose_at(make_floater(SQUARE, 1001.0), 0.0).floats


def test_the_slope_of_the_arm_is_the_metacentric_height():
    """GZ = GM sin of a small angle, of an outline that is no beam, with ballast."""
    floater = make_floater(HOOK, 600.0, [Ballast(0.2, -0.3, 0.05, 40.0)])
    for pose in curve_of(floater).poses:
        apart = 1e-5
        slope = (pose_at(floater, pose.angle + apart).arm - pose_at(floater, pose.angle - apart).arm) / (
            2.0 * apart
        )
        assert slope == pytest.approx(pose.height, rel=1e-5)


def test_ballast_adds_its_mass_and_draws_the_centre_to_it():
    lead = Ballast(0.0, -0.4, 0.05, 200.0)
    floater, plain = make_floater(SQUARE, 400.0, [lead]), make_floater(SQUARE, 400.0)
    assert floater.mass == pytest.approx(600.0) and floater.area == pytest.approx(1.0)
    assert floater.centre == pytest.approx((0.0, -0.4 / 3.0))
    apart = 400.0 * (0.4 / 3.0) ** 2 + 200.0 * (0.8 / 3.0) ** 2 + 0.5 * 200.0 * 0.05**2
    assert floater.inertia == pytest.approx(plain.inertia + apart)
    assert pose_at(floater, 0.0).draft == pytest.approx(0.6)


@given(angle=st.floats(-3.1, 3.1), s=st.floats(0.05, 0.95))
def test_the_arm_is_the_slope_of_the_energy(angle, s):
    floater, apart = make_floater(HOOK, 1000.0 * s), 1e-5
    up, down = pose_at(floater, angle + apart).energy, pose_at(floater, angle - apart).energy
    assert (up - down) / (2.0 * apart) == pytest.approx(pose_at(floater, angle).arm, abs=2e-6)


def test_stable_and_unstable_poses_take_turns():
    for s in (0.1, 0.3, 0.55, 0.9):
        poses = curve_of(make_floater(HOOK, 1000.0 * s)).poses
        kinds = [one.stable for one in poses]
        assert len(kinds) % 2 == 0 and all(a != b for a, b in pairwise(kinds))


@given(depth=st.floats(-0.9, 0.9), angle=st.floats(-3.1, 3.1))
def test_what_is_cut_off_agrees_with_many_strips(depth, angle):
    floater = make_floater(HOOK, 500.0)
    c, s = math.cos(angle), math.sin(angle)
    x, y = floater.corners.T
    turned = np.stack([c * x - s * y, s * x + c * y - depth], axis=1)
    area = width_sum = 0.0
    heights = np.linspace(turned[:, 1].min(), 0.0, 4001)
    for h in 0.5 * (heights[1:] + heights[:-1]) if heights[0] < 0.0 else ():
        a, b = turned, np.roll(turned, -1, axis=0)
        crossed = (a[:, 1] < h) != (b[:, 1] < h)
        at = np.sort((a + ((h - a[:, 1]) / (b[:, 1] - a[:, 1] + ~crossed))[:, None] * (b - a))[crossed, 0])
        strip = float((at[1::2] - at[::2]).sum()) * (heights[1] - heights[0])
        area += strip
        width_sum += strip * h
    found = cut(floater.corners, c, s, depth)
    assert found[0] == pytest.approx(area, abs=2e-4) and found[2] == pytest.approx(width_sum, abs=2e-4)


@pytest.mark.parametrize(
    ("outline", "density", "words"),
    [(SQUARE[:2], 500.0, "outline"), (SQUARE, 0.0, "density"), (SQUARE, math.nan, "density")],
)
def test_nonsense_is_refused(outline, density, words):
    with pytest.raises(ValueError, match=words):
        make_floater(outline, density)


def test_closed_forms_of_the_rest():
    assert math.degrees(exact.hinged_plank_angle(1.0, 0.6, 0.5)) == pytest.approx(49.797034113430236)
    assert exact.heave_period(0.15) == pytest.approx(0.7769462845773928)
    assert exact.roll_period(1.0, 0.3, 0.5) == pytest.approx(0.8721600497040425)
    assert exact.tank_heave_period(0.4, 1.0, 60.0) == pytest.approx(0.6018200042131941)
    assert exact.puddle(0.95, 0.4, 0.5, 1.0) == pytest.approx(0.01)
    assert exact.released(0.5) == pytest.approx(1.0 / 3.0)
    assert exact.square_added_mass() == pytest.approx(1.1884396152264767)
    assert exact.ring_added_mass(0.2, 0.5) == pytest.approx(1.3809523809523812)
    assert exact.wedge_speed(50.0, 4.0, 0.2) == pytest.approx(1.7725491034232885)
    assert exact.terminal_speed(0.1, 2.5, 1.2) == pytest.approx(1.3878721107264322)
    assert exact.terminal_way(0.1, 2.5, 1.2) == pytest.approx(0.38043111158924453)
