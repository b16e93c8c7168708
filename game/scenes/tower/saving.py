"""The tower as the content of a level file."""

from __future__ import annotations

import msgspec

from game.scenes.tower.level import TowerContent
from game.scenes.tower.model import TowerModel


def content_of(model: TowerModel) -> TowerContent:
    """The tower as it was built, with the storey that is cut first as chosen."""
    return msgspec.structs.replace(model.content, first=model.first_storey())
