"""The door of every broad phase: what it takes, what it refuses, and which ids it gives."""

from __future__ import annotations

import numpy as np
import pytest

from tests.physics.broadphase.all_phases import PHASES

NAN, INF = float("nan"), float("inf")

BAD_BOXES = [
    ((1.0, 0.0), (0.0, 1.0)),
    ((0.0, 1.0), (1.0, 0.0)),
    ((NAN, 0.0), (1.0, 1.0)),
    ((0.0, 0.0), (1.0, NAN)),
    ((INF, 0.0), (INF, 1.0)),
    ((0.0, -INF), (1.0, -INF)),
    ((0.0,), (1.0, 1.0)),
    ("ab", (1.0, 1.0)),
    (None, (1.0, 1.0)),
]


@pytest.fixture(params=PHASES)
def phase(request):
    made = PHASES[request.param]()
    made.add_boxes([(0, 0), (1, 1), (5, 5)], [(1, 1), (2, 2), (6, 6)])
    return made


@pytest.mark.parametrize(("lower", "upper"), BAD_BOXES)
def test_what_is_no_box_is_refused_and_nothing_changes(phase, lower, upper):
    before = phase.pairs().tolist()
    with pytest.raises(ValueError):
        phase.add_box(lower, upper)
    with pytest.raises(ValueError):
        phase.update_box(0, lower, upper)
    with pytest.raises(ValueError):
        phase.query_box(lower, upper)
    with pytest.raises(ValueError):
        phase.add_boxes([(0, 0), lower], [(1, 1), upper])
    with pytest.raises(ValueError):
        phase.update_boxes([2, 0], [(0, 0), lower], [(1, 1), upper])
    assert len(phase) == 3
    assert phase.pairs().tolist() == before == [[0, 1]]
    phase.check()


def test_one_line_says_what_is_wrong(phase):
    with pytest.raises(
        ValueError, match=r"box 1: expected numbers, and lower \(nan, 0.0\) not above upper"
    ) as error:
        phase.add_boxes([(0, 0), (NAN, 0)], [(1, 1), (1, 1)])
    assert "\n" not in str(error.value)
    with pytest.raises(ValueError, match="id = 7: there is no box of that id"):
        phase.remove_box(7)
    with pytest.raises(ValueError, match="point: expected finite numbers"):
        phase.query_point((INF, 0.0))


@pytest.mark.parametrize("ids", [[3], [-1], [0.5], ["a"], [[0]], [True], [2**40]])
def test_ids_that_are_none_are_refused(phase, ids):
    with pytest.raises(ValueError):
        phase.update_boxes(ids, [(0, 0)], [(1, 1)])
    with pytest.raises(ValueError):
        phase.remove_boxes(ids)
    assert phase.box(0)[1].tolist() == [1.0, 1.0]


@pytest.mark.parametrize("ids", [[0, 9, 2], [1, 2, 3], [2, 3, 4], [-1, 0, 1]])
def test_an_unknown_id_among_known_ones_is_refused_and_nothing_is_written(phase, ids):
    """Ids in a row are checked in one go: also where only the first and the last look like a row."""
    before = phase.boxes.copy()
    with pytest.raises(ValueError, match="there is no box of that id"):
        phase.update_boxes(ids, np.full((3, 2), 7.0), np.full((3, 2), 8.0))
    assert np.array_equal(phase.boxes, before)


def test_a_row_of_ids_ends_where_the_boxes_do(phase):
    """Full to the last place: the row that begins one later has an id that there is no place for."""
    more = phase.capacity - len(phase)
    phase.add_boxes(np.zeros((more, 2)), np.ones((more, 2)))
    ids = np.arange(1, phase.capacity + 1)
    with pytest.raises(ValueError, match=f"id = .*{phase.capacity}.*: there is no box"):
        phase.update_boxes(ids, np.zeros((len(ids), 2)), np.ones((len(ids), 2)))


def test_lists_of_unlike_length_are_refused(phase):
    with pytest.raises(ValueError, match="2 ids for 1 boxes"):
        phase.update_boxes([0, 1], [(0, 0)], [(1, 1)])
    with pytest.raises(ValueError, match="1 lower corners for 2 upper ones"):
        phase.add_boxes([(0, 0)], [(1, 1), (1, 1)])
    with pytest.raises(ValueError, match="shape"):
        phase.add_boxes(np.zeros((2, 3)), np.zeros((2, 3)))
    with pytest.raises(ValueError, match="cannot be removed twice"):
        phase.remove_boxes([0, 0])


def test_a_new_box_gets_the_smallest_free_id(phase):
    phase.remove_box(1)
    phase.remove_box(0)
    assert phase.add_box((9, 9), (9, 9)) == 0
    assert phase.add_boxes([(0, 0), (1, 1)], [(1, 1), (2, 2)]).tolist() == [1, 3]
    assert phase.pairs().tolist() == [[1, 3]]
    assert 2 in phase and 4 not in phase and -1 not in phase and "a" not in phase


def test_ids_may_be_chosen(phase):
    assert phase.add_boxes([(0, 0), (1, 1)], [(1, 1), (2, 2)], ids=[9, 6]).tolist() == [9, 6]
    assert phase.ids().tolist() == [0, 1, 2, 6, 9]
    assert phase.pairs().tolist() == [[0, 1], [0, 6], [0, 9], [1, 6], [1, 9], [6, 9]]
    phase.check()
    assert phase.add_box((0, 9), (1, 9)) == 3
    for taken in ([9], [4, 4], [-1], [1 << 30]):
        with pytest.raises(ValueError):
            phase.add_boxes([(0, 0)] * len(taken), [(1, 1)] * len(taken), ids=taken)
    phase.check()


@pytest.mark.parametrize(
    "dress",
    [
        lambda a: a.tolist(),
        lambda a: a.astype(np.float32),
        lambda a: a.astype(int),
        lambda a: np.asfortranarray(a),
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: np.broadcast_to(a[None], (1, *a.shape))[0],
    ],
)
def test_any_dress_of_the_same_numbers_gives_the_same(phase, dress):
    lowers, uppers = np.array([[4.0, 4.0], [-0.0, 3.0]]), np.array([[5.0, 5.0], [0.0, 4.0]])
    lowers.setflags(write=False)
    ids = phase.add_boxes(dress(lowers), dress(uppers))
    assert phase.pairs().tolist() == [[0, 1], [2, 3]]
    phase.update_boxes(np.array(ids, dtype=np.int32), dress(uppers), dress(uppers))
    assert phase.pairs().tolist() == [[0, 1], [2, 3]]


def test_what_is_empty_is_answered(phase):
    phase.remove_boxes([0, 1, 2])
    assert phase.pairs().shape == (0, 2)
    assert phase.query_point((0, 0)).tolist() == []
    assert phase.add_boxes([], []).tolist() == []
    phase.update_boxes([], [], [])
    phase.remove_boxes([])
    phase.check()
    assert phase.memory() > 0


def test_the_answer_belongs_to_the_caller(phase):
    phase.pairs()[:] = -1
    assert phase.pairs().tolist() == [[0, 1]]
