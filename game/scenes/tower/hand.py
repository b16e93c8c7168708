"""The hand at the tower: cuts columns, breaks floors, while it runs."""

from __future__ import annotations

import numpy as np

from game.scenes.tower.model import TowerModel
from game.scenes.tower.tables import BODY, COLUMN, KIND, SHARD, SLAB, TALL, WIDE
from game.worlds.hands.hand import NOBODY, Hand, Use
from game.worlds.members.solids import nearest_box

REACH = 0.4  # m beside something, within which the pointer takes it
FARTHEST = 1e4  # m


def part_at(hand: Hand, *kinds: int) -> int:
    """Row of the part of these kinds at the pointer, or NOBODY."""
    parts = hand.model.parts
    there = np.flatnonzero((parts[:, BODY] >= 0.0) & np.isin(parts[:, KIND], kinds))
    bodies = parts[there, BODY].astype(np.int64)
    best, outside = nearest_box(hand.model.world, bodies, parts[there][:, [WIDE, TALL]], hand.at)
    return int(there[best]) if outside <= REACH else NOBODY


def _cut(hand: Hand) -> str:
    row = part_at(hand, COLUMN)
    if row == NOBODY:
        return "There is no column there."
    hand.model.cut(row)
    return ""


def _break(hand: Hand) -> str:
    row = part_at(hand, SLAB, SHARD)
    if row == NOBODY:
        return "There is no floor there."
    hand.model.break_floor(row)
    return ""


def tower_hand(model: TowerModel) -> Hand:
    """The right button breaks."""
    uses = {"cut": Use(_cut), "break": Use(_break)}
    return Hand(model, uses, (-FARTHEST, -FARTHEST), (FARTHEST, FARTHEST), right="break")
