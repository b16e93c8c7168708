"""The cloth as it is written on, as the content of a level file."""

from __future__ import annotations

import msgspec

from game.scenes.burning_cloth.level import BurningClothContent
from game.scenes.burning_cloth.model import BurningClothModel


def content_of(model: BurningClothModel) -> BurningClothContent:
    """The level with what the hand has written and washed out; a new cloth is not burnt."""
    if tuple(model.written) == model.content.dabs and tuple(model.washed) == model.content.washed:
        return model.content
    return msgspec.structs.replace(
        model.content, dabs=tuple(model.written), washed=tuple(model.washed), expected=()
    )
