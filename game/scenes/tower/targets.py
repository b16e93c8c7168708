"""What a story may look at in the tower, what is heard of it, and the tower as a level."""

from __future__ import annotations

import msgspec

from game.scenes.tower.building import floor_height
from game.scenes.tower.level import TowerContent
from game.scenes.tower.measures import front_of, roof_of
from game.scenes.tower.model import TowerModel
from game.scenes.tower.sounds import HALF, NAMES
from game.stage import Hearing


def story_targets(model: TowerModel) -> dict[str, tuple[float, float]]:
    """Where the floors meet, the roof as it was and as it is, the storey that is cut first, the foot; m."""
    content = model.content
    return {
        "front": front_of(model),
        "roof": (0.0, roof_of(model)),
        "top": (0.0, floor_height(content, content.storeys)),
        "charges": (0.0, floor_height(content, model.first_storey()) - 0.5 * content.storey),
        "middle": (0.0, 0.5 * floor_height(content, content.storeys)),
        "foot": (0.0, 3.0),
    }


def hearing(model: TowerModel) -> Hearing:
    """Contacts that began in the last moments."""
    return Hearing("tower", model.time, model.heard.sounds(NAMES, HALF))


def saved(model: TowerModel) -> TowerContent:
    """The tower as it was built, with the storey that is cut first as chosen."""
    return msgspec.structs.replace(model.content, first=model.first_storey())
