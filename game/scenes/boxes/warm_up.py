"""What broad-phase scenes call, called once on three boxes: it is compiled before a scene opens."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from game.physics.broadphase import BroadPhase, HashedPairs, HierarchicalGrid, MatrixPairs, UniformGrid


def exercise(make: Callable[[], BroadPhase]) -> None:
    """Call all that a broad phase and the pair managers can do on three boxes, so that it is compiled."""
    phase = make()
    corners = np.zeros((3, 2))
    ids = phase.add_boxes(corners, corners + 1.0)
    phase.update_boxes(ids, corners, corners + 2.0)
    phase.query_point((0.5, 0.5))
    phase.update_box(phase.add_box((0.0, 0.0), (1.0, 1.0)), (2.0, 2.0), (3.0, 3.0))
    pairs = phase.pairs()
    if isinstance(phase, (UniformGrid, HierarchicalGrid)):
        phase.visits(0)
    phase.remove_box(3)
    phase.remove_boxes(ids[:1])
    for manager in (HashedPairs(), MatrixPairs(4)):
        manager.set_pairs(pairs)
        manager.chain(0, 1) if isinstance(manager, HashedPairs) else manager.place(0, 1)
        manager.clear()
        manager.take_events()
