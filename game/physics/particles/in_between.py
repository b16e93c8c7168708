"""Where particles are between two steps, for a picture of them.

Arrays: fields and before (>= 5, n), tags and tags_before (2, n), now and a step earlier.
"""

from __future__ import annotations

from game.physics.kernels.jit import kernel


@kernel
def place_between(
    fields, before, tags, tags_before, low, high, alpha, dt, now, trail, positions, velocities, trails, first
):
    """Write places ``alpha`` of the way from the step before, and velocities, of particles low to high.

    Who was not there before comes from the nozzle, backwards along its velocity, and waits there to be born.
    now: s, at the end of the step. trails: velocities that lead back no farther than the nozzle in ``trail``
    (s). positions, velocities and trails (n, 2) are written from row ``first`` on; the next free row is
    returned.
    """
    for i in range(low, high):
        x = fields[0, i]
        y = fields[1, i]
        vx = fields[2, i]
        vy = fields[3, i]
        if tags[0, i] == tags_before[0, i] and fields[4, i] == before[4, i]:
            x = before[0, i] + alpha * (x - before[0, i])
            y = before[1, i] + alpha * (y - before[1, i])
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
