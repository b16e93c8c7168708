"""What is measured of a network: how far its links are off, its energy, its areas."""

from __future__ import annotations

import numpy as np

from game.physics.constraints.areas import INTACT
from game.scenes.springs.model import SpringModel
from game.stage import Readout

ROUNDING = 1e-12  # strains and lengths (m) up to this are shown as none


def readouts(model: SpringModel) -> list[Readout]:
    """All that both scenes measure."""
    system = model.system
    kinetic, potential = system.energy()
    links = system.measure()
    elastic = links.energy if model.law.model == "xpbd" else 0.0
    settings = system.settings
    projections = len(system.torn) * settings.iterations * settings.substeps
    return [
        Readout("particles", system.count),
        Readout("links", int(len(system.torn) - system.torn.sum())),
        Readout("worst", _above_rounding(links.worst_strain)),
        Readout("overall", _above_rounding(links.length_ratio - 1.0)),
        Readout("residual", _above_rounding(links.mean_excess), "m"),
        Readout("kinetic", kinetic, "J"),
        Readout("potential", potential, "J"),
        Readout("elastic", elastic, "J"),
        Readout("sum", kinetic + potential + elastic, "J"),
        Readout("torn", int(system.tears)),
        *_beside(model),
        Readout("projections a step", int(projections)),
    ]


def _beside(model: SpringModel) -> list[Readout]:
    """The greatest stretch of each network that is solved beside."""
    pairs = zip(model.content.beside, model.beside, strict=False)
    return [
        Readout(f"{entry.label} worst", _above_rounding(system.measure().worst_strain))
        for entry, system in pairs
    ]


def area_kept(model: SpringModel) -> Readout:
    """Area within all whole outlines, over what it is at rest."""
    now, rest = model.system.areas()
    whole = model.system.outlines.rows[INTACT] > 0.0
    total = float(np.abs(rest[whole]).sum())
    return Readout("area kept", float(np.abs(now[whole]).sum()) / total if total > 0.0 else 1.0)


def _above_rounding(value: float) -> float:
    """A measured error, 0 where it is rounding."""
    return value if abs(value) > ROUNDING else 0.0
