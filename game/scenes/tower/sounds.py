"""What is to be heard: stone on stone, floors on floors."""

from __future__ import annotations

from game.scenes.tower.hearing import STONE, THUD
from game.scenes.tower.model import TowerModel
from game.scenes.tower.tables import HEARD_KIND, HEARD_SPEED, HEARD_TIME, HEARD_X
from game.stage import Hearing, Sound

NAMES = {STONE: "stone", THUD: "thud"}
HALF = 25.0  # m to either side, from the left to the right


def hearing_of(model: TowerModel) -> Hearing:
    """Contacts that began in the last moments."""
    return Hearing(
        "tower",
        model.time,
        [
            Sound(
                float(row[HEARD_TIME]), NAMES[int(row[HEARD_KIND])], float(row[HEARD_SPEED]),
                max(-1.0, min(1.0, float(row[HEARD_X]) / HALF)),
            )
            for row in model.heard
        ],
    )  # fmt: skip
