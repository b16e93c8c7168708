"""Broad phases: which of many boxes overlap, found without testing every box against every other.

All broad phases take the same calls and give the same answers; closed boxes, so touching overlaps:

=====================  ==============================================================  ==================
``NaiveBroadPhase``    every box against every other                                   below 30 boxes
``UniformGrid``        a dense matrix of cells                                         boxes alike in size
``CoveringGrid``       the same, each box in all cells it covers                       to compare with
``HierarchicalGrid``   hash tables, a grid for every size                              boxes of any size
``SweepAndPrune``      end points kept sorted on two axes                              slow motion
``BspTree``            cuts that follow the boxes                                      unlike sizes, heaps
``KineticSweep``       bounds of what boxes cover in steps to come                     even motion
=====================  ==============================================================  ==================

``MatrixPairs`` and ``HashedPairs`` keep pairs from step to step and tell which began and which ended.
"""

from game.physics.broadphase.boxes import BroadPhase
from game.physics.broadphase.bsp.tree import BspTree
from game.physics.broadphase.covering_grid import CoveringGrid
from game.physics.broadphase.hierarchical_grid import HierarchicalGrid
from game.physics.broadphase.kinetic.kinetic_sweep import KineticSweep
from game.physics.broadphase.naive import NaiveBroadPhase
from game.physics.broadphase.pairs import HashedPairs, MatrixPairs, PairEvents, PairManager
from game.physics.broadphase.sweep_and_prune import SweepAndPrune
from game.physics.broadphase.uniform_grid import UniformGrid

__all__ = [
    "BroadPhase",
    "BspTree",
    "CoveringGrid",
    "HashedPairs",
    "HierarchicalGrid",
    "KineticSweep",
    "MatrixPairs",
    "NaiveBroadPhase",
    "PairEvents",
    "PairManager",
    "SweepAndPrune",
    "UniformGrid",
]
