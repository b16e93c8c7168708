"""What a hand does to smoke about a point: stir it, paint dye or fire into it, or clear air."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary
from game.scenes.smoke import model as m
from game.scenes.smoke.model import SmokeModel

Place = tuple[float, float]  # m


def _share(places: tuple[Floats, Floats], point: Place, radius: float) -> Floats:
    """Of the brush at places: 1 in its middle, 0 from its radius (m) on."""
    x, y = places
    away = (elementary.square(x - point[0]) + elementary.square(y - point[1])) / (radius * radius)
    return np.asarray(elementary.square(np.clip(1.0 - away, 0.0, None)))


def stir(model: SmokeModel, point: Place, way: tuple[float, float]) -> None:
    """Push the gas about a point by a velocity, m/s."""
    grid, radius = model.grid, model.parameters.brush
    if model.gas is not None:
        u, v = model.gas.u, model.gas.v
        u += way[0] * _share(grid.u_places(), point, radius)
        v += way[1] * _share(grid.v_places(), point, radius)
        model.gas.jolt()
    elif model.printed is not None:
        share = _share(grid.centres(), point, radius)
        u, v, _ = model.printed.inner
        u += way[0] * share
        v += way[1] * share


def paint(model: SmokeModel, point: Place, what: str) -> None:
    """Dye of the chosen colour ("dye"), fire, or clear air about a point."""
    share = _share(model.grid.centres(), point, model.parameters.brush)
    column = model.column(model.parameters.dye) if what == "dye" else m.SMOKE
    cells = model.scalars  # after the column, which may be new
    if what == "dye":
        cells[..., column] = np.maximum(cells[..., column], np.minimum(1.0, 1.6 * share))
    elif what == "fire":
        cells[..., m.FUEL] += 0.03 * share
        cells[..., m.WARM] = np.maximum(cells[..., m.WARM], m.ROOM + 900.0 * np.minimum(1.0, 1.5 * share))
    else:
        cells[share > 0.05] = model.fresh()
