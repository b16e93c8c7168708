"""The mouse cue: where it points, how far it is pulled, when it strikes, each at its bounds."""

from __future__ import annotations

import math

import pytest

from game.scenes.shared.tables.cue import (
    AIMING,
    FINE,
    FULL_PULL,
    LEAST_SPEED,
    MAX_SPEED,
    NUDGE,
    PULLING,
    REST_GAP,
    STRIKING,
    CueControl,
)
from game.stage import Pointer

BALL = (0.5, 1.0)


def send(cue: CueControl, kind: str, x: float, y: float, ready: bool = True, **more) -> None:
    cue.pointer(Pointer(kind, x, y, **more), *BALL, ready)


def pulled(back: float, aim: float = 0.7) -> CueControl:
    """A cue that was pressed somewhere and pulled back so far (m)."""
    cue = CueControl(aim)
    send(cue, "down", 2.0, 3.0, button=1)
    send(cue, "move", 2.0 - back * math.cos(aim), 3.0 - back * math.sin(aim), button=1)
    return cue


def test_it_begins_at_rest_behind_the_ball_and_points_where_it_is_told():
    cue = CueControl(0.4)
    assert cue.data.tolist() == [0.4, 0.0, AIMING, 0.0, 0.0, 0.4, REST_GAP]
    assert (cue.aim, cue.speed, cue.phase, cue.gap) == (0.4, 0.0, AIMING, REST_GAP)
    cue.point_to(1.5 * math.pi)
    assert cue.aim == pytest.approx(-0.5 * math.pi)


def test_it_points_to_the_pointer_and_finely_with_shift():
    cue = CueControl(0.0)
    send(cue, "move", BALL[0] + 3.0, BALL[1] + 4.0)
    assert cue.aim == pytest.approx(math.atan2(4.0, 3.0))
    before = cue.aim
    send(cue, "move", BALL[0], BALL[1] + 1.0, shift=True)
    assert cue.aim == pytest.approx(before + FINE * (0.5 * math.pi - before))
    between = cue.aim
    send(cue, "move", BALL[0] - 1.0, BALL[1] + 0.01, shift=True)
    send(cue, "move", BALL[0] - 1.0, BALL[1] - 0.01, shift=True)  # across where angles jump
    assert cue.aim == pytest.approx(between + FINE * (0.5 * math.pi + math.atan(0.01)))
    now = cue.data.copy()
    send(cue, "move", BALL[0] + 0.9e-6, BALL[1])
    assert cue.data.tolist() == now.tolist()  # on the ball's middle there is no direction
    send(cue, "move", BALL[0] + 1.1e-6, BALL[1])
    assert cue.aim == 0.0


@pytest.mark.parametrize("aim", [0.7, -2.0])
@pytest.mark.parametrize(
    ("back", "share"), [(-0.2, 0.0), (0.5 * FULL_PULL, 0.5), (FULL_PULL, 1.0), (2.0 * FULL_PULL, 1.0)]
)
def test_the_speed_is_the_share_of_the_full_pull_along_the_aim(aim, back, share):
    cue = pulled(back, aim)
    assert cue.phase == PULLING and cue.speed == pytest.approx(share * MAX_SPEED)
    assert cue.gap == pytest.approx(REST_GAP + share * FULL_PULL) and cue.aim == aim
    send(cue, "move", 2.0 + 5.0 * math.sin(aim), 3.0 - 5.0 * math.cos(aim), button=1)  # to the side
    assert cue.speed == pytest.approx(0.0, abs=1e-9)


def test_a_pull_too_short_is_a_change_of_mind():
    short = FULL_PULL * LEAST_SPEED / MAX_SPEED
    for back, phase in ((short * 0.999, AIMING), (short * 1.001, STRIKING)):
        cue = pulled(back)
        send(cue, "up", 0.0, 0.0, button=1)
        assert cue.phase == phase and (cue.speed > 0.0) == (phase == STRIKING)
    cue = pulled(0.1)
    cue.data[1] = LEAST_SPEED
    send(cue, "up", 0.0, 0.0, button=1)
    assert cue.phase == STRIKING


def test_only_the_left_button_pulls_a_cue_that_is_ready_and_the_right_lets_go():
    cue = CueControl(0.0)
    send(cue, "down", 0.0, 0.0, ready=False, button=1)
    send(cue, "down", 0.0, 0.0, button=2)
    send(cue, "up", 0.0, 0.0, button=1)
    assert cue.phase == AIMING
    for kind, button in (("cancel", 0), ("down", 3)):
        cue = pulled(0.2)
        send(cue, "up", 0.0, 0.0, button=2)
        send(cue, "down", 9.0, 9.0, button=1)  # a pull goes on from where it began
        assert cue.phase == PULLING and cue.data[3:5].tolist() == [2.0, 3.0]
        send(cue, kind, 0.0, 0.0, button=button)
        assert (cue.phase, cue.speed, cue.gap) == (AIMING, 0.0, REST_GAP)


def test_a_stroke_that_has_begun_goes_on():
    cue = CueControl(0.0)
    cue.strike(7.0, 20.0)
    assert cue.aim == pytest.approx(7.0 - 2.0 * math.pi) and cue.speed == MAX_SPEED and cue.phase == STRIKING
    assert cue.gap == pytest.approx(REST_GAP + FULL_PULL)
    kept = cue.data.copy()
    send(cue, "cancel", 0.0, 0.0)
    send(cue, "move", 0.0, 0.0)
    send(cue, "down", 0.0, 0.0, button=1)
    send(cue, "up", 0.0, 0.0, button=1)
    cue.nudge("left")
    assert cue.data.tolist() == kept.tolist()
    cue.strike(0.0, -1.0)
    assert cue.speed == 0.0


def test_a_key_turns_it_against_the_clock_or_with_it():
    cue = CueControl(0.2)
    cue.nudge("left")
    assert cue.aim == pytest.approx(0.2 + NUDGE)
    cue.nudge("right")
    cue.nudge("right")
    assert cue.aim == pytest.approx(0.2 - NUDGE)


@pytest.mark.parametrize("speed", [1.0, 4.0, 10.0])
def test_the_tip_comes_forward_ever_faster_and_is_at_the_ball_once(speed):
    cue, dt = CueControl(0.0), 1e-3
    cue.strike(0.0, speed)
    whole = cue.gap
    reached, steps = False, 0
    while not reached:
        share = 1.0 - cue.gap / whole
        expected = cue.gap - dt * speed * max(math.sqrt(share), 0.25)
        reached = cue.advance(dt)
        steps += 1
        assert reached == (expected <= 0.0)
        assert reached or cue.gap == pytest.approx(expected, abs=1e-12)
    # a quarter of the speed for the first sixteenth of the way, then as its root: 2 (1 - 1/4) of the rest
    assert steps * dt == pytest.approx(whole / speed * (0.0625 / 0.25 + 2.0 * 0.75), rel=0.05, abs=2 * dt)
    assert (cue.phase, cue.gap, cue.speed) == (AIMING, REST_GAP, speed) and not cue.advance(dt)
