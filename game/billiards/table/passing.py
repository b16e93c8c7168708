"""Contacts that a stepped model never sees: two balls that meet in the course of a step, not at its end.

The paths are taken as straight, at constant speed, which they are for balls that met nothing in the step.
"""

from __future__ import annotations

import numpy as np

from game.compiler.decorator import kernel

FIRST, SECOND = 0, 1  # columns of what is found: two balls,
FIRST_PLACE, SECOND_PLACE = slice(2, 4), slice(4, 6)  # and where they were when they were nearest
COLUMNS = 6
GRAZE = 1.0 - 1e-9  # of the sum of radii: what comes no nearer is in contact by rounding only


@kernel
def find_passed(before, now, radii, free, passed):
    """Write the pairs that overlapped between ``before`` and ``now``, and at neither end.

    before, now (n, 2), radii (n,): one unit of length. free (n,): balls that met nothing in the step; only
    these are looked at. passed (k, 6): one row a pair, see the columns. Returns how many there were, which
    may be more than the rows.
    """
    count = 0
    n = before.shape[0]
    for i in range(n):
        if not free[i]:
            continue
        for j in range(i + 1, n):
            if not free[j]:
                continue
            x = before[j, 0] - before[i, 0]
            y = before[j, 1] - before[i, 1]
            end_x = now[j, 0] - now[i, 0]
            end_y = now[j, 1] - now[i, 1]
            way_x = end_x - x
            way_y = end_y - y
            along = -(x * way_x + y * way_y)
            length = way_x * way_x + way_y * way_y
            reach = radii[i] + radii[j]
            apart = x * x + y * y >= reach * reach and end_x * end_x + end_y * end_y >= reach * reach
            if not apart or along <= 0.0 or along >= length:
                continue
            share = along / length
            x += share * way_x
            y += share * way_y
            if x * x + y * y >= reach * reach * GRAZE * GRAZE:
                continue
            if count < passed.shape[0]:
                passed[count, 0] = i
                passed[count, 1] = j
                for axis in range(2):
                    passed[count, 2 + axis] = before[i, axis] + share * (now[i, axis] - before[i, axis])
                    passed[count, 4 + axis] = before[j, axis] + share * (now[j, axis] - before[j, axis])
            count += 1
    return count


def warm_up() -> None:
    """Compile what is here."""
    places = np.zeros((2, 2))
    find_passed(places, places, np.ones(2), np.ones(2, dtype=np.bool_), np.zeros((1, COLUMNS)))
