"""Boxes paired up by incremental sweep and prune on two axes, beside the naive broad phase."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.broadphase import SweepAndPrune
from game.physics.broadphase.effects import MOTION
from game.physics.broadphase.workloads import expected_swaps
from game.physics.kernels import elementary
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.compared import ComparedModel
from game.scenes.boxes.model.managers import MOST_IN_MATRIX, manager_for
from game.scenes.boxes.model.names import named
from game.scenes.boxes.model.swap_story import swap_sentences
from game.scenes.boxes.parameters import SweepParameters

MOST_TICKS = 1_500  # boxes whose end points are drawn
MOST_KEPT = 5  # sentences


class SweepAndPruneModel(ComparedModel):
    """The model of C07.

    swaps: in the last step; swapped: for each axis that is shown, which ends changed places; story: the last
    swaps in words, where boxes have letters; fresh: how many of these are of the last step.
    """

    parameters: SweepParameters
    shaping = ("manager", "resort")

    def make_structures(self) -> None:
        parameters = self.parameters
        self.sap = SweepAndPrune(manager_for(len(self.boxes.alive), parameters.manager), parameters.resort)
        self.swaps = 0
        self.swapped: tuple[NDArray[np.bool_], ...] = ()
        self.story: list[str] = []
        self.fresh = 0
        self.make_naive()

    def structures(self) -> tuple[SweepAndPrune]:
        return (self.sap,)

    @property
    def shows_axes(self) -> bool:
        """Whether the sorted end points are shown."""
        return self.parameters.axes and len(self.boxes) <= MOST_TICKS

    def add(self, lowers: Floats, uppers: Floats, velocities: Floats) -> NDArray[np.int64]:
        rows = len(self.boxes) + len(lowers)
        if self.sap.manager.greatest < rows - 1:
            if rows > MOST_IN_MATRIX:
                self.messages.say(f"Above {MOST_IN_MATRIX} boxes the pairs are kept in a hash table.")
            self.sap.use_manager(manager_for(rows, self.parameters.manager))
        return super().add(lowers, uppers, velocities)

    def pair_up(self) -> None:
        pairs_before, swaps_before = self.pairs, self.sap.swaps
        shown = named(self.boxes) or self.shows_axes
        orders = [self.sap.end_points(axis)[1:] for axis in range(2)] if shown else []
        with self.watch.time("sweep"):
            self.update(self.sap)
            self.pairs = self.sap.pairs()
        events = self.sap.manager.take_events()
        self.begun, self.ended = len(events.begun), len(events.ended)
        self.swaps = self.sap.swaps - swaps_before
        self.swapped = tuple(self._swapped_since(axis, *order) for axis, order in enumerate(orders))
        if named(self.boxes):
            sentences = swap_sentences(self.boxes, orders, pairs_before)
            self.fresh = len(sentences)
            self.story = (self.story + sentences)[-MOST_KEPT:]
        self.compare()

    def _swapped_since(self, axis: int, who: Any, upper: Any) -> NDArray[np.bool_]:
        """Which end points on an axis are others than they were."""
        _, who_now, upper_now = self.sap.end_points(axis)
        swapped: NDArray[np.bool_] = (who != who_now) | (upper != upper_now)
        return swapped

    def mean_swaps(self) -> float:
        """Swaps to be expected in a step of isotropic motion at the boxes' mean speed."""
        boxes = self.boxes
        if MOTION not in self.active or not len(boxes):
            return 0.0
        speed = float(np.sqrt((elementary.square(boxes.velocities[boxes.ids])).sum(axis=1)).mean())
        return expected_swaps(len(boxes), speed * self.parameters.step_length, (WIDTH, HEIGHT))
