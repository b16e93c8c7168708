"""What is measured of the flow in a cavity, and how far it is from what is known."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.scenes.cavity.model import CavityModel
from game.scenes.cavity.published import EXTREMES, NUSSELT, known_number
from game.stage import Readout


def readouts_of(model: CavityModel) -> tuple[Readout, ...]:
    """Speeds on the centre lines, the error against the literature where there is one, the solver's work."""
    gas = model.gas
    found = model.extremes()
    nusselt = model.nusselt() if model.heated else 0.0
    return (
        Readout("least u", found[0], ""),
        Readout("most v", found[1], ""),
        Readout("least v", found[2], ""),
        *_errors(model, found, nusselt),
        Readout("Nusselt", nusselt, ""),
        Readout("change", float(model.clock[1]), "m/s²"),
        Readout("energy", gas.energy(), "m⁴/s²"),
        Readout("fastest", float(max(np.max(np.abs(gas.u)), np.max(np.abs(gas.v)))), "m/s"),
        Readout("volume error", gas.report.after, ""),
        Readout("solver turns", gas.report.turns),
        Readout("gas time", gas.time, "s"),
    )


def _errors(model: CavityModel, extremes: Sequence[float], nusselt: float) -> tuple[Readout, ...]:
    """How far the flow is from the literature, %: of the Nusselt number, or of the worst of three extremes.

    Empty for numbers of which nothing is published here, and for a lid that stands or goes back.
    """
    chosen = model.parameters
    if model.heated:
        known = known_number(chosen.rayleigh, NUSSELT)
        if known is None:
            return ()
        off = 100.0 * (nusselt / NUSSELT[known] - 1.0)
        return Readout("error", abs(off), "%"), Readout("Nusselt error", off, "%")
    known = known_number(chosen.number, EXTREMES)
    if known is None or chosen.lid <= 0.0:
        return ()
    away = (abs(a / b - 1.0) for a, b in zip(extremes, EXTREMES[known], strict=True))
    return (Readout("error", 100.0 * max(away), "%"),)
