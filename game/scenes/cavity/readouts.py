"""What is measured of the flow in a cavity, and how far it is from what is known."""

from __future__ import annotations

import numpy as np

from game.scenes.cavity.model import CavityModel
from game.scenes.cavity.published import EXTREMES, NUSSELT, known_number
from game.stage import Readout


def readouts_of(model: CavityModel) -> tuple[Readout, ...]:
    """Speeds on the centre lines, errors against the literature where there is one, the solver's work."""
    chosen, gas = model.parameters, model.gas
    found = model.extremes()
    error, nusselt, heat_error = 0.0, 0.0, 0.0
    if model.heated:
        nusselt = model.nusselt()
        known = known_number(chosen.rayleigh, NUSSELT)
        heat_error = 100.0 * (nusselt / NUSSELT[known] - 1.0) if known else 0.0
    else:
        known = known_number(chosen.number, EXTREMES)
        if known and chosen.lid > 0.0:
            error = 100.0 * max(abs(a / b - 1.0) for a, b in zip(found, EXTREMES[known], strict=True))
    return (
        Readout("least u", found[0], ""),
        Readout("most v", found[1], ""),
        Readout("least v", found[2], ""),
        Readout("error", error, "%"),
        Readout("Nusselt", nusselt, ""),
        Readout("Nusselt error", heat_error, "%"),
        Readout("change", float(model.clock[1]), "m/s²"),
        Readout("energy", gas.energy(), "m⁴/s²"),
        Readout("fastest", float(max(np.max(np.abs(gas.u)), np.max(np.abs(gas.v)))), "m/s"),
        Readout("volume error", gas.report.after, ""),
        Readout("solver turns", gas.report.turns),
        Readout("gas time", gas.time, "s"),
    )
