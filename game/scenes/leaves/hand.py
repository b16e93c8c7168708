"""The hand: a drag draws a gust, the other button drops a leaf."""

from __future__ import annotations

from game.scenes.leaves.model import MOST_LEAVES, LeavesModel
from game.worlds.hands.hand import Hand, Use

FARTHEST, LOWEST = 12.0, 0.05  # m


def _blow(hand: Hand) -> str:
    (x, y), (to_x, to_y) = hand.start or hand.at, hand.at
    hand.model.blow((x, y), (to_x - x, to_y - y))
    return ""


def _drop(hand: Hand) -> str:
    model: LeavesModel = hand.model
    place = hand.at
    hand.let_go()
    if len(model.plates) >= MOST_LEAVES:
        return f"At most {MOST_LEAVES} leaves."
    model.drop(model.parameters.leaf, place)
    return ""


def leaves_hand(model: LeavesModel) -> Hand:
    """The right button drops."""
    uses = {"gust": Use(release=_blow), "drop": Use(_drop)}
    return Hand(model, uses, (-FARTHEST, LOWEST), (FARTHEST, FARTHEST), left="gust", right="drop")
