"""Aiming by hand: the cue, its lock, spin and power, and the line that is the stroke itself."""

import math

import numpy as np
import pytest

from game.billiards.game.frame import Struck, trajectory_of
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards.stroke.aiming import NOTCH, TIP_STEP
from game.scenes.billiards.stroke.motion import cue_speed_of, power_of, pull_of, stroke_motion
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.choices import LARGEST_TIP
from game.scenes.shared.tables.cue import FULL_PULL, MAX_SPEED
from game.scenes.shared.tables.prediction import foresee
from game.stage import Action, SetParameter
from tests.scenes.billiards.billiards_stages import (
    AT_THE_CORNER,
    aim,
    check_balls,
    click,
    drag,
    open_level,
    point,
    seconds,
    straight_pot,
    until_aiming,
)


def test_fine_aim_by_wheel_keys_and_shift_is_not_spoilt_by_a_trembling_hand():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    assert scene.aiming.cue.aim == pytest.approx(1.0)
    x, y = scene.model.frame.cue_ball
    here = (x + 0.1 * math.cos(1.0), y + 0.1 * math.sin(1.0))
    point(stage, "wheel", *here, wheel=2.0)
    fine = scene.aiming.cue.aim
    assert fine == pytest.approx(1.0 - 2.0 * NOTCH)
    point(stage, "move", here[0] + 0.001, here[1])
    assert scene.aiming.cue.aim == fine
    point(stage, "wheel", *here, wheel=1.0, shift=True)
    assert scene.aiming.cue.aim == pytest.approx(fine - 0.1 * NOTCH)
    stage.post(Action("left"))
    assert scene.aiming.cue.aim > fine
    point(stage, "move", x - 0.1, y)
    assert abs(scene.aiming.cue.aim) == pytest.approx(math.pi)
    point(stage, "move", x - 0.1, y + 0.02, shift=True)
    assert abs(abs(scene.aiming.cue.aim) - math.pi) == pytest.approx(0.1 * math.atan2(0.02, 0.1), rel=1e-6)


def test_a_click_locks_the_aim_and_another_frees_it():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    x, y = scene.model.frame.cue_ball
    click(stage, x + 0.1 * math.cos(1.0), y + 0.1 * math.sin(1.0))
    assert scene.aiming.locked and scene.play.phase == "aiming" and "locked" in scene.messages()[0]
    for place in ((0.9, 1.9), layout.SPIN, (0.2, 2.4)):
        point(stage, "move", *place)
    assert scene.aiming.cue.aim == pytest.approx(1.0)
    stage.post(Action("left"))
    assert scene.aiming.cue.aim > 1.0  # finely, by keys and wheel, it can still be turned
    stage.step_back()
    stage.resume()
    assert scene.aiming.locked
    click(stage, 0.2, 2.4)
    assert not scene.aiming.locked and not scene.messages()
    point(stage, "move", x + 0.1, y)
    assert scene.aiming.cue.aim == pytest.approx(0.0)
    stage.post(Action("lock"))
    assert scene.aiming.locked


def test_a_locked_aim_is_pulled_from_anywhere_and_is_free_after_the_stroke():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    stage.post(Action("lock"))
    drag(stage, (0.9, 1.8), (1.0, 1.9))
    assert scene.play.phase == "striking"
    assert scene.play.pending.azimuth == pytest.approx(AT_THE_CORNER)
    until_aiming(stage)
    assert scene.model.frame.game.potted == 1 and not scene.aiming.locked
    stage.post(Action("undo"))
    point(stage, "move", 0.9, 1.8)
    assert scene.aiming.cue.aim == pytest.approx(AT_THE_CORNER)  # undo aims as before, and so it stays


def test_the_aim_that_stood_is_kept_on_the_way_to_an_instrument():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    seconds(stage, 0.5)
    for share in (0.3, 0.6, 0.9):  # over the cloth to the spin at its right
        point(stage, "move", 0.6, 0.5 + 2.0 * share)
        seconds(stage, 0.1)
    assert scene.aiming.cue.aim != pytest.approx(1.0)
    drag(stage, layout.SPIN, (layout.SPIN[0], layout.SPIN[1] + 0.01))
    assert scene.aiming.cue.aim == pytest.approx(1.0) and scene.aiming.locked
    assert scene.parameters.tip_left < 0.0 and "frees it" in scene.messages()[0]


