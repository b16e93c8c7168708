"""What is measured in the scenes of bounding-volume trees."""

from __future__ import annotations

import math

from game.scenes.bounds.model import BoundsModel
from game.stage import Readout

BESIDE = {"obb": "with boxes", "capsule": "with capsules", "aabb": "axis-aligned"}  # tests of the other trees


def readouts_of(model: BoundsModel, walking: bool = False) -> list[Readout]:
    """Costs of the query, the gap, and how tight the volumes are.

    walking: the query is being walked through, and its crossings have not been found yet.
    """
    query, gap = model.pair.query, model.gap()
    beside = model.beside.query if model.parameters.compare else None
    kind = model.beside.options.kind
    return [
        Readout("tests", query.volume_tests if query else 0),
        Readout("crossings", math.nan if walking else query.crossing_count if query else 0),
        Readout("query", model.watch.median("query"), "s"),
        Readout("gap", gap.distance if gap is not None else math.nan, "m"),
        Readout("volumes", sum(len(tree) for tree in model.pair.trees)),
        Readout("leaf pairs", query.leaves_met if query else 0),
        Readout("segment tests", query.segment_tests if query else 0),
        *([Readout(BESIDE[kind], beside.volume_tests)] if beside else []),
        Readout("area above exact", excess_of(model)),
        Readout("building", model.build_watch.median("build"), "s"),
    ]


def excess_of(model: BoundsModel) -> float:
    """Area of both roots over that of exact ones, less 1; NaN without any, and while corners are dragged."""
    if model.board.held == "point":
        return math.nan
    found = exact = 0.0
    for i, tree in enumerate(model.pair.trees):
        found += float(tree.areas()[0])
        exact += model.pair.exact_area(i)
    return found / exact - 1.0 if exact > 0.0 else math.nan
