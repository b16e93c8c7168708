"""Copying, weighing, digesting and watching states; what a scene remembers beside them; charts."""

from __future__ import annotations

import enum
from collections import deque
from typing import NamedTuple

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from game.stage import Readout, StripSeries
from game.stage.states.memory import recall, remember
from game.stage.states.state import copy_state, digest_of, same_shapes, state_bytes
from game.stage.watch import FiniteWatch


class Inner(NamedTuple):
    """A part."""

    time: float
    flags: np.ndarray


class State(NamedTuple):
    """A state of all kinds of things."""

    points: np.ndarray
    singles: np.ndarray
    inner: Inner
    name: str
    count: int


def make() -> State:
    return State(
        np.arange(6.0).reshape(3, 2), np.ones(3, np.float32), Inner(0.5, np.array([True, False])), "a", 3
    )


CHANGES = {
    "a bit": lambda s: s.points.__setitem__((1, 1), np.nextafter(s.points[1, 1], 9.0)),
    "a sign of zero": lambda s: s.points.__setitem__((0, 0), -0.0),
    "a flag": lambda s: s.inner.flags.__setitem__(0, False),
    "shape": lambda s: s._replace(points=s.points.reshape(2, 3)),
    "type": lambda s: s._replace(singles=s.singles.astype(np.float64)),
    "time": lambda s: s._replace(inner=s.inner._replace(time=0.5000000000000001)),
    "name": lambda s: s._replace(name="b"),
    "count": lambda s: s._replace(count=4),
    "kind of number": lambda s: s._replace(count=3.0),
}


class TestDigest:
    def test_equal_states_have_equal_digests(self) -> None:
        assert digest_of(make(), 5) == digest_of(make(), 5) == digest_of(copy_state(make()), 5)

    def test_the_step_number_belongs_to_it(self) -> None:
        assert digest_of(make(), 5) != digest_of(make(), 6)

    @pytest.mark.parametrize("change", list(CHANGES))
    def test_any_difference_shows(self, change: str) -> None:
        state = make()
        state = CHANGES[change](state) or state
        assert digest_of(state, 0) != digest_of(make(), 0)

    def test_memory_order_does_not_count(self) -> None:
        state = make()
        assert digest_of(state._replace(points=np.asfortranarray(state.points)), 0) == digest_of(state, 0)

    @pytest.mark.parametrize("value", [[1.0], {"a": 1}, object(), np.array([None])])
    def test_what_has_no_bytes_is_refused(self, value) -> None:
        with pytest.raises(TypeError, match="state name"):
            digest_of(make()._replace(name=value), 0)


class TestCopies:
    def test_a_copy_shares_nothing(self) -> None:
        state = make()
        copy = copy_state(state)
        state.points[:] = 9.0
        state.inner.flags[:] = False
        assert digest_of(copy, 0) == digest_of(make(), 0)

    def test_memory_is_used_again_where_it_fits(self) -> None:
        state = make()
        old = copy_state(state)
        new = copy_state(state._replace(singles=np.ones(4, np.float32)), old)
        assert new.points is old.points
        assert new.inner.flags is old.inner.flags
        assert new.singles.shape == (4,)

    def test_shapes(self) -> None:
        state = make()
        assert same_shapes(state, copy_state(state))
        assert not same_shapes(state, None)
        assert not same_shapes(state, state._replace(points=np.zeros((4, 2))))
        assert not same_shapes(state, state._replace(inner=Inner(0.5, np.zeros(3, dtype=bool))))

    def test_weight(self) -> None:
        assert state_bytes(State(np.zeros((1000, 2)), np.zeros(0), Inner(0.0, np.zeros(0)), "", 0)) > 16_000


ARRAYS = hnp.arrays(
    st.sampled_from([np.float64, np.float32]),
    hnp.array_shapes(max_dims=3, max_side=9, min_side=0),
    elements=st.floats(width=32, allow_subnormal=True),
)


