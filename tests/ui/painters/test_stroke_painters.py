"""Cue, labels on the cloth and gauges: right places and colours, nothing for absurd input."""

import math

import numpy as np
import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.ui.look.fonts import FontBook
from game.ui.look.theme import DARK, FELT
from game.ui.painters.cloth_label import draw_cloth_label
from game.ui.painters.cue import BUTT_RADIUS, LENGTH, TIP_RADIUS, draw_cue, paint_cue
from game.ui.painters.gauges import draw_elevation, draw_power, draw_spin
from game.ui.raster import clip_of, pixels_of

BOOK = FontBook(1.0)


def felt(size=(300, 200)):
    surface = pygame.Surface(size, 0, 32)
    surface.fill(FELT)
    return surface


def changed(surface):
    return (pygame.surfarray.array3d(surface) != np.array(tuple(FELT)[:3])).any(axis=2)


@pytest.mark.parametrize("angle", [0.0, 0.7, math.pi / 2, 3.0, 4.6])
def test_the_stick_has_its_length_and_taper(angle):
    surface, scale = felt((400, 400)), 100.0
    ux, uy = math.cos(angle), math.sin(angle)
    tip = (200.0 - 0.5 * LENGTH * scale * ux, 200.0 - 0.5 * LENGTH * scale * uy)
    paint_cue(pixels_of(surface), clip_of(surface), *tip, ux, uy, scale, 400.0)
    covered = np.argwhere(changed(surface)) + 0.5 - np.array(tip)
    along, across = covered @ (ux, uy), np.abs(covered @ (-uy, ux))
    assert along.min() == pytest.approx(0.0, abs=1.0)
    assert along.max() == pytest.approx(LENGTH * scale, abs=1.0)
    near, far = across[along < 20.0].max(), across[along > 127.0].max()
    assert near == pytest.approx((TIP_RADIUS + (BUTT_RADIUS - TIP_RADIUS) * 0.14) * 400.0, abs=1.2)
    assert far == pytest.approx(BUTT_RADIUS * 400.0, abs=1.2)


def test_a_raised_cue_looks_shorter_and_its_shadow_moves_off():
    flat, raised = felt(), felt()
    for surface, elevation in ((flat, 0.0), (raised, 1.0)):
        draw_cue(pixels_of(surface), clip_of(surface), (280.0, 40.0), (-1.0, 0.0), 150.0, elevation)
    assert np.argwhere(changed(flat))[:, 0].min() < np.argwhere(changed(raised))[:, 0].min()
    assert np.argwhere(changed(flat))[:, 1].max() < np.argwhere(changed(raised))[:, 1].max()


def test_the_tip_is_chalked_and_the_shadow_can_be_kept_on_the_table():
    surface = felt()
    table = np.array((100, 0, 300, 200), np.int64)
    draw_cue(
        pixels_of(surface), clip_of(surface), (250.0, 60.0), (-1.0, 0.0), 150.0, 0.0, (150.0, 100.0), table
    )
    red, green, blue, _ = surface.get_at((249, 59))
    assert blue > green > red
    below = changed(surface)[:, 63:]
    assert below[100:].any()
    assert not below[:100].any()


odd = st.one_of(st.floats(allow_nan=True, allow_infinity=True), st.floats(-50, 350))
nowhere = st.sampled_from([math.nan, math.inf, -math.inf, 1e300])
CLIP = pygame.Rect(7, 5, 40, 26)


def draw_all(surface, v):
    """Cue, label and gauges from eight numbers."""
    pixels, clip = pixels_of(surface), clip_of(surface)
    draw_cue(pixels, clip, (v[0], v[1]), (v[2], v[3]), v[4], v[5], (v[6], v[7]))
    draw_cloth_label(surface, BOOK, "a", (v[0], v[1]))
    draw_power(surface, pygame.Rect(0, 0, 60, 40), v[0], v[1], DARK, BOOK)
    draw_spin(surface, (20.0, 20.0), v[0], v[1], DARK, BOOK)
    draw_elevation(surface, (20.0, 20.0), v[0], DARK, BOOK)


@given(st.lists(odd, min_size=8, max_size=8))
@settings(max_examples=80, deadline=None)
def test_whatever_the_numbers_are_nothing_is_drawn_outside_of_the_clip(v):
    surface = felt((60, 40))
    surface.set_clip(CLIP)
    with np.errstate(all="ignore"):
        draw_all(surface, v)
    outside = changed(surface)
    outside[CLIP.left : CLIP.right, CLIP.top : CLIP.bottom] = False
    assert not outside.any()


@given(nowhere, st.floats(0, 60), st.booleans())
@settings(max_examples=40, deadline=None)
def test_what_has_no_place_is_not_drawn(far, near, swap):
    surface = felt((60, 40))
    pixels, clip = pixels_of(surface), clip_of(surface)
    x, y = (near, far) if swap else (far, near)
    draw_cue(pixels, clip, (x, y), (-1.0, 0.0), 150.0, 0.0)
    assert not changed(surface).any()


def test_labels_stay_inside():
    surface = felt((120, 60))
    rect = draw_cloth_label(surface, BOOK, "cut 26°", (119.0, 2.0))
    assert surface.get_rect().contains(rect)


@pytest.mark.parametrize("k", [1.0, 1.25, 1.5, 2.0])
def test_the_power_bar_fills_with_the_speed(k):
    book = FontBook(k)
    filled = []
    for speed in (0.0, 5.0, 10.0, 99.0):
        surface = pygame.Surface((round(80 * k), round(500 * k)), 0, 32)
        draw_power(surface, pygame.Rect(0, 0, *surface.get_size()), speed, 10.0, DARK, book)
        accent = np.array(tuple(DARK.chalk.mark)[:3])
        filled.append(int((pygame.surfarray.array3d(surface) == accent).all(axis=2).sum()))
    assert filled[0] < 0.1 * filled[1]
    assert filled[2] == filled[3]
    assert filled[1] == pytest.approx(0.5 * (filled[0] + filled[2]), rel=0.05)


def test_gauges_draw_in_a_subsurface_as_in_a_window():
    window, alone = pygame.Surface((200, 200), 0, 32), pygame.Surface((90, 90), 0, 32)
    part = window.subsurface((70, 60, 90, 90))
    for surface in (part, alone):
        draw_spin(surface, (40.0, 45.0), 0.2, 0.4, DARK, BOOK)
        draw_elevation(surface, (20.0, 60.0), 0.3, DARK, BOOK)
    assert (pygame.surfarray.array3d(part) == pygame.surfarray.array3d(alone)).all()
    frame = pygame.surfarray.array3d(window)
    frame[70:160, 60:150] = 0
    assert not frame.any()


def test_the_tips_mark_lies_where_it_strikes():
    surface = pygame.Surface((90, 90), 0, 32)
    draw_spin(surface, (45.0, 45.0), 0.5, 0.5, DARK, BOOK)
    red, _, blue, _ = surface.get_at((60, 30))
    assert blue > red + 60
