"""Polygons that break: shards as Voronoi cells of places at random."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.solids.mass import polygon_mass


def cut(corners: Floats, point: Floats, normal: Floats) -> Floats:
    """The part (m, 2) of a convex polygon (n, 2) that lies behind a line through a point, m."""
    away = corners - point
    side = away[:, 0] * normal[0] + away[:, 1] * normal[1]
    found = list[Floats]()
    for k in range(len(corners)):
        after = (k + 1) % len(corners)
        if side[k] <= 0.0:
            found.append(corners[k])
        if (side[k] < 0.0) != (side[after] < 0.0) and side[k] != side[after]:
            found.append(corners[k] + side[k] / (side[k] - side[after]) * (corners[after] - corners[k]))
    return np.array(found).reshape(-1, 2)


def shards_of(outline: Floats, sites: Floats, least: float) -> list[Floats]:
    """Voronoi cells of sites (n, 2) in a convex polygon: corners (m, 2) of each above ``least``, m²."""
    found = []
    for k, site in enumerate(sites):
        cell = outline
        for j, other in enumerate(sites):
            if j != k and len(cell) >= 3:
                cell = cut(cell, 0.5 * (site + other), other - site)
        if len(cell) >= 3 and polygon_mass(cell).mass > least:
            found.append(cell)
    return found
