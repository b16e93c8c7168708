"""What a story may look at in the marble run."""

from __future__ import annotations

import numpy as np

from game.physics.kernels import elementary
from game.physics.solids.tracks.motion import VX, VY, X, Y
from game.scenes.metal.model import MetalModel


def story_targets(model: MetalModel) -> dict[str, tuple[float, float]]:
    """Balls by their names, the first and the last of each cradle, the middle of the blocks; m."""
    places = model.riders.balls.rows[:, X : Y + 1]
    found = {name: (float(x), float(y)) for name, (x, y) in zip(model.names(), places.tolist(), strict=False)}
    for k, balls in enumerate(model.cradle_balls):
        number = "" if k == 0 else f" {k + 1}"
        for name, ball in (("cradle first", balls[0]), ("cradle last", balls[-1])):
            x, y = places[ball].tolist()
            found[name + number] = (x, y)
    if model.block_ids:
        x, y = np.mean(model.world.bodies.positions[model.block_ids], axis=0).tolist()
        found["blocks"] = (x, y)
    return found


def story_names(model: MetalModel) -> list[tuple[tuple[float, float], str]]:
    """Each ball that the level names, and its speed."""
    rows = model.riders.balls.rows
    found = []
    for entry, row in zip(model.content.balls, rows, strict=False):
        if entry.name:
            speed = elementary.hypot(float(row[VX]), float(row[VY]))
            found.append(((float(row[X]), float(row[Y])), f"{entry.name}, {speed:.1f} m/s"))
    return found
