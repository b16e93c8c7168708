"""What a hand does at a fire: blows, pours water, holds a match."""

from __future__ import annotations

from game.worlds.hands.hand import Hand


def blow(hand: Hand) -> str:
    """Push the air at the pointer along with it."""
    hand.model.blow(hand.at, hand.moved)
    return ""


def pour(hand: Hand) -> str:
    """Water falls where the pointer is."""
    hand.model.pour(hand.at)
    return ""


def hold_match(hand: Hand) -> str:
    """A burning match is where the pointer is."""
    hand.model.match.held = hand.at
    return ""
