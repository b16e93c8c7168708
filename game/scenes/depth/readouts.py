"""What is measured of two shapes that overlap."""

from __future__ import annotations

import math

from game.physics.kernels import elementary
from game.scenes.depth.model import DepthModel
from game.stage import Readout


def readouts_of(model: DepthModel) -> tuple[Readout, ...]:
    """Both depths, the motion of the shorter one, and what finding it took."""
    slide, found, checked = model.slide, model.found, model.checked
    saved = 100.0 * (1.0 - found.sigma / slide.sigma) if slide.sigma > 0.0 else 0.0
    rows = (
        Readout("translation", slide.sigma, "m"),
        Readout("generalised", found.sigma, "m"),
        Readout("shorter by", saved, "%"),
        Readout("turn", math.degrees(found.angle), "°"),
        Readout("displacement", elementary.hypot(found.x, found.y), "m"),
        Readout("left uncertain", found.sigma - found.certain, "m"),
        Readout("angles tried", found.evaluations),
        Readout("query", model.watch.median("query"), "s"),
    )
    if checked is None:
        return rows
    return (*rows, Readout("brute force", checked.sigma, "m"), Readout("motions tested", checked.evaluations))
