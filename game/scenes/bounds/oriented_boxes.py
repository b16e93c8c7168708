"""Trees of oriented boxes over two outlines, and where they meet."""

from __future__ import annotations

from game.lab.studies.bounds.fits import box_study
from game.scenes.bounds import C08
from game.scenes.bounds.base import BoundsScene
from game.scenes.bounds.figure import draw_separating_axis
from game.stage import Equation, Strip

OTHERS = ("axis-aligned", "with boxes")  # tests of the trees beside


class OrientedBoxes(BoundsScene):
    """Two outlines that are not convex. Do they meet? Testing every segment against every other one costs
    their product. A tree of boxes answers with a few dozen tests: a box round the whole outline, halved
    across its longer side, a box of its own round each half, and so on. Two trees are walked together: boxes
    that do not overlap end a branch; of two that do, the larger one is opened; where leaves overlap, their
    segments are tested, exactly.

    The boxes are oriented: their axes are turned degree by degree, and the outline is projected on them. The
    centre is the middle of the projections, and the least area wins. Such a box hugs a curve: half as long,
    it is a quarter as broad. Axis-aligned boxes are only half as broad, and need many more tests where
    outlines come close.

    Red boxes are leaves that overlap, green ones their ancestors up to the root, grey ones all the others.
    """

    name, task, title = C08.names
    study = box_study

    strips = (
        Strip("Box tests", "", ("tests", *OTHERS), sometimes=OTHERS),
        Strip("Segment tests", "", ("segment tests",)),
        Strip("Query time", "s", ("query",)),
    )
    figure = staticmethod(draw_separating_axis)
    equations = (
        Equation(
            "Projection", r"u_i = \v{p}_i \cdot \v{e}_\alpha,  v_i = \v{p}_i \cdot \v{e}_{\alpha + 90°}"
        ),
        Equation("Box", r"A(\alpha) = (\max u - \min u)(\max v - \min v)", "the course: α = 0°, 1°, 2°, …"),
        Equation(
            "How much too large",
            r"\frac{A}{A_0} \le 1 + \frac{1}{2}\left(a + \frac{1}{a}\right) \sin 2\delta",
            "aspect a, δ half a step",
        ),
        Equation("Separating axis", r"\abs{\v{d} \cdot \v{n}} > r_A + r_B", "Gottschalk, Lin, Manocha 1996"),
        Equation("Breadth of a box on a curve", r"h \approx \frac{L^2}{8 r}", "radius of curvature r"),
        Equation(
            "Tests to separate a gap g",
            r"n \propto g^{-1/2},  \text{AABB: } g^{-1}",
            "measured: press A",
        ),
    )
    try_this = (
        "Drag B into a bay of A: see red boxes appear where the outlines meet, and how few they are.",
        "Press W to walk through fit, building and query; the arrow keys go on and back, G plays it.",
        "Choose axis-aligned boxes: the coast needs more tests, a gap between two arcs ten times more.",
        "Set the angle step to 30°: sloppy boxes, more tests. Exact boxes lie on a side of the hull.",
        "Press 2 and click an outline of your own; close it at its first corner.",
    )