def test_who_sets_the_power_before_aiming_finds_the_cue_free():
    stage = straight_pot()
    scene = stage.scene
    for share in (0.2, 0.6):  # on the way over the cloth, without a halt
        point(stage, "move", 0.5, 1.0 - share)
        seconds(stage, 0.1)
    drag(stage, layout.POWER.middle, layout.POWER.middle)
    assert not scene.aiming.locked
    aim(stage, 1.0)
    assert scene.aiming.cue.aim == pytest.approx(1.0)
    stage.post(Action("strike"))
    until_aiming(stage)
    seconds(stage, 1.0)  # the pointer lies where it was
    drag(stage, layout.POWER.middle, layout.POWER.middle)
    assert not scene.aiming.locked


def test_the_right_button_and_keys_set_spin_while_one_watches_the_line():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, 1.0)
    scene.aiming.set_tip(0.1, 0.0)
    point(stage, "down", 0.6, 0.6, button=3)
    point(stage, "move", 0.6 + 0.3 * layout.SPIN_RADIUS, 0.6 + 0.2 * layout.SPIN_RADIUS, button=3)
    assert (scene.parameters.tip_left, scene.parameters.tip_up) == pytest.approx((-0.1, -0.3))
    assert scene.aiming.cue.aim == pytest.approx(1.0)
    point(stage, "move", 1.2, 0.6, button=3)
    assert scene.parameters.tip_up == pytest.approx(-math.sqrt(LARGEST_TIP**2 - 0.0), abs=0.02)
    point(stage, "up", 1.2, 0.6, button=3)
    assert not scene.play.grip and scene.play.phase == "aiming"
    scene.aiming.centre()
    for name in ("spin-up", "spin-up", "spin-right", "spin-down", "spin-left", "spin-left"):
        stage.post(Action(name))
    assert (scene.parameters.tip_left, scene.parameters.tip_up) == pytest.approx((TIP_STEP, TIP_STEP))
    point(stage, "down", 0.45, 0.45, button=1)  # with the cue in hand it still takes the stroke back
    point(stage, "down", 0.45, 0.45, button=3)
    assert not scene.play.grip and scene.play.phase == "aiming"


def test_instruments_follow_the_pointer():
    stage = straight_pot()
    scene = stage.scene
    zero, full = layout.POWER.bottom - layout.POWER_FOOT, layout.POWER.top + layout.POWER_TOP
    middle = (0.5 * (zero + full), layout.LEFT_MIDDLE)
    drag(stage, (zero, layout.LEFT_MIDDLE), middle)
    assert scene.parameters.power == pytest.approx(0.5 * MAX_SPEED)
    point(stage, "wheel", *middle, wheel=-3.0)
    assert scene.parameters.power == pytest.approx(0.5 * MAX_SPEED - 0.3)
    sx, sy = layout.SPIN
    drag(stage, (sx, sy), (sx + 0.3 * layout.SPIN_RADIUS, sy - 0.2 * layout.SPIN_RADIUS))
    assert (scene.parameters.tip_up, scene.parameters.tip_left) == pytest.approx((-0.3, 0.2))
    drag(stage, (sx, sy), (sx - 5.0 * layout.SPIN_RADIUS, sy))
    assert scene.parameters.tip_up == pytest.approx(LARGEST_TIP)
    dx, dy = layout.ELEVATION
    reach = layout.ELEVATION_RADIUS
    drag(stage, (dx, dy + reach), (dx - reach * math.sin(0.5), dy + reach * math.cos(0.5)))
    assert scene.parameters.elevation == pytest.approx(math.degrees(0.5))
    stage.post(Action("centre"))
    assert (scene.parameters.tip_up, scene.parameters.tip_left, scene.parameters.elevation) == (0.0, 0.0, 0.0)
    stage.post(Action("harder"))
    assert scene.play.phase == "aiming" and scene.aiming.cue.phase == 0.0


def test_pulling_the_cue_back_strikes_as_hard_as_it_was_pulled():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, AT_THE_CORNER)
    pull = 0.4 * FULL_PULL
    x, y = 0.45, 0.45
    point(stage, "down", x, y, button=1)
    assert scene.play.grip == grip.CUE
    point(
        stage,
        "move",
        x - pull * math.cos(scene.aiming.cue.aim),
        y - pull * math.sin(scene.aiming.cue.aim),
        button=1,
    )
    assert scene.parameters.power == pytest.approx(0.4 * MAX_SPEED)
    point(
        stage,
        "up",
        x - pull * math.cos(scene.aiming.cue.aim),
        y - pull * math.sin(scene.aiming.cue.aim),
        button=1,
    )
    assert scene.play.phase == "striking"
    seconds(stage, 0.5)
    assert scene.play.phase == "rolling"
    struck = scene.model.frame.last
    assert power_of(struck.stroke.cue_speed) == pytest.approx(0.4 * MAX_SPEED)
    until_aiming(stage)
    assert 3 not in [number for number, _, _ in scene.model.frame.layout.places]
    assert scene.model.frame.game.potted == 1
    check_balls(stage)


