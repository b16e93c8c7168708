"""What the three tables measure: how far they are apart, energy and events of the shot."""

from __future__ import annotations

import numpy as np

from game.scenes.three_tables.model import ThreeTablesModel
from game.stage import Readout

APART = ("lecture", "stepped", "perturbed")  # tables that are compared with the exact one
LEAST = 1e-17  # m; what the logarithm of no difference at all is taken from


def difference_now(model: ThreeTablesModel, name: str) -> float:
    """Largest distance of a ball to its place on the exact table at this moment, m."""
    if name not in model.played.tables or not model.playing:
        return 0.0
    return model.differences_until(model.shown_s)[name][-1]


def readouts_of(model: ThreeTablesModel) -> tuple[Readout, ...]:
    """What is shown and charted."""
    time, playing = model.shown_s, model.playing
    moving = model.played.tables["exact"].state_at(time).velocities
    masses = model.masses[model.in_play]
    energy = float((0.5 * masses * (moving * moving).sum(axis=1)).sum()) if playing else 0.0
    done = int(np.searchsorted(model.played.event_times, time, side="right")) if playing else 0
    apart = [name for name in APART if name in model.played.tables]
    return (
        Readout("events", done),
        Readout("difference", difference_now(model, "stepped"), "m"),
        Readout("shot", time, "s"),
        Readout("energy", energy, "J"),
        *(Readout(name, difference_now(model, name), "m") for name in apart),
        Readout("strokes", model.strokes),
    )
