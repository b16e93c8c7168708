"""What makes one computer player unlike another: its hand, and what it likes beside what wins."""

from __future__ import annotations

from typing import NamedTuple


class Hand(NamedTuple):
    """How unsteady a hand is, as multiples of the usual noise: of the aim (azimuth), of the speed, and of the
    spin (where the tip meets the ball, and how the cue is raised).
    """

    aim: float = 1.0
    speed: float = 1.0
    spin: float = 1.0


class Taste(NamedTuple):
    """What a player weighs beside its chance to win. All 0 and confidence 1: nothing else.

    pot: how much the chance of the stroke itself counts in place of what it leaves, 0 to 1 (not at carom).
    safety: what a safe stroke counts more, in chances to win (not at carom; at snooker times
    `weighing.SNOOKER_POINTS`). bank: the same for a stroke by way of a cushion (not at snooker); at carom for
    each cushion. confidence: so many times steadier than it is a player takes its hand to be.
    """

    pot: float = 0.0
    safety: float = 0.0
    bank: float = 0.0
    confidence: float = 1.0


PLAIN = Taste()
SAFETY = "safety"  # kind of a stroke that is not meant to pot
