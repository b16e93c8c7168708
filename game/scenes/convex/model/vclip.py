"""Two convex polygons measured by V-Clip."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.narrowphase import ConvexPolygon, Feature, PolygonSet, Proximity, vclip, vclip_batch
from game.physics.narrowphase.queries import FeatureStep, vclip_trace
from game.physics.proximity_effects import EXACT_ANSWER
from game.scenes.convex.model.pair import PairModel
from game.scenes.convex.parameters import VClipParameters


class VClipModel(PairModel):
    """The pair of C10."""

    parameters: VClipParameters

    def measure(self, a: ConvexPolygon, b: ConvexPolygon, start: tuple[Feature, Feature]) -> Proximity:
        return vclip(a, b, start, EXACT_ANSWER in self.active)

    def measure_batch(
        self, shapes: PolygonSet, pairs: NDArray[np.int64], features: NDArray[np.int64]
    ) -> None:
        vclip_batch(shapes, shapes, pairs, features=features, deep=EXACT_ANSWER in self.active)

    def trace(self) -> list[FeatureStep]:
        """The steps of the last query; none without two convex polygons."""
        shapes = self.shapes()
        if shapes is None:
            return []
        return vclip_trace(*shapes, self.start_features(*shapes), EXACT_ANSWER in self.active)[1]

    def trace_length(self) -> int:
        return len(self.trace())
