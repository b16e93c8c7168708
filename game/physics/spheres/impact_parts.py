"""A substep divided at its impacts: how long its parts are."""

from __future__ import annotations

from collections.abc import Callable, Iterator

MOMENT = 1e-9  # of a substep: shortest part, so that time goes on
IMPACTS_PER_SPHERE, MOST_IMPACTS = 8, 400  # parts of a substep, at most; the last one takes what is left
ROUNDING = 1e-15  # of a substep; less is nothing left


def divide_at_impacts(
    nominal: float, spheres: int, pause: bool, time_to_impact: Callable[[float], float]
) -> Iterator[float]:
    """Lengths (s) of the parts of a substep of ``nominal`` length, one after another, each to be stepped.

    time_to_impact: seconds until the first impact from where the spheres are now, at most those given.
    pause: after a part that ends at an impact comes one of a moment, in which what has met collides before
    anybody looks where it goes; for schemes that move last.
    """
    left = nominal
    most = min(IMPACTS_PER_SPHERE * spheres, MOST_IMPACTS)
    struck = False
    for part in range(most):
        if part == most - 1:
            h = left
        elif struck and pause:
            h = min(MOMENT * nominal, left)
        else:
            h = min(max(time_to_impact(left), MOMENT * nominal), left)
        struck = not struck and h < left
        yield h
        left -= h
        if not left > ROUNDING * nominal:
            return
