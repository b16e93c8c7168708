"""What a story may look at in the fireplace."""

from __future__ import annotations

import numpy as np

from game.physics.heat.nodes import TEMPERATURE
from game.scenes.fireplace.match import KEYS
from game.scenes.fireplace.model import FireplaceModel


def story_targets(model: FireplaceModel) -> dict[str, tuple[float, float]]:
    """The match's head, the kindling, the logs' middle, the hottest piece, the flames, the flue; m."""
    head = model.match.place(model.time)
    found = {
        "match": head[0] if head is not None else KEYS[0][:2],
        "kindling": (0.0, 0.09),
        "hearth": (0.0, 0.32),
        "flue": (0.0, 1.2),
        "flames": (0.0, 0.25 + 0.5 * model.flame_height()),
        "embers": (0.0, 0.12),
    }
    wood = model.wood
    if wood.count:
        x, y = wood.places()[int(np.argmax(wood.nodes.nodes[TEMPERATURE, : wood.count]))].tolist()
        found["hottest"] = (x, y)
    return found


def story_names(model: FireplaceModel) -> list[tuple[tuple[float, float], str]]:
    """The hottest piece, and the flames by their height."""
    found, wood = [], model.wood
    if wood.count:
        kelvin = wood.nodes.nodes[TEMPERATURE, : wood.count]
        hottest = int(np.argmax(kelvin))
        x, y = wood.places()[hottest].tolist()
        found.append(((x, y), f"the hottest wood, {float(kelvin[hottest]):.0f} K"))
    if model.flame_height() > 0.0:
        found.append(((0.0, 0.25 + model.flame_height()), f"flames, {model.flame_height():.2f} m"))
    return found
