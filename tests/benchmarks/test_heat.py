"""What heat, burning and a veil of smoke and flames cost.

python -m pytest tests/benchmarks/test_heat.py --benchmark-enable
"""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.physics.combustion import Flames
from game.physics.heat import BurningBodies, HeatGrid
from game.ui.raster import clip_of, pixels_of
from game.ui.raster.field import shade_table
from game.ui.raster.veil import paint_veil, veil_room


@pytest.mark.parametrize("scheme", ["explicit", "alternating", "crank-nicolson"])
def test_conduction(benchmark, scheme):
    benchmark.group = "256 x 256 cells of heat"
    n = 256 if benchmark.enabled else 16
    start = np.random.default_rng(1).uniform(300.0, 900.0, (n, n))
    grid = HeatGrid(start, 1.0 / n, 1e-4, 1.0, scheme=scheme)
    benchmark.pedantic(grid.step, (0.9 * grid.explicit_limit,), rounds=30, warmup_rounds=2)
    assert grid.heat() == pytest.approx(float(np.sum(start)) / n**2, rel=1e-9)


def test_cloth_nodes(benchmark):
    benchmark.group = "10,000 nodes that burn"
    side = 100 if benchmark.enabled else 8
    index = np.arange(side * side).reshape(side, side)
    links = np.concatenate([
        np.stack([index[:, :-1].ravel(), index[:, 1:].ravel()], 1),
        np.stack([index[:-1].ravel(), index[1:].ravel()], 1),
    ])  # fmt: skip
    cloth = BurningBodies(side * side, links, 1e-3, rest=0.01, fuel=1e-5, area=1e-5)
    cloth.temperature[:side] = 900.0
    benchmark.pedantic(cloth.step, (1.0 / 60.0,), rounds=30, warmup_rounds=2)
    assert np.all(np.isfinite(cloth.temperature))


def test_flames(benchmark):
    benchmark.group = "256 x 128 cells that burn"
    cells = np.zeros((128, 256, 5))
    cells[..., 1], cells[..., 3] = np.random.default_rng(2).uniform(300.0, 1400.0, (128, 256)), 0.27
    cells[..., 2], cells[..., 4] = 0.01, 1e-4
    flames, source = Flames((1, 2, 3, 4), 0.01), np.zeros((128, 256))
    benchmark.pedantic(flames.step, (cells, 1.0 / 60.0, source), rounds=30, warmup_rounds=2)
    assert flames.books_now().burnt > 0.0


def test_veil(benchmark):
    benchmark.group = "smoke and flames over 1280 x 720"
    x = np.tile(np.arange(256) / 128.0, (128, 1))
    veil = np.stack([np.clip(0.5 * np.sin(5.0 * x), 0, 1), np.exp(-(((x - 1.0) / 0.2) ** 2))], axis=2)
    table = shade_table([(0.0, pygame.Color(0, 0, 0)), (1.0, pygame.Color(240, 120, 30))])
    surface, room = pygame.Surface((1280, 720), 0, 32), veil_room(1280)
    arguments = (pixels_of(surface), clip_of(surface), veil.astype(np.float32))
    box = np.array((0.0, 0.0, 1280.0, 720.0))
    benchmark.pedantic(paint_veil, (*arguments, box, 0x808080, table, room, True), rounds=20, warmup_rounds=2)
    assert surface.get_at((640, 300)) != (0, 0, 0, 255)
