"""What is measured in the V-Clip and GJK scenes."""

from __future__ import annotations

import math
from time import perf_counter

import numpy as np

from game.physics.narrowphase import vclip
from game.physics.narrowphase.batch import PolygonSet
from game.scenes.convex.model.pair import PairModel
from game.stage import Readout
from game.worlds.stopwatch import Stopwatch

REPEATS = 64  # queries that are timed together


class PairReadouts:
    """Distance, steps and time of the query."""

    def __init__(self, model: PairModel):
        self.model = model
        self._watch = Stopwatch()

    def rows(self) -> list[Readout]:
        """All of them."""
        model, ready = self.model, self.model.ready
        distance, steps = (float(model.answer[0]), float(model.answer[7])) if ready else (math.nan, math.nan)
        queries, total = (int(count) for count in model.counts)
        rows = [
            Readout("distance", distance, "m"),
            Readout("steps", steps),
            Readout("query", self._query_time(), "s"),
            Readout("mean steps", total / max(queries, 1)),
        ]
        if ready:
            rows.append(Readout("certificate lacks", model.certificate()))
        return rows

    def _query_time(self) -> float:
        """Time of a query as a batch has it, s: for the picture alone."""
        shapes = self.model.shapes()
        if shapes is None:
            return math.nan
        batch = PolygonSet(shapes)
        pairs = np.tile(np.array((0, 1), dtype=np.int64), (REPEATS, 1))
        features = np.tile(self.model.begun, (REPEATS, 1))
        began = perf_counter()
        self.model.measure_batch(batch, pairs, features)
        self._watch.add("query", (perf_counter() - began) / REPEATS)
        return self._watch.median("query")


class GjkReadouts(PairReadouts):
    """The same, and what V-Clip says."""

    def rows(self) -> list[Readout]:
        rows, shapes = super().rows(), self.model.shapes()
        if shapes is not None:
            rows.append(Readout("V-Clip", vclip(*shapes).distance, "m"))
        return rows