class TestWatch:
    @given(ARRAYS, st.booleans())
    def test_it_agrees_with_numpy(self, array: np.ndarray, strided: bool) -> None:
        view = array[::2] if strided else array
        watch = FiniteWatch()
        state = make()._replace(points=view)
        expected = None if np.isfinite(view).all() else "points"
        assert watch.first_bad(state) == expected
        assert watch.first_bad(state) == expected

    @given(st.integers(0, 5), st.sampled_from([np.nan, -np.nan, np.inf, -np.inf]))
    def test_it_sees_a_change_in_an_array_it_knows(self, index: int, value: float) -> None:
        watch, state = FiniteWatch(), make()
        assert watch.first_bad(state) is None
        state.points.flat[index] = value
        assert watch.first_bad(state) == "points"
        state.points.flat[index] = 1.0
        assert watch.first_bad(state) is None

    @pytest.mark.parametrize("value", [5e-324, 1.7976931348623157e308, -0.0, -1e-310])
    def test_extreme_numbers_are_finite(self, value: float) -> None:
        state = make()
        state.points[0, 0] = value
        assert FiniteWatch().first_bad(state) is None

    def test_names_of_parts(self) -> None:
        state = make()
        assert FiniteWatch().first_bad(state._replace(inner=Inner(np.nan, np.zeros(1)))) == "inner.time"
        assert FiniteWatch().first_bad(state._replace(inner=Inner(0.0, np.array([np.inf])))) == "inner.flags"
        watch = FiniteWatch()
        assert watch.first_bad(state) is None
        assert watch.first_bad(state._replace(inner=Inner(np.inf, np.zeros(1)))) == "inner.time"

    def test_other_arrays_are_looked_at_anew(self) -> None:
        watch, state = FiniteWatch(), make()
        assert watch.first_bad(state) is None
        assert watch.first_bad(state._replace(points=np.array([np.nan]))) == "points"
        assert watch.first_bad(state) is None

    def test_other_kinds(self) -> None:
        assert (
            FiniteWatch().first_bad(make()._replace(points=np.array([1j, complex(0.0, np.nan)]))) == "points"
        )
        swapped = np.array([1.0, np.inf]).astype(">f8")
        assert FiniteWatch().first_bad(make()._replace(points=swapped)) == "points"
        assert FiniteWatch().first_bad(make()._replace(points=np.arange(4))) is None

    def test_exempt_fields(self) -> None:
        state = make()._replace(points=np.array([np.inf]))
        assert FiniteWatch(frozenset({"points"})).first_bad(state) is None


class Colour(enum.Enum):
    """An enumeration."""

    RED = 1


class Aim(msgspec.Struct, frozen=True):
    """A frozen struct."""

    angle: float


class Thing:
    """Stands for a scene."""


