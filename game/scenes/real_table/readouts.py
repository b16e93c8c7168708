"""What the real table measures: how far the cue ball of each model is off its track at this moment."""

from __future__ import annotations

import numpy as np

from game.scenes.real_table.comparison import MODELS
from game.scenes.real_table.model import RealTableModel
from game.stage import Readout


def off_now(model: RealTableModel, name: str) -> float:
    """Distance of the cue ball from its latest sample at the time of that sample, m; 0 if not played."""
    played = model.compared.models.get(name)
    if played is None:
        return 0.0
    at = int(np.searchsorted(model.shot.tracks[0].times, model.time, side="right")) - 1
    return float(played.errors[0][max(at, 0)])


def readouts_of(model: RealTableModel) -> tuple[Readout, ...]:
    """What is shown and charted."""
    best = model.compared.models.get("han")
    return (
        Readout("track", min(model.time, model.shot.end_time), "s"),
        *(Readout(name, off_now(model, name), "m") for name in MODELS),
        Readout("rmse cue ball", 0.0 if best is None else best.rmse_cue, "m"),
        Readout("rmse all balls", 0.0 if best is None else best.rmse_all, "m"),
        Readout("samples", sum(len(track.times) for track in model.shot.tracks)),
    )
