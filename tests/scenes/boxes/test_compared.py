"""A broad phase beside the naive one: when that is done, when it begins anew, and what it says."""

from __future__ import annotations

from contextlib import contextmanager
from types import SimpleNamespace

import numpy as np
import pytest

from game.physics.broadphase.effects import NAIVE
from game.scenes.boxes.model import compared
from game.scenes.boxes.model.compared import ComparedModel

# of five slots the second is free; the first two boxes that there are overlap
LOWERS = np.array([(0.0, 0.0), (9.0, 9.0), (0.5, 0.5), (5.0, 5.0), (7.0, 0.0)])
IDS = np.array([0, 2, 3, 4], dtype=np.int64)


class Watch:
    """Keeps what it was asked."""

    def __init__(self) -> None:
        self.said: list[str] = []

    def forget(self, name: str) -> None:
        self.said.append(f"forget {name}")

    @contextmanager
    def time(self, name: str):
        self.said.append(f"time {name}")
        yield


@pytest.fixture
def model() -> ComparedModel:
    made = object.__new__(ComparedModel)
    made.boxes = SimpleNamespace(ids=IDS, covered=lambda: (LOWERS.copy(), LOWERS + 1.0))
    made.active, made.watch, made.pairs = (NAIVE,), Watch(), np.array([(0, 2)], dtype=np.int64)
    made.update = lambda phase: None
    made.make_naive()
    return made


def test_nothing_is_said_before_it_was_asked(model):
    assert (model.compared, model.same, len(model.naive)) == (False, True, 0)


def test_both_agree_or_they_do_not(model):
    model.compare()
    assert (model.compared, model.same) == (True, True) and model.watch.said == ["time naive"]
    assert model.naive.ids().tolist() == IDS.tolist()
    for wrong in ([], [(0, 3)], [(0, 2), (3, 4)]):
        model.pairs = np.array(wrong, dtype=np.int64).reshape(-1, 2)
        model.compare()
        assert (model.compared, model.same) == (True, False)
    model.active = ()
    model.compare()
    assert (model.compared, model.same) == (False, True) and model.watch.said[-1] == "forget naive"


def test_more_boxes_than_it_is_good_for_are_left_out(model, monkeypatch):
    for most, done in ((4, True), (3, False)):
        monkeypatch.setattr(compared, "MOST_NAIVE", most)
        model.same = False
        model.compare()
        assert (model.compared, model.same) == (done, True)


def test_it_begins_anew_only_where_the_boxes_are_others(model):
    model.compare()
    first = model.naive
    model.compare()
    assert model.naive is first
    for ids in (np.array([0, 2, 3], dtype=np.int64), np.array([0, 2, 4], dtype=np.int64)):
        model.boxes.ids = ids
        before = model.naive
        model.compare()
        assert model.naive is not before and model.naive.ids().tolist() == ids.tolist()
