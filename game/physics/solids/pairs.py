"""Broad phase: pairs of shapes whose boxes overlap, by a hashed grid of several levels and counting sorts.

A shape lies in one cell, that of its box's middle, on the level whose cells are at least as large as its box
(Ericson 2005, "Real-Time Collision Detection", 7.2). It looks for others on its own level and on those of
larger cells; boxes have some margin, so that pairs serve for several steps.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays.state import DYNAMIC, NONE

LEVELS = 48
MOST_COLOURS = 23  # what finds none free shares the last
FINEST = -16  # cells of the finest level are 2**FINEST m
MANY_CELLS = 64  # of a box on one level; few shapes do not make so many worth avoiding


@inner_kernel
def level_of(extent):
    """Level whose cells, 2**(FINEST + level) m, are at least as large as extent (m)."""
    if not extent > 0.0:
        return 0
    return min(LEVELS - 1, max(0, math.frexp(extent)[1] - FINEST))


@inner_kernel
def bucket_of(level, x, y, mask):
    """Bucket of a cell."""
    return (level * 83492791 ^ x * 73856093 ^ y * 19349663) & mask


@inner_kernel
def sort_into_cells(shapes, heads, members, cells, tallies):
    """Put shapes into buckets; bits of the levels in use. heads, members, cells are written."""
    mask = heads.shape[0] - 2
    heads[:] = 0
    used = 0
    for s in range(shapes.kinds.shape[0]):
        if shapes.kinds[s] == NONE:
            continue
        x0, y0, x1, y1 = shapes.boxes[s, 0], shapes.boxes[s, 1], shapes.boxes[s, 2], shapes.boxes[s, 3]
        level = level_of(max(x1 - x0, y1 - y0))
        size = math.ldexp(1.0, level + FINEST)
        cells[s, 0] = level
        cells[s, 1] = math.floor(0.5 * (x0 + x1) / size)
        cells[s, 2] = math.floor(0.5 * (y0 + y1) / size)
        used |= 1 << level
        bucket = bucket_of(level, cells[s, 1], cells[s, 2], mask)
        tallies[s] = bucket
        heads[bucket + 1] += 1
    for bucket in range(mask + 1):
        heads[bucket + 1] += heads[bucket]
    for s in range(shapes.kinds.shape[0] - 1, -1, -1):  # heads end where buckets begin, members ascend
        if shapes.kinds[s] != NONE:
            bucket = tallies[s]
            heads[bucket + 1] -= 1
            members[heads[bucket + 1]] = s
    for bucket in range(mask + 1):  # heads[b + 1] is where b begins: shift by one
        heads[bucket] = heads[bucket + 1]
    heads[mask + 1] = 0
    for s in range(shapes.kinds.shape[0]):
        heads[mask + 1] += shapes.kinds[s] != NONE
    return used


@inner_kernel
def may_meet(bodies, shapes, a, b):
    """True if two shapes are of different bodies, one of them dynamic, and neither shuns the other."""
    i, j = shapes.bodies[a], shapes.bodies[b]
    if i == j or not (bodies.flags[i] | bodies.flags[j]) & DYNAMIC:
        return False
    return shapes.categories[a] & shapes.masks[b] != 0 and shapes.categories[b] & shapes.masks[a] != 0


@inner_kernel
def is_excluded(excluded, i, j):
    """True if the bodies i and j are among those that shun each other: excluded (k,) i << 32 | j, sorted."""
    key = min(i, j) << 32 | max(i, j)
    low, high = 0, excluded.shape[0]
    while low < high:
        middle = (low + high) >> 1
        if excluded[middle] < key:
            low = middle + 1
        else:
            high = middle
    return low < excluded.shape[0] and excluded[low] == key


@inner_kernel
def pairs_of(s, level, bodies, shapes, excluded, scratch, found):
    """Add the pairs of shape s with shapes of one level; returns how many are found by now.

    Where its box has more cells than there are shapes, a walk through all shapes is shorter, and has an end.
    """
    boxes, heads, members, cells = shapes.boxes, scratch.heads, scratch.members, scratch.cells
    mask = heads.shape[0] - 2
    size = math.ldexp(1.0, level + FINEST)
    x0, y0, x1, y1 = boxes[s, 0], boxes[s, 1], boxes[s, 2], boxes[s, 3]
    if not ((x1 - x0) / size + 2.0) * ((y1 - y0) / size + 2.0) < heads[mask + 1] + MANY_CELLS:
        for place in range(heads[mask + 1]):
            other = members[place]
            if cells[other, 0] == level:
                found = add_pair(s, other, level, bodies, shapes, excluded, scratch, found)
        return found
    first_x, last_x = math.floor(x0 / size - 0.5), math.floor(x1 / size + 0.5)
    first_y, last_y = math.floor(y0 / size - 0.5), math.floor(y1 / size + 0.5)
    for x in range(first_x, last_x + 1):
        for y in range(first_y, last_y + 1):
            bucket = bucket_of(level, x, y, mask)
            for place in range(heads[bucket], heads[bucket + 1]):
                other = members[place]
                if cells[other, 0] != level or cells[other, 1] != x or cells[other, 2] != y:
                    continue
                found = add_pair(s, other, level, bodies, shapes, excluded, scratch, found)
    return found


@inner_kernel
def add_pair(s, other, level, bodies, shapes, excluded, scratch, found):
    """Add the pair of two shapes, if it is one and is not found from its other side; how many there are."""
    boxes, room = shapes.boxes, scratch.pair_keys.shape[0]
    if scratch.cells[s, 0] == level and other <= s:
        return found
    if boxes[other, 0] > boxes[s, 2] or boxes[other, 2] < boxes[s, 0]:
        return found
    if boxes[other, 1] > boxes[s, 3] or boxes[other, 3] < boxes[s, 1]:
        return found
    if not may_meet(bodies, shapes, s, other):
        return found
    if excluded.shape[0] > 0 and is_excluded(excluded, int(shapes.bodies[s]), int(shapes.bodies[other])):
        return found
    if found < room:
        a, b = min(s, other), max(s, other)
        if shapes.kinds[b] > shapes.kinds[a]:
            a, b = b, a
        scratch.pair_keys[found, 0], scratch.pair_keys[found, 1] = a, b
    return found + 1


@inner_kernel
def sort_by(column, pairs, target, count, tallies):
    """Counting sort, stable, of pairs (count, 2) by one column into target."""
    tallies[:] = 0
    for p in range(count):
        tallies[pairs[p, column] + 1] += 1
    for s in range(tallies.shape[0] - 1):
        tallies[s + 1] += tallies[s]
    for p in range(count):
        place = tallies[pairs[p, column]]
        tallies[pairs[p, column]] += 1
        target[place, 0], target[place, 1] = pairs[p, 0], pairs[p, 1]


@inner_kernel
def find_pairs(bodies, shapes, excluded, scratch):
    """All pairs (a, b), sorted, in scratch.pair_keys; returns their number, even if there is no space."""
    used = sort_into_cells(shapes, scratch.heads, scratch.members, scratch.cells, scratch.tallies)
    found = 0
    for s in range(shapes.kinds.shape[0]):
        if shapes.kinds[s] == NONE:
            continue
        for level in range(scratch.cells[s, 0], LEVELS):
            if used >> level == 0:
                break
            if used >> level & 1:
                found = pairs_of(s, level, bodies, shapes, excluded, scratch, found)
    if found <= scratch.pair_keys.shape[0]:
        sort_by(1, scratch.pair_keys, scratch.pair_spare, found, scratch.tallies)
        sort_by(0, scratch.pair_spare, scratch.pair_keys, found, scratch.tallies)
    return found


@inner_kernel
def carry_over(contacts, old, pair_keys, found, shapes):
    """Make contacts those of pair_keys (found, 2); what was there keeps its manifold. old: spare, written."""
    before = contacts.count[0]
    for p in range(before):
        old.shapes[p, 0], old.shapes[p, 1] = contacts.shapes[p, 0], contacts.shapes[p, 1]
        for k in range(contacts.marks.shape[1]):
            old.marks[p, k] = contacts.marks[p, k]
        for k in range(contacts.manifolds.shape[1]):
            old.manifolds[p, k] = contacts.manifolds[p, k]
    q = 0
    for p in range(found):
        a, b = pair_keys[p, 0], pair_keys[p, 1]
        while q < before and (old.shapes[q, 0] < a or (old.shapes[q, 0] == a and old.shapes[q, 1] < b)):
            q += 1
        contacts.shapes[p, 0], contacts.shapes[p, 1] = a, b
        contacts.bodies[p, 0], contacts.bodies[p, 1] = shapes.bodies[a], shapes.bodies[b]
        same = q < before and old.shapes[q, 0] == a and old.shapes[q, 1] == b
        for k in range(contacts.marks.shape[1]):
            contacts.marks[p, k] = old.marks[q, k] if same else 0
        for k in range(contacts.manifolds.shape[1]):
            contacts.manifolds[p, k] = old.manifolds[q, k] if same else 0.0
    contacts.count[0] = found


@inner_kernel
def order_by_colours(bodies, contacts, scratch):
    """Solve pairs that share no body after each other: the processor need not wait for one to begin the
    next.
    """
    colours, colour_of = scratch.colours, scratch.colour_of
    colours[:] = 0
    top = 0
    for p in range(contacts.count[0]):
        i, j = contacts.bodies[p, 0], contacts.bodies[p, 1]
        taken = (colours[i] if bodies.flags[i] & DYNAMIC else 0) | (
            colours[j] if bodies.flags[j] & DYNAMIC else 0
        )
        colour = 0
        while colour < MOST_COLOURS and taken >> colour & 1:
            colour += 1
        colours[i] |= 1 << colour
        colours[j] |= 1 << colour
        colour_of[p] = colour
        top = max(top, colour)
    place = 0
    for colour in range(top + 1):
        for p in range(contacts.count[0]):
            if colour_of[p] == colour:
                contacts.order[place] = p
                place += 1
