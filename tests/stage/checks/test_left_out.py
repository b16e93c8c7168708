"""What a state leaves out is found by name, and nothing else is."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.stage import Part, Scene
from game.stage.checks.left_out import _fields, fields_left_out

DT = 0.01


class Halves(NamedTuple):
    """places (2,) m."""

    places: np.ndarray


class Model(Part):
    """Two beads that move; scratch is written and read within each step."""

    def __init__(self) -> None:
        self.places, self.rates = np.zeros(2), np.array([1.0, -2.0])
        self.scratch = np.zeros(2)
        self.pushes = 0  # a plain attribute of a part: remembered

    def advance(self, dt: float) -> None:
        self.scratch[:] = dt * self.rates
        self.places += self.scratch
        self.rates *= 0.9
        self.pushes += 1
        self.places[0] += self.pushes


class Engine:
    """No part: the stage does not remember what it counts."""

    def __init__(self) -> None:
        self.turns = 0


class Beads(Scene):
    """A scene whose state lacks the rates."""

    name, title = "beads", "Beads"

    def build(self, level) -> None:
        self.model = Model()

    def advance(self, dt: float) -> None:
        self.model.advance(dt)

    def state(self) -> NamedTuple:
        return Halves(self.model.places)


class WholeState(NamedTuple):
    """places and rates (2,)."""

    places: np.ndarray
    rates: np.ndarray


class Whole(Beads):
    """The same with all of its state."""

    def state(self) -> NamedTuple:
        return WholeState(self.model.places, self.model.rates)


class Driven(Whole):
    """Steps depend on a number of an object that is no part."""

    def build(self, level) -> None:
        super().build(level)
        self.engine = Engine()

    def advance(self, dt: float) -> None:
        self.engine.turns += 1
        self.model.rates[1] += self.engine.turns
        super().advance(dt)


class Geared(Whole):
    """Steps depend on a number that lies four objects deep."""

    def build(self, level) -> None:
        super().build(level)
        self.first = Engine()
        self.first.second = Engine()
        self.first.second.third = Engine()
        self.first.second.third.fourth = Engine()

    def advance(self, dt: float) -> None:
        last = self.first.second.third.fourth
        last.turns += 1
        self.model.rates[1] += last.turns
        super().advance(dt)


@pytest.mark.parametrize(
    ("scene_type", "names"),
    [
        (Beads, ["model.rates"]),
        (Whole, []),
        (Driven, ["engine.turns"]),
        (Geared, ["first.second.third.fourth.turns"]),
    ],
)
def test_the_field_is_named(scene_type: type[Scene], names: list[str]) -> None:
    assert fields_left_out(scene_type(), DT) == names


class Inner:
    """Numbers in an object of one's own."""

    def __init__(self, inner=None):
        self.rate = 1.0
        self.inner = inner


def test_fields_are_named_by_their_way_through_objects_of_ones_own():
    """And not those of what Python itself is made of, such as an error that is kept."""
    outer = Inner(Inner(np.zeros(2)))
    outer.error = ValueError()
    outer.error.noted = 2.0
    found = {name: (owner, attribute) for name, owner, attribute in _fields(outer)}
    assert set(found) == {"rate", "inner.rate", "inner.inner"}
    assert found["inner.rate"] == (outer.inner, "rate") and found["rate"] == (outer, "rate")


def test_fields_are_looked_for_to_a_depth_and_no_farther():
    chain = Inner()
    for _ in range(8):
        chain = Inner(chain)
    assert {name for name, _, _ in _fields(chain)} == {"inner." * deep + "rate" for deep in range(5)}
