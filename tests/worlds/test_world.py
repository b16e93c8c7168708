"""What a member keeps of itself, and what a world keeps of its own by one: arrays and tables, as copies."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.effects import EffectSet
from game.worlds.tables import NO_FLOATS, NO_LONGS, extended
from game.worlds.world import Kept, Member, World


class Row(NamedTuple):
    body: Longs = NO_LONGS
    mass: Floats = NO_FLOATS


class Things(Member):
    kept = ("table", "marks")

    def __init__(self) -> None:
        self.table = extended(Row(), [(3, 0.5), (7, 2.0)])
        self.marks: Floats = np.array([1.0, 2.0, 3.0])


class State(NamedTuple):
    table: Floats
    own: Floats
    marks: Floats


class Small(World):
    state_type = State

    def __init__(self) -> None:
        super().__init__(None, None, EffectSet())
        self.things, self.own = Things(), np.array([9.0])
        self.members = (Kept(self.things, "table"), Kept(self, "own"), Kept(self.things, "marks"))


def test_a_member_keeps_what_it_names_in_that_order() -> None:
    things = Things()
    table, marks = things.state()
    assert table.tolist() == [[3.0, 0.5], [7.0, 2.0]] and marks.tolist() == [1.0, 2.0, 3.0]
    kept = [one.copy() for one in (table, marks)]
    things.table = extended(things.table, [(8, 1.0)])
    things.marks[:] = 0.0
    things.restore(iter(kept))
    assert things.table.body.tolist() == [3, 7] and things.table.body.dtype == np.int64
    assert things.marks.tolist() == [1.0, 2.0, 3.0] and things.marks is not kept[1]


def test_a_world_keeps_its_own_arrays_between_those_of_its_members() -> None:
    world = Small()
    state: Any = world.state()
    assert state._fields == ("table", "own", "marks") and state.own.tolist() == [9.0]
    state = State(*(one.copy() for one in state))
    world.own, world.things.marks = np.zeros(4), np.zeros(0)
    world.restore(state)
    assert world.own.tolist() == [9.0] and world.things.marks.tolist() == [1.0, 2.0, 3.0]
    world.own[0] = 1.0
    assert state.own.tolist() == [9.0]


def test_a_member_that_names_nothing_keeps_nothing() -> None:
    fields = iter([np.zeros(1)])
    Member().restore(fields)
    assert Member().state() == () and next(fields).tolist() == [0.0]
