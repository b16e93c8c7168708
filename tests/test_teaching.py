"""The section [teaching] of level files: read strictly, written back, answers judged."""

from __future__ import annotations

from pathlib import Path

import pytest

from game.level_checks import LevelError
from game.levels import format_level, parse_level, save_level
from game.stage import (
    Action,
    Param,
    ParameterError,
    Pointer,
    Scene,
    SceneAction,
    SetEffect,
    SetParameter,
    Stage,
)
from game.stage.records.run_text import recording_in, text_of
from game.stage.replaying import replay_scene
from game.teaching import ChoiceQuestion, GoalQuestion, NumberQuestion, read_number
from tests.stage.example_scene import GRAVITY, BouncingBall

HEAD = 'scene = "example"\n[parameters]\ngravity = 5.0\n'
LOCKS = '[teaching]\ntask = "Fall."\nlocked = ["gravity"]\nlocked_effects = ["test-gravity"]\n'
LOCKS += 'hidden_parameters = ["restitution"]\n'


def level_of(teaching: str, head: str = HEAD):
    return parse_level(head + teaching, "example", None, Path("task.toml"))


def asked(question: str) -> str:
    return f'[teaching]\ntask = "Fall."\n[[teaching.questions]]\n{question}'


ERRORS = [
    ("[teaching]\n", "teaching.task: missing"),
    ('[teaching]\ntask = ""\n', "teaching.task: expected"),
    ('[teaching]\ntask = "a"\nlock = []\n', "teaching.lock: unknown key"),
    ('[teaching]\ntask = "a"\nlocked = "gravity"\n', "teaching.locked: expected"),
    ('[teaching]\ntask = "a"\nhidden = ["sky"]\n', "teaching.hidden[0]: "),
    (asked('ask = "How?"\n'), "teaching.questions[0].kind: missing"),
    (asked('kind = "riddle"\nask = "How?"\n'), "teaching.questions[0].kind: "),
    (
        asked('kind = "number"\nask = "How?"\nvalue = 1.0\n'),
        "questions[0]: expected either tolerance or percent",
    ),
    (
        asked('kind = "number"\nask = "How?"\npercent = 5.0\n'),
        "questions[0]: expected either readout or value",
    ),
    (
        asked('kind = "number"\nask = "How?"\nvalue = 1\npercent = 5\ntolerance = 1\n'),
        "either tolerance or percent",
    ),
    (
        asked('kind = "number"\nask = "How?"\nvalue = 1\ntolerance = -1.0\n'),
        "questions[0].tolerance: expected",
    ),
    (
        asked('kind = "number"\nask = "How?"\nvalue = 0.0\npercent = 5.0\n'),
        "questions[0].percent: of 0 is nothing",
    ),
    (
        asked('kind = "number"\nask = "How?"\nvalue = nan\npercent = 5.0\n'),
        "questions[0].value: expected a finite",
    ),
    (
        asked('kind = "choice"\nask = "Which?"\noptions = ["a"]\nright = 1\n'),
        "questions[0].options: expected",
    ),
    (
        asked('kind = "choice"\nask = "Which?"\noptions = ["a", "b"]\nright = 3\n'),
        "right: 3: there are 2 options",
    ),
    (asked('kind = "choice"\nask = "Which?"\noptions = ["a", "b"]\n'), "expected either right or readouts"),
    (
        asked('kind = "choice"\nask = "Which?"\noptions = ["a", "b"]\nreadouts = ["x", "y", "z"]\n'),
        "readouts: expected one for each of 2",
    ),
    (asked('kind = "goal"\nask = "Go."\nreadout = "height"\n'), "questions[0]: expected least or most"),
    (
        asked('kind = "goal"\nask = "Go."\nreadout = "height"\nleast = 2\nmost = 1\n'),
        "least: 2 is above most, 1",
    ),
    (
        asked('kind = "goal"\nask = "Go."\nreadout = "height"\nleast = inf\n'),
        "least: expected a finite number",
    ),
]


