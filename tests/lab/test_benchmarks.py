"""Scenarios and how they are timed; no time is judged."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from game.lab.benchmarks import Measured, Peer, Scenario, all_scenarios, measure_scenario, rigid
from game.lab.benchmarks.billiards import random_shots
from game.lab.benchmarks.broadphase import Workload, kd_tree, pymunk_step, str_tree
from game.lab.benchmarks.constraints import NumpyCloth, pymunk_chain
from game.lab.benchmarks.solids import pymunk_pyramid, pyramid


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
        "pyramid-210",
        "skin-rotor",
    ],
)
def test_a_scenario_of_each_room_runs(name):
    scenario = next(scenario for scenario in all_scenarios() if scenario.name == name)
    measured = measure_scenario(replace(scenario, peers=()), turns=1)
    assert 0.0 < measured.least_s <= measured.median_s


def test_both_pyramids_are_the_same_and_ours_sinks_less():
    pytest.importorskip("pymunk")
    (world, top), (space, other) = pyramid(10, steps=60), pymunk_pyramid(10, steps=60)
    assert len(world.ids()) == len(space.bodies) + 1 == 56  # pymunk's ground is not among them
    np.testing.assert_allclose(world.bodies.positions[top], other.position, atol=0.02)
    assert 0.0 < 9.5 - world.bodies.positions[top, 1] < 9.5 - other.position.y


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


def test_the_cloth_by_numpy_is_a_cloth():
    """The colour that is projected last has its links at their length, the held row stays, weight acts."""
    cloth = NumpyCloth()
    top = cloth.y[0].copy()
    for _ in range(2):
        cloth.step(1.0 / 60.0)
    a, b, _, _ = cloth.families[-1]
    lengths = np.hypot(cloth.x[b] - cloth.x[a], cloth.y[b] - cloth.y[a])
    assert np.abs(lengths - 0.01).max() < 1e-14
    assert np.array_equal(cloth.y[0], top)
    assert top[0] - cloth.y[1].min() < 0.011  # three thousandths and more without the hold
    assert cloth.vy[-1] == pytest.approx(-2.0 * 9.81 / 60.0)  # the hem has not felt the hold yet
    assert np.abs(cloth.x - 0.01 * np.arange(cloth.x.shape[1])).max() < 1e-9


def test_an_engine_has_the_same_chain():
    pytest.importorskip("pymunk")
    space, bodies = pymunk_chain()
    assert len(bodies) == 101 and len(space.bodies) == len(space.constraints) == 100
    assert [body.position.x for body in bodies[1:]] == pytest.approx(0.1 * np.arange(1, 101))


def test_there_are_as_many_random_shots_as_are_wanted():
    shots = random_shots(2, 3)
    assert len(shots) == 3 and all(len(shot.balls) == 2 for shot in shots)


def test_bodies_start_anew_in_every_run(monkeypatch):
    monkeypatch.setattr(rigid, "batch", lambda: (np.zeros((2, 13)), np.zeros((2, 7)), np.zeros((2, 6))))
    monkeypatch.setattr(rigid, "advance", lambda method, states, *others: states.__iadd__(1.0))
    run, states = rigid.runner(rigid.METHODS[0])
    for _ in range(2):
        run()
        assert (states == 1.0).all()


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
