"""What is to be heard: the match being struck, threads that part."""

from __future__ import annotations

from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.tables import HALF, HEARD_KIND, HEARD_SPEED, HEARD_TIME, HEARD_X
from game.stage import Hearing, Sound

NAMES = {1: "wood", 2: "thud"}


def hearing_of(model: BurningClothModel) -> Hearing:
    """Crackles of the last moments, from the left or the right."""
    return Hearing(
        "dominoes",
        model.time,
        [
            Sound(
                float(row[HEARD_TIME]), NAMES[int(row[HEARD_KIND])], float(row[HEARD_SPEED]),
                max(-1.0, min(1.0, float(row[HEARD_X]) / HALF)),
            )
            for row in model.heard
        ],
    )  # fmt: skip
