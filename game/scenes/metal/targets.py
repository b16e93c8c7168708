"""What a story may look at in the marble run."""

from __future__ import annotations

import numpy as np

from game.physics.solids.tracks.motion import X, Y
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
