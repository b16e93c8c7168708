"""The noise of a person's own hand, measured: strokes that were meant, and what became of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.search.strokes import Noise
from game.physics.kernels import elementwise

FEWEST = 5  # strokes, from which a hand can be told


def noise_of(pairs: Sequence[tuple[Stroke, Stroke]], radius: float) -> Noise | None:
    """Standard deviations of the strokes made from those meant, (meant, made) each; None for fewer than
    FEWEST.

    A tip has two directions, which count alike. Bias counts as noise: the hand is off either way. radius of
    the cue ball, m.
    """
    if len(pairs) < FEWEST:
        return None
    off = np.array([np.subtract(made, meant) for meant, made in pairs])
    off[:, 1] = (off[:, 1] + np.pi) % (2.0 * np.pi) - np.pi
    speed, azimuth, elevation, left, up = np.sqrt((off * off).mean(axis=0)).tolist()
    return Noise(radius * float(elementwise.hypot(left, up)) / np.sqrt(2.0), elevation, azimuth, speed)
