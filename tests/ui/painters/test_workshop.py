"""The workshop: steel balls that are seen to turn, and a wall that is lit."""

from __future__ import annotations

import numpy as np
import pytest

from game.ui.painters.steel import paint_steel, room_of
from game.ui.painters.wall import BOARD, paint_wall, seam_light, wall_picture

pytestmark = pytest.mark.compiled


ABOVE = np.array([[24.0, -400.0]])  # px: a lamp over the middle of the picture


def painted(turn: float, radius: float = 20.0, dark: bool = True, lamps: np.ndarray = ABOVE) -> np.ndarray:
    pixels = np.full((48, 48), 0xFF123456, np.uint32)
    paint_steel(
        pixels, np.array((0, 0, 48, 48), np.int64), np.full((1, 2), 24.0), np.array([radius]),
        np.array([[np.cos(turn), np.sin(turn)]]), lamps, room_of(dark),
    )  # fmt: skip
    return pixels


def bright(pixels: np.ndarray) -> np.ndarray:
    found: np.ndarray = (pixels >> 16 & 255).astype(float) + (pixels >> 8 & 255) + (pixels & 255)
    return found


@pytest.mark.parametrize("dark", [False, True])
def test_a_ball_is_bright_above_and_dark_about_its_horizon(dark: bool) -> None:
    pixels = bright(painted(1.0, dark=dark))
    assert pixels[10, 24] > 1.8 * pixels[24:27, 30].mean()
    assert pixels[38, 24] > 1.2 * pixels[24:27, 30].mean()
    assert pixels[10:16, 14:20].max() > pixels[10:16, 28:34].max()  # the window


def test_the_nearest_lamp_above_is_mirrored_where_it_hangs() -> None:
    """A lamp to the right lights the right of the ball; one below it, or one farther off, does not."""
    right = painted(1.0, lamps=np.array([[424.0, -300.0], [-2000.0, -300.0], [0.0, 100.0]]))
    left = painted(1.0, lamps=np.array([[-376.0, -300.0], [2000.0, -300.0], [48.0, 100.0]]))
    pixels = bright(right) - bright(left)
    assert pixels[10:24, 32:40].mean() > 40.0 and pixels[10:24, 8:16].mean() < -40.0
    assert np.abs(pixels[34:40, 18:30]).max() < 1.0


def test_a_ball_covers_its_disc_and_no_more() -> None:
    changed = painted(0.0) != 0xFF123456
    y, x = np.nonzero(changed)
    away = np.hypot(x - 23.5, y - 23.5)
    assert away.max() < 21.2
    assert changed.sum() == pytest.approx(np.pi * 20.5**2, rel=0.03)


def test_it_is_seen_how_a_ball_turns() -> None:
    """A third of a turn looks the same, half of that does not."""
    first, third, sixth = (painted(turn) for turn in (0.2, 0.2 + 2.0 * np.pi / 3.0, 0.2 + np.pi / 3.0))
    assert (first == third).mean() > 0.999
    assert (first != sixth).sum() > 30


def test_what_lies_beyond_the_clip_is_left() -> None:
    pixels = np.zeros((48, 48), np.uint32)
    places = np.array([[24.0, 24.0], [np.nan, 3.0], [1e9, 0.0]])
    clip = np.array((20, 22, 30, 26), np.int64)
    paint_steel(pixels, clip, places, np.full(3, 20.0), np.tile((1.0, 0.0), (3, 1)), ABOVE, room_of(True))
    assert (pixels[22:26, 20:30] != 0).all()
    pixels[22:26, 20:30] = 0
    assert not pixels.any()


@pytest.mark.parametrize("dark", [False, True])
def test_the_wall_is_lighter_below_a_lamp(dark: bool) -> None:
    picture = bright(wall_picture(dark, 0.0))
    row = int((36.0 - 13.0) * 16)
    below, between = int((14.2 + 30.0) * 16), int((9.4 + 30.0) * 16)
    assert picture[row, below - 3 : below + 3].mean() > 1.1 * picture[row, between - 3 : between + 3].mean()


def test_boards_are_seen_by_their_seams() -> None:
    x = np.linspace(-0.3, 2.8, 400)
    light = seam_light(x, float(x[1] - x[0]), True)
    seams = x[light < 220]
    assert np.abs(seams - np.round(seams / BOARD) * BOARD).max() < 0.03
    assert {round(float(one)) for one in seams / BOARD} == {0, 1, 2}


def test_rows_of_a_cell_are_alike_and_seams_end_at_the_foot() -> None:
    picture = np.array([[0xFF808080, 0xFF404040], [0xFF202020, 0xFF101010]], np.uint32)
    pixels = np.zeros((4, 3), np.uint32)
    rows, columns = np.array([0, 0, 1, 1]), np.array([0, 0, 1])
    paint_wall(pixels, np.array((0, 0, 3, 4), np.int64), picture, rows, columns, np.array([256, 128, 256]), 1)
    assert pixels[0].tolist() == pixels[1].tolist() == [0xFF808080, 0xFF404040, 0xFF404040]
    assert pixels[2].tolist() == pixels[3].tolist() == [0xFF202020, 0xFF202020, 0xFF101010]
