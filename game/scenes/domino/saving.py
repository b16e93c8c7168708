"""The dominoes as they stand, as the content of a level file."""

from __future__ import annotations

import math

import msgspec

from game.scenes.domino.level import DominoContent, SingleEntry
from game.scenes.domino.model import DominoModel
from game.scenes.domino.tables import BODY, FOOT_X, FOOT_Y, LEAN, TALL, THICK, TO


def content_of(model: DominoModel) -> DominoContent:
    """The level; where a hand has added, moved or taken away dominoes, all of them one by one.

    Fallen ones are written where they stood: a level is what is there before the first push.
    """
    if not model.changed:
        return model.content
    singles = tuple(
        SingleEntry(
            at=(float(row[FOOT_X]), float(row[FOOT_Y])),
            lean=math.degrees(float(row[LEAN])),
            to=1 if row[TO] > 0.0 else -1,
            size=(float(row[THICK]), float(row[TALL])),
        )
        for row in model.dominoes
        if row[BODY] >= 0.0
    )
    return msgspec.structs.replace(model.content, rows=(), singles=singles)
