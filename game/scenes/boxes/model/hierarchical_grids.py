"""Boxes paired up by hierarchical grids, beside the naive broad phase."""

from __future__ import annotations

from game.physics.broadphase import HierarchicalGrid
from game.scenes.boxes.model.compared import ComparedModel
from game.scenes.boxes.model.managers import manager_for
from game.scenes.boxes.parameters import HierarchyParameters

MOST_STACKED = 1_500  # boxes in a stack of levels


class HierarchicalGridModel(ComparedModel):
    """The model of C06."""

    parameters: HierarchyParameters
    shaping = ("manager", "step_ratio")

    def make_structures(self) -> None:
        self.grid = HierarchicalGrid(int(self.parameters.step_ratio))
        self.keeper = manager_for(len(self.boxes.alive), self.parameters.manager)
        self.make_naive()

    def structures(self) -> tuple[HierarchicalGrid]:
        return (self.grid,)

    @property
    def stacked(self) -> bool:
        """Whether the levels are shown as a stack."""
        return self.parameters.stack and len(self.boxes) <= MOST_STACKED

    def pair_up(self) -> None:
        rows = len(self.boxes.alive)
        with self.watch.time("hierarchical"):
            self.update(self.grid)
            self.pairs = self.grid.pairs()
        if self.keeper.greatest < rows - 1:
            self.keeper = manager_for(rows, self.parameters.manager)
        with self.watch.time("keeper"):
            self.keeper.set_pairs(self.pairs)
            events = self.keeper.take_events()
        self.begun, self.ended = len(events.begun), len(events.ended)
        self.compare()
