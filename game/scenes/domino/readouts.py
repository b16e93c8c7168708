"""What is measured in the world of dominoes, beside what theory says."""

from __future__ import annotations

import math

from game.physics.dominoes import stopping_distance
from game.physics.kernels import elementary
from game.scenes.domino.course import height_at
from game.scenes.domino.model import QUIET, DominoModel
from game.scenes.domino.tables import (
    BODY,
    SLIDER_BODY,
    SLIDER_MU,
    SLIDER_SPEED,
    SLIDER_WAY,
    SLIDER_X,
)
from game.stage import Readout


def readouts(model: DominoModel) -> list[Readout]:
    """All of it: the wave first, then the balls, then the blocks."""
    wave, theory = model.wave or math.nan, model.theory()
    count = int((model.dominoes[:, BODY] >= 0.0).sum())
    rows = [
        Readout("struck", model.struck()),
        Readout("dominoes", count),
        Readout("wave speed", wave, "m/s"),
        Readout("theory", theory, "m/s"),
        Readout("wave error", 100.0 * abs(wave / theory - 1.0) if theory > 0.0 else math.nan, "%"),
        Readout("awake", model.awake()),
        Readout("fastest ball", model.fastest_ball(), "m/s"),
        Readout("moving balls", model.moving_balls()),
        Readout("at rest", model.at_rest()),
    ]
    return [*rows, *_slides(model), Readout("a step", model.watch.median("step"), "s")]


def _slides(model: DominoModel) -> list[Readout]:
    """How far each block has slid since the line, what the formula says, the worst error of those at rest."""
    found, worst = [], math.nan
    speeds = model.world.bodies.velocities
    for k, (row, entry) in enumerate(zip(model.sliders, model.content.sliders, strict=True)):
        way = exact = math.nan
        if row[SLIDER_SPEED] >= 0.0:
            way = float(row[SLIDER_WAY])
            _, slope = height_at(model.floors[entry.floor], float(row[SLIDER_X]) + 0.01)
            exact = stopping_distance(
                float(row[SLIDER_SPEED]), float(row[SLIDER_MU]), -slope, model.gravity()
            )
            stopped = elementary.length(*speeds[int(row[SLIDER_BODY])].tolist()) < QUIET
            if stopped and math.isfinite(exact) and exact > 0.0:
                error = 100.0 * abs(way / exact - 1.0)
                worst = error if math.isnan(worst) else max(worst, error)
        found += [Readout(f"block {k + 1}", way, "m"), Readout(f"formula {k + 1}", exact, "m")]
    return [*found, Readout("slide error", worst, "%")] if len(model.sliders) else []