@pytest.mark.parametrize(("text", "words"), ERRORS)
def test_what_is_wrong_is_told_with_file_field_and_reason(text, words):
    with pytest.raises(LevelError) as caught:
        level_of(text)
    message = str(caught.value)
    assert message.startswith("task.toml: teaching") and words in message and "\n" not in message


NAMES = [
    (
        '[teaching]\ntask = "a"\nlocked = ["wind"]\n',
        "teaching.locked[0]: no parameter 'wind'; there are gravity",
    ),
    ('[teaching]\ntask = "a"\nhidden_parameters = ["wind"]\n', "teaching.hidden_parameters[0]: no parameter"),
    ('[teaching]\ntask = "a"\nlocked_effects = ["wind"]\n', "teaching.locked_effects[0]: no effect 'wind'"),
    (
        '[teaching]\ntask = "a"\nhidden_readouts = ["x"]\n',
        "hidden_readouts[0]: no readout 'x'; there are energy",
    ),
    (
        asked('kind = "goal"\nask = "Go."\nreadout = "speed"\nleast = 1\n'),
        "questions[0].readout: no readout 'speed'",
    ),
    (
        asked('kind = "choice"\nask = "?"\noptions = ["a", "b"]\nreadouts = ["height", "y"]\n'),
        "teaching.questions[0].readouts[1]: no readout 'y'",
    ),
]


@pytest.mark.parametrize(("text", "words"), NAMES)
def test_names_that_the_scene_does_not_know_are_told_when_it_is_built(text, words):
    with pytest.raises(LevelError) as caught:
        Stage(BouncingBall, level=level_of(text))
    assert str(caught.value).startswith("task.toml: teaching") and words in str(caught.value)


def test_the_section_is_written_as_it_was_read(tmp_path):
    question = 'kind = "number"\nask = "How high?"\nreadout = "height"\nunit = "m"\ntolerance = 0.5\n'
    more = '[[teaching.questions]]\nkind = "goal"\nask = "Go."\nreadout = "height"\nleast = 0.0\n'
    level = level_of(LOCKS + "[[teaching.questions]]\n" + question + more)
    save_level(level, tmp_path / "a.toml")
    again = parse_level((tmp_path / "a.toml").read_text(), "example", None)
    assert again.teaching == level.teaching and again.teaching.questions[1].least == 0.0
    assert again.teaching.fixed == {"gravity", "restitution"}


# -- answers --------------------------------------------------------------------------------------


def test_a_number_is_right_within_its_tolerance_of_the_readout_now():
    question = NumberQuestion(ask="?", readout="height", tolerance=0.25)
    for answer, right in (("2.25", True), ("1,75", True), ("2.2501", False), ("", False), ("two", False)):
        assert question.is_right(answer, {"height": 2.0}) is right
    assert not question.is_right("2.0", {}) and not question.is_right("nan", {"height": 2.0})
    shares = NumberQuestion(ask="?", value=-200.0, percent=5.0)
    assert shares.is_right("\u2212190", {}) and not shares.is_right("-189", {})


def test_a_choice_by_readouts_is_the_largest_or_the_smallest_now():
    most = ChoiceQuestion(ask="?", options=["a", "b"], readouts=["x", "y"])
    least = ChoiceQuestion(ask="?", options=["a", "b"], readouts=["x", "y"], most=False)
    assert most.is_right("2", {"x": 1.0, "y": 2.0}) and not most.is_right("1", {"x": 1.0, "y": 2.0})
    assert least.is_right("1", {"x": 1.0, "y": 2.0}) and not least.is_right("", {"x": 1.0, "y": 2.0})
    assert not most.is_right("0", {"x": 1.0}) and most.expected({"x": 1.0}) == 0


def test_a_goal_is_reached_between_its_ends():
    goal = GoalQuestion(ask="?", readout="x", least=1.0, most=2.0)
    assert [goal.is_right("", {"x": x}) for x in (0.9, 1.0, 2.0, 2.1)] == [False, True, True, False]
    assert not goal.is_right("", {}) and GoalQuestion(ask="?", readout="x", most=2.0).is_right(
        "", {"x": -9.0}
    )


