"""Bodies that keep apart: whatever links and outlines hold together is one, and its particles keep a distance
from those of all others, as a constraint of position (Müller and others 2007, section 4.3, with discs for the
surfaces). A disc of half the distance stands around each particle. So surfaces keep apart as long as their
particles are nearer to each other than the discs are wide. No body may pass a disc within a substep.

Arrays: x, y (n,) m; w (n,) 1/kg; members (n,): particles, body by body; starts (b + 1,): where each begins.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Longs
from game.compiler.decorator import lean_kernel
from game.physics.constraints.links import TINY


@lean_kernel
def root_of(parents, i):
    """The particle that stands for the body of particle i; paths are shortened on the way."""
    while parents[i] != i:
        parents[i] = parents[parents[i]]
        i = parents[i]
    return i


@lean_kernel
def join_bodies(parents, pairs, corners, starts):
    """Write into parents (n,), each its own at first, who is held together by links and outlines."""
    for e in range(pairs.shape[0]):
        parents[root_of(parents, pairs[e, 0])] = root_of(parents, pairs[e, 1])
    for j in range(starts.shape[0] - 1):
        for i in range(starts[j] + 1, starts[j + 1]):
            parents[root_of(parents, corners[i])] = root_of(parents, corners[starts[j]])
    for i in range(parents.shape[0]):
        parents[i] = root_of(parents, i)


def bodies_of(count: int, pairs: Longs, corners: Longs, outline_starts: Longs) -> tuple[Longs, Longs]:
    """(members (n,), starts (b + 1,)) of the bodies that links (m, 2) and outlines make of n particles."""
    parents = np.arange(count, dtype=np.int64)
    join_bodies(parents, pairs, corners, outline_starts)
    members = np.argsort(parents, kind="stable").astype(np.int64)
    changes = np.flatnonzero(np.diff(parents[members])) + 1
    return members, np.concatenate(([0], changes, [count])).astype(np.int64)


@lean_kernel
def box_bodies(x, y, members, starts, boxes):
    """Write the axis-aligned boxes (4, b) m of bodies: left, bottom, right, top."""
    for b in range(starts.shape[0] - 1):
        first = members[starts[b]]
        left = right = x[first]
        bottom = top = y[first]
        for place in range(starts[b] + 1, starts[b + 1]):
            i = members[place]
            left = min(left, x[i])
            right = max(right, x[i])
            bottom = min(bottom, y[i])
            top = max(top, y[i])
        boxes[0, b] = left
        boxes[1, b] = bottom
        boxes[2, b] = right
        boxes[3, b] = top


@lean_kernel
def push_bodies_apart(x, y, w, members, starts, boxes, distance):
    """Move particles of different bodies that are nearer than ``distance`` (m) apart to it; x, y are written.

    boxes (4, b): scratch buffer.
    """
    box_bodies(x, y, members, starts, boxes)
    count = starts.shape[0] - 1
    for a in range(count):
        for b in range(a + 1, count):
            if (
                boxes[0, a] >= boxes[2, b] + distance
                or boxes[0, b] >= boxes[2, a] + distance
                or boxes[1, a] >= boxes[3, b] + distance
                or boxes[1, b] >= boxes[3, a] + distance
            ):
                continue
            for place in range(starts[a], starts[a + 1]):
                i = members[place]
                outside_x = x[i] <= boxes[0, b] - distance or x[i] >= boxes[2, b] + distance
                if outside_x or y[i] <= boxes[1, b] - distance or y[i] >= boxes[3, b] + distance:
                    continue
                push_from(i, x, y, w, members, starts[b], starts[b + 1], distance)


@lean_kernel
def push_from(i, x, y, w, members, begin, end, distance):
    """Move particle i and those of a body that are nearer than ``distance`` (m) apart to it."""
    for place in range(begin, end):
        j = members[place]
        dx = x[j] - x[i]
        dy = y[j] - y[i]
        square = dx * dx + dy * dy
        mobility = w[i] + w[j]
        if square >= distance * distance or square <= TINY * TINY or mobility == 0.0:
            continue
        pull = (1.0 - distance / math.sqrt(square)) / mobility
        x[i] += w[i] * pull * dx
        y[i] += w[i] * pull * dy
        x[j] -= w[j] * pull * dx
        y[j] -= w[j] * pull * dy
