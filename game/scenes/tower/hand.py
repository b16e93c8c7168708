"""The hand at the tower: cuts columns, breaks floors, while it runs."""

from __future__ import annotations

from game.scenes.tower.building import COLUMN
from game.scenes.tower.frame import FLOORS
from game.scenes.tower.world import TowerWorld
from game.worlds.hands.hand import NOBODY, Hand, Use

REACH = 0.4  # m beside something, within which the pointer takes it
FARTHEST = (1e4, 1e4)  # m


def _cut(hand: Hand) -> str:
    model: TowerWorld = hand.model
    row = model.frame.nearest(hand.at, (COLUMN,), REACH)
    if row == NOBODY:
        return "There is no column there."
    model.cut(row)
    return ""


def _break(hand: Hand) -> str:
    model: TowerWorld = hand.model
    row = model.frame.nearest(hand.at, FLOORS, REACH)
    if row == NOBODY:
        return "There is no floor there."
    model.break_floor(row)
    return ""


def tower_hand(model: TowerWorld) -> Hand:
    """The hand of a tower; its right button breaks."""
    low = (-FARTHEST[0], -FARTHEST[1])
    return Hand(model, {"cut": Use(_cut), "break": Use(_break)}, low, FARTHEST, right="break")
