"""Scenarios and how they are timed; no time is judged."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from game.lab.benchmarks import Measured, Peer, Scenario, all_scenarios, measure_scenario
from game.lab.benchmarks.broadphase import Workload, kd_tree, pymunk_step, str_tree


def test_names_differ_and_words_are_there():
    scenarios = all_scenarios()
    assert len({scenario.name for scenario in scenarios}) == len(scenarios) > 15
    assert all(scenario.title and scenario.unit and scenario.count >= 1 for scenario in scenarios)


@pytest.mark.parametrize(
    "name",
    [
        "cut",
        "grid-equal-1000",
        "particles-10000",
        "chain",
        "gjk-warm-8",
        "overlap-obb",
        "body-rk4",
        "skin-rotor",
    ],
)
def test_a_scenario_of_each_room_runs(name):
    scenario = next(scenario for scenario in all_scenarios() if scenario.name == name)
    measured = measure_scenario(replace(scenario, peers=()), turns=1)
    assert 0.0 < measured.least_s <= measured.median_s


@pytest.mark.parametrize("kind", ["equal", "power-law"])
def test_other_trees_of_boxes_find_the_pairs_there_are(kind):
    """What is timed side by side must be the same work."""
    workload = Workload(kind, 300)
    lowers, uppers = workload.frame()
    apart = (lowers[:, None] > uppers[None]) | (lowers[None] > uppers[:, None])
    pairs = int(np.triu(~apart.any(axis=2), 1).sum())
    assert pairs > 100
    assert str_tree(kind, 300)() == pairs
    assert kind != "equal" or kd_tree(kind, 300)() == pairs


def test_an_engine_steps_the_same_boxes():
    pytest.importorskip("pymunk")
    step = pymunk_step("equal", 50)
    assert [step(), step()] == [50, 50]


def test_peers_are_timed_in_turns_and_missing_ones_left_out():
    order = []

    def missing():
        raise ImportError("no such package")

    def slow():
        order.append("slow")
        sum(range(300_000))

    scenario = Scenario(
        "made-up", "Made up", "call", lambda: lambda: order.append("quick"), 4,
        (Peer("slow", lambda: slow), Peer("missing", missing)),
    )  # fmt: skip
    measured = measure_scenario(scenario, turns=3)
    assert list(measured.peers) == ["slow"]
    assert measured.least_s <= measured.median_s <= measured.worst_s
    assert measured.ratio("slow") == measured.peers["slow"] / measured.least_s
    assert order[-1] == "slow" and "quick" in order
    assert Measured(scenario, 2.0, 2.5, 3.0, {"slow": 8.0}).ratio("slow") == 4.0
    with pytest.raises(ValueError, match="turns"):
        measure_scenario(scenario, turns=0)
