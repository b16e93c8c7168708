"""Long-range attachments: no particle is farther from a pin than the links between them are long.

One inequality for each free particle, so a hanging rope or cloth cannot stretch as a whole however few sweeps
the links get (Kim, Chentanez, Müller 2012, "Long range attachments", with geodesic distances).

Arrays: x, y (n,) m; pins (n,), the pin of each particle or -1; reaches (n,) m; heap, keys, place_of (n,): the
queue of Dijkstra's algorithm, its distances, and where in it a particle stands.
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel


@kernel
def sift_up(heap, keys, place_of, at):
    """Move an entry of a heap of particles towards the root until its parent is no farther."""
    while at > 0:
        parent = (at - 1) // 2
        a = heap[at]
        b = heap[parent]
        if keys[b] <= keys[a]:
            break
        heap[at] = b
        heap[parent] = a
        place_of[b] = at
        place_of[a] = parent
        at = parent


@kernel
def sift_down(heap, keys, place_of, size):
    """Move the root of a heap of particles towards the leaves until no child is nearer."""
    at = 0
    while True:
        child = 2 * at + 1
        if child >= size:
            break
        if child + 1 < size and keys[heap[child + 1]] < keys[heap[child]]:
            child += 1
        a = heap[at]
        b = heap[child]
        if keys[a] <= keys[b]:
            break
        heap[at] = b
        heap[child] = a
        place_of[b] = at
        place_of[a] = child
        at = child


@kernel
def nearest_pins(inverse_mass, first_link, links_of, other_end, rest, order, torn, pins, reaches):
    """For each particle the nearest pin along links that hold, and how far it is (Dijkstra 1959).

    first_link (n + 1,), links_of, other_end: the links at each particle. rest (m,) m in the order of solving,
    torn in the order given, reached by ``order``. Written: pins (n,) index or -1, reaches (n,) m.
    """
    n = inverse_mass.shape[0]
    heap = pins.copy()
    place_of = pins.copy()
    size = 0
    for i in range(n):
        pins[i] = -1
        place_of[i] = -1
        reaches[i] = math.inf
        if inverse_mass[i] == 0.0:
            pins[i] = i
            reaches[i] = 0.0
            heap[size] = i
            place_of[i] = size
            size += 1
    while size > 0:
        near = heap[0]
        size -= 1
        heap[0] = heap[size]
        place_of[heap[0]] = 0
        place_of[near] = -2
        sift_down(heap, reaches, place_of, size)
        for k in range(first_link[near], first_link[near + 1]):
            far = other_end[k]
            way = reaches[near] + rest[links_of[k]]
            if torn[order[links_of[k]]] or place_of[far] == -2 or way >= reaches[far]:
                continue
            if place_of[far] == -1:
                place_of[far] = size
                heap[size] = far
                size += 1
            reaches[far] = way
            pins[far] = pins[near]
            sift_up(heap, reaches, place_of, place_of[far])


@kernel
def pull_back(x, y, inverse_mass, pins, reaches):
    """Move each free particle that is out of reach of its pin straight back to where it reaches."""
    for i in range(inverse_mass.shape[0]):
        pin = pins[i]
        if pin < 0 or inverse_mass[i] == 0.0:
            continue
        dx = x[i] - x[pin]
        dy = y[i] - y[pin]
        square = dx * dx + dy * dy
        if square > reaches[i] * reaches[i]:
            part = reaches[i] / math.sqrt(square)
            x[i] = x[pin] + part * dx
            y[i] = y[pin] + part * dy
