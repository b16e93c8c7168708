"""Spheres added to the body and removed, undone and redone."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.scenes.rigid_body.level import MOST_SPHERES
from game.scenes.rigid_body.model import RigidModel
from game.stage import Part

MOST_UNDONE = 30


class Edit(NamedTuple):
    """A sphere added (or else removed), its place in the list, and its row of the design."""

    added: bool
    place: int
    row: tuple[float, ...]


class Edits(Part):
    """What was changed of a model's body, latest last."""

    def __init__(self, model: RigidModel):
        self.model = model
        self.done: list[Edit] = []
        self.undone: list[Edit] = []

    def add(self, row: tuple[float, ...]) -> None:
        """Add a sphere (a row of a design), if there is space."""
        count = len(self.model.bodies.design)
        if count >= MOST_SPHERES:
            self.model.messages.say(f"There can be {MOST_SPHERES} spheres at most.")
            return
        self._do(Edit(True, count, row))

    def remove(self, index: int) -> None:
        """Remove a sphere; the last one stays."""
        design = self.model.bodies.design
        if len(design) == 1:
            self.model.messages.say("The last sphere stays.")
            return
        self._do(Edit(False, index, tuple(design[index].tolist())))

    def undo(self) -> None:
        """Undo the latest edit."""
        if self.done:
            edit = self.done[-1]
            self.undone, self.done = [*self.undone, edit], self.done[:-1]
            self._apply(edit._replace(added=not edit.added))

    def redo(self) -> None:
        """Do again what was undone last."""
        if self.undone:
            edit = self.undone[-1]
            self.done, self.undone = [*self.done, edit], self.undone[:-1]
            self._apply(edit)

    def _do(self, edit: Edit) -> None:
        self.undone = []
        self.done = [*self.done, edit][-MOST_UNDONE:]
        self._apply(edit)

    def _apply(self, edit: Edit) -> None:
        added, place, row = edit
        design = self.model.bodies.design
        self.model.reshape(
            np.insert(design, place, row, axis=0) if added else np.delete(design, place, axis=0)
        )
