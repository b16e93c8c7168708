"""What a breeze gives a cloth, node by node, against a plain twin."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.cloth import Breeze
from game.physics.cloth.layout import INVERSE, NODE_ROWS, THERE, VX, VZ, X, Y, Z
from game.physics.cloth.sheet import blow_on

NY, NX = 3, 4
BREEZE = Breeze(-1.0, -0.5, 0.5, 0.7, 0.4, 3.0, 0.9, 0.3, 0.05)


def blown(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    nodes = np.zeros((NODE_ROWS, NY, NX))
    nodes[X] = 0.4 * np.arange(NX)[None] + 0.1 * random.standard_normal((NY, NX))
    nodes[Y] = 1.0 - 0.4 * np.arange(NY)[:, None] + 0.1 * random.standard_normal((NY, NX))
    nodes[Z] = 0.2 * random.standard_normal((NY, NX))
    nodes[VX : VZ + 1] = random.standard_normal((3, NY, NX))
    nodes[INVERSE] = 5.0 + 20.0 * random.random((NY, NX))
    nodes[INVERSE, 0, 0] = 0.0
    nodes[THERE] = random.random((NY, NX)) < 0.8
    nodes[X, 2, 3], nodes[Y, 2, 3] = 40.0, -40.0  # far beyond the gas
    return nodes, random.standard_normal((4, 6)), random.standard_normal((5, 5))


def normal(nodes: np.ndarray, j: int, i: int) -> np.ndarray:
    def beside(b: int, a: int) -> tuple[int, int]:
        b, a = min(max(b, 0), NY - 1), min(max(a, 0), NX - 1)
        return (b, a) if nodes[THERE, b, a] > 0.0 else (j, i)

    def place(at: tuple[int, int]) -> np.ndarray:
        return nodes[(slice(X, Z + 1), *at)]

    right = place(beside(j, i + 1)) - place(beside(j, i - 1))
    up = place(beside(j - 1, i)) - place(beside(j + 1, i))
    found = np.cross(right, up)
    length = float(np.linalg.norm(found))
    return found / length if length > 1e-12 else np.array([0.0, 0.0, 1.0])


@pytest.mark.parametrize("seed", range(4))
def test_air_pushes_by_its_part_across_and_brushes_along_and_never_overtakes(seed):
    nodes, u, v = blown(seed)
    before, area, dt = nodes.copy(), 0.16, 0.02
    blow_on(nodes, u, v, BREEZE, area, dt)
    for j in range(NY):
        for i in range(NX):
            if (j, i) == (0, 0):
                continue
            x, y, _ = before[X : Z + 1, j, i]
            column = int(np.clip(int((x + 1.0) / 0.5), 0, 4))
            row = int(np.clip(int((y + 0.5) / 0.5), 0, 3))
            wave = math.sin(3.0 * (x + 0.6 * y) - 0.9)
            air = np.array(
                [u[row, column : column + 2].mean(), v[row : row + 2, column].mean(), 0.7 + 0.4 * wave]
            )
            slip = air - before[VX : VZ + 1, j, i]
            n = normal(before, j, i)
            across = float(slip @ n)
            along = slip - across * n
            light = before[INVERSE, j, i]
            strong = 0.3 * area * light * abs(across) * dt
            weak = 0.05 * area * light * float(np.linalg.norm(along)) * dt
            gained = strong / (1.0 + strong) * across * n + weak / (1.0 + weak) * along
            assert nodes[VX : VZ + 1, j, i] - before[VX : VZ + 1, j, i] == pytest.approx(gained, abs=1e-12)
    untouched = [row for row in range(NODE_ROWS) if not VX <= row <= VZ]
    assert np.array_equal(nodes[untouched], before[untouched])
    assert np.array_equal(nodes[:, 0, 0], before[:, 0, 0])
