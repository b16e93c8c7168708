"""Camera: the map and its inverse, what stays fixed under pan and zoom, and the spring's exactness."""

from __future__ import annotations

import math

import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.stage import Frame
from game.ui.canvas.camera import Camera

RECT = pygame.Rect(30, 40, 800, 400)


def camera(y_up=True, quarter_turns=0):
    made = Camera(y_up=y_up, quarter_turns=quarter_turns)
    made.fit(Frame(-2.0, 0.0, 2.0, 1.0), RECT, 20.0)
    return made


@pytest.mark.parametrize("y_up", [True, False])
@pytest.mark.parametrize("turns", [0, 1, 2, 3])
@given(x=st.floats(-1e3, 1e3), y=st.floats(-1e3, 1e3))
def test_there_and_back(y_up, turns, x, y):
    c = camera(y_up, turns)
    back = c.to_world(*c.to_screen(x, y))
    assert back == pytest.approx((x, y), abs=1e-9)


def test_fit_leaves_the_margin_and_centres():
    c = camera()
    assert c.scale == pytest.approx(760 / 4)
    assert c.to_screen(0.0, 0.5) == pytest.approx(RECT.center)
    assert c.to_screen(-2.0, 0.5)[0] == pytest.approx(RECT.x + 20)


def test_y_up_and_quarter_turns():
    assert camera().to_screen(0, 1)[1] < camera().to_screen(0, 0)[1]
    assert camera(y_up=False).to_screen(0, 1)[1] > camera(y_up=False).to_screen(0, 0)[1]
    c = camera(y_up=True, quarter_turns=1)  # clockwise: right becomes down, up becomes right
    assert c.to_screen(1, 0.5)[1] > RECT.centery
    assert c.to_screen(0, 1.0)[0] > RECT.centerx
    assert c.angle_to_screen(0.0) == pytest.approx(math.pi / 2)
    assert c.scale == pytest.approx(min(760 / 1, 360 / 4))


@given(st.floats(0.05, 50), st.integers(0, 800), st.integers(0, 400), st.integers(1, 40))
def test_zoom_holds_the_point_under_the_pointer_all_the_way(factor, px, py, frames):
    c = camera()
    before = c.to_world(px, py)
    c.zoom(factor, (px, py))
    for _ in range(frames):
        c.update(1 / 60)
        assert c.to_world(px, py) == pytest.approx(before, abs=1e-6)


def test_zoom_is_bounded_and_refuses_nonsense():
    c = camera()
    for factor in (math.nan, math.inf, 0.0, -1.0):
        c.zoom(factor, RECT.center)
    assert c.is_home
    for _ in range(200):
        c.zoom(10.0, RECT.center, smooth=False)
    assert c.scale == pytest.approx(400 * 760 / 4)
    c.pan(math.nan, 1.0)
    assert all(map(math.isfinite, c.center))


def test_pan_moves_with_the_hand_and_home_returns():
    c = camera()
    c.pan(10.0, -5.0)
    assert c.to_screen(0.0, 0.5) == pytest.approx((RECT.centerx + 10, RECT.centery - 5))
    c.home()
    for _ in range(200):
        c.update(1 / 60)
    assert c.is_home and not c.update(1 / 60)
    assert c.to_screen(0.0, 0.5) == pytest.approx(RECT.center)


def test_spring_does_not_depend_on_the_frame_rate():
    coarse, fine = camera(), camera()
    for c in (coarse, fine):
        c.look_at(Frame(5.0, 5.0, 6.0, 6.0))
    coarse.update(0.3)
    for _ in range(30):
        fine.update(0.01)
    assert fine.center == pytest.approx(coarse.center, abs=1e-9)
    assert fine.scale == pytest.approx(coarse.scale, rel=1e-9)
    # closed form of a critically damped spring from rest: gap (1 + w t) exp(-w t)
    gap = 5.5 * (1 + 3.0) * math.exp(-3.0)
    assert coarse.center[0] == pytest.approx(5.5 - gap, abs=1e-9)


def test_resize_keeps_a_moved_view():
    c = camera()
    c.zoom(2.0, RECT.center, smooth=False)
    c.pan(100.0, 0.0)
    center = c.center
    c.fit(Frame(-2.0, 0.0, 2.0, 1.0), pygame.Rect(0, 0, 400, 200), 10.0)
    assert c.center == center and c.scale == pytest.approx(2 * 380 / 4)


def test_one_pixel_and_empty_frames_do_no_harm():
    c = Camera()
    for frame in (Frame(0, 0, 0, 0), Frame(-math.inf, 0, math.inf, 1), Frame(math.nan, 0, 1, 1)):
        c.fit(frame, pygame.Rect(0, 0, 1, 1), 20.0)
        assert all(map(math.isfinite, c.to_screen(0.0, 0.0)))


def test_visible_is_the_part_inside():
    v = camera().visible()
    assert v.left == pytest.approx(-800 / 380) and v.right == pytest.approx(800 / 380)
    assert v.top - v.bottom == pytest.approx(400 / 190)
