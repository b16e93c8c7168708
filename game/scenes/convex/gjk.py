"""GJK: two convex polygons, their Minkowski difference, and the simplexes that walk to the origin."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from game.lab.studies.narrowphase.distance import gjk_study
from game.scenes.convex import C11
from game.scenes.convex.base import ConvexPairScene
from game.scenes.convex.figure import draw_difference
from game.scenes.convex.model.gjk import GjkModel
from game.scenes.convex.parameters import GjkParameters
from game.scenes.convex.readouts import GjkReadouts
from game.scenes.convex.view import gjk as view
from game.stage import Equation, Frame, Strip


class Gjk(ConvexPairScene):
    """Two convex polygons A and B, and beside them all differences of their points: A − B, also convex. Its
    distance from the origin is that of the two; if it holds the origin, they overlap.

    GJK never builds A − B. It keeps a simplex, one or two of its corners, and takes the point v of it that is
    closest to the origin. It asks both polygons for their vertices farthest along −v and v: that gives the
    corner w farthest towards the origin. If w is no nearer than v, seen along v, v is the answer; else the
    best simplex with w is the next one. Farthest vertices are found by climbing from the last one, and the
    last simplex is the first one of the next query.

    If a triangle holds the origin, the polytope is expanded from it to the border of A − B (EPA): its closest
    edge is the depth of the overlap.
    """

    name, task, title = C11.names
    study = gjk_study

    parameters_type = GjkParameters
    parameters: GjkParameters
    model_type = GjkModel
    model: GjkModel
    readouts_type = GjkReadouts

    strips = (
        Strip("Steps", "per query", ("steps",)),
        Strip("Distance", "m", ("distance", "V-Clip"), ("V-Clip",), sometimes=("V-Clip",)),
        Strip("Query", "s", ("query",)),
    )
    figure = staticmethod(draw_difference)
    equations = (
        Equation("Minkowski difference", r"A - B = \{ \v{a} - \v{b} \}"),
        Equation("Support", r"\v{w} = s_A(-\v{v}) - s_B(\v{v})", "Gilbert, Johnson, Keerthi 1988"),
        Equation(
            "The end",
            r"\v{v}\cdot\v{v} - \v{v}\cdot\v{w} \le \epsilon \v{v}\cdot\v{v}",
            "van den Bergen 1999",
        ),
        Equation("Bounds", r"\frac{\v{v}\cdot\v{w}}{\abs{\v{v}}} \le d \le \abs{\v{v}}"),
        Equation(
            "Witness points", r"\v{v} = \sum \lambda_i (\v{a}_i - \v{b}_i),  \v{p} = \sum \lambda_i \v{a}_i"
        ),
    )
    try_this = (
        "Switch coherence off and walk with the arrow keys: simplex by simplex to the origin.",
        "Drag B onto A: the difference moves over the origin, and the polytope grows to its border.",
        "Open the two coins and compare scan with climb.",
        "Set the tolerance to a tenth: the query ends early, with a distance that is a little too large.",
    )

    def frame(self) -> Frame:
        return view.frame_of(self.model.content.view) if self.parameters.minkowski else super().frame()

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return view.legend(self.model)

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(self.model, self.hand, canvas)
        self.draw_expected(canvas)
