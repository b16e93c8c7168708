"""What is measured of grains in a sound field."""

from __future__ import annotations

import numpy as np

from game.physics.kernels import elementwise
from game.scenes.levitation.model import APART, LevitationModel
from game.stage import Readout


def readouts_of(model: LevitationModel) -> tuple[Readout, ...]:
    """How many are carried, how far the nearest is from the focus, and how strong the trap is."""
    levitator = model.levitator
    held = model.held()
    away = elementwise.hypot(*(levitator.positions - levitator.place).T)
    behind = float(np.min(away, initial=APART))
    across, upright = model.strongest()
    return (
        Readout("carried", int(np.count_nonzero(held))),
        Readout("fallen", int(np.count_nonzero(~held))),
        Readout("focus speed", float(levitator.focus[1]), "m/s"),
        Readout("off the focus", behind, "m"),
        Readout("fastest", model.fastest(), "m/s"),
        Readout("sideways", across, "weights"),
        Readout("upright", upright, "weights"),
        Readout("drag limit", model.escape_speed(min(across, upright)), "m/s"),
    )
