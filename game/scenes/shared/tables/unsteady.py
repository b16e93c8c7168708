"""A person's hand that does not do exactly what was meant: the noise that computer players have."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.shot.cue import strike
from game.physics.kernels import elementary

if TYPE_CHECKING:
    from game.billiards.search.strokes import Noise

STEADY_HAND = "none"  # does exactly what is meant
# how many times `game.billiards.search.strokes.Noise`, the hand of a master; 2.8 is that of a club player
HANDS = {STEADY_HAND: 0.0, "steady": 1.0, "average": 2.8}
HAND_SEED = 70_001  # apart from the seeds of racks and of computer players
SURE = 2.0  # standard deviations on either side, within which 19 of 20 strokes lie


def shaken(stroke: Stroke, hand: str | Noise, seed: int, count: int, radius: float) -> Stroke:
    """A stroke as a hand of HANDS, or of some noise, does it: the same for the same seed and count of strokes
    before. radius of the cue ball, m.
    """
    if isinstance(hand, str) and not HANDS[hand]:
        return stroke
    from game.billiards.search.strokes import Noise, with_noise

    noise = Noise().scaled(HANDS[hand]) if isinstance(hand, str) else hand
    draw = np.random.default_rng((HAND_SEED, seed, count)).standard_normal((1, 5))
    noisy = with_noise(np.array([stroke]), draw, noise, radius)
    return Stroke(*noisy[0].tolist())


def spread_of(stroke: Stroke, hand: str, radius: float) -> float:
    """Standard deviation of the direction in which the cue ball sets off, rad; radius of the ball, m.

    To first order in what strays: the cue's azimuth and, by squirt, the tip.
    """
    if not HANDS[hand]:
        return 0.0
    from game.billiards.search.strokes import Noise

    noise = Noise().scaled(HANDS[hand])
    aside = noise.tip / radius
    turned = _squirt(stroke.tip_left + 0.5 * aside) - _squirt(stroke.tip_left - 0.5 * aside)
    return elementary.hypot(noise.azimuth, turned)


def _squirt(tip_left: float) -> float:
    """Direction of a ball struck along x, rad; the tip in ball radii."""
    x, y, _ = strike(1.0, 0.0, 0.0, tip_left).velocity
    return elementary.atan2(y, x)
