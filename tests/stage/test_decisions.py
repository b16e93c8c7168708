"""Decisions: what a player without a hand brings in, checked at the door, recorded, not asked for again."""

import math

import numpy as np
import pytest

from game.stage import Decision, ParameterError, Recording, Scene, Stage, replay_scene


class Chooser(Scene):
    """A number that its own player changes every tenth step."""

    name, task, title = "chooser", "X02", "Chooser"
    asked = 0

    def build(self, level):
        self.value = np.zeros(1)
        self.steps = 0
        self.last = -1

    def advance(self, dt):
        self.steps += 1

    def state(self):
        from typing import NamedTuple

        class State(NamedTuple):
            value: np.ndarray

        return State(self.value)

    def decisions(self, at_once=False):
        type(self).asked += 1
        type(self).at_once = at_once
        due = self.steps % 10 == 0 and self.steps != self.last
        return [Decision("add", (float(self.steps),))] if due else []

    def decide(self, event):
        if event.name != "add":
            raise ValueError(f"{event.name}: only add is known")
        self.value += event.values[0]
        self.last = self.steps


def played(steps: int) -> Stage:
    stage = Stage(Chooser)
    for _ in range(steps):
        stage.listen()
        stage.run(1)
    return stage


def test_decisions_act_and_are_replayed_without_asking(tmp_path):
    stage = played(40)
    assert stage.scene.value[0] == 60.0
    path = tmp_path / "r.json"
    stage.recording.save(path)
    asked = Chooser.asked
    again = replay_scene(Recording.load(path), Chooser)
    assert again.digest() == stage.digest() and Chooser.asked == asked


def test_a_run_without_a_window_lets_players_play_at_once():
    stage = Stage(Chooser)
    stage.run(40)
    assert stage.scene.value[0] == 0.0
    stage = Stage(Chooser)
    stage.run(40, players=True)
    assert Chooser.at_once and stage.digest() == played(40).digest() and not Chooser.at_once
    assert replay_scene(stage.recording, Chooser).digest() == stage.digest()


def test_nobody_is_asked_while_it_stands_or_repeats():
    stage = played(40)
    end = stage.digest()
    for _ in range(25):
        stage.step_back()
    asked = Chooser.asked
    stage.listen()  # paused
    stage.resume()
    while stage.step_number < 30:  # where the last remembered decision acts
        stage.listen()
        stage.run(1)
    assert Chooser.asked == asked
    while stage.step_number < 40:
        stage.listen()
        stage.run(1)
    assert stage.digest() == end


def test_what_cannot_be_is_refused_and_changes_nothing():
    stage = played(5)
    before = stage.digest()
    for event in (
        Decision("add", (math.inf,)),
        Decision("add", (1.0,) * 65),
        Decision("add", ("x",)),
        Decision("multiply", (2.0,)),
    ):
        with pytest.raises(ParameterError):
            stage.post(event)
    assert stage.digest() == before


def test_a_scene_without_players_takes_none():
    class Plain(Chooser):
        name = "plain"
        decisions = Scene.decisions
        decide = Scene.decide

    stage = Stage(Plain)
    stage.listen()
    with pytest.raises(ParameterError, match="takes no decisions"):
        stage.post(Decision("add", (1.0,)))
