"""Outlines that are not convex: stars, combs, letters, coast lines."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise, linear

KINDS = ("star", "comb", "letter", "coast")
_E = ((0, 0), (4, 0), (4, 1), (1.2, 1), (1.2, 2.5), (3.4, 2.5), (3.4, 3.5), (1.2, 3.5), (1.2, 5), (4, 5),
      (4, 6), (0, 6))  # fmt: skip
_H = ((0, 0), (1.1, 0), (1.1, 2.5), (3, 2.5), (3, 0), (4.1, 0), (4.1, 6), (3, 6), (3, 3.5), (1.1, 3.5),
      (1.1, 6), (0, 6))  # fmt: skip
_C = ((0, 0), (4, 0), (4, 2), (2.9, 2), (2.9, 1), (1.1, 1), (1.1, 5), (2.9, 5), (2.9, 4), (4, 4), (4, 6),
      (0, 6))  # fmt: skip
LETTERS = (_E, _H, _C)
COAST_CORNERS = 64
TOOTH = 0.8  # of a comb, against 2 from tooth to tooth


def _star(variant: int) -> Floats:
    tips = 5 + variant % 5
    turns = np.arange(2 * tips) * math.pi / tips
    return (
        np.stack([elementwise.cos(turns), elementwise.sin(turns)], axis=1)
        * np.where(np.arange(2 * tips) % 2, 0.4, 1.0)[:, None]
    )


def _comb(variant: int) -> Floats:
    """Teeth narrower than the gaps between them, so that two of them go into each other."""
    teeth = 4 + variant % 4
    corners = [(0.0, 0.0), (2.0 * teeth - 2.0 + TOOTH, 0.0)]
    for k in range(teeth - 1, -1, -1):
        right, left = 2.0 * k + TOOTH, 2.0 * k
        corners += [(right, 1.0)] * (k < teeth - 1) + [(right, 4.0), (left, 4.0)] + [(left, 1.0)] * (k > 0)
    return np.array(corners)


def _coast(variant: int) -> Floats:
    """A rugged round: radii by waves whose heights fall with their number, phases by chance."""
    chance = np.random.default_rng(1_000 + variant)
    turns = np.arange(COAST_CORNERS) * math.tau / COAST_CORNERS
    radii = np.ones(COAST_CORNERS)
    for wave in range(2, 17):
        radii += (
            0.42
            / elementary.pow(wave, 0.9)
            * elementwise.cos(wave * turns + linear.uniform(chance, 0.0, math.tau))
        )
    radii = np.maximum(radii, 0.25)
    return np.stack([radii * elementwise.cos(turns), radii * elementwise.sin(turns)], axis=1)


def outline_of(kind: str, variant: int = 0) -> Floats:
    """Corners (n, 2), counter-clockwise, about the centre of mass, the farthest at 1. ValueError if none."""
    if kind not in KINDS:
        raise ValueError(f"kind = {kind!r}: expected one of {', '.join(KINDS)}")
    if kind == "letter":
        corners = np.array(LETTERS[variant % len(LETTERS)], dtype=np.float64)
    else:
        corners = {"star": _star, "comb": _comb, "coast": _coast}[kind](variant)
    corners = corners - area_and_centre(corners)[1]
    return np.asarray(corners / np.max(elementwise.hypot(*corners.T)))


def area_and_centre(corners: Floats) -> tuple[float, Floats]:
    """Signed area and centre of mass of a polygon (n, 2)."""
    x, y = corners.T
    following = np.roll(corners, -1, axis=0)
    cross = x * following[:, 1] - following[:, 0] * y
    area = 0.5 * float(np.sum(cross))
    return area, np.asarray(np.sum((corners + following) * cross[:, None], axis=0) / (6.0 * area))


def second_moment(corners: Floats) -> float:
    """Polar second moment of area about the origin, m⁴."""
    following = np.roll(corners, -1, axis=0)
    cross = corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]
    squares = np.sum(corners * corners + corners * following + following * following, axis=1)
    return float(np.sum(cross * squares)) / 12.0
