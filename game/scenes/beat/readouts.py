"""Numbers of the beat and of the shot that meets it."""

from __future__ import annotations

import math

from game.scenes.beat.model import BeatModel
from game.stage import Readout


def readouts_of(model: BeatModel) -> tuple[Readout, ...]:
    """How well the impacts meet the beats."""
    shown = model.shown
    count = Readout("beats", len(model.beats))
    if shown is None:
        return (count, Readout("error", math.nan, "s"), Readout("largest error", math.nan, "s"),
                Readout("impacts", math.nan), Readout("off the beat", math.nan),
                Readout("after the last beat", math.nan))  # fmt: skip
    found = shown.rhythm
    return (
        count,
        Readout("error", found.error_s, "s"),
        Readout("largest error", max(map(abs, found.misses)), "s"),
        Readout("impacts", len(found.impacts)),
        Readout("off the beat", found.extras),
        Readout("after the last beat", shown.after),
    )
