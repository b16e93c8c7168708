"""A step of free flight of all particles, and the list of those that may meet something on their way.

Particles are worked through in blocks that stay in the nearest cache: mark without a branch those that come
near a solid, note their state as it was, then fly them all. The few on the list go through `contacts`.

Arrays, (n,) each: x, y, vx, vy (m, m/s); marks, lying (flags). hits (LIST_ROWS, k) and who (k,): a list.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from game.compiler.decorator import lean_kernel
from game.physics.particles.effects import GROUND_BIT, OBSTACLES_BIT
from game.physics.particles.flight import decay_over, fly
from game.physics.particles.forces import DRAG_BIT, SIDEWAYS_BITS, unpack_forces

BLOCK = 512  # particles; their four fields take 16 KiB, half of a first-level cache


@lean_kernel
def mark_near_disc(x, y, vx, vy, marks, solid, slack, h):
    """Mark each particle that may touch a disc within h (s): a superset, found without root or branch.

    A way of length d <= h |v| + slack touches only if it begins within R + d of the centre, and
    (R + d)² <= 1.125 R² + 9 d², d² <= 1.25 h² v² + 5 slack².
    """
    slack += h * math.sqrt(solid[3] * solid[3] + solid[4] * solid[4])
    cx = solid[0]
    cy = solid[1]
    reach = 1.125 * solid[2] * solid[2] + 45.0 * slack * slack
    stretch = 11.25 * h * h
    for i in range(marks.shape[0]):
        dx = x[i] - cx
        dy = y[i] - cy
        marks[i] |= dx * dx + dy * dy <= reach + stretch * (vx[i] * vx[i] + vy[i] * vy[i])


@lean_kernel
def mark_near_ground(y, vy, marks, lying, floor, slack, h):
    """Mark each particle that may be below the floor after h (s), but for those that lie on it already."""
    limit = floor + slack
    for i in range(marks.shape[0]):
        lying[i] = (y[i] == floor) & (vy[i] == 0.0)
        marks[i] = (y[i] + min(h * vy[i], 0.0) <= limit) & (lying[i] == 0)


@lean_kernel(forceinline=True)
def lie_on(lying, y, vy, floor):
    """Height and vertical velocity after a flight: what lay on the floor lies on unless lifted."""
    stays = (lying != 0) & (y <= floor)
    return floor if stays else y, 0.0 if stays else vy


@lean_kernel
def note_marked(x, y, vx, vy, marks, begin, listed, found):
    """Write state and index (``begin`` on) of marked particles from place ``found`` on; the next place."""
    hits, who = listed
    for i in range(marks.shape[0]):
        if marks[i]:
            who[found] = begin + i
            hits[0, found] = x[i]
            hits[1, found] = y[i]
            hits[2, found] = vx[i]
            hits[3, found] = vy[i]
            found += 1
    return found


@cache
def make_advance(method: int, mask: int) -> Callable[..., Any]:
    """The kernel ``advance(fields, low, high, world, h, marks, listed, found)``.

    It flies particles ``low`` to ``high`` of ``fields`` (rows x, y, vx, vy, ...) over h (s). Those that may
    meet a solid on the way are written with their state before it to the list (hits, who) from place
    ``found`` on. Returns the next free place. ``world``: forces, rows of `Discs`, height of the floor (m),
    and slack, m that a particle may be carried beyond h |v|; ``marks`` (2, BLOCK) is scratch.

    Those that lie on the floor slide on with the others: what comes of them needs no search for an impact.
    """
    touches = mask & (OBSTACLES_BIT | GROUND_BIT)

    @lean_kernel
    def advance(fields, low, high, world, h, marks, listed, found):
        forces, solids, floor, slack = world
        law = unpack_forces(forces)
        decay = decay_over(law.drag if mask & DRAG_BIT else 0.0, h)
        # literals would have every helper compiled for each; as plain integers they are folded all the same
        which = np.int64(method)
        terms = np.int64(mask)
        for begin in range(low, high, BLOCK):
            end = min(begin + BLOCK, high)
            x = fields[0][begin:end]
            y = fields[1][begin:end]
            vx = fields[2][begin:end]
            vy = fields[3][begin:end]
            near = marks[0][: end - begin]
            lying = marks[1][: end - begin]
            if touches:
                if mask & GROUND_BIT:
                    mark_near_ground(y, vy, near, lying, floor, slack, h)
                else:
                    near[:] = 0
                if mask & OBSTACLES_BIT:
                    for j in range(solids.shape[0]):
                        mark_near_disc(x, y, vx, vy, near, solids[j], slack, h)
                found = note_marked(x, y, vx, vy, near, begin, listed, found)
            for i in range(x.shape[0]):
                x1, y1, ux, uy = fly(which, terms, law, decay, x[i], y[i], vx[i], vy[i], h)
                if mask & GROUND_BIT:
                    y1, uy = lie_on(lying[i], y1, uy, floor)
                x[i] = x1
                y[i] = y1
                if mask & SIDEWAYS_BITS:
                    vx[i] = ux
                vy[i] = uy
        return found

    return advance
