"""The hand at the cloth: holds a match to it, writes, washes out, wets, drags it, blows."""

from __future__ import annotations

from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.tables import HALF, TALL
from game.worlds.hands.fire import blow, hold_match, pour
from game.worlds.hands.hand import Hand, Use

NO_CLOTH = "There is no cloth here to write on."


def _write(hand: Hand) -> str:
    return "" if hand.model.write_at(hand.at, hand.verb == "wash") else NO_CLOTH


def _write_on(hand: Hand) -> str:
    hand.model.write_at(hand.at, hand.verb == "wash")
    return ""


def _grab(hand: Hand) -> str:
    return "" if hand.model.cloth.grab(hand.at) else "There is no cloth here to take hold of."


def _drag(hand: Hand) -> str:
    hand.model.cloth.drag(hand.at)
    return ""


def _drop(hand: Hand) -> None:
    hand.model.cloth.release()
    hand.model.match.held = None


USES = {
    "match": Use(hold_match, hold_match), "write": Use(_write, _write_on), "wash": Use(_write, _write_on),
    "water": Use(pour, pour), "drag": Use(_grab, _drag), "blow": Use(move=blow),
}  # fmt: skip


def cloth_hand(model: BurningClothModel) -> Hand:
    """The right button wets."""
    return Hand(model, USES, (-HALF, 0.003), (HALF, TALL), right="water", drop=_drop)
