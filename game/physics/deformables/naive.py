"""The twin that tests all pairs: what the table must find, no more and no less."""

from __future__ import annotations

import numpy as np

from game.compiler.decorator import lean_kernel
from game.physics.deformables.edges import is_crossing, is_searched
from game.physics.deformables.vertices import is_contact


@lean_kernel
def all_vertices(mask, points, store, keys):
    """All vertices in all triangles: writes keys as long as there is space; returns how many there are."""
    hits = 0
    for t in range(store.triangles.shape[0]):
        for v in range(points.shape[0]):
            if is_contact(mask, points, store, t, v):
                if hits < keys.shape[0]:
                    keys[hits] = (t << 32) | v
                hits += 1
    return hits


@lean_kernel
def all_edges(mask, points, inside, store, keys):
    """All edges that matter with all of the rim: writes keys; returns how many there are."""
    hits = 0
    for e in range(store.edges.shape[0]):
        if is_searched(store, inside, e):
            for r in range(store.rim.shape[0]):
                f = np.int64(store.rim[r])
                if is_crossing(mask, points, store, e, f):
                    if hits < keys.shape[0]:
                        keys[hits] = (e << 32) | f
                    hits += 1
    return hits
