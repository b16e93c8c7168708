"""The hand at the snooker table: what each action and each turn of the wheel changes, and its bounds."""

from __future__ import annotations

import pytest

from game.scenes.shared.tables import grip
from game.scenes.snooker import layout
from game.scenes.snooker.hand import FINER, LARGEST_TIP, NOTCH, POWER_STEP, TIP_STEP, SnookerHand
from game.stage import Pointer
from tests.scenes.snooker.snooker_stages import level_of

TWO = """spotted = [16, 17, 18, 19, 20, 21]
balls = [{ number = 0, position = [0.5, 2.0] }, { number = 1, position = [1.2, 1.2] }]
"""


@pytest.fixture
def hand() -> SnookerHand:
    scene = level_of(TWO).scene
    return SnookerHand(scene.course)


@pytest.mark.parametrize(
    ("name", "left", "up"),
    [("spin-left", 1, 0), ("spin-right", -1, 0), ("spin-up", 0, 1), ("spin-down", 0, -1)],
)
def test_the_tip_goes_step_by_step_to_its_bound_and_back_to_the_centre(hand, name, left, up):
    chosen = hand.course.parameters
    chosen.tip_left, chosen.tip_up, chosen.elevation = 0.0, 0.0, 12.0
    hand.act(name)
    assert (chosen.tip_left, chosen.tip_up) == pytest.approx((left * TIP_STEP, up * TIP_STEP))
    for _ in range(60):
        hand.act(name)
    assert (chosen.tip_left, chosen.tip_up) == (left * LARGEST_TIP, up * LARGEST_TIP)
    assert chosen.elevation == 12.0
    hand.act("centre")
    assert (chosen.tip_left, chosen.tip_up, chosen.elevation) == (0.0, 0.0, 0.0)


def test_power_goes_up_and_down_by_a_step(hand):
    chosen = hand.course.parameters
    chosen.power = 3.0
    hand.act("harder")
    assert chosen.power == pytest.approx(3.0 + POWER_STEP)
    for _ in range(2):
        hand.act("softer")
    assert chosen.power == pytest.approx(3.0 - POWER_STEP)


def test_the_wheel_turns_the_cue_and_with_control_or_over_the_bar_sets_the_power(hand):
    course = hand.course
    course.parameters.power = 3.0
    for turn, shift, share in ((1.0, False, 1.0), (-2.0, False, 1.0), (1.0, True, FINER)):
        course.locked = False
        course.cue.point_to(0.3)
        hand.take(Pointer("wheel", 1.0, 1.0, wheel=turn, shift=shift))
        assert course.cue.aim == pytest.approx(0.3 - NOTCH * turn * share) and course.locked
    assert course.parameters.power == 3.0
    aim = course.cue.aim
    hand.take(Pointer("wheel", 1.0, 1.0, wheel=2.0, control=True))
    assert course.parameters.power == pytest.approx(3.0 + 2.0 * POWER_STEP)
    bar = layout.POWER
    hand.take(Pointer("wheel", 0.5 * (bar.top + bar.bottom), 0.5 * (bar.left + bar.right), wheel=-1.0))
    assert course.parameters.power == pytest.approx(3.0 + POWER_STEP) and course.cue.aim == aim
    course.grip = grip.TIP
    hand.take(Pointer("wheel", 1.0, 1.0, wheel=1.0))
    assert course.cue.aim == aim


@pytest.mark.parametrize(
    ("name", "called"),
    [("undo", "undo"), ("replay", "replay"), ("view", "next_guide"), ("rack", "next_one"),
     ("concede", "concede"), ("restart", "restart"), ("strike", "strike_by_hand")],
)  # fmt: skip
def test_each_command_is_what_its_name_says_and_nothing_else(hand, monkeypatch, name, called):
    done = []
    names = ("undo", "replay", "next_guide", "next_one", "concede", "restart", "strike_by_hand", "skip",
             "take_option", "nominate")  # fmt: skip
    for other in names:
        monkeypatch.setattr(type(hand.course), other, lambda course, *given, other=other: done.append(other))
    hand.act(name)
    assert done == [called]


def test_options_and_nominations_are_counted_as_they_are_named(hand, monkeypatch):
    done = []
    monkeypatch.setattr(type(hand.course), "take_option", lambda course, row: done.append(("option", row)))
    monkeypatch.setattr(type(hand.course), "nominate", lambda course, ball: done.append(("ball", ball)))
    for name in ("first", "second", "third", "nominate-2", "nominate-7"):
        hand.act(name)
    assert done == [("option", 0), ("option", 1), ("option", 2), ("ball", 16), ("ball", 21)]


def test_locking_the_aim_and_a_table_that_plays_itself_are_turned_on_and_off(hand):
    course = hand.course
    locked, plays = course.locked, course.plays_itself
    for turn in (True, False):
        hand.act("lock")
        assert course.locked == (locked != turn)
    course.grip, course.rest_s = grip.TIP, 3.0
    hand.act("demo")
    assert course.plays_itself != plays and not course.grip and course.rest_s == 0.0
