"""Two convex polygons measured by GJK, and in an overlap by EPA."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary
from game.physics.narrowphase import (
    ConvexPolygon,
    Feature,
    PolygonSet,
    Proximity,
    epa,
    epa_trace,
    gjk_batch,
)
from game.physics.narrowphase.queries import PolytopeStep, SimplexStep
from game.physics.proximity_effects import EXACT_ANSWER
from game.scenes.convex.model.pair import PairModel
from game.scenes.convex.parameters import GjkParameters


class GjkModel(PairModel):
    """The pair of C11."""

    parameters: GjkParameters

    def measure(self, a: ConvexPolygon, b: ConvexPolygon, start: tuple[Feature, Feature]) -> Proximity:
        return epa(a, b, start, **self._options())

    def _options(self) -> dict[str, Any]:
        """What the parameters say to a query."""
        return {
            "tolerance": elementary.pow(10.0, self.parameters.exponent),
            "method": self.parameters.method,
            "deep": EXACT_ANSWER in self.active,
        }

    def measure_batch(
        self, shapes: PolygonSet, pairs: NDArray[np.int64], features: NDArray[np.int64]
    ) -> None:
        gjk_batch(shapes, shapes, pairs, features=features, **self._options())

    def trace(self) -> list[SimplexStep | PolytopeStep]:
        """The steps of the last query: GJK's, then in an overlap EPA's; none without two convex polygons."""
        shapes = self.shapes()
        if shapes is None:
            return []
        _, steps, growth = epa_trace(*shapes, self.start_features(*shapes), **self._options())
        return [*steps, *growth]

    def trace_length(self) -> int:
        return len(self.trace())
