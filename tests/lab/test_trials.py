"""Trials made of functions, and points at which every method is measured alike."""

from __future__ import annotations

from game.lab.study import Outcome, Setting
from game.lab.trials import Computation, chosen_setting, computation, every_setting


def test_what_a_computation_begins_with_is_made_anew_before_each_run():
    made: list[list[int]] = []

    def begin() -> list[int]:
        made.append([0])
        return made[-1]

    def work(start: list[int]) -> int:
        start[0] += 1
        return start[0]

    trial = Computation(2.5, begin, work, lambda found: Outcome(0.5 * found, 10 * found))
    assert trial.simulated_s == 2.5
    for _ in range(2):
        trial.reset()
        trial.run()
        assert trial.outcome() == Outcome(0.5, 10)
    trial.run()  # not begun anew
    assert trial.outcome() == Outcome(1.0, 20)
    assert made == [[1], [2]]


def test_a_computation_without_a_beginning():
    runs: list[int] = []
    trial = computation(1.0, lambda: runs.append(1) or len(runs), lambda found: Outcome(0.0, found))
    for count in (1, 2):
        trial.reset()
        trial.run()
        assert trial.outcome().counter == count


def test_every_method_at_every_value_method_by_method():
    found = every_setting(("a", "b"), (2, 4), lambda name, n: {"how": name, "n": n}, lambda n: 1.0 / n)
    assert [(one.method, one.knob, one.weight) for one in found] == [
        ("a", 2.0, 0.5), ("a", 4.0, 0.25), ("b", 2.0, 0.5), ("b", 4.0, 0.25),
    ]  # fmt: skip
    assert found[1].scene == {"how": "a", "n": 4}


def test_a_scene_stands_at_its_own_method_and_knob_if_that_is_one_of_the_study():
    chosen = {"method": "a", "cells": 8, "other": 1}
    assert chosen_setting("method", "cells")(chosen) == Setting("a", 8.0)
    assert chosen_setting("method", "cells", ("b",))(chosen) is None
    assert chosen_setting("method", "cells", ("a",))(chosen) == Setting("a", 8.0)
