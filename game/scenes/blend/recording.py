"""Runs of the liquid as they are recorded, and as the same liquid would run with numbers in between."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from game.arrays import Floats
from game.physics.grid.layout import Grid
from game.physics.liquid import Liquid
from game.physics.liquid.distances import Run, run_of
from game.physics.solids import SolidSettings, SolidWorld, box
from game.physics.surfaces import SolidSurface
from game.scenes.blend.level import RunEntry, WaterEntry

FRAME = 1.0 / 30.0  # s from picture to picture
GRAVITY = 9.81  # m/s²
FILLED = 6  # turns in which the liquid's fill goes on into a wall


def speed_of_time(tank: tuple[float, float]) -> float:
    """m/s: how much of place a second counts for, where places in time are compared."""
    return math.sqrt(GRAVITY * tank[1])


@lru_cache(maxsize=32)
def recorded(entry: RunEntry, tank: tuple[float, float], cells: int) -> Run:
    """The run at half of the resolution at which it is computed."""
    half = max(2, round(0.5 * cells))
    cell = tank[0] / (2 * half)
    grid = Grid(2 * half, 2 * max(1, round(0.5 * tank[1] / cell)), cell)
    liquid = Liquid(grid, most=8 * grid.nx * grid.ny)
    inside = np.zeros((grid.ny, grid.nx), dtype=bool)
    if entry.width > 0.0 and entry.height > 0.0:
        world = SolidWorld(SolidSettings())
        world.add_body(box(entry.width, entry.height), (entry.at, 0.5 * entry.height), 0.0, kind="fixed")
        liquid.set_solids(SolidSurface(world))
        x, y = (np.arange(grid.nx) + 0.5) * cell, (np.arange(grid.ny) + 0.5) * cell
        inside = (np.abs(x - entry.at) < 0.5 * entry.width)[None, :] & (y < entry.height)[:, None]
    for water in entry.water:
        liquid.add(_places(liquid, water), (0.0, -water.speed))
    pictures = []
    for frame in range(max(2, round(entry.seconds / FRAME) + 1)):
        if frame:
            for _ in range(2):
                liquid.advance(0.5 * FRAME)
        liquid.refresh()
        pictures.append(_at_nodes(np.minimum(liquid.cells.fill, 1.0), inside))
    return run_of(np.stack(pictures), (FRAME * speed_of_time(tank), 2.0 * cell, 2.0 * cell))


def _places(liquid: Liquid, water: WaterEntry) -> Floats:
    if water.radius == 0.0:
        return liquid.lattice(water.low, water.high)
    (x, y), radius = water.low, water.radius
    places = liquid.lattice((x - radius, y - radius), (x + radius, y + radius))
    return places[np.sum(np.square(places - (x, y)), axis=1) < radius * radius]


def _at_nodes(fill: Floats, inside: np.ndarray) -> Floats:
    """Means of the four cells about every second corner; a wall takes over what is beside it."""
    if inside.any():
        fill = np.where(inside, 0.0, fill)
        known = ~inside
        for _ in range(max(FILLED, int(np.max(np.sum(inside, axis=0))))):
            wide, sure = (
                np.pad(fill * known, 1, mode="edge"),
                np.pad(known, 1, mode="edge").astype(np.float64),
            )
            total = wide[2:, 1:-1] + wide[1:-1, 2:] + wide[1:-1, :-2]
            many = sure[2:, 1:-1] + sure[1:-1, 2:] + sure[1:-1, :-2]
            fill = np.where(inside, total / np.maximum(many, 1.0), fill)
            known = known | (many > 0.0)
    wide = np.pad(fill, 1, mode="edge")
    return 0.25 * (wide[:-1:2, :-1:2] + wide[1::2, :-1:2] + wide[:-1:2, 1::2] + wide[1::2, 1::2])


def between(runs: Sequence[RunEntry], weights: Sequence[float]) -> RunEntry:
    """The run with the weighted mean of all numbers. ValueError for runs with unlike water."""
    if len({len(run.water) for run in runs}) > 1:
        raise ValueError("runs: expected as many boxes and drops of water in each")

    def mean(values: Sequence[float]) -> float:
        return sum(weight * value for weight, value in zip(weights, values, strict=True))

    water = tuple(
        WaterEntry(
            low=(mean([one.low[0] for one in same]), mean([one.low[1] for one in same])),
            high=(mean([one.high[0] for one in same]), mean([one.high[1] for one in same])),
            radius=mean([one.radius for one in same]),
            speed=mean([one.speed for one in same]),
        )
        for same in zip(*(run.water for run in runs), strict=True)
    )
    return RunEntry(
        water=water, at=mean([run.at for run in runs]), width=mean([run.width for run in runs]),
        height=mean([run.height for run in runs]), seconds=mean([run.seconds for run in runs]),
    )  # fmt: skip
