"""What a cloth that burns costs, and its picture.

python -m pytest tests/benchmarks/test_cloth.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.physics.cloth import Breeze, Cloth, GasAt
from game.physics.cloth.layout import HOT, X, Y
from game.scenes.burning_cloth.picture.sheet_painter import COLUMNS, paint_sheet
from game.ui.raster import clip_of, pixels_of

DT = 1.0 / 60.0


def burning_cloth(meshes: int) -> Cloth:
    cloth = Cloth(meshes)
    cloth.write(np.ones(cloth.patches.shape[1:]))
    cloth.patches[HOT] = np.random.default_rng(1).uniform(300.0, 900.0, cloth.patches.shape[1:])
    return cloth


@pytest.mark.parametrize("part", ["heat", "motion"])
def test_cloth(benchmark, part):
    benchmark.group = "a cloth of 80 by 45 meshes, 14,400 patches"
    cloth = burning_cloth(80 if benchmark.enabled else 8)
    cells = np.zeros((60, 96, 4))
    cells[..., 0], cells[..., 2] = 293.15, 0.27
    gas = GasAt(-1.6, 0.0, 1.0 / 30.0, 0.08, 6.7e-5, 0.27, 1.3, 700.0, 0.4, 1.5e7, 0.06)
    wind = (
        np.full((60, 97), 1.0),
        np.zeros((61, 96)),
        Breeze(-1.6, 0.0, 1.0 / 30.0, 0.5, 0.4, 3.4, 0.0, 0.7, 0.15),
    )
    if part == "heat":
        benchmark.pedantic(cloth.heat, (DT, cells, np.zeros((60, 96)), gas), rounds=30, warmup_rounds=2)
    else:
        benchmark.pedantic(cloth.move, (DT, wind), rounds=30, warmup_rounds=2)
    assert np.isfinite(cloth.nodes).all() and np.isfinite(cloth.patches).all()


def test_picture_of_a_cloth(benchmark):
    benchmark.group = "a cloth over 1280 x 720"
    cloth = Cloth(80 if benchmark.enabled else 8)
    ny, nx = cloth.whole.shape
    vertices = np.zeros((2 * ny + 1, 2 * nx + 1, COLUMNS))
    vertices[::2, ::2, 0], vertices[::2, ::2, 1] = (
        640.0 + 500.0 * cloth.nodes[X],
        800.0 - 480.0 * cloth.nodes[Y],
    )
    vertices[..., 2:5], vertices[..., 5] = 200.0, 1.0
    surface = pygame.Surface((1280, 720), 0, 32)
    arguments = (pixels_of(surface), clip_of(surface), vertices, np.ones((ny, nx), np.int64))
    benchmark.pedantic(paint_sheet, arguments, rounds=20, warmup_rounds=2)
    assert surface.get_at((640, 300))[:3] == (200, 200, 200)
