"""V-Clip: two convex polygons, their Voronoi regions, and the walk to the closest features."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from game.lab.studies.narrowphase.distance import vclip_study
from game.scenes.convex import C10
from game.scenes.convex.base import ConvexPairScene
from game.scenes.convex.figure import draw_regions
from game.scenes.convex.model.vclip import VClipModel
from game.scenes.convex.parameters import VClipParameters
from game.scenes.convex.view import vclip as view
from game.stage import Equation


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

    parameters_type = VClipParameters
    parameters: VClipParameters
    model_type = VClipModel
    model: VClipModel

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
        "Drag B through A: the arrow is the shortest displacement that separates them.",
        "Choose Draw and click a star: it is refused; press H to take its hull.",
    )

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return view.legend(self.model)

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(self.model, self.hand, canvas)
        self.draw_expected(canvas)
