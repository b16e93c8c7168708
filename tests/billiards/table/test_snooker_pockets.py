"""What the pockets of the snooker table take: how far a ball may be off, measured with exact strokes."""

import math

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.snooker.frame import new_snooker_frame
from game.billiards.table.snooker import BLACK
from tests.billiards.game.snooker.referee import order

OFF = np.linspace(-0.05, 0.05, 41)  # m, aside of the middle of the opening
DISTANCE = 0.8  # m, of the ball from there


def taken(corner: bool, speed: float, aslant: float) -> float:
    """Width m of the strip, at the opening, in which a ball falls. aslant rad from straight into the
    pocket.
    """
    opening = np.array((0.0, 0.0 if corner else 0.5 * 3.569))
    angle = (0.25 * math.pi if corner else 0.0) + aslant
    along = np.array((math.cos(angle), math.sin(angle)))
    ball, down = opening + DISTANCE * along, 0
    for off in OFF:
        at = opening + off * np.array((-along[1], along[0]))
        course = (at - ball) / np.hypot(*(at - ball))
        cue = ball - 0.12 * course
        frame = new_snooker_frame(order(BLACK), {0: tuple(cue), BLACK: tuple(ball)})
        played = frame.play(Stroke(speed, math.atan2(course[1], course[0])))
        down += BLACK in played.summary.balls_down
    return down * float(OFF[1] - OFF[0])


@pytest.mark.parametrize(("corner", "least", "most"), [(True, 0.042, 0.062), (False, 0.055, 0.072)])
def test_a_ball_may_brush_the_jaws_but_not_much(corner, least, most):
    width = taken(corner, 1.0, 0.0)
    assert least < width < most


@pytest.mark.parametrize("corner", [True, False])
def test_fast_and_aslant_the_pocket_is_narrower(corner):
    straight = taken(corner, 1.0, 0.0)
    assert taken(corner, 1.0, 0.55) < straight - 0.008
    assert taken(corner, 3.0, 0.55) < straight - 0.008
