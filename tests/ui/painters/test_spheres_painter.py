"""Lit spheres: hidden ones, soft rims, turning octants, odd input; and outlines of discs."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.ui.painters.spheres import OUTLINE_CORNERS, SpherePainter, trace_outline

RED, BLUE = 0xC02020, 0x2020C0
CLIP = np.array((0, 0, 60, 60), np.int64)


def painted(spheres, turn=None, clip=CLIP, painter=None, alpha=1.0):
    """Pixels after spheres (x, y, z, r, colour) are drawn on black."""
    pixels = np.zeros((60, 60), np.uint32)
    rows = np.array(spheres, float).reshape(-1, 5)
    turns = np.eye(3)[None] if turn is None else np.asarray(turn, float)[None]
    (painter or SpherePainter()).draw(
        pixels, clip, rows[:, :3].copy(), rows[:, 3].copy(), turns, np.zeros(len(rows), np.int64),
        rows[:, 4].astype(np.uint32), alpha,
    )  # fmt: skip
    return pixels


def channels(pixels):
    return np.stack([(pixels >> shift) & 255 for shift in (16, 8, 0)], axis=-1).astype(int)


def is_red(pixel):
    r, _, b = channels(np.array(pixel))
    return r > b


def test_a_disc_of_the_right_size_lit_from_above_left():
    pixels = painted([(30, 30, 0, 20, RED)])
    covered = (pixels & 0xFFFFFF) > 0
    assert covered.sum() == pytest.approx(math.pi * 400, rel=0.05)
    light = channels(pixels).sum(axis=2)
    assert light[18, 20] > 1.3 * light[42, 40]
    assert not covered[:9].any()
    rim = channels(pixels)[30, 49]
    assert 0 < rim.sum() < channels(pixels)[30, 45].sum()


@pytest.mark.parametrize("order", [1, -1])
def test_the_nearer_one_is_seen_whatever_the_order(order):
    spheres = [(30, 30, 0, 15, RED), (30, 30, 30, 8, BLUE)]
    pixels = painted(spheres[::order])
    assert not is_red(pixels[30, 30])
    assert is_red(pixels[30, 42])
    behind = painted([(30, 30, 0, 15, RED), (30, 30, -30, 8, BLUE)][::order])
    assert np.array_equal(behind, painted([(30, 30, 0, 15, RED)]))


def test_spheres_cut_through_one_another():
    """Two equal ones side by side meet in the plane half way."""
    pixels = painted([(22, 30, 0, 14, RED), (38, 30, 0, 14, BLUE)])
    assert is_red(pixels[30, 27])
    assert not is_red(pixels[30, 33])
    assert is_red(pixels[25, 28])
    assert not is_red(pixels[25, 32])


def test_octants_turn_with_the_body():
    still = painted([(30, 30, 0, 20, RED)])
    c, s = math.cos(0.6), math.sin(0.6)
    turned = painted([(30, 30, 0, 20, RED)], ((c, -s, 0), (s, c, 0), (0, 0, 1)))
    assert (channels(still) != channels(turned)).any(axis=2).sum() > 200
    quarter = painted([(30, 30, 0, 20, RED)], ((0, -1, 0), (1, 0, 0), (0, 0, 1)))
    half = painted([(30, 30, 0, 20, RED)], ((-1, 0, 0), (0, -1, 0), (0, 0, 1)))
    assert (channels(still) != channels(quarter)).any(axis=2).sum() > 800
    assert np.abs(channels(still) - channels(half)).max() <= 1


def test_the_memory_is_clean_after_each_picture():
    painter = SpherePainter()
    painted([(30, 30, 50, 25, BLUE)], painter=painter)
    again = painted([(30, 30, 0, 15, RED)], painter=painter)
    assert np.array_equal(again, painted([(30, 30, 0, 15, RED)]))


def test_the_clip_is_kept():
    clip = np.array((20, 10, 35, 40), np.int64)
    pixels = painted([(30, 30, 0, 25, RED)], clip=clip)
    outside = np.ones((60, 60), bool)
    outside[10:40, 20:35] = False
    assert not pixels[outside].any()
    assert pixels[~outside].any()


@pytest.mark.parametrize(
    "odd",
    [
        (math.nan, 30, 0, 10), (30, math.inf, 0, 10), (30, 30, -math.inf, 10), (30, 30, 0, math.nan),
        (30, 30, 0, -5), (30, 30, 0, 0), (30, 30, 0, 1e300), (1e300, 30, 0, 10), (-500, 30, 0, 10),
    ],
)  # fmt: skip
def test_what_cannot_be_drawn_is_left_out(odd):
    assert np.array_equal(painted([(*odd, BLUE), (30, 30, 0, 15, RED)]), painted([(30, 30, 0, 15, RED)]))


def test_small_and_transparent_ones():
    assert painted([(30.2, 30.7, 0, 0.8, RED)]).any()
    weak, strong = (channels(painted([(30, 30, 0, 10, RED)], alpha=a)).sum() for a in (0.5, 1.0))
    assert weak == pytest.approx(0.5 * strong, rel=0.03)
    assert not painted(np.zeros((0, 5))).any()


def test_arrays_that_do_not_fit_are_refused():
    pixels, one = np.zeros((8, 8), np.uint32), np.ones(1)
    color, owner = np.zeros(1, np.uint32), np.zeros(1, np.int64)
    painter, clip, turns = SpherePainter(), np.array((0, 0, 8, 8), np.int64), np.eye(3)[None]
    with pytest.raises(ValueError, match="one n"):
        painter.draw(pixels, clip, np.zeros((2, 3)), one, turns, owner, color)
    with pytest.raises(ValueError, match="turns"):
        painter.draw(pixels, clip, np.zeros((1, 3)), one, np.eye(3), owner, color)
    with pytest.raises(ValueError, match="owners"):
        painter.draw(pixels, clip, np.zeros((1, 3)), one, turns, owner + 1, color)


def test_outline_of_two_discs():
    """What lies in the other is left out: all other points lie on a rim and in no disc."""
    centers, radii = np.array(((0.0, 0.0), (1.5, 0.0), (0.1, 0.0))), np.array((1.0, 1.0, 0.3))
    points = np.zeros((3 * (OUTLINE_CORNERS + 2), 2))
    trace_outline(centers, radii, points)
    by_disc = points.reshape(3, -1, 2)
    assert np.isnan(by_disc[:, -1]).all()
    assert np.isnan(by_disc[2]).all()
    drawn = points[np.isfinite(points[:, 0])]
    off = np.sqrt(((drawn[:, None] - centers) ** 2).sum(axis=2)) - radii
    assert np.allclose(off.min(axis=1), 0.0, atol=1e-12)
    assert len(drawn) == pytest.approx(2 * OUTLINE_CORNERS * (1 - math.acos(0.75) / math.pi), abs=6)
