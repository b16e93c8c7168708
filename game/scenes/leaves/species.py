"""Kinds of leaves: how they are built, and their outlines."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise
from game.physics.plates import Plate


class Species(NamedTuple):
    """A kind of leaf. plate: its law, before each leaf's own variation; colors: 0xRRGGBB of upper sides;
    wide: of its breadth beside its length; varies: share of its inertia, and curls: rad of its curl, by
    which the leaves of the kind differ."""

    plate: Plate
    colors: tuple[int, ...]
    wide: float
    varies: float
    curls: float


# Light and curled ones flutter; flat ones with I* between `regimes.BORDERS` tumble; mass at one end glides.
SPECIES = {
    "maple": Species(
        Plate(0.045, 0.62, 0.03, curl=0.30, bend_hz=10.0),
        (0xD8431F, 0xC22A1C, 0xE8702A, 0xF0A03C), 1.0, 0.3, 0.3,
    ),
    "oak": Species(
        Plate(0.028, 1.38, 0.03, bend_hz=20.0), (0x9A5A2A, 0xB06A30, 0x7E4A24, 0xC4843C), 0.62, 0.06, 0.03
    ),
    "birch": Species(
        Plate(0.022, 1.37, 0.03, bend_hz=20.0), (0xF2C230, 0xE8B020, 0xF6D45C, 0xD89A1C), 0.72, 0.06, 0.03
    ),
    "linden": Species(
        Plate(0.036, 0.75, 0.03, curl=0.15, bend_hz=14.0),
        (0xE6B83A, 0xC9A227, 0xD98E2B, 0xB8A13A), 0.86, 0.3, 0.2,
    ),
    "ash": Species(
        Plate(0.032, 1.0, 0.03, bend_hz=20.0, balance=0.65),
        (0xC7B24A, 0xA8963C, 0xD2A048, 0xE0C468), 0.42, 0.2, 0.05,
    ),
}  # fmt: skip


def outline_of(name: str) -> Floats:
    """(k, 2) along and across a leaf, from -1 to 1, counter-clockwise, its tip at +1."""
    wide = SPECIES[name].wide
    turn = np.linspace(0.0, math.tau, 28, endpoint=False)
    if name == "maple":
        lobes = np.array((0.0, 0.95, 2.05, 4.23, 5.33))
        points: list[tuple[float, float]] = []
        reach = (1.0, 0.95, 0.66, 0.66, 0.95)
        for k, at in enumerate(lobes):
            nxt = lobes[(k + 1) % 5] + (math.tau if k == 4 else 0.0)
            for off, far in ((-0.20, 0.62), (-0.09, 0.76), (0.0, 1.0), (0.09, 0.76), (0.20, 0.62)):
                points.append(
                    (reach[k] * far * elementary.cos(at + off), reach[k] * far * elementary.sin(at + off))
                )
            notch = 0.5 * (at + nxt)
            deep = 0.34 if k != 2 else 0.22
            points.append((deep * elementary.cos(notch), deep * elementary.sin(notch)))
        shape = np.array(points)
    elif name == "oak":
        along = elementwise.cos(turn)
        half = elementwise.power(np.abs(elementwise.sin(turn)), 0.8) * (
            0.72 + 0.28 * elementwise.cos(9.0 * along + 0.6)
        )
        shape = np.stack([along, wide * half * np.sign(elementwise.sin(turn))], axis=1)
    elif name == "linden":
        along = elementwise.cos(turn)
        shape = np.stack(
            [
                along,
                wide
                * elementwise.power(np.abs(elementwise.sin(turn)), 0.75)
                * np.sign(elementwise.sin(turn))
                * (1.0 - 0.25 * along),
            ],
            1,
        )
    else:
        along = elementwise.cos(turn)
        shape = np.stack(
            [
                along,
                wide
                * elementwise.power(np.abs(elementwise.sin(turn)), 1.25)
                * np.sign(elementwise.sin(turn))
                * (1.0 - 0.2 * along),
            ],
            1,
        )
    return np.ascontiguousarray(shape)


def half_of(outline: Floats, side: float) -> Floats:
    """The part of an outline on one side (1, -1) of the middle of the chord (Sutherland, Hodgman 1974)."""
    kept = []
    for k in range(len(outline)):
        a, b = outline[k], outline[(k + 1) % len(outline)]
        if side * a[0] >= 0.0:
            kept.append(a)
        if (a[0] > 0.0) != (b[0] > 0.0):
            share = a[0] / (a[0] - b[0])
            kept.append(a + share * (b - a))
    return np.array(kept).reshape(-1, 2)
