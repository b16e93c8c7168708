"""What the tests of broad phases share: one of each kind, and the plainest answer there is."""

from __future__ import annotations

import numpy as np

from game.physics.broadphase import (
    BroadPhase,
    BspTree,
    CoveringGrid,
    HierarchicalGrid,
    KineticSweep,
    MatrixPairs,
    NaiveBroadPhase,
    SweepAndPrune,
    UniformGrid,
)

PHASES = {
    "naive": NaiveBroadPhase,
    "uniform": lambda: UniformGrid((0.0, 0.0), (8.0, 8.0), 1.0),
    "uniform-fine": lambda: UniformGrid((-1.0, -1.0), (9.0, 9.0), 0.3),
    "covering": lambda: CoveringGrid((0.0, 0.0), (8.0, 8.0), 1.0),
    "hierarchical": HierarchicalGrid,
    "hierarchical-8": lambda: HierarchicalGrid(8),
    "bsp": BspTree,
    "kinetic": KineticSweep,
    "kinetic-16": lambda: KineticSweep(16, 2.0, 0.01),
    "sweep": SweepAndPrune,
    "sweep-matrix": lambda: SweepAndPrune(MatrixPairs(400), resort=False),
}


def every_phase() -> dict[str, BroadPhase]:
    """A new broad phase of every kind."""
    return {name: make() for name, make in PHASES.items()}


def brute_pairs(ids: np.ndarray, lowers: np.ndarray, uppers: np.ndarray) -> np.ndarray:
    """All overlapping pairs by comparing everything with everything, (m, 2), a < b, sorted."""
    meet = (lowers[:, None] <= uppers[None]) & (lowers[None] <= uppers[:, None])
    a, b = np.nonzero(np.triu(meet.all(axis=2), 1))
    pairs = np.stack([ids[a], ids[b]], axis=1).reshape(-1, 2)
    pairs.sort(axis=1)
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


def brute_query(ids: np.ndarray, lowers: np.ndarray, uppers: np.ndarray, lower, upper) -> np.ndarray:
    """Ids of the boxes that overlap a box, ascending."""
    meet = (lowers <= np.asarray(upper)) & (np.asarray(lower) <= uppers)
    return np.sort(ids[meet.all(axis=1)])
