"""How fast a front of embers goes in a cloth, in closed form."""

from __future__ import annotations

import math
from functools import lru_cache

ROUNDS = 200


@lru_cache(maxsize=64)
def creeping_speed(diffusivity: float, rate: float, ignition: float, loss: float = 0.0) -> float:
    """Speed (m/s) of the front of u_t = D u_xx - h u + r f, f_t = -r f, where u >= ignition; else f stays 1.

    u: temperature above the surroundings over what the fuel's heat makes without losses. D m²/s, r and h 1/s.
    In the frame of the front, u = a exp(-m x) before it. Behind it, u is B exp(s x) + P exp(r x / c), with m,
    s = (sqrt(c² + 4 D h) ± c) / 2 D and P = -r / (D r² / c² + r - h). The value and slope are the same on
    both sides where u is the ignition, which gives a = P (s - r / c) / (m + s). Without losses c = sqrt(D r
    (1 - ignition) / ignition): at 1/5 it is Fisher's 2 sqrt(D r). 0: it goes out. ValueError.
    """
    if not (0.0 < diffusivity < math.inf and 0.0 < rate < math.inf and 0.0 <= loss < math.inf):
        raise ValueError(
            f"diffusivity, rate, loss = {diffusivity!r}, {rate!r}, {loss!r}: expected above 0, and from 0"
        )
    if not 0.0 < ignition < 1.0:
        raise ValueError(f"ignition = {ignition!r}: expected above 0 and below 1")
    free = math.sqrt(diffusivity * rate * (1.0 - ignition) / ignition)
    if loss == 0.0:
        return free

    def reached(c: float) -> float:
        root = math.sqrt(c * c + 4.0 * diffusivity * loss)
        s = (root - c) / (2.0 * diffusivity)
        fast = rate / c
        share = -rate / (diffusivity * fast * fast + rate - loss)
        return share * (s - fast) * diffusivity / root

    # as c grows from 0, what is reached first rises, then falls: the front that lasts is the faster one
    low, high = 1e-9 * free, free
    best = max((free * k / 400.0 for k in range(1, 401)), key=reached)
    if reached(best) < ignition:
        return 0.0
    low = best
    for _ in range(ROUNDS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if reached(middle) > ignition else (low, middle)
    return 0.5 * (low + high)
