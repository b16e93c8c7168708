"""Every broad phase against brute force: random, tied, degenerate boxes, single and bulk calls."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.broadphase.workloads import WORKLOADS, make_boxes
from tests.physics.broadphase.all_phases import PHASES, brute_pairs, brute_query, every_phase

# Coordinates on a small lattice make ties; the others reach outside of every grid, or are hardly there.
lattice = st.integers(-2, 10).map(float)
odd = st.sampled_from([-0.0, 0.3, 0.1 + 0.2, 1.0 - 2.0**-53, 1e-300, 5e-324, 1e9, -1e9, 1e300, 4.0 - 1e-12])
coordinate = st.one_of(lattice, odd, st.floats(-2.0, 10.0))
extent = st.one_of(st.sampled_from([0.0, 1.0, 2.0, 1e-9, 40.0, math.inf]), st.floats(0.0, 3.0))


@st.composite
def boxes(draw):
    x, y, width, height = draw(coordinate), draw(coordinate), draw(extent), draw(extent)
    low = (-math.inf if draw(st.integers(0, 40)) == 0 else x, y)
    return low, (x + width, y + height)


operation = st.one_of(
    st.tuples(st.just("add"), boxes()),
    st.tuples(st.just("add many"), st.lists(boxes(), max_size=12)),
    st.tuples(st.just("remove"), st.integers(0, 99)),
    st.tuples(st.just("remove many"), st.integers(0, 99), st.integers(0, 8)),
    st.tuples(st.just("update"), st.integers(0, 99), boxes()),
    st.tuples(st.just("update many"), st.integers(0, 99), st.lists(boxes(), max_size=12)),
    st.tuples(st.just("query"), boxes()),
    st.tuples(st.just("point"), coordinate, coordinate),
    st.tuples(st.just("check")),
)


class Script:
    """Plays operations on every broad phase and keeps the boxes by id."""

    def __init__(self) -> None:
        self.phases = every_phase()
        self.boxes: dict[int, tuple] = {}

    def arrays(self):
        ids = np.array(sorted(self.boxes), dtype=np.int64)
        lowers = np.array([self.boxes[i][0] for i in ids.tolist()]).reshape(-1, 2)
        uppers = np.array([self.boxes[i][1] for i in ids.tolist()]).reshape(-1, 2)
        return ids, lowers, uppers

    def some(self, start: int, count: int) -> list[int]:
        known = sorted(self.boxes)
        return [known[(start + i) % len(known)] for i in range(min(count, len(known)))]

    def play(self, what: str, *words) -> None:
        if what == "add":
            given = {phase.add_box(*words[0]) for phase in self.phases.values()}
            assert len(given) == 1
            self.boxes[given.pop()] = words[0]
        elif what == "add many":
            lowers, uppers = [b[0] for b in words[0]], [b[1] for b in words[0]]
            given = {tuple(phase.add_boxes(lowers, uppers).tolist()) for phase in self.phases.values()}
            assert len(given) == 1
            self.boxes.update(zip(given.pop(), words[0], strict=True))
        elif what in ("remove", "update") and self.boxes:
            (box,) = self.some(words[0], 1)
            for phase in self.phases.values():
                getattr(phase, f"{what}_box")(box, *(words[1] if what == "update" else ()))
            if what == "update":
                self.boxes[box] = words[1]
            else:
                del self.boxes[box]
        elif what == "remove many" and self.boxes:
            chosen = self.some(*words)
            for phase in self.phases.values():
                phase.remove_boxes(chosen)
            for box in chosen:
                del self.boxes[box]
        elif what == "update many" and self.boxes:
            chosen = self.some(words[0], len(words[1]))
            new = words[1][: len(chosen)]
            for phase in self.phases.values():
                phase.update_boxes(chosen, [b[0] for b in new], [b[1] for b in new])
            self.boxes.update(zip(chosen, new, strict=True))
        elif what == "query":
            expected = brute_query(*self.arrays(), *words[0])
            for name, phase in self.phases.items():
                assert phase.query_box(*words[0]).tolist() == expected.tolist(), name
        elif what == "point":
            expected = brute_query(*self.arrays(), words, words)
            for name, phase in self.phases.items():
                assert phase.query_point(words).tolist() == expected.tolist(), name
        elif what == "check":
            self.check()

    def check(self) -> None:
        expected = brute_pairs(*self.arrays()).tolist()
        for name, phase in self.phases.items():
            assert phase.pairs().tolist() == expected, name
            assert phase.ids().tolist() == sorted(self.boxes), name
            phase.check()
        for box in self.some(0, 2):
            partners = sorted(sum(pair) - box for pair in expected if box in pair)
            assert all(phase.partners(box).tolist() == partners for phase in self.phases.values())


@settings(max_examples=60)
@given(st.lists(operation, min_size=1, max_size=25))
def test_any_script_of_calls_gives_the_pairs_and_queries_of_brute_force(operations):
    script = Script()
    for words in operations:
        script.play(*words)
    script.check()
    assert all(len(phase.ids()) == len(script.boxes) for phase in script.phases.values())


@pytest.mark.parametrize("kind", WORKLOADS)
def test_moving_boxes_give_the_pairs_of_brute_force_in_every_frame(kind):
    generator = np.random.default_rng(11)
    moving = make_boxes(kind, 150, generator, extent=(8.0, 8.0), speed=0.05)
    phases = every_phase()
    lowers, uppers = moving.lowers, moving.uppers
    ids = np.arange(150)
    for phase in phases.values():
        phase.add_boxes(lowers, uppers)
    met = 0
    for frame in range(60):
        step = generator.random((150, 2)) * 8.0 - lowers if kind == "teleport" and frame % 3 == 0 else 0.0
        lowers = lowers + moving.velocities + step
        uppers = uppers + moving.velocities + step
        expected = brute_pairs(ids, lowers, uppers)
        met += len(expected)
        for name, phase in phases.items():
            phase.update_boxes(ids, lowers, uppers)
            assert np.array_equal(phase.pairs(), expected), (name, frame)
    assert met > 60 * 50
    for phase in phases.values():
        phase.check()


@pytest.mark.parametrize("name", PHASES)
def test_single_and_bulk_calls_give_the_same(name):
    generator = np.random.default_rng(3)
    moving = make_boxes("heavy-tail", 80, generator, extent=(8.0, 8.0), share=0.05)
    single, bulk = PHASES[name](), PHASES[name]()
    ids = bulk.add_boxes(moving.lowers, moving.uppers)
    assert [single.add_box(a, b) for a, b in zip(moving.lowers, moving.uppers, strict=True)] == ids.tolist()
    assert np.array_equal(single.pairs(), bulk.pairs())
    shift = generator.standard_normal((80, 2))
    bulk.update_boxes(ids, moving.lowers + shift, moving.uppers + shift)
    for box in ids.tolist():
        single.update_box(box, moving.lowers[box] + shift[box], moving.uppers[box] + shift[box])
    assert np.array_equal(single.pairs(), bulk.pairs())
    bulk.remove_boxes(ids[::3])
    for box in ids[::3].tolist():
        single.remove_box(box)
    assert np.array_equal(single.pairs(), bulk.pairs())
    assert single.add_box((0, 0), (1, 1)) == bulk.add_box((0, 0), (1, 1)) == 0
    single.check()
    bulk.check()
