"""The hand on a tilted stack: a place on a sheet is one in the world, and boxes of its level are meant."""

from __future__ import annotations

import msgspec
import numpy as np

from game.scenes.boxes.hand import Hand
from game.scenes.boxes.model.base import NO_BOX
from game.scenes.boxes.model.hierarchical_grids import HierarchicalGridModel
from game.scenes.boxes.sheets import Sheet, sheet_at, sheets_of
from game.stage import Pointer


class StackHand(Hand):
    """The hand of C06. sheet: the one that the pointer is on; grasped: that on which something was taken."""

    model: HierarchicalGridModel

    def __init__(self, model: HierarchicalGridModel):
        super().__init__(model)
        self.sheet: Sheet | None = None
        self.grasped: Sheet | None = None

    def take(self, event: Pointer) -> None:
        if self.model.stacked and event.kind != "cancel":
            busy = self.model.held >= 0 or self.anchor is not None
            sheet = sheet_at(sheets_of(self.model), event.x, event.y)
            if sheet is not None:
                self.sheet = sheet
            elif event.kind == "down" or not (busy or self.erasing):
                self.pointed = None
                return
            if busy and self.grasped is not None:
                self.sheet = self.grasped
            if event.kind == "down":
                self.grasped = self.sheet
            if self.sheet is None:
                return
            x, y = self.sheet.back(event.x, event.y)
            event = msgspec.structs.replace(event, x=x, y=y)
        super().take(event)

    def box_at(self, at: tuple[float, float]) -> int:
        """As ever; in a stack the topmost box of the level whose sheet is pointed at."""
        return self._on_level(at, super().box_at(at))

    @property
    def looked(self) -> int:
        """As ever; in a stack of the boxes below the pointer the topmost one of that level."""
        found = super().looked
        if found in (NO_BOX, self.model.held, self.model.chosen) or self.pointed is None:
            return found
        return self._on_level(self.pointed, found)

    def _on_level(self, at: tuple[float, float], found: int) -> int:
        """The topmost box at a place, m, on the level of the sheet pointed at; NO_BOX if there is none."""
        if not self.model.stacked or self.sheet is None or found < 0:
            return found
        boxes, grid = self.model.boxes, self.model.grid
        within = ((boxes.lowers <= at) & (at <= boxes.uppers)).all(axis=1) & (boxes.alive == 1)
        mine = [i for i in np.flatnonzero(within).tolist() if grid.level(i) == self.sheet.level]
        return mine[-1] if mine else NO_BOX
