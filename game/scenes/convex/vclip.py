"""V-Clip: two convex polygons, their Voronoi regions, and the walk to the closest features."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.narrowphase.distance import vclip_study
from game.physics.narrowphase import ConvexPolygon, Feature, PolygonSet, Proximity, vclip, vclip_batch
from game.physics.narrowphase.queries import FeatureStep, vclip_trace
from game.physics.proximity_effects import EXACT_ANSWER
from game.scenes.convex import C10
from game.scenes.convex import vclip_view as view
from game.scenes.convex.base import ConvexPairScene
from game.scenes.convex.figure import draw_regions
from game.stage import Equation, Toggle


class VClip(ConvexPairScene):
    """Two convex polygons, and the two features of them that are closest: vertices or edges. The plane around
    each polygon is divided into the Voronoi regions of its features: what lies in a region is closest to that
    feature. Two features are the closest ones when each has the nearest point of the other in its own region.

    If a border is crossed, V-Clip goes to the neighbour beyond it, and the distance has become less. When
    the shapes have hardly moved, it begins at the last answer and is there at once: that is coherence. A
    vertex behind an edge would be caught in a local minimum; then the edge it is farthest in front of is
    next. Inside all edges, there is overlap, and its depth is measured along the normals of all edges.

    An outline that is not convex is refused, and its hull offered.
    """

    name, task, title = C10.names
    study = vclip_study

    regions = Toggle(
        True, group="Shown", label="Voronoi regions", help="borders; those of the two features filled"
    )
    walk = Toggle(True, group="Shown", label="Walk", help="features visited by the last query, numbered")

    figure = staticmethod(draw_regions)
    equations = (
        Equation(
            "Region of a vertex",
            r"\v{e}_i \cdot (\v{x} - \v{p}_i) \le 0 \le \v{e}_{i-1} \cdot (\v{x} - \v{p}_i)",
        ),
        Equation(
            "Region of an edge", r"0 \le \v{e}_i \cdot (\v{x} - \v{p}_i) \le \abs{\v{e}_i}^2", "Mirtich 1998"
        ),
        Equation(
            "Distance to a vertex, along an edge",
            r"D' \propto \v{g} \cdot (\v{p} + \lambda\v{g} - \v{x})",
            "clip_edge",
        ),
        Equation("Distance to an edge, along another", r"D' \propto \v{n} \cdot \v{g}", "clip_edge"),
        Equation("Proof", r"\min_B \v{n}\cdot\v{x} - \max_A \v{n}\cdot\v{x} = d", "optimality certificate"),
    )
    try_this = (
        "Switch coherence off and press S: the walk begins at another pair of features each time.",
        "Walk through the query with the arrow keys and see which border sends it on.",
        "Drag B through A: the arrow is the shortest way out.",
        "Choose Draw and click a star: it is refused; press H to take its hull.",
    )

    def measure(self, a: ConvexPolygon, b: ConvexPolygon, start: tuple[Feature, Feature]) -> Proximity:
        return vclip(a, b, start, EXACT_ANSWER in self.active)

    def time_batch(self, shapes: PolygonSet, pairs: NDArray[np.int64], features: NDArray[np.int64]) -> None:
        vclip_batch(shapes, shapes, pairs, features=features, deep=EXACT_ANSWER in self.active)

    def trace(self) -> list[FeatureStep]:
        """The steps of the last query."""
        a, b = self.shape(0), self.shape(1)
        if a is None or b is None:
            return []
        return vclip_trace(a, b, self.start_features(a, b), EXACT_ANSWER in self.active)[1]

    def trace_length(self) -> int:
        return len(self.trace()) if self.ready else 0

    def legend(self) -> Sequence[tuple[str, str, str]]:
        if not self.ready:
            return (("dash:vermilion", "not convex: refused", ""), ("dash:green", "hull offered", ""))
        rows = [("line:green", "closest features", ""), ("disc:amber", "closest points", "")]
        if self.answer[0] <= 0.0:
            rows = [("line:green", "features of the shortest way out", ""), ("arrow:vermilion", "depth", "")]
        if self.walk:
            rows.append(("line:amber", "features visited", str(int(self.answer[7]))))
        if self.regions:
            rows.append(("box:text1:chalk", "their Voronoi regions", ""))
        return rows

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(self, canvas)
