"""Smoke and light over a picture, beside a naive twin."""

from __future__ import annotations

import time

import numpy as np
import pygame
import pytest

from game.ui.raster import clip_of, pixels_of
from game.ui.raster.field import shade_table
from game.ui.raster.veil import paint_veil

BLACK_TO_FIRE = [(0.0, pygame.Color(0, 0, 0)), (1.0, pygame.Color(240, 120, 30))]
TABLE = shade_table(BLACK_TO_FIRE)
GROUND, SMOKE = (40, 60, 80), 0x808080


def painted(veil, box=(0.0, 0.0, 32.0, 24.0), adds=True, size=(32, 24)):
    surface = pygame.Surface(size, 0, 32)
    surface.fill(GROUND)
    row = np.empty((veil.shape[1], 2), np.float32)
    cells = np.ascontiguousarray(veil, np.float32)
    paint_veil(pixels_of(surface), clip_of(surface), cells, np.array(box), SMOKE, TABLE, row, adds)
    return pygame.surfarray.array3d(surface).astype(int)


def even(smoke, light):
    return np.broadcast_to(np.array([smoke, light]), (4, 5, 2))


def test_smoke_covers_by_its_thickness():
    for thick in (0.0, 0.25, 1.0, 2.0):
        share = min(thick, 1.0)
        seen = painted(even(thick, 0.0))
        wanted = [g + share * (0x80 - g) for g in GROUND]
        assert np.max(np.abs(seen - wanted)) <= 1


def test_light_is_added_or_laid_over():
    seen = painted(even(0.0, 0.999))
    assert np.max(np.abs(seen - [min(255, g + f) for g, f in zip(GROUND, (240, 120, 30), strict=True)])) <= 2
    seen = painted(even(0.0, 0.999), adds=False)
    assert np.max(np.abs(seen - (240, 120, 30))) <= 2
    assert np.array_equal(painted(even(0.0, 0.0)), painted(even(np.nan, np.nan)))


def test_it_is_linear_between_cells_with_the_first_row_below():
    veil = np.zeros((2, 2, 2))
    veil[0, :, 0] = 1.0  # below
    seen = painted(veil, (0.0, 0.0, 32.0, 24.0))[16, :, 0]
    assert seen[-1] == pytest.approx(0x80, abs=1) and seen[0] == GROUND[0]
    assert np.all(np.diff(seen) >= 0) and seen[11] == pytest.approx((GROUND[0] + 0x80) / 2, abs=4)


@pytest.mark.parametrize("box", [(np.nan, 0, 9, 9), (9, 9, 3, 3), (0, 0, 1e12, 9), (-50, -50, -40, -40)])
def test_a_box_of_nonsense_draws_nothing(box):
    assert np.all(painted(even(1.0, 1.0), box) == GROUND)


def test_a_veil_over_a_whole_picture_is_quick_enough():
    surface = pygame.Surface((1280, 720), 0, 32)
    veil = np.random.default_rng(1).uniform(0.0, 1.0, (128, 256, 2)).astype(np.float32)
    row, times = np.empty((256, 2), np.float32), []
    for _ in range(5):
        start = time.process_time()
        paint_veil(
            pixels_of(surface),
            clip_of(surface),
            veil,
            np.array((0.0, 0.0, 1280.0, 720.0)),
            SMOKE,
            TABLE,
            row,
            True,
        )
        times.append(time.process_time() - start)
    assert min(times) < 0.1  # measured: see the benchmarks
    print(f"{1e3 * min(times):.2f} ms")
