"""The yard in the light of what burns, and the cloth before it, against plain sums."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.burning_cloth.picture.sheet_painter import ALL, COLUMNS, NOTHING, paint_sheet
from game.scenes.burning_cloth.picture.yard import paint_yard

GAIN = np.array((917, 501, 213), np.int64)


def test_each_pixel_is_its_colour_and_the_light_there():
    rng = np.random.default_rng(7)
    colors = rng.integers(0, 1 << 24, (13, 21)).astype(np.uint32) | np.uint32(0xFF000000)
    takes = rng.integers(0, 256, (13, 21)).astype(np.uint8)
    light = rng.uniform(0.0, 1.15, (5, 6)).astype(np.float32)
    light[2:], takes[4:6] = 0.00399, 255  # so little that nothing is seen of it
    rows, columns = rng.integers(0, 4, 13), rng.integers(0, 5, 21)
    rows[4:6] = 3
    down, across = rng.uniform(0.0, 1.0, 13).astype(np.float32), rng.uniform(0.0, 1.0, 21).astype(np.float32)
    pixels = np.zeros((20, 40), np.uint32)
    work = np.zeros(6, np.float32), np.zeros(21, np.float32)
    paint_yard(pixels, np.array((9, 3, 30, 16), np.int64), colors, takes, light,
               (rows, down, columns, across), GAIN, work)  # fmt: skip
    for y in range(13):
        lines = light[rows[y]] + down[y] * (light[rows[y] + 1] - light[rows[y]])
        near = lines[columns] + across * (lines[columns + 1] - lines[columns])
        strong = (near * takes[y].astype(np.float32)).astype(np.int64)
        if lines.max() < 0.004:
            strong[:] = 0
        for shift, gain in zip((16, 8, 0), GAIN.tolist(), strict=True):
            channel = colors[y].astype(np.int64) >> shift & 255
            wanted = np.minimum(channel + (channel * gain * strong >> 16), 255)
            assert ((pixels[3 + y, 9:30] >> np.uint32(shift) & np.uint32(255)) == wanted).all()
    assert (pixels[3:16, 9:30] >> np.uint32(24) == 255).all() and not pixels[:3].any()
    assert not pixels[:, :9].any() and not pixels[:, 30:].any() and not pixels[16:].any()


def sheet(turned=0.0, left=1.0):
    """Vertices (3, 3, COLUMNS) of one mesh about (20, 15) px, turned, its colours linear in the place."""
    v = np.zeros((3, 3, COLUMNS))
    c, s = math.cos(turned), math.sin(turned)
    for b in range(3):
        for a in range(3):
            x, y = 11.0 * (a - 1), 8.0 * (b - 1)
            v[b, a, :2] = 20.3 + c * x - s * y, 15.2 + s * x + c * y
            v[b, a, 2:5] = 120.0 + 4.0 * x, 100.0 + 5.0 * y, 80.0 + 2.0 * x - 3.0 * y
            v[b, a, 5] = left
    return v


@pytest.mark.parametrize("kind", [1, 2])
@pytest.mark.parametrize("turned", [0.0, 0.4, 1.3, 2.0, 3.5, 5.1])
def test_a_mesh_is_covered_once_in_the_colours_between_its_corners(kind, turned):
    pixels = np.zeros((30, 40), np.uint32)
    paint_sheet(pixels, np.array((0, 0, 40, 30), np.int64), sheet(turned), np.full((1, 1), kind))
    c, s = math.cos(turned), math.sin(turned)
    for row in range(30):
        for column in range(40):
            dx, dy = column + 0.5 - 20.3, row + 0.5 - 15.2
            x, y = c * dx + s * dy, -s * dx + c * dy
            inside = min(11.0 - abs(x), 8.0 - abs(y))
            if inside > 1e-6:
                ink = int(pixels[row, column])
                found = np.array((ink >> 16 & 255, ink >> 8 & 255, ink & 255))
                wanted = np.array((120.0 + 4.0 * x, 100.0 + 5.0 * y, 80.0 + 2.0 * x - 3.0 * y))
                assert ink >> 24 == 255 and (np.abs(found + 0.5 - wanted) < 0.5 + 1e-6).all()
            elif inside < -1e-6:
                assert pixels[row, column] == 0


@pytest.mark.parametrize("channel", [0, 1, 2])
@pytest.mark.parametrize(("value", "nearest"), [(400.0, 255), (-50.0, 0), (255.0, 255), (0.0, 0)])
def test_colours_beyond_what_there_is_are_the_nearest(channel, value, nearest):
    v = sheet()
    v[..., 2:5] = 100.0
    v[..., 2 + channel] = value
    pixels = np.zeros((30, 40), np.uint32)
    paint_sheet(pixels, np.array((0, 0, 40, 30), np.int64), v, np.ones((1, 1), np.int64))
    wanted = [100, 100, 100]
    wanted[channel] = nearest
    assert (pixels[15, 15:25] == (0xFF000000 | wanted[0] << 16 | wanted[1] << 8 | wanted[2])).all()


@pytest.mark.parametrize("left", [0.0, 0.5 * NOTHING, 0.5 * (NOTHING + ALL), ALL])
def test_what_is_burnt_thin_lets_the_ground_through(left):
    pixels = np.full((30, 40), 0xFF000000, np.uint32)
    paint_sheet(pixels, np.array((0, 0, 40, 30), np.int64), sheet(left=left), np.ones((1, 1), np.int64))
    share = min(max((left - NOTHING) / (ALL - NOTHING), 0.0), 1.0)
    assert int(pixels[15, 20] >> np.uint32(16) & np.uint32(255)) == pytest.approx(120.0 * share, abs=2.0)
