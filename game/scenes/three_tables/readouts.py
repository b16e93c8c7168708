"""What the three tables measure: how far they lie apart, energy and events of the shot."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.scenes.three_tables.state import PLAYING, STROKES
from game.stage import Readout

if TYPE_CHECKING:
    from game.scenes.three_tables.scene import ThreeTables

LEAST = 1e-17  # m; what the logarithm of no difference at all is taken from


def difference_now(scene: ThreeTables, name: str) -> float:
    """Largest distance of a ball to its place on the exact table at this moment, m."""
    if name not in scene.played.tables or not scene.shot[PLAYING]:
        return 0.0
    return scene.differences_until(scene.shown_s)[name][-1]


def readouts_of(scene: ThreeTables) -> tuple[Readout, ...]:
    """All that is shown and charted."""
    time, playing = scene.shown_s, bool(scene.shot[PLAYING])
    moving = scene.played.tables["exact"].state_at(time).velocities
    masses = scene.masses[scene.in_play]
    energy = float((0.5 * masses * (moving * moving).sum(axis=1)).sum()) if playing else 0.0
    done = int(np.searchsorted(scene.played.event_times, time, side="right")) if playing else 0
    logs = {
        name: math.log10(max(difference_now(scene, name), LEAST))
        for name in ("lecture", "stepped", "perturbed")
    }
    return (
        Readout("events", done),
        Readout("difference", difference_now(scene, "stepped"), "m"),
        Readout("shot", time, "s"),
        Readout("energy", energy, "J"),
        *(Readout(name, value, "log10 m") for name, value in logs.items()),
        Readout("strokes", scene.shot[STROKES]),
    )
