"""Mistakes in a scene's definition: one line each that says what to write."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.definition import DefinitionError
from game.stage import Entry, Param, Parameters, Readout, Scene, Stage, Strip
from game.stage.opening.definition import check_strips


class Angle(NamedTuple):
    angle: np.ndarray


class Right(Scene):
    """A scene without a fault."""

    name, task, title = "right", "X", "Right"
    strips = (Strip("Angle", "rad", ("angle", "now and then"), sometimes=("now and then",)),)

    def build(self, level):
        self.angle = np.zeros(1)

    def advance(self, dt):
        self.angle += dt

    def state(self):
        return Angle(self.angle)

    def readouts(self):
        return [Readout("angle", float(self.angle[0]), "rad")]


def test_a_scene_without_a_fault_is_opened():
    stage = Stage(Right)
    assert stage.run(3) == 3 and stage.fault is None
    check_strips(stage.scene)  # nothing is raised


def test_what_each_scene_defines_is_named():
    class Empty(Scene):
        name = "empty"

        def advance(self, dt):
            pass

    with pytest.raises(DefinitionError, match=r"Empty: define build, state"):
        Empty()


def test_a_state_that_is_no_named_tuple():
    class Listed(Right):
        def state(self):
            return [self.angle]

    with pytest.raises(DefinitionError, match=r"Listed.state\(\) gives a list: a NamedTuple"):
        Stage(Listed)


def test_a_strip_of_what_is_not_measured():
    class Charted(Right):
        strips = (Strip("Energy", "J", ("enrgy",)),)

    with pytest.raises(DefinitionError, match=r"Charted.strips: 'Energy' charts 'enrgy'; readouts\(\) gives"):
        check_strips(Stage(Charted).scene)


def test_a_default_out_of_range_names_class_parameter_and_range():
    with pytest.raises(DefinitionError, match=r"Far.start: the default of start = 9.0: outside 0 to 1 m"):

        class Far(Scene):
            start = Param(9.0, 0.0, 1.0, unit="m")

    with pytest.raises(DefinitionError, match=r"Choices.start: the default of start = 9.0"):

        class Choices(Parameters):
            start = Param(9.0, 0.0, 1.0)


def test_a_parameter_that_hides_something_or_is_declared_twice():
    with pytest.raises(DefinitionError, match="cannot have this name"):

        class Hiding(Scene):
            level = Param(1.0, 0.0, 2.0)

    class Some(Parameters):
        speed = Param(1.0, 0.0, 2.0)

    with pytest.raises(DefinitionError, match=r"Twice.speed: Some declares it as well"):

        class Twice(Scene):
            parameters_type = Some
            speed = Param(1.0, 0.0, 2.0)


def test_a_row_that_names_a_card_that_is_not_there():
    row = Entry(
        "pendulum", "E1", "Pendulum", "", "", "game.scenes.examples.pendulum", "Pendulum", card="draw_nothing"
    )
    with pytest.raises(DefinitionError, match=r"examples.card has no 'draw_nothing'"):
        row.card_painter()


def test_the_length_of_a_step_is_declared_once():
    """By a parameter or by dt, never by both; dt then is the default of the parameter."""
    with pytest.raises(DefinitionError, match=r"Both.dt: the parameter step_length says it already"):

        class Both(Scene):
            dt = 0.01
            step_length = Param(0.01, 0.001, 0.1)

    class Steps(Parameters):
        step_length = Param(0.02, 0.001, 0.1)

    class One(Scene):
        parameters_type = Steps

    assert One.dt == 0.02 and Scene.dt != One.dt
