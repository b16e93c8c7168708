"""Labels find free places near those they want, inside the view."""

import math

from hypothesis import given, settings
from hypothesis import strategies as st

from game.ui.text.label_places import SLACK, Box, LabelPlaces

VIEW = Box(0.0, 0.0, 400.0, 300.0)
corner = st.tuples(st.floats(-50.0, 420.0), st.floats(-50.0, 320.0))


def box_at(x, y, width=60.0, height=16.0):
    return Box(x, y, x + width, y + height)


@given(st.lists(corner, min_size=1, max_size=5))
@settings(deadline=None)
def test_a_few_labels_never_cross_nor_leave_the_view(corners):
    places, put = LabelPlaces(), []
    for x, y in corners:
        box = places.free(box_at(x, y), VIEW)
        places.claim(box)
        put.append(box)
    for i, box in enumerate(put):
        assert math.isclose(box.right - box.left, 60.0)
        assert math.isclose(box.bottom - box.top, 16.0)
        assert VIEW.left - 1e-9 <= box.left
        assert box.right <= VIEW.right + 1e-9
        assert VIEW.top - 1e-9 <= box.top
        assert box.bottom <= VIEW.bottom + 1e-9
        assert not any(box.crosses(other) for other in put[:i])


def test_a_free_place_is_taken_as_wanted_and_a_taken_one_is_left_by_the_shortest_way():
    places = LabelPlaces()
    assert places.free(box_at(100.0, 100.0), VIEW) == box_at(100.0, 100.0)
    places.claim(box_at(100.0, 100.0))
    assert places.free(box_at(110.0, 95.0), VIEW) == box_at(110.0, 84.0)
    assert places.free(box_at(158.0, 100.0), VIEW) == box_at(160.0, 100.0)
    assert places.free(box_at(160.0 - SLACK, 100.0), VIEW) == box_at(160.0 - SLACK, 100.0)
    places.clear()
    assert places.free(box_at(110.0, 95.0), VIEW) == box_at(110.0, 95.0)


def test_a_label_beyond_the_edge_comes_inside_and_a_larger_one_shows_its_beginning():
    places = LabelPlaces()
    assert places.free(box_at(390.0, -40.0), VIEW) == box_at(340.0, 0.0)
    assert places.free(box_at(-30.0, 10.0, 900.0), VIEW).left == 0.0
    nowhere = box_at(math.nan, 0.0)
    assert places.free(nowhere, VIEW) is nowhere
