"""Too many pairs are refused before they take all memory, whatever finds them."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.broadphase import (
    CoveringGrid,
    HashedPairs,
    HierarchicalGrid,
    KineticSweep,
    MatrixPairs,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.kernels.limits import LimitError

COUNT = 200
ALL = COUNT * (COUNT - 1) // 2
MAKERS = {
    "uniform grid": lambda: UniformGrid((0.0, 0.0), (8.0, 8.0), 1.0),
    "covering grid": lambda: CoveringGrid((0.0, 0.0), (8.0, 8.0), 8.0),
    "hierarchical grid": HierarchicalGrid,
    "kinetic sweep": KineticSweep,
    "sweep and prune": SweepAndPrune,
}


@pytest.mark.parametrize("name", MAKERS)
def test_as_many_pairs_as_there_may_be_and_no_more(name: str):
    lowers = np.random.default_rng(1).random((COUNT, 2))
    enough = MAKERS[name]()
    enough.limit_pairs(2 * ALL)
    enough.add_boxes(lowers, lowers + 1.0)
    assert len(enough.pairs()) == ALL
    short = MAKERS[name]()
    short.limit_pairs(ALL - 1)
    with pytest.raises(LimitError, match="too many pairs: at most") as raised:
        short.add_boxes(lowers, lowers + 1.0)
        short.pairs()
    assert "\n" not in str(raised.value)
    assert len(short._sorter.keys) <= ALL - 1


def test_boxes_that_grow_together_are_refused_by_sweep_and_prune():
    phase = SweepAndPrune()
    phase.limit_pairs(1000)
    lowers = np.arange(400.0).reshape(200, 2) * 3.0
    ids = phase.add_boxes(lowers, lowers + 1.0)
    assert len(phase.pairs()) == 0
    with pytest.raises(LimitError):
        phase.update_boxes(ids, np.zeros((200, 2)), lowers + 1.0)
        phase.pairs()


@pytest.mark.parametrize("make", [HashedPairs, lambda: MatrixPairs(300)])
def test_managers_take_as_many_as_there_is_room_for(make):
    manager = make()
    manager.limit_pairs(100)
    pairs = np.array([(a, b) for a in range(20) for b in range(a + 1, 20)])
    manager.set_pairs(pairs[:64])
    assert len(manager.pairs()) == 64
    with pytest.raises(LimitError):
        manager.set_pairs(pairs)
