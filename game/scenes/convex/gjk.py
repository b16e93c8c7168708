"""GJK: two convex polygons, their Minkowski difference, and the simplexes that walk to the origin."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.narrowphase.distance import gjk_study
from game.physics.narrowphase import (
    ConvexPolygon,
    Feature,
    PolygonSet,
    Proximity,
    epa,
    epa_trace,
    gjk_batch,
    vclip,
)
from game.physics.narrowphase.gjk import METHODS
from game.physics.narrowphase.queries import PolytopeStep, SimplexStep
from game.physics.proximity_effects import EXACT_ANSWER
from game.scenes.convex import C11
from game.scenes.convex import gjk_view as view
from game.scenes.convex.base import ConvexPairScene
from game.scenes.convex.figure import draw_difference
from game.stage import Choice, Equation, Frame, Param, Readout, Strip, Toggle


class Gjk(ConvexPairScene):
    """Two convex polygons A and B, and beside them all differences of their points: A − B, also convex. Its
    distance from the origin is that of the two; if it holds the origin, they overlap.

    GJK never builds A − B. It keeps a simplex, one or two of its corners, takes the point v of it that is
    closest to the origin, and asks both polygons for their vertices farthest along −v and v: that gives
    the corner w farthest towards the origin. If w is no nearer than v, seen along v, v is the answer;
    else the best simplex with w is the next one. Farthest vertices are found by climbing from the last
    one, and the last simplex is the first one of the next query.

    If a triangle holds the origin, the polytope is expanded from it to the border of A − B (EPA): its closest
    edge is the depth of the overlap.
    """

    name, task, title = C11.names
    study = gjk_study

    exponent = Param(
        -14.0, -14.0, -1.0, step=1.0, group="Query", label="Tolerance, power of ten",
        help="relative, at which the walk may end early",
    )  # fmt: skip
    method = Choice(
        "climb", METHODS, labels=("Climb", "Scan"), group="Query", label="Farthest vertex",
        help="by climbing from the last one, or by looking at all",
    )  # fmt: skip
    minkowski = Toggle(True, group="Shown", label="Minkowski difference")
    supports = Toggle(True, group="Shown", label="Support vertices", help="asked for in the step shown")

    strips = (
        Strip("Steps", "per query", ("steps",)),
        Strip("Distance", "m", ("distance", "V-Clip"), ("V-Clip",)),
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

    def measure(self, a: ConvexPolygon, b: ConvexPolygon, start: tuple[Feature, Feature]) -> Proximity:
        return epa(a, b, start, **self.options())

    def options(self) -> dict[str, Any]:
        """What the parameters say to a query."""
        return {
            "tolerance": 10.0**self.exponent,
            "method": self.method,
            "deep": EXACT_ANSWER in self.active,
        }

    def time_batch(self, shapes: PolygonSet, pairs: NDArray[np.int64], features: NDArray[np.int64]) -> None:
        gjk_batch(
            shapes, shapes, pairs, features=features, tolerance=10.0**self.exponent,
            deep=EXACT_ANSWER in self.active, method=self.method,
        )  # fmt: skip

    def trace(self) -> list[SimplexStep | PolytopeStep]:
        """The steps of the last query: GJK's, then in an overlap EPA's."""
        a, b = self.shape(0), self.shape(1)
        if a is None or b is None:
            return []
        _, steps, growth = epa_trace(a, b, self.start_features(a, b), **self.options())
        return [*steps, *growth]

    def trace_length(self) -> int:
        return len(self.trace()) if self.ready else 0

    def readouts(self) -> list[Readout]:
        rows = super().readouts()
        a, b = self.shape(0), self.shape(1)
        if self.ready and a is not None and b is not None:
            rows.append(Readout("V-Clip", vclip(a, b).distance, "m"))
        return rows

    def frame(self) -> Frame:
        return view.frame_of(self.content.view) if self.minkowski else super().frame()

    def legend(self) -> Sequence[tuple[str, str, str]]:
        if not self.ready:
            return (("dash:vermilion", "not convex: refused", ""), ("dash:green", "hull offered", ""))
        rows = [("line:green", "closest features", ""), ("disc:amber", "closest points", "")]
        if self.answer[0] <= 0.0:
            rows = [("line:green", "features of the shortest way out", ""), ("arrow:vermilion", "depth", "")]
        if self.minkowski:
            rows.append(("line:amber", "simplex, closest point v", str(int(self.answer[7]))))
            rows.append(("diamond:pink", "new corner w", ""))
            if self.answer[0] > 0.0:
                rows.append(("line:amber", "circle: no farther than |v|", ""))
                rows.append(("dash:pink", "circle: no nearer than v·w / |v|", ""))
        return rows

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(self, canvas)
