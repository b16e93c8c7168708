"""An array as a picture against a naive twin, and inside its box only."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.ui.raster import clip_of, pixels_of
from game.ui.raster.field import field_room, paint_field, shade_table

STOPS = [(0.0, pygame.Color(0, 0, 0)), (0.5, pygame.Color(200, 40, 10)), (1.0, pygame.Color(255, 255, 255))]
TABLE = shade_table(STOPS)


def painted(values, box, alpha=1.0, size=(64, 48)):
    surface = pygame.Surface(size, 0, 32)
    surface.fill((7, 8, 9))
    room = field_room(values.shape[1], size[0])
    paint_field(
        pixels_of(surface), clip_of(surface), values.astype(np.float32), np.array(box), TABLE, room, alpha
    )
    return surface


def test_each_pixel_has_the_colour_of_the_value_between_the_cells():
    rng = np.random.default_rng(4)
    values, box = rng.uniform(-0.2, 1.2, (6, 9)), (5.3, 4.1, 58.7, 43.2)
    surface = painted(values, box)
    for x, y in rng.integers((6, 5), (58, 43), (300, 2)).tolist():
        u = np.clip((x + 0.5 - box[0]) / (box[2] - box[0]) * 9 - 0.5, 0, 8)
        v = np.clip((box[3] - y - 0.5) / (box[3] - box[1]) * 6 - 0.5, 0, 5)
        i, j = min(int(v), 4), min(int(u), 7)
        rows = values[i] + (v - i) * (values[i + 1] - values[i])
        value = rows[j] + (u - j) * (rows[j + 1] - rows[j])
        shade = min(max(int(np.floor(value * 256)), 0), 255)
        near = {int(TABLE[min(max(shade + d, 0), 255)]) & 0xFFFFFF for d in (-1, 0, 1)}
        assert (surface.get_at_mapped((x, y)) & 0xFFFFFF) in near


def test_its_room_may_be_wider_than_it_needs():
    values, box = np.random.default_rng(5).uniform(-0.2, 1.2, (6, 9)), np.array((5.3, 4.1, 58.7, 43.2))
    surface = pygame.Surface((64, 48), 0, 32)
    surface.fill((7, 8, 9))
    wide = field_room(40, 300)
    for part in wide:
        part[:] = 77
    paint_field(
        pixels_of(surface), clip_of(surface), values.astype(np.float32), box, TABLE, wide, 1.0
    )  # fmt: skip
    assert (pixels_of(surface) == pixels_of(painted(values, tuple(box)))).all()


def test_a_single_column_takes_nothing_from_what_was_there_before():
    surface = pygame.Surface((20, 10), 0, 32)
    room = field_room(3, 20)
    room.row[:] = np.nan
    paint_field(
        pixels_of(surface), clip_of(surface), np.ones((1, 1), np.float32),
        np.array((0.0, 0.0, 20.0, 10.0)), TABLE, room, 1.0,
    )  # fmt: skip
    assert (pixels_of(surface) & np.uint32(0xFFFFFF) == 0xFFFFFF).all()


def test_nothing_outside_its_box_and_the_clip():
    surface = pygame.Surface((40, 30), 0, 32)
    surface.fill((7, 8, 9))
    surface.set_clip(pygame.Rect(10, 10, 8, 8))
    paint_field(pixels_of(surface), clip_of(surface), np.ones((3, 3), np.float32),
                np.array((0.0, 0.0, 30.0, 30.0)), TABLE, field_room(3, 40), 1.0)  # fmt: skip
    seen = pygame.surfarray.array3d(surface)
    changed = (seen != (7, 8, 9)).any(axis=2)
    assert changed[10:18, 10:18].all() and changed.sum() == 64


@pytest.mark.parametrize(
    ("values", "box"),
    [
        (np.full((2, 2), np.nan), (0.0, 0.0, 20.0, 20.0)),
        (np.full((2, 2), np.inf), (0.0, 0.0, 20.0, 20.0)),
        (np.ones((1, 1)), (3.0, 3.0, 9.0, 9.0)),
        (np.ones((2, 2)), (np.nan, 0.0, 20.0, 20.0)),
        (np.ones((2, 2)), (20.0, 20.0, 10.0, 10.0)),
        (np.ones((2, 2)), (-1e8, -1e8, 1e8, 1e8)),
    ],
)
def test_odd_numbers_do_no_harm(values, box):
    surface = painted(values, box)
    assert surface.get_at((63, 0))[:3] in ((7, 8, 9), (255, 255, 255))


def test_half_of_it_lets_what_is_below_through():
    surface = painted(np.ones((2, 2)), (0.0, 0.0, 64.0, 48.0), 0.5)
    assert abs(surface.get_at((30, 20))[0] - (7 + 255) // 2) <= 1


def test_a_table_goes_through_its_stops():
    assert TABLE[0] & 0xFFFFFF == 0
    assert abs(int(TABLE[128] >> 16 & 255) - 200) <= 1 and TABLE[255] & 0xFFFFFF == 0xFFFFFF
