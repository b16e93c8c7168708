"""Boxes paired up by a uniform grid; a full matrix and a hash table keep the pairs, side by side."""

from __future__ import annotations

import math

import numpy as np

from game.physics.broadphase import CoveringGrid, HashedPairs, MatrixPairs, PairEvents, UniformGrid
from game.physics.broadphase.effects import HASHED_PAIRS, MATRIX_PAIRS
from game.physics.effects import EffectSet
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.base import BoxesModel
from game.scenes.boxes.model.managers import MOST_IN_MATRIX, matrix_for
from game.scenes.boxes.parameters import GridParameters

MOST_CELLS = 1 << 20
TURNS = ("first", "second")  # in which a manager is given the pairs


class UniformGridModel(BoxesModel):
    """The model of C05."""

    parameters: GridParameters
    shaping = ("cell", "storage")

    def make_structures(self) -> None:
        cell = max(self.parameters.cell * self.size, math.sqrt(WIDTH * HEIGHT / MOST_CELLS))
        kind = UniformGrid if self.parameters.storage == "corner" else CoveringGrid
        self.grid = kind((0.0, 0.0), (WIDTH, HEIGHT), min(cell, WIDTH))
        self.hashed = HashedPairs()
        self.answers: list[PairEvents] = []  # of the managers, in the last step
        self.matrix: MatrixPairs | None = None
        self._fit_matrix(len(self.boxes.alive))

    def _fit_matrix(self, rows: int) -> None:
        """A matrix for the ids there are, while there are not too many; its pairs are kept."""
        if rows <= MOST_IN_MATRIX and self.matrix is not None and self.matrix.capacity >= rows:
            return
        old, self.matrix = self.matrix, matrix_for(rows)
        if old is None:
            return
        if self.matrix is None:
            self.messages.say(f"Above {MOST_IN_MATRIX} boxes the full matrix is left out.")
        else:
            self.matrix.set_pairs(old.pairs())
            self.matrix.take_events()

    def structures(self) -> tuple[UniformGrid]:
        return (self.grid,)

    def pair_up(self) -> None:
        with self.watch.time("grid"):
            self.update(self.grid)
            self.pairs = self.grid.pairs()
        self._fit_matrix(len(self.boxes.alive))
        self.answers = []
        managers = (("matrix", MATRIX_PAIRS, self.matrix), ("hash", HASHED_PAIRS, self.hashed))
        # in turn, as the first one finds the pairs in no cache and the second one does
        for name, effect, manager in managers if self.steps % 2 else managers[::-1]:
            if manager is None or effect not in self.active:
                self._forget_times(name)
                continue
            with self.watch.time(f"{name}, {TURNS[len(self.answers)]}"):
                manager.set_pairs(self.pairs)
                self.answers.append(manager.take_events())
        self.begun, self.ended = (len(events) for events in self.answers[0]) if self.answers else (0, 0)

    def manager_s(self, name: str) -> float:
        """What a manager ("matrix", "hash") takes in a step, s: the mean over both turns; NaN if unknown."""
        medians = [self.watch.median(f"{name}, {turn}") for turn in TURNS]
        known = [seconds for seconds in medians if math.isfinite(seconds)]
        return sum(known) / len(known) if known else math.nan

    def _forget_times(self, *names: str) -> None:
        for name in names:
            for turn in TURNS:
                self.watch.forget(f"{name}, {turn}")

    @property
    def compared(self) -> bool:
        """Whether both managers kept the pairs in the last step, so that there is something to compare."""
        return len(self.answers) == 2

    @property
    def same(self) -> bool:
        """Whether the managers' answers of the last step agree.

        They are compared when that is asked for, so that it is not counted as the cost of a manager.
        """
        return not self.compared or all(np.array_equal(*both) for both in zip(*self.answers, strict=True))

    @property
    def keeps_matrix(self) -> bool:
        """Whether the full matrix keeps the pairs."""
        return self.matrix is not None and MATRIX_PAIRS in self.active

    @property
    def keeps_table(self) -> bool:
        """Whether the hash table keeps the pairs."""
        return HASHED_PAIRS in self.active

    def change_effects(self, active: EffectSet) -> None:
        """A manager that was off is given the pairs there are; who comes first is another one now."""
        super().change_effects(active)
        self._forget_times("matrix", "hash")
        for manager in (self.matrix, self.hashed):
            if manager is not None:
                manager.set_pairs(self.pairs)
                manager.take_events()
