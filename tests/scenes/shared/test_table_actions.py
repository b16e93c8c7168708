"""What cue tables share: keys that take options, and when a stroke is heard."""

import numpy as np
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.scenes.carom.scene import CaromScene
from game.scenes.shared.tables import actions
from game.scenes.snooker.scene import SnookerScene


@pytest.mark.parametrize("count", [2, 3, 4])
def test_key_n_takes_option_n(count):
    made = [(one.name, one.key) for one in actions.options(count)]
    assert made == list(zip(actions.OPTIONS, "1234", strict=True))[:count]


@pytest.mark.parametrize(("kind", "given"), [(SnookerScene, (Call(),)), (CaromScene, ())])
def test_a_stroke_is_heard_while_it_rolls_and_not_before(kind, given):
    scene = kind()
    assert scene.hearing() is None
    scene.course.begin_stroke(Stroke(2.0, 0.5 * np.pi), *given)
    assert scene.hearing() is None  # the cue swings
    while scene.course.phase != "rolling":
        scene.advance(0.02)
    heard = scene.hearing()
    assert heard is not None and heard.sounds[0].kind == "tip"
    scene.course.skip()
    assert scene.hearing() is None
