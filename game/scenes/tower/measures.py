"""What is measured of the tower: what stands, what has come down, how fast, and what the law says of it."""

from __future__ import annotations

import math

import numpy as np

from game.physics.accretion import strike_times
from game.scenes.tower.building import columns_mass, floor_height, slab_mass
from game.scenes.tower.model import TowerModel
from game.scenes.tower.tables import BODY, COLUMN, CUT, KIND, NOT_YET, STOREY, STRUCK


def pieces_of(model: TowerModel) -> int:
    """How many parts there are."""
    return int(np.count_nonzero(model.parts[:, BODY] >= 0.0))


def mass_of(model: TowerModel) -> float:
    """kg, of all that is in the world, by the solver's own numbers."""
    bodies = model.parts[model.parts[:, BODY] >= 0.0, BODY].astype(np.int64)
    return math.fsum((1.0 / model.world.bodies.inverse_masses[bodies]).tolist())


def standing(model: TowerModel) -> int:
    """Storeys whose columns are all there."""
    whole = (model.parts[:, KIND] == COLUMN) & (model.parts[:, BODY] >= 0.0)
    counts = np.bincount(model.parts[whole, STOREY].astype(np.int64), minlength=model.content.storeys + 1)
    return int(np.count_nonzero(counts[1:] == model.content.bays + 1))


def struck(model: TowerModel) -> int:
    """Floors below the charges that have been struck."""
    return int(np.count_nonzero(model.storeys[: model.first_storey() - 1, STRUCK] != NOT_YET))


def fall_of(model: TowerModel) -> tuple[float, float, float]:
    """s from the last cut of the first storey to the last floor struck, s by the law, m the front fell.

    NaN before any floor was struck, and without gravity.
    """
    first, content = model.first_storey(), model.content
    begun, count = model.storeys[first - 1, CUT], struck(model)
    if begun == NOT_YET or not count or model.gravity() <= 0.0:
        return math.nan, math.nan, math.nan
    begun += model.parameters.delay * content.bays
    floor, above = slab_mass(content), content.storeys - first
    moving, drop = floor + above * (floor + columns_mass(content)), content.storey - content.slab
    law = strike_times(moving, [floor] * count, drop, model.gravity())
    return float(model.storeys[: first - 1, STRUCK].max() - begun), law[-1], drop * count


def front_of(model: TowerModel) -> tuple[float, float]:
    """Where the floors meet now, m."""
    first = model.first_storey()
    storey = max(first - struck(model), 0) if model.storeys[first - 1, CUT] != NOT_YET else first
    return 0.0, floor_height(model.content, storey)


def roof_of(model: TowerModel) -> float:
    """Height (m) of the highest part."""
    bodies = model.parts[model.parts[:, BODY] >= 0.0, BODY].astype(np.int64)
    return float(model.world.bodies.positions[bodies, 1].max())
