"""Dust: puffs that spring up where something strikes, slow down in the air, spread, settle.

Their velocity goes over to that of the air at a rate, implicitly, which is at rest unless it is computed (see
`air`); a puff grows as the square root of its age, as what mixes does. They show the dust; its mass is in the
air's cells.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from game.arrays import Floats
from game.physics.kernels import linear
from game.scenes.tower import tables

MOST = 900
DRAG = 1.1  # 1/s
SINK = 0.12  # m/s


def puffs(places: Floats, speeds: Floats, size: float, life: float, random: np.random.Generator) -> Floats:
    """New ones at places (n, 2) m with velocities (n, 2) m/s, each a little different."""
    count = len(places)
    found = np.zeros((count, tables.DUST_WIDTH))
    found[:, [tables.DX, tables.DY]] = places
    found[:, [tables.DVX, tables.DVY]] = speeds * linear.uniform(
        random, 0.3, 1.0, (count, 1)
    ) + linear.uniform(random, -0.6, 0.6, (count, 2))
    found[:, tables.LIFE] = life * linear.uniform(random, 0.6, 1.3, count)
    found[:, tables.SIZE] = size * linear.uniform(random, 0.6, 1.5, count)
    return found


def advance_dust(dust: Floats, dt: float, wind: Callable[[Floats], Floats] | None = None) -> Floats:
    """All of them a step later; those that have settled are gone, and the oldest if there are too many.

    wind: velocity (n, 2) m/s of the air at places (n, 2) m.
    """
    if not len(dust):
        return dust
    now = dust.copy()
    if wind is not None:
        now[:, [tables.DVX, tables.DVY]] += DRAG * dt * wind(dust[:, [tables.DX, tables.DY]])
    now[:, [tables.DVX, tables.DVY]] /= 1.0 + DRAG * dt
    now[:, tables.DVY] -= DRAG * SINK * dt
    now[:, [tables.DX, tables.DY]] += dt * now[:, [tables.DVX, tables.DVY]]
    now[:, tables.DY] = np.maximum(now[:, tables.DY], 0.3)
    now[:, tables.AGE] += dt
    return now[now[:, tables.AGE] < now[:, tables.LIFE]][-MOST:]
