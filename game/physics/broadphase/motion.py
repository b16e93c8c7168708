"""Coherent motion of boxes, as the tasks have it: explicit Euler, the velocity negated at the boundary."""

from __future__ import annotations

from game.physics.jit import kernel

MOTION, WALLS = 1, 2  # bits of ``mask``


@kernel
def move_boxes(centers, velocities, half_sizes, alive, lower, upper, mask, dt, lowers, uppers):
    """One step of explicit Euler, x + v dt; then v = -v on an axis where a box is beyond the boundary.

    A velocity that already leads back is not negated again: so a box comes back by itself, however far out
    it is. ``centers``, ``velocities``: (n, 2) m, m/s, written. ``half_sizes``: (n, 2) m. ``alive``: (n,).
    ``lower``, ``upper``: (2,) corners of the boundary, m. ``mask``: MOTION | WALLS. ``lowers``, ``uppers``:
    (n, 2) m, written: the boxes' corners.
    """
    for box in range(len(centers)):
        if alive[box] == 0:
            continue
        for axis in range(2):
            if mask & MOTION:
                centers[box, axis] += velocities[box, axis] * dt
            low = centers[box, axis] - half_sizes[box, axis]
            high = centers[box, axis] + half_sizes[box, axis]
            if mask & WALLS:
                outwards = velocities[box, axis]
                if (low < lower[axis] and outwards < 0.0) or (high > upper[axis] and outwards > 0.0):
                    velocities[box, axis] = -outwards
            lowers[box, axis] = low
            uppers[box, axis] = high
