"""A broad phase beside the naive one: the same boxes, the same pairs, and what each takes."""

from __future__ import annotations

import numpy as np

from game.physics.broadphase import NaiveBroadPhase
from game.physics.broadphase.effects import NAIVE
from game.scenes.boxes.model.base import BoxesModel
from game.scenes.boxes.parameters import ComparedParameters

MOST_NAIVE = 4_000  # boxes; the naive method takes some 10 ms there, and four times as much at twice as many


class ComparedModel(BoxesModel):
    """Base of models that hold one broad phase against testing every box against every other.

    compared: whether that was done in the last step; same: whether both found the same pairs, or True.
    """

    parameters: ComparedParameters

    def make_naive(self) -> None:
        """Begin without the naive broad phase; it takes the boxes when it is asked."""
        self.naive = NaiveBroadPhase()
        self.compared, self.same = False, True

    def compare(self) -> None:
        """Find the pairs by the naive method, too, if that is asked for and not too much."""
        ids = self.boxes.ids
        self.compared = NAIVE in self.active and len(ids) <= MOST_NAIVE
        if not self.compared:
            self.watch.forget("naive")
            self.same = True
            return
        if len(self.naive) != len(ids) or not np.array_equal(self.naive.ids(), ids):
            self.naive = NaiveBroadPhase()
            lowers, uppers = self.boxes.covered()
            self.naive.add_boxes(lowers[ids], uppers[ids], ids=ids)
        with self.watch.time("naive"):
            self.update(self.naive)
            pairs = self.naive.pairs()
        self.same = np.array_equal(pairs, self.pairs)
