"""What is measured of the tower: what stands, what has come down, how fast, and what the law says of it."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.accretion import strike_times
from game.scenes.tower.building import COLUMN, NOT_YET, columns_mass, floor_height, slab_mass
from game.scenes.tower.world import TowerWorld


def mass_of(model: TowerWorld) -> float:
    """kg, of everything in the world, by the solver's own numbers."""
    return math.fsum((1.0 / model.world.bodies.inverse_masses[model.frame.bodies()]).tolist())


def standing(model: TowerWorld) -> int:
    """Storeys whose columns are all there."""
    storeys = model.frame.parts.storey[model.frame.rows((COLUMN,))]
    counts = np.bincount(storeys, minlength=model.content.storeys + 1)
    return int(np.count_nonzero(counts[1:] == model.content.bays + 1))


def struck(model: TowerWorld) -> int:
    """Floors below the charges that have been struck."""
    return len(strikes_of(model))


def fall_of(model: TowerWorld) -> tuple[float, float, float]:
    """s from when nothing carried what falls to the last floor struck, s by the law, m the front fell.

    The law begins at the same moment, with the speed and the way that were measured then: while the charges
    go off one after the other, the columns that are left still carry some. NaN before any floor was struck,
    and without gravity.
    """
    first, content, count = model.first_storey(), model.content, struck(model)
    begun, speed, way = model.course.freed
    if begun == NOT_YET or not count or model.gravity() <= 0.0:
        return math.nan, math.nan, math.nan
    floor, above = slab_mass(content), content.storeys - first
    moving, drop = floor + above * (floor + columns_mass(content)), drop_of(model)
    if way >= drop:
        return math.nan, math.nan, math.nan
    law = strike_times(moving, [floor] * count, drop, model.gravity(), speed, way)
    return float(strikes_of(model).max() - begun), law[-1], drop * count - way


def drop_of(model: TowerWorld) -> float:
    """m that a floor falls until it strikes the next."""
    return model.content.storey - model.content.slab


def strikes_of(model: TowerWorld) -> Floats:
    """s at which floors below the charges were struck, in the order of time."""
    times = model.frame.storeys.struck[: model.first_storey() - 1]
    return np.sort(times[times != NOT_YET])


def paces_of(model: TowerWorld) -> Floats:
    """m/s of the front, the mean from each floor to the next, the first from where it was freed."""
    begun, _, way = model.course.freed
    strikes = strikes_of(model)
    if begun == NOT_YET or not len(strikes):
        return np.zeros(0)
    ways = np.full(len(strikes), drop_of(model))
    ways[0] -= way
    return np.asarray(ways / np.diff(strikes, prepend=begun))


def free_fall_of(model: TowerWorld) -> float:
    """s that the way of the front would take in free fall, from the same start; NaN as `fall_of`."""
    _, law, way = fall_of(model)
    if not math.isfinite(law):
        return math.nan
    speed, gravity = model.course.freed.speed, model.gravity()
    return (math.sqrt(speed * speed + 2.0 * gravity * way) - speed) / gravity


def front_of(model: TowerWorld) -> tuple[float, float]:
    """Where the floors meet now, m."""
    first = model.first_storey()
    storey = max(first - struck(model), 0) if model.frame.storeys.cut[first - 1] != NOT_YET else first
    return 0.0, floor_height(model.content, storey)


def roof_of(model: TowerWorld) -> float:
    """Height (m) of the highest part."""
    return float(model.world.bodies.positions[model.frame.bodies(), 1].max())