def test_after_a_pull_the_power_is_again_what_was_set():
    stage = straight_pot()
    scene = stage.scene
    stage.post(SetParameter("power", 2.5))
    aim(stage, AT_THE_CORNER)
    x, y = scene.model.frame.cue_ball
    ux, uy = math.cos(AT_THE_CORNER), math.sin(AT_THE_CORNER)
    near, far = 0.1, 0.1 - 0.6 * FULL_PULL
    drag(stage, (x + near * ux, y + near * uy), (x + far * ux, y + far * uy))
    assert scene.play.phase == "striking" and scene.parameters.power > 2.5
    until_aiming(stage)
    assert scene.parameters.power == 2.5
    stage.post(Action("undo"))
    assert scene.parameters.power > 2.5  # the same stroke can be tried again


def test_a_short_pull_is_a_change_of_mind_and_esc_takes_the_stroke_back():
    stage = straight_pot()
    scene = stage.scene
    power = scene.parameters.power
    aim(stage, AT_THE_CORNER)
    drag(stage, (0.45, 0.45), (0.4502, 0.4502))
    assert scene.play.phase == "aiming" and scene.parameters.power == power
    point(stage, "down", 0.45, 0.45, button=1)
    point(stage, "move", 0.6, 0.6, button=1)
    assert scene.parameters.power != power
    point(stage, "cancel", 0.6, 0.6)
    assert scene.play.phase == "aiming" and scene.parameters.power == power and not scene.play.grip


def test_the_line_that_is_aimed_by_is_the_stroke_itself():
    stage = straight_pot()
    scene = stage.scene
    aim(stage, AT_THE_CORNER + 0.02)
    scene.parameters.tip_up, scene.parameters.tip_left, scene.parameters.elevation = -0.4, 0.2, 12.0
    struck = Struck(scene.model.frame, scene.aiming.stroke)
    sight = foresee(struck, 60)
    stage.post(Action("strike"))
    seconds(stage, 0.5)
    played = scene.model.played
    assert played.trajectory.digest == trajectory_of(struck).digest
    assert sight.target == 3
    assert sight.last == pytest.approx(played.trajectory.final["0"], abs=1e-9)
    ghost = np.array(sight.ghost)
    first = next(event.time for event in played.trajectory.events if event.type == "ball-ball")
    assert ghost == pytest.approx(played.trajectory.state_at(first).positions[0], abs=1e-9)
    assert np.linalg.norm(ghost - sight.target_place) == pytest.approx(2.0 * BALL_RADIUS, abs=1e-9)
    path = next(path for path in sight.others if path.number == 3)
    assert path.points[-1] == pytest.approx(played.trajectory.end[1, :2], abs=1e-9)


def test_fewer_events_show_a_shorter_path():
    stage = open_level("default")
    scene = stage.scene
    struck = Struck(scene.model.frame, scene.aiming.stroke)
    lengths = []
    for events in (1, 40, 120):
        sight = foresee(struck, events)
        lengths.append(sum(np.abs(np.diff(path.points, axis=0)).sum() for path in sight.others))
    assert lengths == sorted(lengths) and lengths[0] < 1e-3 < lengths[-1]


def test_the_cue_meets_the_ball_when_the_stroke_begins():
    for power in (0.1, 1.0, 4.0, 10.0):
        for practised in (False, True):
            motion = stroke_motion(cue_speed_of(power), practised)
            gap, solid = motion.track.sample(motion.hit_s).tolist()
            assert gap == 0.0 and solid == 1.0
            times = np.linspace(0.0, motion.hit_s, 400)
            gaps = motion.track.sample(times)[:, 0]
            assert gaps.min() >= 0.0 and gaps.max() <= max(pull_of(power), 0.6 * pull_of(power) + 0.02) + 1e-9
            assert motion.track.sample(motion.end_s).tolist()[1] == 0.0
            if not practised:
                assert gaps[0] == pytest.approx(pull_of(power))
                assert np.all(np.diff(gaps) <= 0.0)
