"""The hand at the fireplace: blows, drags wood, adds a log, holds a match, pours water."""

from __future__ import annotations

from game.scenes.fireplace.model import FireplaceModel
from game.scenes.fireplace.tables import HALF, TALL
from game.worlds.hands.fire import blow, hold_match, pour
from game.worlds.hands.hand import Hand, Use


def _grab(hand: Hand) -> str:
    hand.model.hold(hand.at)
    return ""


def _lead(hand: Hand) -> str:
    hand.model.lead(hand.at)
    return ""


def _add_log(hand: Hand) -> str:
    added = hand.model.add_log(hand.at)
    hand.point = None
    return "" if added else "No more wood fits in."


def _drop(hand: Hand) -> None:
    hand.model.let_go()
    hand.model.match.held = None


USES = {
    "blow": Use(move=blow), "drag": Use(_grab, _lead), "log": Use(_add_log),
    "match": Use(hold_match, hold_match), "water": Use(pour, pour),
}  # fmt: skip


def fire_hand(model: FireplaceModel) -> Hand:
    """The right button adds a log."""
    return Hand(model, USES, (-HALF, 0.003), (HALF, TALL), right="log", drop=_drop)
