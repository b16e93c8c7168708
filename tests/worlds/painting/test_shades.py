"""Pictures in two lights: what they show of both, where they are bent, what they let through; finer cells."""

from __future__ import annotations

import numpy as np
import pytest

from game.worlds.painting.lit import lit_room, paint_lit
from game.worlds.painting.shades import FINE, finer, grid_of, in_two_lights, lit, smoothstep, soft


def shown(picture: np.ndarray, lights: tuple[float, ...], ground: int = 0, bend: float = 0.0) -> np.ndarray:
    """(16, 24, 3) red, green, blue of a picture over all of a ground."""
    pixels = np.full((16, 24), ground, np.uint32)
    box, clip = np.array((0.0, 0.0, 24.0, 16.0)), np.array((0, 0, 24, 16), np.int64)
    moved = np.full(picture.shape[0], bend)
    room = lit_room(picture.shape[2], 24)
    paint_lit(pixels, clip, picture, box, moved, np.array(lights, np.float32), room)
    return np.stack([pixels >> shift & 255 for shift in (16, 8, 0)], axis=2).astype(float)


def plain(cover: float = 1.0) -> np.ndarray:
    whole = np.ones((4, 6))
    return lit(whole[..., None] * (100.0, 60.0, 20.0), 0.5 * whole, 1.5 * whole, cover * whole)


def test_both_lights_show_of_a_picture() -> None:
    assert shown(plain(), (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)) == pytest.approx(
        np.broadcast_to((50.0, 30.0, 10.0), (16, 24, 3)), abs=1.0
    )
    both = shown(plain(), (1.0, 0.5, 0.0, 1.0, 0.5, 0.2))
    assert both == pytest.approx(np.broadcast_to((200.0, 60.0, 6.0), (16, 24, 3)), abs=1.0)


def test_what_covers_less_lets_the_ground_through() -> None:
    """Of the ground as much as is not covered; light without cover is added, and stays white at most."""
    half = shown(plain(0.25), (1.0, 1.0, 1.0, 0.0, 0.0, 0.0), ground=0x80C8FF)
    assert half == pytest.approx(np.broadcast_to((108.5, 157.5, 193.75), (16, 24, 3)), abs=1.0)
    none, white = np.zeros((4, 6)), np.full((4, 6, 3), 200.0)
    added = shown(in_two_lights(0.0 * white, white, none), (0.0, 0.0, 0.0, 1.0, 0.1, 0.0), ground=0x646464)
    assert added == pytest.approx(np.broadcast_to((255.0, 120.0, 100.0), (16, 24, 3)), abs=1.0)


def test_the_first_row_is_the_lowest_and_a_bend_moves_rows() -> None:
    x, y = grid_of(((0.0, 0.0), (24.0, 16.0)), (16, 24))
    ramp = lit(np.stack([8.0 * x, 12.0 * y, 0.0 * x], axis=2), 0.0 * x + 1.0, 0.0 * x, 0.0 * x + 1.0)
    lights = (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)
    still, moved = shown(ramp, lights), shown(ramp, lights, bend=3.0)
    assert still[0, 5, 1] > still[-1, 5, 1] and still[0, 5, 1] == pytest.approx(12.0 * 15.5, abs=2.0)
    assert moved[:, 4:22, 0] == pytest.approx(still[:, 1:19, 0], abs=1.5)


def test_slow_shades_are_not_in_bands() -> None:
    """A tenth of a step of 8 bits is shown as a tenth of the pixels."""
    whole = np.full((4, 6, 3), 50.1)
    found = shown(in_two_lights(whole, 0.0 * whole, np.ones((4, 6))), (1.0, 1.0, 1.0, 0.0, 0.0, 0.0))
    assert set(np.unique(found)) == {50.0, 51.0}
    assert found.mean() == pytest.approx(50.1, abs=0.05)


def test_finer_cells_keep_what_is_even_and_have_no_steps() -> None:
    x, y = grid_of(((0.0, 0.0), (12.0, 9.0)), (9, 12))
    found = finer(2.0 * x + y)
    assert found.shape == (9 * FINE, 12 * FINE)
    fx, fy = grid_of(((0.0, 0.0), (12.0, 9.0)), found.shape)
    inner = (slice(2 * FINE, -2 * FINE),) * 2
    assert found[inner] == pytest.approx((2.0 * fx + fy)[inner], abs=1e-12)  # splines have a line as it is
    spike = np.zeros((9, 9))
    spike[4, 4] = 1.0
    smooth = finer(spike)
    assert smooth.sum() == pytest.approx(FINE * FINE)
    # of a cubic B-spline: 2/3 in its middle, where its second derivative is -2
    assert np.abs(np.diff(smooth, n=2, axis=0)).max() <= 2.0 / FINE**2 * 2.0 / 3.0


def test_a_blur_keeps_the_sum_and_spreads_as_it_says() -> None:
    spot = np.zeros((61, 61))
    spot[30, 30] = 1.0
    found = soft(spot, (2.0, 3.0))
    away = np.arange(61) - 30.0
    assert found.sum() == pytest.approx(1.0)
    assert (found.sum(axis=1) * away**2).sum() == pytest.approx(4.0, rel=0.01)
    assert (found.sum(axis=0) * away**2).sum() == pytest.approx(9.0, rel=0.01)


def test_a_soft_step_goes_either_way() -> None:
    assert smoothstep(1.0, 3.0, np.array((0.0, 2.0, 4.0))).tolist() == [0.0, 0.5, 1.0]
    assert smoothstep(3.0, 1.0, np.array((0.0, 2.0, 4.0))).tolist() == [1.0, 0.5, 0.0]
