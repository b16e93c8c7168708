"""What is to be heard of colliding spheres: the ledger's last entries."""

from __future__ import annotations

import numpy as np

from game.physics.spheres import ledger
from game.scenes.spheres.model import CollisionModel
from game.stage import Hearing, Sound
from game.worlds.hearing import REMEMBERED_S

LEAST = 0.05  # m/s of approach; what rests is silent


def hearing_of(model: CollisionModel) -> Hearing:
    """Collisions of the last moments; a wall sounds duller than a sphere."""
    now, entries = model.world.time, model.world.ledger()
    recent = entries[(entries[:, ledger.TIME] > now - REMEMBERED_S) & (-entries[:, ledger.BEFORE] > LEAST)]
    half = (
        0.5 * model.parameters.step_length / model.parameters.substeps
    )  # entries have the time at which their substep began
    frame = model.frame()
    middle, reach = 0.5 * (frame.left + frame.right), max(0.5 * (frame.right - frame.left), 1e-9)
    pans = np.clip((recent[:, ledger.X] - middle) / reach, -1.0, 1.0).tolist()
    return Hearing(
        "spheres",
        now,
        [
            Sound(
                entry[ledger.TIME] + half,
                "cushion" if entry[ledger.OTHER] < 0.0 else "ball",
                -entry[ledger.BEFORE],
                pan,
            )
            for entry, pan in zip(recent.tolist(), pans, strict=True)
        ],
    )