class TestMemory:
    def thing(self) -> Thing:
        thing = Thing()
        thing.number, thing.word, thing.nothing, thing.colour = 1.5, "x", None, Colour.RED
        thing.aim = Aim(0.5)
        thing.list, thing.tuple, thing.dict = [1, [2, 3]], (1, (2,)), {"a": [1], "b": {1, 2}}
        thing.deque = deque([1, 2], maxlen=2)
        thing.random = np.random.default_rng(5)
        thing.array = np.zeros(3)
        thing.mixed = [1, np.zeros(2)]
        return thing

    def test_plain_things_come_back(self) -> None:
        thing = self.thing()
        kept = remember(thing)
        drawn = thing.random.random(3)
        thing.number, thing.word, thing.nothing, thing.colour, thing.aim = 0, "", 4, None, Aim(9.0)
        thing.list[1].append(4)
        thing.dict["a"].append(2)
        thing.dict["b"].add(7)
        thing.deque.append(3)
        recall(thing, kept)
        assert (thing.number, thing.word, thing.nothing, thing.colour) == (1.5, "x", None, Colour.RED)
        assert thing.aim == Aim(0.5)
        assert (thing.list, thing.tuple) == ([1, [2, 3]], (1, (2,)))
        assert thing.dict == {"a": [1], "b": {1, 2}}
        assert thing.deque == deque([1, 2])
        assert thing.deque.maxlen == 2
        assert np.array_equal(thing.random.random(3), drawn)

    def test_it_can_be_recalled_twice(self) -> None:
        thing = self.thing()
        kept = remember(thing)
        for _ in range(2):
            recall(thing, kept)
            thing.list[1].append(4)
        recall(thing, kept)
        assert thing.list == [1, [2, 3]]

    def test_what_was_made_since_is_removed(self) -> None:
        thing = self.thing()
        kept = remember(thing)
        thing.new, thing.surface = 5, object()
        recall(thing, kept)
        assert not hasattr(thing, "new")
        assert hasattr(thing, "surface")

    def test_arrays_and_what_holds_them_are_left_alone(self) -> None:
        thing = self.thing()
        kept = remember(thing)
        thing.array[0] = 1.0
        thing.mixed[0] = 2
        recall(thing, kept)
        assert thing.array[0] == 1.0
        assert thing.mixed[0] == 2

    def test_its_weight_grows_with_what_is_kept(self) -> None:
        thing = self.thing()
        light = remember(thing).bytes
        thing.list = list(range(1000))
        assert remember(thing).bytes > light + 30_000


class TestSeries:
    def test_changes_are_counted(self) -> None:
        series, seen = StripSeries(), set()
        for change in (lambda: series.sample(1, 0.1, []), lambda: series.cut(0), series.clear):
            change()
            seen.add(series.changes)
        assert len(seen) == 3

    def test_a_window_of_seconds(self) -> None:
        series = StripSeries(window_s=1.0, rate_hz=10.0)
        for step in range(100):
            series.sample(step, step * 0.1, [Readout("a", step)])
        assert series.times[-1] == pytest.approx(9.9)
        assert series.times[0] >= 8.9 - 1e-9
        assert series.values("a").tolist() == list(range(100 - len(series), 100))
        assert series.values("a").flags.c_contiguous

    def test_names_that_come_and_go(self) -> None:
        series = StripSeries()
        series.sample(0, 0.0, [Readout("a", 1.0)])
        series.sample(1, 0.1, [Readout("b", 2.0)])
        assert series.names == ("a", "b")
        assert np.array_equal(series.values("a"), [1.0, np.nan], equal_nan=True)
        assert np.array_equal(series.values("b"), [np.nan, 2.0], equal_nan=True)

    def test_going_back(self) -> None:
        series = StripSeries()
        for step in range(10):
            series.sample(step, step * 0.1, [Readout("a", step)])
        series.cut(4)
        series.sample(5, 0.5, [Readout("a", 50.0)])
        assert series.values("a").tolist() == [0, 1, 2, 3, 4, 50]
        series.sample(5, 0.5, [Readout("a", 51.0)])
        assert series.values("a").tolist() == [0, 1, 2, 3, 4, 51]

    @given(st.lists(st.floats(0.0, 3.0), min_size=1, max_size=300))
    def test_it_holds_what_a_list_would(self, gaps: list[float]) -> None:
        series, time_s, plain = StripSeries(2.0, 5.0), 0.0, []
        for step, gap in enumerate(gaps):
            time_s += gap
            series.sample(step, time_s, [Readout("a", step)])
            plain = [item for item in [*plain, (time_s, step)] if item[0] >= time_s - 2.0]
        kept = plain[-len(series) :]
        assert len(series) == min(len(plain), int(2.0 * 5.0 * 1.25) + 8)
        assert series.times.tolist() == [item[0] for item in kept]
        assert series.values("a").tolist() == [item[1] for item in kept]

    def test_a_name_never_sampled(self) -> None:
        with pytest.raises(KeyError):
            StripSeries().values("x")
