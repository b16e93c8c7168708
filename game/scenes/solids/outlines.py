"""Outlines of all shapes, packed for drawing: corners in the frames of their bodies, with a bevel inside."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.kernels import elementwise, linear
from game.physics.solids.arrays.state import DISC, NONE, SEGMENT, Pool, Shapes
from game.scenes.solids.cutting import rounded_outline

BEVEL = 0.09  # of the least width of a shape
MOST_BEVEL = 0.09  # m


class Outlines(NamedTuple):
    """corners (v, 2) m, of polygons; owners (v,) their bodies; starts (m + 1,) first corner of each polygon;
    bevels (v, 2) m the same corners moved inwards; ends (e, 2, 2) m of segments and their bodies (e,); discs:
    centres (d, 2) m, radii (d,) m, bodies (d,).
    """

    corners: Floats
    bevels: Floats
    normals: Floats
    owners: Longs
    starts: Longs
    ends: Floats
    end_owners: Longs
    centres: Floats
    radii: Floats
    disc_owners: Longs


def outlines_of(shapes: Shapes, pool: Pool) -> Outlines:
    """Of all shapes that there are."""
    polygons: list[Floats] = []
    owners: list[int] = []
    for slot in np.flatnonzero(
        (shapes.kinds != NONE) & (shapes.kinds != DISC) & (shapes.kinds != SEGMENT)
    ).tolist():
        start, count = int(shapes.starts[slot]), int(shapes.counts[slot])
        polygons.append(rounded_outline(pool.corners[start : start + count], float(shapes.radii[slot])))
        owners.append(int(shapes.bodies[slot]))
    counts = [len(polygon) for polygon in polygons]
    corners = np.concatenate(polygons) if polygons else np.zeros((0, 2))
    starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    inside = [_bevel(polygon) for polygon in polygons]
    empty = np.zeros((0, 2))
    chain = np.flatnonzero(shapes.kinds == SEGMENT)
    first = shapes.starts[chain].astype(np.int64)
    disc = np.flatnonzero(shapes.kinds == DISC)
    return Outlines(
        corners,
        np.concatenate([part[0] for part in inside]) if inside else empty,
        np.concatenate([part[1] for part in inside]) if inside else empty,
        np.repeat(np.array(owners, dtype=np.int64), counts),
        starts,
        np.stack([pool.corners[first + 1], pool.corners[first + 2]], axis=1)
        if len(chain)
        else np.zeros((0, 2, 2)),
        shapes.bodies[chain].astype(np.int64),
        pool.corners[shapes.starts[disc]],
        shapes.radii[disc],
        shapes.bodies[disc].astype(np.int64),
    )


def _bevel(corners: Floats) -> tuple[Floats, Floats]:
    """Corners moved inwards, and the outward normal of the edge that begins at each."""
    edges = np.roll(corners, -1, axis=0) - corners
    lengths = elementwise.hypot(edges[:, 0], edges[:, 1])[:, None]
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.where(lengths > 0.0, lengths, 1.0)
    before = np.roll(normals, 1, axis=0)
    heights = linear.product(corners, normals.T)
    width = float((heights.max(axis=0) - heights.min(axis=0)).min())
    inset = min(BEVEL * width, MOST_BEVEL)
    share = np.maximum(1.0 + (normals * before).sum(axis=1), 0.3)[:, None]
    return corners - inset * (normals + before) / share, normals
