"""The grip of the hand: the patch of particles around the held one that is led along with it.

One of ten thousand particles is no hold on a cloth: it comes out as a spike, and its own links tear first. So
a particle nearer than R to the one that is taken, at a distance d, is led along by the weight w = (1 -
d²/R²)² (the biweight of Beaton and Tukey 1974): 1 at the held one, falling off smoothly to 0 at R. Where a
substep leads it is that share of where the hand goes, and links move it by (1 - w) of its inverse mass.

The hand of a system is one array: particle held or NOBODY, its own inverse mass (1/kg), target x, y (m),
substep prepared for and its length in compliance (s). Then (index, own inverse mass, weight) for each of the
patch.
"""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.constraints.motion import FRESH, INVERSE_MASS, VX
from game.physics.constraints.network import NOBODY

HEAD = 6  # numbers of the hand before its patch


def empty_hand(before: Floats | None = None) -> Floats:
    """A hand that holds nothing; what another held, and where, stays in it unread."""
    hand = np.zeros(HEAD) if before is None else before[:HEAD].copy()
    hand[0], hand[4] = NOBODY, 0.0
    return hand


def patch_of(hand: Floats) -> Floats:
    """The particles that are led along, (k, 3): index, own inverse mass (1/kg), weight. A view."""
    return hand[HEAD:].reshape(-1, 3)


def hand_on(index: int, positions: Floats, inverse_masses: Floats, radius: float) -> Floats:
    """A hand that takes a particle, and those around it within ``radius`` (m; 0: none).

    positions (n, 2) m, inverse_masses (n,) 1/kg; the fixed ones stay where they are.
    """
    head = np.array([index, inverse_masses[index], *positions[index], 0.0, 0.0])
    if radius <= 0.0:
        return head
    away = positions - positions[index]
    rest = 1.0 - (away * away).sum(axis=1) / (radius * radius)
    led = np.flatnonzero((rest > 0.0) & (inverse_masses > 0.0) & (np.arange(len(positions)) != index))
    return np.concatenate((head, np.column_stack((led, inverse_masses[led], rest[led] * rest[led])).ravel()))


def take_hold(hand: Floats, inverse_masses: Floats) -> None:
    """Write the inverse masses (n,) that the held one and its patch have in the hand."""
    patch = patch_of(hand)
    inverse_masses[int(hand[0])] = 0.0
    inverse_masses[patch[:, 0].astype(np.int64)] = (1.0 - patch[:, 2]) * patch[:, 1]


def own_masses(hand: Floats, inverse_masses: Floats) -> Floats:
    """A copy (n,) of inverse masses as they are when the hand lets go."""
    own = inverse_masses.copy()
    if hand[0] != NOBODY:
        patch = patch_of(hand)
        own[int(hand[0])] = hand[1]
        own[patch[:, 0].astype(np.int64)] = patch[:, 1]
    return own


def let_go(hand: Floats, fields: Floats) -> None:
    """Give the held one and its patch their own inverse masses; a fixed one stands still. fields: written."""
    held, led = int(hand[0]), patch_of(hand)[:, 0].astype(np.int64)
    fields[INVERSE_MASS, held] = hand[1]
    fields[INVERSE_MASS, led] = patch_of(hand)[:, 1]
    fields[FRESH, held] = fields[FRESH, led] = 1.0
    for i in (held, *led.tolist()):
        if fields[INVERSE_MASS, i] == 0.0:
            fields[VX : VX + 2, i] = 0.0


def give_mass(hand: Floats, fields: Floats, index: int, inverse_mass: float) -> None:
    """Give a particle another inverse mass (1/kg); what the hand holds has it once it is let go."""
    patch = patch_of(hand)
    led = np.flatnonzero(patch[:, 0] == index)
    if index == hand[0]:
        hand[1] = inverse_mass
    elif len(led):
        patch[led[0], 1] = inverse_mass
        fields[INVERSE_MASS, index] = (1.0 - patch[led[0], 2]) * inverse_mass
    else:
        fields[INVERSE_MASS, index] = inverse_mass
        if inverse_mass == 0.0:
            fields[VX : VX + 2, index] = 0.0
