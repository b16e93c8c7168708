"""Where particles are between two steps, for a picture of them.

Arrays: fields (>= 5, n), x, y, vx, vy, birth; tags (2, n); places, velocities and trails (m, 2).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel


class Swarm(NamedTuple):
    """The arrays of a pool of particles."""

    fields: NDArray[np.float64]
    tags: NDArray[np.int64]


class Shown(NamedTuple):
    """What a picture shows of particles."""

    places: NDArray[np.float64]  # (m, 2) m
    velocities: NDArray[np.float64]  # (m, 2) m/s
    trails: NDArray[np.float64]  # (m, 2) m/s: velocities that lead back no farther than the nozzle


class Instant(NamedTuple):
    """Where between two steps: alpha of the way from the one before to that at ``now`` (s), dt (s) apart."""

    alpha: float
    dt: float
    now: float


@kernel
def place_between(swarm, before, low, high, instant, trail, shown, first):
    """Write places at an instant, and velocities, of particles low to high of a `Swarm`.

    before: the same swarm a step earlier. A particle that was not there then comes from the nozzle, backwards
    along its velocity, and waits there to be born. trail: s, what a trail lasts. ``shown`` is written from
    row ``first`` on; the next free row is returned.
    """
    fields, tags = swarm
    alpha, dt, now = instant
    positions, velocities, trails = shown
    for i in range(low, high):
        x = fields[0, i]
        y = fields[1, i]
        vx = fields[2, i]
        vy = fields[3, i]
        if tags[0, i] == before.tags[0, i] and fields[4, i] == before.fields[4, i]:
            x = before.fields[0, i] + alpha * (x - before.fields[0, i])
            y = before.fields[1, i] + alpha * (y - before.fields[1, i])
        else:
            back = min((1.0 - alpha) * dt, max(now - fields[4, i], 0.0))
            x -= back * vx
            y -= back * vy
        positions[first, 0] = x
        positions[first, 1] = y
        velocities[first, 0] = vx
        velocities[first, 1] = vy
        age = now - (1.0 - alpha) * dt - fields[4, i]
        part = min(max(age / trail, 0.0), 1.0)
        trails[first, 0] = part * vx
        trails[first, 1] = part * vy
        first += 1
    return first


@kernel
def gather_touching(tags, positions, low, high, since, first, found, places):
    """Copy the places of those that touched a stone in step ``since`` or later; the next free row.

    positions (n, 2): row ``first`` belongs to particle ``low``. places (n, 2) is written from ``found`` on.
    """
    for i in range(low, high):
        if tags[1, i] >= since:
            places[found, 0] = positions[first + i - low, 0]
            places[found, 1] = positions[first + i - low, 1]
            found += 1
    return found
