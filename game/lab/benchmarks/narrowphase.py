"""Distances of convex polygons that turn a little from round to round, beside shapely."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.lab.studies.narrowphase.support import pebbles
from game.physics.kernels import elementwise
from game.physics.narrowphase import PolygonSet, Proximities, gjk_batch, vclip_batch

PAIRS, SHAPES, TURN = 1_000, 40, 0.01
ROUNDS = 16
SIZES = (8, 64, 512)


class Workload:
    """A thousand pairs of pebbles in random places, none overlapping; poses for ROUNDS rounds."""

    def __init__(self, corners: int) -> None:
        self.points = pebbles(corners, SHAPES, corners)
        random = np.random.default_rng(corners)
        self.which = random.integers(0, SHAPES, (2, PAIRS))
        self.sets = [PolygonSet([self.points[k] for k in row]) for row in self.which.tolist()]
        far, around = random.uniform(2.05, 4.0, PAIRS), random.uniform(0.0, 2.0 * math.pi, PAIRS)
        self.places = np.column_stack((far * elementwise.cos(around), far * elementwise.sin(around)))
        self.angles = random.uniform(0.0, 2.0 * math.pi, (2, PAIRS))
        self.poses = [[self.pose(k, side) for side in (0, 1)] for k in range(ROUNDS)]
        self.round = 0
        self.features = np.full((PAIRS, 2), -1, dtype=np.int64)

    def pose(self, k: int, side: int) -> Floats:
        """Poses (PAIRS, 4) x, y, cos, sin of the first or second polygons in round k."""
        angles = self.angles[side] + (TURN if side else -TURN) * k
        return np.column_stack((self.places * side, elementwise.cos(angles), elementwise.sin(angles)))

    def next_poses(self) -> list[Floats]:
        """Those of the next round, there and back."""
        self.round += 1
        k = self.round % (2 * ROUNDS - 2)
        return self.poses[k if k < ROUNDS else 2 * ROUNDS - 2 - k]

    def world(self, k: int) -> list[list[Floats]]:
        """All polygons of round k where they lie."""
        return [
            [
                self.points[which] @ np.array([[c, s], [-s, c]]) + (x, y)
                for which, (x, y, c, s) in zip(self.which[side], self.poses[k][side].tolist(), strict=True)
            ]
            for side in (0, 1)
        ]

    def ask(self, method: str) -> Proximities:
        """All distances of the next round: ``gjk-cold``, ``gjk-warm``, ``vclip-cold`` or ``vclip``."""
        a, b = self.sets
        poses_a, poses_b = self.next_poses()
        if method.endswith("cold"):
            self.features[:] = -1
        batch = vclip_batch if method.startswith("vclip") else gjk_batch
        return batch(a, b, None, poses_a, poses_b, self.features)


def shapely_distances(corners: int) -> Call:
    """All distances by shapely's vectorised function, of polygons that are made beforehand."""
    import shapely

    sides: Any = [
        np.array([shapely.Polygon(p) for p in side], dtype=object) for side in Workload(corners).world(0)
    ]
    return lambda: shapely.distance(*sides)


def _ours(method: str, corners: int) -> Call:
    return partial(Workload(corners).ask, method)


SCENARIOS = tuple(
    Scenario(
        f"{method}-{corners}", f"{title}, polygons of {corners} vertices", "query",
        partial(_ours, method, corners), PAIRS,
        () if method.endswith("cold") else (Peer("shapely distance", partial(shapely_distances, corners)),),
    )
    for corners in SIZES
    for method, title in (
        ("gjk-cold", "GJK without a start"), ("gjk-warm", "GJK from the last answer"),
        ("vclip-cold", "V-Clip without a start"), ("vclip", "V-Clip"),
    )
)  # fmt: skip
