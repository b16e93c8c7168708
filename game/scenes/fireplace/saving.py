"""The fireplace as it stands, as the content of a level file."""

from __future__ import annotations

import math

import msgspec

from game.physics.heat.nodes import TEMPERATURE, WATER
from game.scenes.fireplace.level import FireplaceContent, WoodEntry
from game.scenes.fireplace.model import FireplaceModel
from game.scenes.fireplace.tables import BODY, HALF_LENGTH, HALF_THICK, SCALE, WHOLE


def content_of(model: FireplaceModel) -> FireplaceContent:
    """The level; where wood has burnt or was moved, each piece by itself, as thick as it is now."""
    if not model.changed:
        return model.content
    wood = model.wood
    entries: list[WoodEntry] = []
    for row, x, y, kelvin, water in zip(
        wood.table, *wood.places().T, wood.nodes.nodes[TEMPERATURE], wood.nodes.nodes[WATER], strict=False
    ):
        thick = float(max(2.0 * row[HALF_THICK] * row[SCALE], 0.008))
        if len(entries) >= 40 or thick < 0.0081:
            continue
        turn = math.degrees(float(wood.world.bodies.angles[int(row[BODY])]))
        entries.append(
            WoodEntry(
                at=(float(x), float(y)), turn=math.remainder(turn, 360.0), pieces=1, thick=thick,
                length=float(max(2.0 * row[HALF_LENGTH] * row[SCALE], 0.01)),
                kelvin=float(min(kelvin, 2000.0)),
                moisture=float(min(water / row[WHOLE], 2.0)),
            )
        )  # fmt: skip
    return msgspec.structs.replace(
        model.content, wood=tuple(entries), damper=float(model.parameters.damper), expected=()
    )
