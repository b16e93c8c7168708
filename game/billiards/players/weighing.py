"""What strokes count for a player of some hand and taste."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.players.taste import PLAIN, Hand, Taste
from game.billiards.search.candidates import BANK, KICK, KIND
from game.billiards.search.strokes import Noise

SNOOKER_POINTS = 40.0  # that a whole chance to win stands for, where strokes are weighed in points


def weighed(worth: Floats, chance: Floats, candidates: Floats, taste: Taste) -> Floats:
    """What strokes (f,) count for a player. worth, chance (f,); candidates (f, 8) that they come from."""
    if taste == PLAIN:
        return worth
    banked: NDArray[np.bool_] = np.isin(candidates[:, KIND], (BANK, KICK))
    scores: Floats = (1.0 - taste.pot) * worth + taste.pot * chance + taste.bank * banked
    return scores


def weighed_safe(worth: Floats, taste: Taste) -> Floats:
    """What safe strokes (f,) count for a player; they pot nothing."""
    if taste == PLAIN:
        return worth
    scores: Floats = (1.0 - taste.pot) * worth + taste.safety
    return scores


def noise_of(hand: Hand, share: float) -> Noise:
    """The standard deviations of a hand, all of them times a share."""
    usual = Noise()
    return Noise(
        share * hand.spin * usual.tip, share * hand.spin * usual.elevation,
        share * hand.aim * usual.azimuth, share * hand.speed * usual.speed,
    )  # fmt: skip
