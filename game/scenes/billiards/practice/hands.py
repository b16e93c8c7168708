"""Whose noise the map and the landing cloud are drawn with: a grade's, or one's own as it was measured."""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.game.rules import CUE_BALL
from game.billiards.map.hand import FEWEST, noise_of
from game.billiards.search.strokes import Noise
from game.scenes.billiards.play import Play
from game.scenes.shared.tables.choices import OWN

STAND_IN = "club"  # for one's own hand while too little is known of it


class Hand(NamedTuple):
    """A hand's noise, and what it is called."""

    noise: Noise
    words: str


def hand_of(play: Play) -> Hand:
    """The hand that is chosen; one's own is told from FEWEST strokes on that strayed at all."""
    from game.billiards.players.opponents import GRADES

    chosen = str(play.parameters.odds)
    if chosen != OWN:
        return Hand(GRADES[chosen].noise, GRADES[chosen].title)
    radius = float(play.model.frame.layout.balls.radii[CUE_BALL])
    own = noise_of(play.own, radius)
    if own is not None:
        return Hand(own, f"your hand, {len(play.own)} strokes")
    missing = FEWEST - len(play.own)
    return Hand(GRADES[STAND_IN].noise, f"{GRADES[STAND_IN].title}; yours after {missing} more")
