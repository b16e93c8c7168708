"""Computer players: what they decide comes in as events, so that a recording replays without them."""

import threading
import time

import msgspec
import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.players import opponents
from game.scenes.billiards.opponents.deciding import NEW_RACK_S
from game.scenes.billiards.opponents.thinking import decision_of, simple_stroke, think
from game.scenes.billiards.scene import Billiards
from game.scenes.shared.tables.choices import GRADES
from game.scenes.shared.thinker import Question, Thinker, Thought
from game.stage import Action, Decision, SetParameter, replay_scene
from tests.scenes.billiards.billiards_stages import check_balls, open_level, seconds, until_aiming


def simply(question: Question) -> Thought:
    """A player that needs no search."""
    if question.frame.game.options:
        return Thought((Decision("option", (0.0,)),))
    return Thought((decision_of(simple_stroke(question.frame, question.seed)),))


def thought_over(thinker: Thinker) -> None:
    """Wait until the question that was asked last is answered, however long the machine takes."""
    while thinker.thinking:
        time.sleep(0.001)


def play_on(stage, strokes: int) -> None:
    """Let computer players play so many strokes, as the window would: polling before each frame."""
    scene = stage.scene
    for _ in range(4000):
        if scene.model.frame.strokes >= strokes and scene.play.phase == "aiming":
            return
        stage.listen()
        thought_over(scene.opponents.thinker)
        if scene.play.phase == "rolling":
            stage.post(Action("strike"))
        stage.run(6)
    raise AssertionError("the players do not play")


def test_grades_are_those_of_the_search():
    assert tuple(opponents.GRADES) == GRADES


def test_a_recording_of_two_computer_players_replays_to_the_same_digest():
    stage = open_level("nine-ball")
    stage.scene.opponents.thinker = Thinker(simply, lambda: None)
    for name in ("first_player", "second_player"):
        stage.post(SetParameter(name, "club"))
    play_on(stage, 5)
    check_balls(stage)
    recording = msgspec.json.decode(msgspec.json.encode(stage.recording), type=type(stage.recording))
    assert sum(isinstance(stamped.event, Decision) for stamped in recording.events) >= 5
    again = replay_scene(recording, Billiards)
    assert again.digest() == stage.digest()
    assert not again.scene.opponents.thinker.thinking and again.scene.opponents.thinker.failure == ""


def test_stepping_back_over_a_stroke_does_not_ask_again():
    stage = open_level("nine-ball")
    asked = []
    stage.scene.opponents.thinker = Thinker(lambda q: asked.append(q.key) or simply(q), lambda: None)
    for name in ("first_player", "second_player"):
        stage.post(SetParameter(name, "club"))
    play_on(stage, 1)
    end, first = stage.digest(), asked[0]
    steps = stage.step_number
    for _ in range(40):
        stage.step_back()
    stage.resume()
    while stage.step_number < steps:
        if stage.scene.model.frame.strokes < 1:  # what comes after the stroke was not decided before
            stage.listen()
        stage.run(1)
    assert stage.digest() == end and asked.count(first) == 1


def test_frames_go_on_while_a_player_thinks_and_an_old_answer_is_forgotten():
    stage = open_level("nine-ball")
    gate = threading.Event()

    def slowly(question: Question) -> Thought:
        gate.wait()
        return simply(question)

    stage.scene.opponents.thinker = Thinker(slowly, lambda: None)
    stage.post(SetParameter("first_player", "club"))
    for _ in range(50):
        stage.listen()
        seconds(stage, 0.02)
    assert stage.scene.play.phase == "aiming" and stage.scene.opponents.thinker.thinking
    stage.post(SetParameter("first_player", "person"))
    stage.listen()
    gate.set()
    thought_over(stage.scene.opponents.thinker)
    assert not stage.scene.opponents.thinker.thinking
    for _ in range(20):
        stage.listen()
        seconds(stage, 0.02)
    assert stage.scene.play.phase == "aiming" and stage.scene.model.frame.strokes == 0


def test_without_a_window_time_stands_still_while_players_think():
    """Two runs are alike, whatever the machine does meanwhile, and replay without a thought."""
    digests, asked = [], []

    def slowly(question: Question) -> Thought:
        asked.append(threading.current_thread())
        assert question.patient
        time.sleep(0.01 * len(asked))
        return simply(question)

    for _ in range(2):
        stage = open_level("nine-ball")
        stage.scene.opponents.thinker = Thinker(slowly, lambda: None)
        for name in ("first_player", "second_player"):
            stage.post(SetParameter(name, "club"))
        assert stage.scene.plays_alone
        stage.run(round(25.0 / stage.dt), players=True)
        assert stage.scene.model.frame.strokes >= 2
        digests.append(stage.digest())
    assert digests[0] == digests[1] and set(asked) == {threading.current_thread()}
    count = len(asked)
    assert replay_scene(stage.recording, Billiards).digest() == digests[0] and len(asked) == count


def test_a_rack_of_two_computer_players_is_followed_by_the_next():
    stage = open_level("masters")
    scene = stage.scene
    scene.model.frame = scene.model.frame.replace(
        game=msgspec.structs.replace(scene.model.frame.game, winner=0, won=(1, 0))
    )
    seconds(stage, NEW_RACK_S + 0.1)
    assert (
        not scene.model.frame.game.over
        and scene.model.frame.game.opening
        and scene.model.frame.game.won == (1, 0)
    )


def test_a_player_that_fails_does_not_stop_the_game():
    stage = open_level("nine-ball")

    def failing(question: Question) -> Thought:
        raise RuntimeError("no idea")

    stage.scene.opponents.thinker = Thinker(failing, lambda: None)
    stage.post(SetParameter("first_player", "club"))
    play_on(stage, 1)
    assert "no idea" in stage.scene.opponents.thinker.failure
    check_balls(stage)


def test_what_is_thought_becomes_decisions(monkeypatch):
    stage = open_level("nine-ball")
    question = stage.scene.opponents.question._replace(grade="master")
    meant = Stroke(4.0, 1.5, 0.1, 0.1, -0.2)
    made = opponents.Decision("", (0.4, 0.4), meant, Call(3, 2), (), 0.5)
    monkeypatch.setattr(opponents, "decide", lambda *_, **__: made)
    white, stroke = think(question).decisions
    assert white == Decision("white", (0.4, 0.4))
    assert stroke.name == "stroke" and stroke.values[5:] == (3.0, 2.0, 0.0, 0.0)
    assert stroke.values[0] == pytest.approx(4.0, abs=0.5) and stroke.values[0] != 4.0  # the hand's noise
    for event in (white, stroke):
        stage.post(event)
    assert stage.scene.play.phase == "striking"
    until_aiming(stage)
    asked = question.frame.replace(game=with_options(question.frame.game))
    monkeypatch.setattr(opponents, "decide", lambda *_, **__: opponents.Decision("pass back"))
    assert think(question._replace(frame=asked)).decisions == (Decision("option", (1.0,)),)


def with_options(game):
    from game.billiards.game.games.rotation import PASS_BACK, PLAY

    return msgspec.structs.replace(game, options=(PLAY, PASS_BACK))


def test_it_plays_itself_the_same_way_each_time():
    digests = []
    for _ in range(2):
        stage = open_level()
        stage.post(Action("demo"))
        seconds(stage, 12.0)
        assert stage.scene.model.frame.strokes >= 1
        digests.append(stage.digest())
    assert digests[0] == digests[1]
    stage.post(Action("demo"))
    until_aiming(stage)
    check_balls(stage)
