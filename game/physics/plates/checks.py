"""What plates take from outside, checked: settings, walls, any wind."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.plates import flight
from game.physics.plates.contacts import WALL
from game.physics.surfaces.sample_fields import Field

LARGEST = 1e7  # m, m/s


class PlateSettings(NamedTuple):
    """gravity m/s² downwards; floor: height of the ground m; friction with it and with one another."""

    gravity: float = 9.81
    floor: float = 0.0
    friction: float = 0.5


def checked_settings(settings: PlateSettings) -> PlateSettings:
    """The settings; ValueError, naming the field, for nonsense."""
    for name, low, high in (("gravity", -1e4, 1e4), ("floor", -LARGEST, LARGEST), ("friction", 0.0, 100.0)):
        if not low <= getattr(settings, name) <= high:
            raise ValueError(f"{name} = {getattr(settings, name)!r}: expected {low:g} to {high:g}")
    return settings


def checked_walls(walls: ArrayLike) -> Floats:
    """Segments (m, 6): ends m, radius m, friction."""
    rows = np.array(walls, dtype=np.float64)
    if not rows.size:
        return np.zeros((0, WALL))
    if rows.ndim != 2 or rows.shape[1] not in (4, 6) or not np.isfinite(rows).all():
        raise ValueError("walls: expected segments (m, 4) or (m, 6) of finite numbers")
    if rows.shape[1] == 4:
        rows = np.concatenate([rows, np.tile((0.002, 0.5), (len(rows), 1))], axis=1)
    if (rows[:, 4:] < 0.0).any():
        raise ValueError("walls: expected radius and friction of 0 or more")
    return np.ascontiguousarray(rows)


def slopes_of(field: Field, places: Floats, time: float, air: Floats, reach: float = 1e-3) -> None:
    """Write (WIND, n) of any field of two columns at places (2, n) m by differences over ``reach``."""
    where = np.ascontiguousarray(places.T)
    across, up = np.array([reach, 0.0]), np.array([0.0, reach])
    here = field.sample(where, time)
    if here.shape[1:] != (2,):
        raise ValueError("wind: expected a field of two columns, m/s")
    by_x = (field.sample(where + across, time) - field.sample(where - across, time)) / (2.0 * reach)
    by_y = (field.sample(where + up, time) - field.sample(where - up, time)) / (2.0 * reach)
    by_t = (field.sample(where, time + reach) - field.sample(where, time - reach)) / (2.0 * reach)
    air[flight.WX], air[flight.WY] = here.T
    air[flight.WX_X], air[flight.WY_X] = by_x.T
    air[flight.WX_Y], air[flight.WY_Y] = by_y.T
    air[flight.WX_T], air[flight.WY_T] = by_t.T
