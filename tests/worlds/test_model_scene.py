"""What a scene of a model, a hand and a view asks of them by itself."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.scenes import CATALOGUE
from game.stage import Frame, Hearing, Pointer, Readout, Stage
from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectation, Expectations
from game.worlds.scene import ModelScene, Told

SEEN = View(left=-1.0, bottom=-2.0, right=3.0, top=4.0)


class SmallContent(LevelEntry, frozen=True, kw_only=True):
    view: View = SEEN
    expected: Expectations = (Expectation(readout="steps", value=2.0),)


class SmallState(NamedTuple):
    steps: np.ndarray


class SmallModel:
    def __init__(self, content):
        self.content, self.steps, self.changed = content, np.zeros(1), []

    def advance(self, dt):
        self.steps += 1.0
        return "Two." if self.steps[0] == 2.0 else ""

    def state(self):
        return SmallState(self.steps)

    def restore(self, state):
        self.steps = state.steps.copy()

    def change_effects(self, active):
        self.changed.append(active)

    def change_parameter(self, name):
        self.changed.append(name)


class Small(ModelScene):
    name, task, title = "small", "T", "Small"
    content_type = SmallContent
    default_content = SmallContent()
    not_of_model = ("colour",)
    told = Told(
        lambda model: [Readout("steps", float(model.steps[0]))],
        lambda model: model.content,
        lambda model: {"here": (1.0, 2.0)},
        lambda model: Hearing("small", 0.5, ()),
        lambda model: [((1.0, 2.0), "here")],
        lambda model: {"here": 3.0},
    )

    def make(self, content):
        self.model = SmallModel(content)


class Mute(Small):
    name = "mute"
    told = Small.told._replace(hearing=Told().hearing)


def test_what_is_told_is_asked_of_the_model():
    scene = Small()
    scene.advance(0.1)
    assert [(one.name, one.value) for one in scene.readouts()] == [("steps", 1.0)]
    assert scene.save_content() is scene.default_content
    assert scene.story_targets() == {"here": (1.0, 2.0)} and scene.story_sizes() == {"here": 3.0}
    assert scene.story_names() == [((1.0, 2.0), "here")] and scene.hearing() == Hearing("small", 0.5, ())
    assert scene.frame() == Frame(-1.0, -2.0, 3.0, 4.0) and scene.legend() == ()


def test_the_model_steps_is_restored_and_says_what_there_is_to_say():
    scene = Small()
    before = SmallState(scene.state().steps.copy())
    scene.advance(0.1)
    scene.advance(0.1)
    assert scene.messages() == ("Two.",) and scene.messages() == ()
    assert scene.state().steps[0] == 2.0
    scene.restore(before)
    assert scene.state().steps[0] == 0.0
    scene.pointer(Pointer("down", 0.0, 0.0, button=1))  # there is no hand
    for name in ("colour", "mass"):
        scene.parameter_changed(name)
    scene.effects_changed()
    assert scene.model.changed == ["mass", scene.active]


def test_captions_wait_for_a_step_unless_they_are_measured_at_once(monkeypatch):
    scene = Small()
    assert "not measured yet" in scene.captions()[0].words
    monkeypatch.setattr(Small, "at_once", True)
    assert "measured 0" in scene.captions()[0].words and not scene.captions()[0].met
    scene.advance(0.1)
    scene.advance(0.1)
    assert scene.captions()[0].met


def test_a_level_that_expects_an_unknown_readout_is_refused(monkeypatch):
    wrong = SmallContent(expected=(Expectation(readout="leaps", value=1.0),))
    monkeypatch.setattr(Small, "default_content", wrong)
    with pytest.raises(ValueError, match="no readout 'leaps'; there are steps"):
        Small()


@pytest.mark.parametrize(("scene_type", "heard"), [(Small, True), (Mute, False)])
def test_a_scene_is_heard_if_it_tells_of_sounds(scene_type, heard):
    assert scene_type.is_heard() is heard


@pytest.mark.parametrize(
    ("name", "heard"),
    [("c13", True), ("c12", False), ("p22", True), ("a09", True), ("tracks", False), ("pendulum", False)],
)
def test_scenes_of_the_catalogue_that_are_heard(name, heard):
    assert CATALOGUE[name].load().is_heard() is heard


def test_a_scene_that_is_only_watched_takes_no_hand():
    stage = Stage(CATALOGUE["p22"].load())
    assert stage.scene.hand is None and stage.scene.view is None
