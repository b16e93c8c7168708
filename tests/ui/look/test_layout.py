"""Regions of the window: the measures of the look at 1280 x 720, and no overlap anywhere."""

from __future__ import annotations

import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.ui.look.layout import arrange, arrange_over, auto_scale, overlay_rect


def test_measures_at_1280_by_720():
    layout = arrange(1280, 720, 1.0)
    assert layout.top_bar == pygame.Rect(0, 0, 1280, 48)
    assert layout.stage == pygame.Rect(0, 48, 960, 512)
    assert layout.panel == pygame.Rect(960, 48, 320, 672)
    assert layout.strips == pygame.Rect(0, 560, 960, 128)
    assert layout.hint_bar == pygame.Rect(0, 688, 960, 32)
    assert len(layout.charts) == 3 and layout.charts[0].x == 16
    assert not layout.drawer and not layout.values_only


def test_everything_scales_with_the_window():
    one, two = arrange(1280, 720, 1.0), arrange(2560, 1440, 2.0)
    for name in ("top_bar", "stage", "panel", "strips", "hint_bar"):
        small, large = getattr(one, name), getattr(two, name)
        assert large == pygame.Rect(small.x * 2, small.y * 2, small.w * 2, small.h * 2)


def test_narrow_window_makes_the_panel_a_drawer_and_drops_a_chart():
    layout = arrange(1100, 720, 1.0)
    assert layout.drawer and layout.stage.w == 1100 and layout.free_stage.right == layout.panel.x
    assert len(arrange(1160, 720, 1.0).charts) == 2
    assert arrange(1280, 590, 1.0).values_only


def test_panel_off_gives_its_room_to_the_stage():
    layout = arrange(1280, 720, 1.0, panel=False)
    assert layout.stage.w == layout.hint_bar.w == 1280 and layout.panel.w == 0


@pytest.mark.parametrize("size", [(1280, 720), (1600, 900), (1920, 1080), (3840, 2160)])
def test_a_game_fills_its_window_and_bar_and_hints_lie_over_the_rows_it_leaves(size):
    layout = arrange_over(*size, auto_scale(*size))
    assert layout.overlaid and layout.stage == layout.window == pygame.Rect(0, 0, *size)
    assert layout.panel.w == layout.strips.h == 0 and not layout.charts
    row = 56 * size[1] / 720
    assert layout.top_bar.bottom <= row and layout.hint_bar.h <= 0.5 * row
    assert layout.hint_bar.bottom == size[1]


@pytest.mark.parametrize(("size", "k"), [((1280, 720), 1.25), ((1440, 900), 1.25), ((700, 500), 1.0)])
def test_letters_too_large_for_those_rows_have_rows_of_their_own(size, k):
    layout = arrange_over(*size, k)
    assert layout == arrange(*size, k, panel=False, strips=0) and not layout.overlaid
    assert not layout.stage.colliderect(layout.top_bar) and not layout.stage.colliderect(layout.hint_bar)


@pytest.mark.parametrize(
    ("size", "k"), [((1280, 720), 1.0), ((1920, 1080), 1.25), ((2560, 1440), 1.5), ((3840, 2160), 2.0)]
)
def test_scale_follows_the_height(size, k):
    assert auto_scale(*size) == k


def test_scale_never_outgrows_the_window():
    assert auto_scale(640, 480, 2.0) == pytest.approx(4 / 3)
    assert auto_scale(400, 300, 2.0) == 1.0
    assert auto_scale(240, 240) == pytest.approx(0.75)
    assert auto_scale(1, 1, 2.0) == 0.5
    assert auto_scale(1280, 720, float("nan")) == 1.0


@given(
    st.integers(320, 3840),
    st.integers(240, 2160),
    st.sampled_from([0.75, 1.0, 1.3, 2.0]),
    st.booleans(),
    st.integers(0, 3),
)
def test_regions_never_overlap_and_fill_the_window(width, height, user, panel, strips):
    k = auto_scale(width, height, user)
    layout = arrange(width, height, k, panel=panel, strips=strips)
    regions = [layout.top_bar, layout.stage, layout.strips, layout.hint_bar]
    if not layout.drawer:
        regions.append(layout.panel)
    regions = [r for r in regions if r.w and r.h]
    for i, a in enumerate(regions):
        assert layout.window.contains(a)
        assert not any(a.colliderect(b) for b in regions[i + 1 :])
    assert sum(r.w * r.h for r in regions) == width * height
    assert layout.stage.w >= 100 and layout.stage.h >= 100
    for i, chart in enumerate(layout.charts):
        assert layout.strips.contains(chart)
        assert chart.collidelist(list(layout.charts[i + 1 :])) == -1
    if layout.drawer:
        assert layout.stage.contains(layout.panel) and layout.free_stage.w >= 1


@given(st.integers(-5, 400), st.integers(-5, 400), st.floats(0.5, 4.0), st.booleans())
def test_any_size_and_scale_gives_regions_with_an_area(width, height, k, panel):
    layout = arrange(width, height, k, panel=panel)
    assert layout.stage.w >= 1 and layout.stage.h >= 1
    assert min(layout.top_bar.h, layout.panel.w, layout.hint_bar.h, layout.strips.h) >= 0


def test_overlay_keeps_clear_of_the_edges():
    assert overlay_rect(pygame.Rect(0, 0, 1280, 720), 1.0, 624) == pygame.Rect(112, 48, 1056, 624)
    small = overlay_rect(pygame.Rect(0, 0, 500, 300), 1.0, 624)
    assert small == pygame.Rect(16, 16, 468, 268)
    assert overlay_rect(pygame.Rect(0, 0, 1, 1), 1.0, 624).size == (1, 1)
