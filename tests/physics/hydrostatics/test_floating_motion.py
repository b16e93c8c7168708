"""How a body heaves, rolls, sinks and enters water beside closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.hydrostatics import FloatingBody, FloatingSettings, exact, make_floater
from game.physics.hydrostatics.motion import SPIN, TURN, VY, Tank, Y
from game.physics.hydrostatics.stability import curve_of, pose_at

BARE = FloatingSettings(added=0, drag=0.0, waves=0.0)
SEA = Tank(1000.0, 20_000.0, 1000.0)


def outline(width: float, height: float):
    w, h = 0.5 * width, 0.5 * height
    return [(-w, -h), (w, -h), (w, h), (-w, h)]


def disc(radius: float, corners: int = 256):
    turn = 2.0 * math.pi * np.arange(corners) / corners
    return radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)


def period(body: FloatingBody, column: int, middle: float, dt: float = 1e-3) -> float:
    times, before = [], float(body.pose[column]) - middle
    for k in range(6000):
        body.step(dt)
        now = float(body.pose[column]) - middle
        if before < 0.0 <= now:
            times.append((k + before / (before - now)) * dt)
        before = now
    return float(np.diff(times).mean())


def test_a_beam_heaves_and_rolls_at_its_periods():
    beam = make_floater(outline(1.0, 0.3), 500.0)
    rest = 20.0  # half of it is below the level
    heaving = FloatingBody(beam, SEA, (500.0, rest + 0.01), settings=BARE)
    assert period(heaving, Y, rest + 0.15e-3) == pytest.approx(0.7769462845773928, rel=1e-3)
    rolling = FloatingBody(beam, SEA, (500.0, rest), 0.02, settings=BARE)
    assert period(rolling, TURN, 0.0) == pytest.approx(0.8721600497040425, rel=3e-3)


def test_in_a_narrow_tank_the_level_answers():
    log = make_floater(outline(0.4, 0.4), 60.0 / 0.16)
    tank = Tank(1.0, 0.6, 1000.0)
    body = FloatingBody(log, tank, (0.5, 0.67), settings=BARE)
    rest = 0.66 - 0.15 + 0.2
    body.put((0.5, rest + 0.005), 0.0)
    assert period(body, Y, rest) == pytest.approx(0.6018200042131941, rel=1e-3)


def test_the_level_rises_by_what_is_displaced():
    tank = Tank(2.0, 1.0, 1000.0)
    log = make_floater(outline(0.6, 0.4), 500.0)  # 120 kg
    body = FloatingBody(log, tank, (1.0, 0.6), settings=FloatingSettings(waves=1.0))
    body.step(20.0, 20_000)
    assert body.find_level() == pytest.approx(0.56, rel=1e-6)
    stone = FloatingBody(make_floater(outline(0.3, 0.3), 2500.0), tank, (1.0, 0.3))
    stone.step(5.0, 5_000)
    assert stone.find_level() == pytest.approx(0.545, rel=1e-9)
    assert stone.corners()[:, 1].min() == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(("share", "lies"), [(1.02, False), (0.98, True)])
def test_a_ship_floats_in_its_own_puddle(share, lies):
    water = share * exact.puddle(0.95, 0.4, 0.5, 1.0)
    assert exact.puddle(0.95, 0.4, 0.5, 1.0) == pytest.approx(0.01)
    ship = make_floater(outline(0.95, 0.4), 500.0)
    body = FloatingBody(ship, Tank(1.0, water, 1000.0), (0.5, 0.21), settings=FloatingSettings(waves=1.0))
    body.step(10.0, 20_000)
    assert (body.corners()[:, 1].min() < 1e-9) == lies


@pytest.mark.parametrize("s", [0.01, 0.5, 2.0])
def test_a_disc_let_go_starts_with_its_added_mass(s):
    body = FloatingBody(make_floater(disc(0.1), 1000.0 * s), SEA, (500.0, 10.0),
                        settings=FloatingSettings(drag=0.0, waves=0.0))  # fmt: skip
    body.step(1e-5)
    body.pose[VY] = 0.0  # the water that goes along is there now
    body.step(1e-4)
    assert body.pose[VY] / (1e-4 * 9.81) == pytest.approx(exact.released(s), rel=1e-3)


def test_a_disc_sinks_at_its_terminal_speed():
    deep = Tank(100.0, 3000.0, 1000.0)
    body = FloatingBody(make_floater(disc(0.1 / 2.0), 2500.0), deep, (50.0, 20.0))
    goal, way = exact.terminal_speed(0.1, 2.5, 1.2), 0.0
    body.step(1e-6)
    for _ in range(60_000):
        body.step(5e-5)
        if way == 0.0 and -body.pose[VY] >= 0.9 * goal:
            way = 20.0 - float(body.pose[Y])
    assert -body.pose[VY] == pytest.approx(1.3878721107264322, rel=1e-3)
    assert way == pytest.approx(0.38043111158924453, rel=1e-3)


def test_a_wedge_enters_as_von_karman_has_it():
    """Without weight: momentum is shared with half a disc as wide as what is wet."""
    wedge = make_floater([(0.0, 0.0), (0.6, 0.3), (-0.6, 0.3)], 50.0 / 0.18)
    settings = FloatingSettings(gravity=0.0, drag=0.0, waves=0.0)
    body = FloatingBody(wedge, SEA, (500.0, 20.0 + wedge.centre[1] + 1e-4), settings=settings)
    body.pose[VY] = -4.0
    while body.find_level() - body.corners()[:, 1].min() < 0.1:
        body.step(1e-5)
    assert -body.pose[VY] == pytest.approx(1.7725491034232885, rel=2e-3)


@pytest.mark.parametrize("start", [10.0, 49.0, 51.0, 90.0])
def test_a_hinged_plank_leans_as_its_hinge_is_deep(start):
    plank = make_floater([(-0.005, 0.0), (0.005, 0.0), (0.005, 1.0), (-0.005, 1.0)], 600.0)
    angle = -math.radians(start)
    place = 500.0 - 0.5 * math.sin(angle), 19.5 + 0.5 * math.cos(angle)
    body = FloatingBody(plank, SEA, place, angle, hinge=(0.0, 0.0), settings=FloatingSettings(waves=0.5))
    body.step(20.0, 20_000)
    assert -math.degrees(body.pose[TURN]) == pytest.approx(49.797034113430236, abs=0.05)
    assert body.placed(body.hinge[None, 1:3])[0] == pytest.approx((500.0, 19.5), abs=1e-9)


@pytest.mark.parametrize("s", [0.21, 0.215, 0.25, 0.35, 0.75])
@pytest.mark.parametrize("start", [1.0, 44.0])
def test_a_square_log_goes_to_its_angle_from_each_unstable_pose(s, start):
    log = make_floater(outline(1.0, 1.0), 1000.0 * s)
    pose = pose_at(log, math.radians(start))
    body = FloatingBody(log, SEA, (500.0, 20.0 - pose.depth), math.radians(start),
                        settings=FloatingSettings(waves=0.3))  # fmt: skip
    body.step(120.0, 60_000)
    turned = abs(math.degrees(body.pose[TURN])) % 90.0
    assert min(turned, 90.0 - turned) == pytest.approx(math.degrees(exact.square_log_tilt(s)), abs=0.3)


@pytest.mark.parametrize(("heel", "rights"), [(0.97, True), (1.03, False)])
def test_a_hull_rights_or_capsizes_by_the_sign_of_its_arm(heel, rights):
    hull = make_floater([(-0.5, 0.3), (-0.35, -0.1), (0.0, -0.2), (0.35, -0.1), (0.5, 0.3)], 450.0)
    poses = curve_of(hull).poses
    limit = min(one.angle for one in poses if one.angle > 0.1 and not one.stable)
    pose = pose_at(hull, heel * limit)
    body = FloatingBody(hull, SEA, (500.0, 20.0 - pose.depth), heel * limit)
    body.step(60.0, 30_000)
    assert (abs(body.pose[TURN]) < 0.5 * limit) == rights


def test_energy_never_rises_where_it_slams():
    """Thrown out of the water, it comes down flat; the bound is what a step of symplectic Euler may err."""
    log = make_floater(outline(0.6, 0.2), 400.0)
    body = FloatingBody(log, Tank(4.0, 4.0, 1000.0), (2.0, 1.5), 0.02)
    body.step(1e-9)
    before, flown = body.energy(), False
    for _ in range(9000):
        body.step(1e-3)
        now = body.energy()
        assert now < before + 3e-3 * 240.0 and math.isfinite(now)
        before, flown = now, flown or body.displaced() == 0.0
    assert flown and abs(body.pose[VY]) < 0.02 and abs(body.pose[SPIN]) < 0.05


def test_walls_and_floor_hold_it():
    stone = make_floater(outline(0.3, 0.1), 3000.0)
    body = FloatingBody(stone, Tank(1.0, 0.6, 1000.0), (0.3, 0.4), 1.2)
    body.pose[3] = 3.0
    body.step(5.0, 5_000)
    corners = body.corners()
    assert corners[:, 0].max() <= 1.0 + 1e-9 and corners[:, 1].min() >= -1e-9
    assert abs(math.sin(body.pose[TURN])) < 0.02  # flat on one of its long sides


def test_a_state_is_taken_up_to_the_bit():
    beam = make_floater(outline(1.0, 0.3), 500.0)
    body = FloatingBody(beam, SEA, (500.0, 20.1), 0.3)
    body.step(0.5, 100)
    kept = body.state()._replace(pose=body.pose.copy())
    body.step(0.5, 100)
    end = body.pose.copy()
    body.restore(kept)
    body.step(0.5, 100)
    assert np.array_equal(body.pose, end)


@pytest.mark.parametrize(
    ("tank", "place", "words"),
    [(Tank(0.0, 1.0, 1000.0), (0.0, 0.0), "width"), (Tank(1.0, -1.0, 1000.0), (0.0, 0.0), "water"),
     (SEA, (math.nan, 0.0), "place")],
)  # fmt: skip
def test_nonsense_is_refused(tank, place, words):
    with pytest.raises(ValueError, match=words):
        FloatingBody(make_floater(outline(1.0, 1.0), 500.0), tank, place)
