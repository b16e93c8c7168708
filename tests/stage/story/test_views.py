"""What a story's camera shows: frames and views, upright and turned."""

from __future__ import annotations

import math

import pytest

from game.stage import Frame
from game.stage.script.camera import ASPECT, MIDDLE, View, kept_inside, view_of


@pytest.mark.parametrize(
    ("frame", "turned", "width"),
    [
        (Frame(-1.0, 2.0, 7.0, 3.0), False, 8.0),
        (Frame(3.0, -5.0, 4.0, 4.0), False, 9.0 * ASPECT),
        (Frame(-1.0, 2.0, 7.0, 3.0), True, 8.0 * ASPECT),
        (Frame(3.0, -5.0, 4.0, 4.0), True, 9.0),
    ],
)
def test_a_view_shows_all_of_a_frame_and_no_more_than_it_must(frame, turned, width):
    view = view_of(frame, turned)
    assert view.width == pytest.approx(width)
    assert (view.x, view.y) == (0.5 * (frame.left + frame.right), 0.5 * (frame.bottom + frame.top))
    shown = view.frame(turned)
    across, up = width, width / ASPECT
    if turned:
        across, up = up, across
    assert (shown.right - shown.left, shown.top - shown.bottom) == pytest.approx((across, up))
    assert shown.left <= frame.left + 1e-9 and shown.right >= frame.right - 1e-9
    assert shown.bottom <= frame.bottom + 1e-9 and shown.top >= frame.top - 1e-9
    assert view_of(Frame(1.0, 1.0, 1.0, 1.0)).width == pytest.approx(1e-9)


@pytest.mark.parametrize("turned", [False, True])
def test_a_view_follows_a_point_just_so_far_that_it_is_in_the_middle(turned):
    view = View(1.0, -2.0, math.log(10.0))
    across, up = 10.0 * MIDDLE, 10.0 * MIDDLE / ASPECT
    if turned:
        across, up = up, across
    for side in (-1.0, 1.0):
        assert kept_inside(view, 1.0 + side * across * 0.999, -2.0 + side * up * 0.999, turned) == view
        moved = kept_inside(view, 1.0 + side * (across + 0.25), -2.0 + side * (up + 0.5), turned)
        assert moved == pytest.approx((1.0 + side * 0.25, -2.0 + side * 0.5, view.log_width))
