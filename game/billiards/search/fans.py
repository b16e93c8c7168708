"""Fans of strokes: the same stroke at many azimuths, and the stretch of them that succeeds.

Throw, squirt and real cushions turn a ball off the geometric path. A fan finds by how much, and the middle of
its widest stretch of successes is where a hand may err most.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.laws.lean import lean_kernel
from game.billiards.search import strokes as st
from game.billiards.search.candidates import AIM, SPREAD, WINDOW
from game.billiards.search.rating import SCORED, WON
from game.physics.kernels import elementary, elementwise

LEAST_RAYS = 9
MOST_RAYS = 41
RAYS_A_WINDOW = 4.0  # rays within the window that geometry leaves


def rays_for(candidates: Floats, least: int = LEAST_RAYS, most: int = MOST_RAYS) -> NDArray[np.int64]:
    """How many rays (c,) the fan of each candidate has, an odd number each."""
    rays = RAYS_A_WINDOW * candidates[:, SPREAD] / np.maximum(candidates[:, WINDOW], 1e-6)
    half = np.clip(np.ceil(0.5 * rays), (least - 1) // 2, (most - 1) // 2)
    return 2 * half.astype(np.int64) + 1


@lean_kernel
def spread_fans(candidates, styles, rays, starts, squirt, strokes):
    """Strokes of all fans, candidate by candidate, style by style, ray by ray, to strokes (m, 5).

    styles (s, 4): speed m/s, tip left and up in ball radii, elevation rad. rays (c,), starts (c,): how many
    rays a candidate has, and where its strokes begin. squirt (s,): by how much a style turns the ball, rad.
    """
    for c in range(candidates.shape[0]):
        for s in range(styles.shape[0]):
            for k in range(rays[c]):
                row = strokes[starts[c] + s * rays[c] + k]
                share = 2.0 * k / (rays[c] - 1) - 1.0
                row[st.SPEED] = styles[s, 0]
                row[st.AZIMUTH] = candidates[c, AIM] - squirt[s] + share * candidates[c, SPREAD]
                row[st.ELEVATION] = styles[s, 3]
                row[st.TIP_LEFT] = styles[s, 1]
                row[st.TIP_UP] = styles[s, 2]


@lean_kernel
def widest_runs(kinds, rays, starts, styles, middles, lengths):
    """Of each fan the longest run of successes: its middle stroke and its length, to (c, s) arrays.

    kinds (m,): classes of the strokes. A length of 0: no success; of two equal runs the first is taken.
    """
    for c in range(rays.shape[0]):
        for s in range(styles):
            first = starts[c] + s * rays[c]
            best = 0
            middle = first
            run = 0
            for k in range(rays[c]):
                kind = kinds[first + k]
                run = run + 1 if kind in (SCORED, WON) else 0
                if run > best:
                    best = run
                    middle = first + k - run // 2
            middles[c, s] = middle
            lengths[c, s] = best


def squirt_of(styles: Floats, ball_mass: float, end_mass: float) -> Floats:
    """By how much a tip off the centre turns the ball's path (s,), rad: `cue.strike`."""
    a = styles[:, 1]
    rest = 1.0 - a * a
    return -elementwise.arctan2(2.5 * a * np.sqrt(rest), 1.0 + ball_mass / end_mass + 2.5 * rest)


def make_styles(
    speeds: tuple[float, ...], ups: tuple[float, ...], lefts: tuple[float, ...], elevation: float = 0.0
) -> Floats:
    """All ways to strike (s, 4) from speeds (m/s) and tip offsets (ball radii)."""
    rows = [(v, left, up, elevation) for v in speeds for up in ups for left in lefts]
    return np.array(rows).reshape(-1, 4)


def chance_of_run(half: Floats, sigma: float) -> Floats:
    """Chances (n,) that an azimuth of deviation sigma (rad) stays within `half` (n,) rad of its aim."""
    return np.array([elementary.erf(value / (math.sqrt(2.0) * sigma)) for value in half.tolist()])
