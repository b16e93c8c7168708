"""What a session stands on after it went back, or went on from another: state, picture, time."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.stage import Param, Scene, SetParameter, Stage
from game.stage.session import Session
from tests.stage.example_scene import BouncingBall


def session_of(scene: type[Scene]) -> Session:
    return Stage(scene)._session


class Grown(NamedTuple):
    """numbers: (n,)."""

    numbers: np.ndarray


class Growing(Scene):
    """A state that has one number more after each ten steps."""

    name, task, title = "growing", "X04", "Growing"

    def build(self, level):
        self.steps = 0
        self.grown = Grown(np.zeros(1))

    def advance(self, dt):
        self.grown = Grown(
            np.zeros(len(self.grown.numbers) + (self.grown.numbers[0] % 10 == 9)) + self.grown.numbers[0] + 1
        )

    def state(self):
        return self.grown

    def restore(self, state):
        self.grown = state


@pytest.mark.parametrize("step", [60, 30, 0])
def test_the_picture_never_starts_from_a_state_of_another_shape(step):
    """A step that was kept is not stepped to: there is no state before it to start from."""
    session = session_of(Growing)
    for _ in range(75):
        session.advance()
        session.keep_previous()
    session.return_to(step)
    assert session.scene.previous.numbers.shape == session.scene.state().numbers.shape == (1 + step // 10,)


@pytest.mark.parametrize("step", [69, 61, 45, 31, 1])
def test_after_a_step_back_the_picture_starts_from_the_step_before_that(step):
    """`previous` is the state one step earlier, as it is after a step forward."""
    session, states = session_of(BouncingBall), []
    for _ in range(70):
        states.append([part.copy() for part in session.scene.state()])
        session.advance()
    session.return_to(step)
    for found, then in ((session.scene.state(), states[step]), (session.scene.previous, states[step - 1])):
        assert all(np.array_equal(one, other) for one, other in zip(found, then, strict=True))


def test_a_session_that_goes_on_from_another_holds_that_state_and_nothing_before_it():
    source, other = session_of(BouncingBall), session_of(BouncingBall)
    for _ in range(100):
        source.advance()
    for _ in range(50):
        other.advance()
    base, events = source.kept(95)
    assert base.step == 90 and events == ()
    other.resume(base, events)
    assert (other.step, other.first_step, other._ring.last_step) == (90, 90, 90)
    for now, then in zip(other.scene.previous, base.state, strict=True):
        assert np.array_equal(now, then)
    while other.step < 100:
        other.advance()
    assert other.digest() == source.digest() and other.time_s == source.time_s
    assert not other.go_back() or other.step == 99
    assert source.kept(-5)[0].step == 0


class SteppedBall(BouncingBall):
    """One may choose how long its steps are."""

    name, task, title = "stepped", "X00", "Stepped ball"
    step_length = Param(1.0 / 128.0, 1e-3, 0.1, unit="s", label="Time step")


def test_time_goes_on_from_where_the_length_of_a_step_was_changed():
    stage = Stage(SteppedBall)
    stage.run(10)
    stage.post(SetParameter("step_length", 1.0 / 64.0))
    stage.run(4)
    assert stage.dt == 1.0 / 64.0 and stage._session.time_s == (10 + 8) / 128.0
    for step in (13, 12, 11, 10):
        stage.step_back()
        assert (stage.step_number, stage._session.time_s) == (step, (10 + 2 * (step - 10)) / 128.0)
    stage.step_back()
    assert stage.dt == 1.0 / 128.0 and stage._session.time_s == 9 / 128.0
