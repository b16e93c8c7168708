"""The kinetic sweep: bounds hold while boxes go on as they did, and only what does not is swept anew."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.broadphase import KineticSweep
from game.physics.broadphase.kinetic.kinetic_sweep import directions_of
from game.physics.broadphase.workloads import WORKLOADS, make_boxes
from tests.physics.broadphase.all_phases import brute_pairs


def sweep_of(kind: str = "equal", count: int = 300, seed: int = 1, **values):
    boxes = make_boxes(kind, count, np.random.default_rng(seed), (10.0, 10.0), 0.375, 1.0)
    phase = KineticSweep(**values)
    return phase, phase.add_boxes(boxes.lowers, boxes.uppers), boxes


def go(phase, ids, boxes, steps, velocities, first=0):
    """Let boxes move on evenly, all answers compared with the plainest; events of each step."""
    events = []
    for step in range(first + 1, first + steps + 1):
        low, high = boxes.lowers + step * velocities, boxes.uppers + step * velocities
        phase.update_boxes(ids, low, high)
        assert np.array_equal(phase.pairs(), brute_pairs(ids, low, high))
        phase.check()
        events.append(phase.events)
    return events


@pytest.mark.parametrize("slabs", [4, 8, 16])
@pytest.mark.parametrize("kind", WORKLOADS)
def test_pairs_on_every_workload_slow_and_fast(kind, slabs):
    phase, ids, boxes = sweep_of(kind, 200, slabs=slabs)
    size = float(np.median(boxes.half_sizes))
    slow = go(phase, ids, boxes, 12, 0.1 * size * boxes.velocities)
    fast = np.where(np.arange(200)[:, None] % 3 == 0, 6.0, 0.3) * size * boxes.velocities
    assert sum(go(phase, ids, boxes, 12, fast)[1:]) >= sum(slow[2:])  # once they are under way


def test_boxes_at_rest_cost_no_events_and_even_motion_costs_one_each_time_the_bound_is_used_up():
    phase, ids, boxes = sweep_of()
    assert go(phase, ids, boxes, 10, 0.0 * boxes.velocities)[-5:] == [0] * 5
    phase, ids, boxes = sweep_of()
    size = 2.0 * float(boxes.half_sizes[0, 0])
    events = go(phase, ids, boxes, 120, 0.02 * size * boxes.velocities / 1.0)[20:]
    # a bound grows by a size: 50 steps straight along an axis, up to 71 aslant
    assert sum(events) == pytest.approx(300 * 100 / 57.0, rel=0.15)
    assert phase.renewals == 2  # at first, and when the velocities were known
    assert max(events) < 30  # they do not all end together


def test_what_turns_leaps_or_trembles_is_noticed_in_the_same_step():
    phase, ids, boxes = sweep_of()
    size = 2.0 * float(boxes.half_sizes[0, 0])
    velocities = 0.03 * size * boxes.velocities
    go(phase, ids, boxes, 10, velocities)
    rng = np.random.default_rng(5)
    centers = boxes.centers + 10 * velocities
    for step in range(30):
        turned = rng.random(300) < 0.05
        velocities[turned] = -3.0 * velocities[turned][:, ::-1]
        centers = centers + velocities
        leapt = rng.random(300) < 0.02
        centers[leapt] = rng.random((int(leapt.sum()), 2)) * 10.0
        shake = 0.04 * size * (-1.0) ** step * (np.arange(300)[:, None] % 2)
        low, high = centers + shake - boxes.half_sizes, centers + shake + boxes.half_sizes
        phase.update_boxes(ids, low, high)
        assert np.array_equal(phase.pairs(), brute_pairs(ids, low, high))
        phase.check()


def test_trembling_things_are_learned_and_left_alone():
    phase, ids, boxes = sweep_of()
    shake = 0.04 * 2.0 * boxes.half_sizes
    events = []
    for step in range(40):
        shift = (step % 2) * shake
        phase.update_boxes(ids, boxes.lowers + shift, boxes.uppers + shift)
        phase.pairs()
        events.append(phase.events)
    assert sum(events[20:]) < 300


def test_boxes_that_come_go_grow_and_have_no_end():
    phase, ids, boxes = sweep_of(count=60)
    rng = np.random.default_rng(2)
    low, high = boxes.lowers.copy(), boxes.uppers.copy()
    held = {int(i): (low[i], high[i]) for i in ids}
    endless = phase.add_box((-np.inf, 4.0), (np.inf, 5.0))
    held[endless] = (np.array([-np.inf, 4.0]), np.array([np.inf, 5.0]))
    point = phase.add_box((5.0, 4.5), (5.0, 4.5))
    held[point] = (np.array([5.0, 4.5]), np.array([5.0, 4.5]))
    for step in range(40):
        gone = int(rng.choice(list(held)))
        phase.remove_box(gone)
        del held[gone]
        if step % 3:
            corner = rng.random(2) * 10.0
            held[phase.add_box(corner, corner + 0.5)] = (corner, corner + 0.5)
        for box, (a, b) in held.items():
            held[box] = (a - 0.01 * (box % 3), b + 0.02 * (box % 2))
            phase.update_box(box, *held[box])
        known = np.array(sorted(held))
        lows, highs = (np.array([held[box][k] for box in known]) for k in (0, 1))
        assert np.array_equal(phase.pairs(), brute_pairs(known, lows, highs))
        phase.check()


def test_more_slabs_let_fewer_false_pairs_through_and_none_gets_lost():
    false, candidates = [], []
    for slabs in (4, 8, 16):
        phase, ids, boxes = sweep_of(slabs=slabs, growth=6.0)
        size = 2.0 * float(boxes.half_sizes[0, 0])
        go(phase, ids, boxes, 20, 0.5 * size * boxes.velocities)
        assert phase.false_pairs == phase.candidates - len(phase.pairs())
        false.append(phase.false_pairs)
        candidates.append(phase.candidates)
    assert false[0] > 1.1 * false[1] > 1.1 * false[2] > 0
    assert candidates[2] > len(phase.pairs())


def test_a_bound_is_the_box_swept_along_its_way():
    phase = KineticSweep(8, growth=10.0, pad=0.0)
    ids = phase.add_boxes([[0.0, 0.0]], [[1.0, 1.0]])
    for step in range(4):
        phase.update_boxes(ids, [[0.1 * step, 0.1 * step]], [[1.0 + 0.1 * step, 1.0 + 0.1 * step]])
        phase.pairs()
    corners = phase.polygon(0)
    x, y = corners.T
    area = 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))
    length = float(x.max() - x.min() - 1.0)  # of the way, on each axis
    assert length > 4.0
    assert area == pytest.approx(1.0 + 2.0 * length, rel=1e-6)  # hexagon: the square, and its two sides' way
    assert (np.abs(x - y) <= 1.0 + 1e-9).all()


def test_coming_events_are_those_that_come():
    phase, ids, boxes = sweep_of()
    velocities = 0.02 * 2.0 * float(boxes.half_sizes[0, 0]) * boxes.velocities
    go(phase, ids, boxes, 12, velocities)
    coming = phase.coming_events()
    assert coming.sum() == 300
    assert go(phase, ids, boxes, 8, velocities, 12) == coming[:8].tolist()


def test_what_makes_no_sense_is_refused():
    with pytest.raises(ValueError, match="slabs = 6: expected one of 4, 8, 16"):
        KineticSweep(6)
    with pytest.raises(ValueError, match="growth = nan: expected a finite number of at least 0"):
        KineticSweep(growth=float("nan"))
    assert directions_of(8) == pytest.approx(
        np.array([[1, 0], [0.5**0.5, 0.5**0.5], [0, 1], [-(0.5**0.5), 0.5**0.5]])
    )
