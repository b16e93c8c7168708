"""Strengths of the forces between pairs that make surface tensions."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from game.arrays import Floats


@lru_cache(maxsize=1)
def cohesion_moment() -> float:
    """∫ q³ of the cohesion over (0, 1): exact, as both are polynomials and Gauss' rule has 8 points."""
    points, parts = np.polynomial.legendre.leggauss(8)
    q = 0.5 * (1.0 + points)
    return float(np.sum(0.5 * parts * q * q * q * (q - 1.0 / 3.0) * (1.0 - q) * (3.0 + 4.2 * q)))


def adhesion(tensions: Sequence[float], support: float) -> Floats:
    """Strengths (kinds, kinds) of the pair force that make surface tensions (N/m); none between kinds.

    Work to part a half-plane from another, half of it for each side: σ = ∫ r³ F dr / (3 V²).
    """
    scale = 3.0 / (support * support * support * support * cohesion_moment())
    return np.diag(np.asarray(tensions, dtype=np.float64) * scale)