@pytest.mark.parametrize(("text", "number"), [(" 1,5 ", 1.5), ("1e3", 1000.0), ("\u22122", -2.0)])
def test_numbers_are_read_as_people_type_them(text, number):
    assert read_number(text) == number


# -- locks ----------------------------------------------------------------------------------------

REFUSED = [SetParameter("gravity", 1.0), SetParameter("restitution", 0.1), SetEffect("test-gravity", False)]


@pytest.mark.parametrize("event", REFUSED, ids=str)
def test_no_event_changes_what_is_locked_and_nothing_is_recorded(event):
    stage = Stage(BouncingBall, level=level_of(LOCKS))
    stage.run(10)
    digest = stage.digest()
    with pytest.raises(ParameterError, match="locked by this level"):
        stage.post(event)
    assert stage.digest() == digest and not stage.recording.events and stage.scene.values["gravity"] == 5.0


def test_what_is_not_locked_is_free():
    stage = Stage(BouncingBall, level=level_of(LOCKS))
    stage.post(SetParameter("height", 2.0))
    stage.post(SetEffect("test-ground", False))
    assert stage.scene.values["height"] == 2.0 and GRAVITY in stage.scene.active


@pytest.mark.parametrize(
    "options",
    [
        {"parameters": {"gravity": 1.0}},
        {"effects_off": ["test-gravity"]},
        {"parameters": {"restitution": 0.0}},
    ],
    ids=str,
)
def test_a_scene_is_not_begun_with_anything_locked_set_otherwise(options):
    with pytest.raises(ParameterError, match="locked by the level"):
        Stage(BouncingBall, level=level_of(LOCKS), **options)
    Stage(BouncingBall, level=level_of(LOCKS), parameters={"gravity": 5.0, "restitution": 0.8})


def changed_text(change) -> str:
    """A run as text in which somebody has changed something."""
    stage = Stage(BouncingBall, level=level_of(LOCKS))
    stage.run(20)
    stage.post(SetParameter("height", 2.0))
    stage.run(20)
    return text_of(change(stage.recording))


@pytest.mark.parametrize("forged", ["event", "start"])
def test_a_run_as_text_cannot_change_what_is_locked(forged):
    import msgspec

    def change(recording):
        if forged == "start":
            values = {**recording.parameters, "gravity": 1.0}
            return msgspec.structs.replace(recording, parameters=values)
        events = [
            msgspec.structs.replace(one, event=SetParameter("gravity", 1.0)) for one in recording.events
        ]
        return msgspec.structs.replace(recording, events=events)

    replay_scene(recording_in(changed_text(lambda recording: recording)), BouncingBall)  # as it was, it goes
    with pytest.raises(ValueError, match="locked"):
        replay_scene(recording_in(changed_text(change)), BouncingBall)


class Restless(BouncingBall):
    """A scene whose hand and keys set parameters by themselves."""

    name = "example"
    wind = Param(0.0, -1.0, 1.0)
    actions = (SceneAction("turn", "Turn", "t"),)

    def pointer(self, event):
        super().pointer(event)
        self.gravity = 7.0

    def action(self, name):
        self.restitution = 0.1


@pytest.mark.parametrize("event", [Pointer("down", 0.0, 1.0, 1), Action("turn")], ids=str)
def test_hands_and_keys_of_a_scene_cannot_change_what_is_locked(event):
    free = Stage(Restless, level=level_of(""))
    free.post(event)
    stage = Stage(Restless, level=level_of(LOCKS))
    stage.run(5)
    digest = stage.digest()
    with pytest.raises(ParameterError, match="locked by this level"):
        stage.post(event)
    assert stage.digest() == digest and stage.scene.values["gravity"] == 5.0
    assert stage.scene.values["restitution"] == 0.8 and not stage.scene.held
    assert issubclass(Restless, Scene)


def test_the_text_of_a_level_says_the_locks():
    assert "locked = [" in format_level(level_of(LOCKS))
