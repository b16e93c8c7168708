"""Smoke and light over a picture, beside a naive twin."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.ui.raster import clip_of, pixels_of
from game.ui.raster.field import shade_table
from game.ui.raster.veil import paint_veil, veil_room

BLACK_TO_FIRE = [(0.0, pygame.Color(0, 0, 0)), (1.0, pygame.Color(240, 120, 30))]
TABLE = shade_table(BLACK_TO_FIRE)
GROUND, SMOKE = (40, 60, 80), 0x808080


def painted(veil, box=(0.0, 0.0, 32.0, 24.0), adds=True, size=(32, 24)):
    surface = pygame.Surface(size, 0, 32)
    surface.fill(GROUND)
    cells = np.ascontiguousarray(veil, np.float32)
    paint_veil(
        pixels_of(surface), clip_of(surface), cells, np.array(box), SMOKE, TABLE, veil_room(size[0]), adds
    )
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


def twin(veil, box, adds, size=(64, 40)):
    """The same in plain numpy: bilinear between the middles of cells, then smoke, then light."""
    rows, columns = veil.shape[:2]
    left, top, right, bottom = box
    x, y = np.arange(size[0]) + 0.5, np.arange(size[1]) + 0.5
    u = np.clip((x - left) * columns / (right - left) - 0.5, 0.0, columns - 1.0)
    v = np.clip((bottom - y) * rows / (bottom - top) - 0.5, 0.0, rows - 1.0)
    i, j = np.minimum(u.astype(int), columns - 2), np.minimum(v.astype(int), rows - 2)
    f, g = (u - i)[:, None, None], (v - j)[None, :, None]
    low = (1 - f) * veil[j][:, i].swapaxes(0, 1) + f * veil[j][:, i + 1].swapaxes(0, 1)
    high = (1 - f) * veil[j + 1][:, i].swapaxes(0, 1) + f * veil[j + 1][:, i + 1].swapaxes(0, 1)
    found = (1 - g) * low + g * high
    smoke, light = np.clip(found[..., :1], 0, 1), np.clip(found[..., 1], 0, 1)
    inks = TABLE[np.minimum((light * 256).astype(int), 255)]
    ink = np.stack([(inks >> shift) & 255 for shift in (16, 8, 0)], axis=2)
    strong = np.minimum(1.5 * light, 1.0)[..., None]
    seen = np.array(GROUND) * (1 - smoke) + 0x80 * smoke
    seen = np.minimum(seen + ink, 255) if adds else seen * (1 - strong) + ink * strong
    inside = ((x >= left) & (x < right))[:, None] & ((y >= top) & (y < bottom))[None]
    return np.where(inside[..., None], seen, GROUND)


@pytest.mark.parametrize("adds", [True, False])
@pytest.mark.parametrize("box", [(0.0, 0.0, 64.0, 40.0), (9.0, 4.0, 51.0, 33.0), (-30.0, -20.0, 90.0, 77.0)])
@pytest.mark.parametrize("cells", [(12, 16), (7, 5), (2, 2)])
def test_it_is_what_its_twin_says(cells, box, adds):
    """Also where only some cells hold smoke, fewer of them light, and whole rows nothing at all."""
    rng = np.random.default_rng(5)
    for shown in (1.0, 0.15, 0.03):
        veil = rng.uniform(0.05, 1.0, (*cells, 2)) * (rng.random((*cells, 1)) < shown)
        veil[..., 1] *= rng.random(cells) < 0.5
        seen, wanted = painted(veil, box, adds, (64, 40)), twin(veil.astype(np.float32), box, adds)
        assert np.max(np.abs(seen - wanted)) <= 1.6  # a shade beside, where 256 times the light is whole


@pytest.mark.parametrize("box", [(np.nan, 0, 9, 9), (9, 9, 3, 3), (0, 0, 1e12, 9), (-50, -50, -40, -40)])
def test_a_box_of_nonsense_draws_nothing(box):
    assert np.all(painted(even(1.0, 1.0), box) == GROUND)
