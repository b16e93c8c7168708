"""Burning gas as it is seen: hot soot shines, cold soot is smoke."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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


def paint_veil(
    look: FlameLook, temperature: Floats, soot: Floats, edge: Floats, veil: NDArray[np.float32]
) -> None:
    """veil (ny, nx, 2), written: how thick the smoke and how bright the flames are, 0 to 1."""
    soot = np.maximum(soot, 0.0)
    warm = np.clip((temperature - look.glows) / (look.brightest - look.glows), 0.0, 1.0)
    veil[..., 1] = warm * (look.bare + (1.0 - look.bare) * np.minimum(soot / look.shining, 1.0)) * edge
    veil[..., 0] = np.minimum(soot / look.thick, look.most) * (1.0 - np.minimum(2.0 * warm, 1.0)) * edge


def flame_height(look: FlameLook, temperature: Floats, cell: float) -> float:
    """m, of the highest row of gas that is seen to burn; cell: m."""
    rows = np.flatnonzero(np.max(temperature, axis=1) > look.burns)
    return float(rows[-1] + 1) * cell if len(rows) else 0.0
