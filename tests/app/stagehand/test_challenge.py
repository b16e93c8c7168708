"""The challenge of the day: its level, one's best stroke as a text, and somebody else's beside it."""

from __future__ import annotations

import json

import pytest

from game.app.stagehand.challenge import (
    ChallengeKeeper,
    best_of,
    day_of,
    words_of,
    write_challenge,
)
from game.app.stagehand.opening import Opening
from game.billiards.game.rules import Call
from game.billiards.players.daily import challenge_of
from game.scenes.billiards.opponents.thinking import decision_of
from game.scenes.billiards.scene import Billiards
from game.stage import Action

DAY = "2026-11-23"


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    return tmp_path


@pytest.fixture
def stage():
    made = Opening(level=write_challenge(DAY)).make_stage(Billiards)
    made.run(2)
    return made


def settled(stage):
    """The stroke is over."""
    stage.run(30)
    for _ in range(400):
        if stage.scene.course.phase == "aiming":
            return stage
        stage.run(10)
    raise AssertionError("the shot does not end")


def play(stage, keeper, decisions, guest=False):
    """A stroke, and what it is answered with."""
    keeper.update(stage, guest)
    for decision in decisions:
        stage.post(decision)
    stage.run(5)
    assert keeper.update(stage, guest) is None  # the balls roll
    return keeper.update(settled(stage), guest)


def own(worse=0.0):
    """The solution of the day, and strokes that are not as good."""
    stroke = challenge_of(DAY).stroke
    return [decision_of(stroke._replace(cue_speed=stroke.cue_speed + worse), Call())]


def test_the_level_is_written_once_and_is_that_of_the_day(stage, home):
    found = challenge_of(DAY)
    assert day_of(stage) == DAY and stage.level.path.parent == home / "challenges"
    assert [(b.number, *b.position) for b in stage.level.content.balls] == list(found.balls)
    assert stage.scene.model.frame.layout.places == found.balls
    before = stage.level.path.stat().st_mtime_ns
    assert write_challenge(DAY) == stage.level.path and stage.level.path.stat().st_mtime_ns == before
    assert best_of(DAY) is None and stage.scene.scored.par == pytest.approx(found.par)


def test_the_best_is_kept_and_no_worse_one_after_it(stage, home):
    keeper, par = ChallengeKeeper(), challenge_of(DAY).par
    answer = play(stage, keeper, own())
    assert answer.cause == f"{words_of(par)} from the middle; par is {words_of(par)}."
    assert "Your best of the day" in answer.consequence and answer.complaint == ""
    best = best_of(DAY)
    assert best.distance == pytest.approx(par) and best.text.startswith("stroke1.billiards.")
    answer = play(stage, keeper, own(0.02))
    assert best_of(DAY) == best
    assert keeper.update(stage, False) is None  # each stroke is answered once
    missed = play(stage, keeper, own(-0.6))
    assert "is to go down" in missed.cause and best_of(DAY) == best
    assert json.loads((home / "challenges.json").read_text())["format"] == 1


def test_somebody_elses_stroke_is_replayed_after_any_tries_and_compared(stage):
    play(stage, ChallengeKeeper(), own())
    text = best_of(DAY).text
    other, keeper = Opening(level=write_challenge(DAY)).make_stage(Billiards), ChallengeKeeper()
    other.run(2)
    play(other, keeper, own(-0.6))  # tries before it do not matter
    play(other, keeper, own(0.05))
    kept = best_of(DAY)
    answer = play(other, keeper, other.scene.take_text(text), guest=True)
    assert other.scene.scored.distance == stage.scene.scored.distance
    assert words_of(challenge_of(DAY).par) in answer.cause and "equally near" in answer.consequence
    assert best_of(DAY) == kept
    assert other.scene.given_text() == text


def test_a_file_that_cannot_be_read_is_left_alone(stage, home):
    (home / "challenges.json").write_text('{"format": 9, "days": {}}')
    assert best_of(DAY) is None
    answer = play(stage, ChallengeKeeper(), own())
    assert "nothing is written over it" in answer.complaint
    assert (home / "challenges.json").read_text() == '{"format": 9, "days": {}}'


def test_other_levels_are_no_challenge():
    made = Opening().make_stage(Billiards)
    made.run(2)
    assert day_of(made) == "" and ChallengeKeeper().update(made, False) is None


@pytest.mark.parametrize(("mine", "theirs", "said"), [
    (0.0, 0.02, "you are nearer"), (0.02, 0.0, "the other is nearer"),
])  # fmt: skip
def test_who_is_nearer_is_said_of_both_strokes(stage, mine, theirs, said):
    elsewhere = Opening(level=write_challenge(DAY)).make_stage(Billiards)
    elsewhere.run(2)
    for decision in own(theirs):
        elsewhere.post(decision)
    text = settled(elsewhere).scene.given_text()
    keeper = ChallengeKeeper()
    play(stage, keeper, own(mine))
    answer = play(stage, keeper, stage.scene.take_text(text), guest=True)
    assert answer.consequence == f"Yours: {words_of(best_of(DAY).distance)}; {said}."


def test_a_stroke_that_is_taken_back_is_not_answered(stage):
    keeper = ChallengeKeeper()
    assert play(stage, keeper, own()) is not None
    stage.post(Action("undo"))
    stage.run(3)
    assert stage.scene.scored.strokes == 0
    assert keeper.update(stage, False) is None
