"""Burning gas as it is seen: hot soot shines, cold soot is smoke."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel

Floats = NDArray[np.float64]


class FlameLook(NamedTuple):
    """When gas is seen. glows, brightest: K from which it begins to, and is; bare: brightness of hot gas
    without soot; shining: kg/m³ of soot with which a flame is seen in full; thick: kg/m³ of soot over which
    smoke would hide all, and most: what it hides at most; burns: K from which gas counts as flame.
    """

    glows: float
    brightest: float
    bare: float
    shining: float
    thick: float
    most: float
    burns: float


@lean_kernel
def see_gas(look: Any, temperature: Any, soot: Any, edge: Any, veil: Any) -> None:
    """veil (ny, nx, 2) float32, written: how thick the smoke and how bright the flames are, 0 to 1.

    temperature K, soot kg/m³, edge: share that is seen of each cell; all (ny, nx).
    """
    for j in range(veil.shape[0]):
        for i in range(veil.shape[1]):
            there = max(soot[j, i], 0.0)
            warm = min(max((temperature[j, i] - look.glows) / (look.brightest - look.glows), 0.0), 1.0)
            full = look.bare + (1.0 - look.bare) * min(there / look.shining, 1.0)
            veil[j, i, 1] = warm * full * edge[j, i]
            thick = min(there / look.thick, look.most)
            veil[j, i, 0] = thick * (1.0 - min(2.0 * warm, 1.0)) * edge[j, i]


def warm_up_gas() -> None:
    """Compile what gas is seen by."""
    cells, veil = np.zeros((2, 2, 5)), np.zeros((2, 2, 2), np.float32)
    look = FlameLook(1.0, 2.0, 0.5, 1.0, 1.0, 1.0, 1.0)
    see_gas(look, cells[..., 0], cells[..., 3], np.ones((2, 2)), veil)


def flame_height(look: FlameLook, temperature: Floats, cell: float) -> float:
    """m, of the highest row of gas that is seen to burn; cell: m."""
    rows = np.flatnonzero(np.max(temperature, axis=1) > look.burns)
    return float(rows[-1] + 1) * cell if len(rows) else 0.0
