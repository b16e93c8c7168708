"""What is to be heard of solids: impacts by what they are of and how hard they are, and joints that break."""

from __future__ import annotations

from game.scenes.solids.measures import (
    HEARD_KIND,
    HEARD_SPEED,
    HEARD_TIME,
    HEARD_X,
    SNAP,
    STEEL,
    STONE,
    THUD,
    WOOD,
)
from game.scenes.solids.model import SolidModel
from game.stage import Hearing, Sound

NAMES = {THUD: "thud", WOOD: "wood", STONE: "stone", STEEL: "steel", SNAP: "crackle"}


def hearing_of(model: SolidModel) -> Hearing:
    """Contacts that began in the last moments, from the left to the right of the view."""
    view = model.content.view
    middle, half = 0.5 * (view.left + view.right), 0.5 * max(view.right - view.left, 1e-9)
    return Hearing(
        "solids",
        model.time,
        [
            Sound(
                float(row[HEARD_TIME]), NAMES[int(row[HEARD_KIND])], float(row[HEARD_SPEED]),
                max(-1.0, min(1.0, (float(row[HEARD_X]) - middle) / half)),
            )
            for row in model.heard
        ],
    )  # fmt: skip
