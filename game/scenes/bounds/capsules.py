"""Trees of capsules (line-swept spheres) over two outlines, beside trees of boxes on the same ones."""

from __future__ import annotations

from typing import ClassVar

from game.lab.studies.bounds.fits import capsule_study
from game.physics.bounds import near_least_capsule
from game.scenes.bounds import C09
from game.scenes.bounds.base import BoundsScene
from game.scenes.bounds.figure import draw_capsules
from game.scenes.bounds.panes import Panes, SideBySide
from game.scenes.bounds.parameters import CapsuleParameters
from game.stage import Equation, Strip, WarmUp

OTHERS = ("with boxes", "axis-aligned")  # tests of the trees beside


class Capsules(BoundsScene):
    """The same trees with capsules: all points within a radius of a core segment. The core is laid along each
    direction in turn, in the middle of the projection. The radius is half of the breadth, and the core is as
    short as its round ends allow. The least area wins.

    A capsule has no corners to turn: two of them overlap if their cores are nearer than both radii together,
    one distance of two segments. It takes a few more tests than boxes on thin curves, as its round ends reach
    beyond them.

    The capsule of least area is hard to find: it need not lie along a side of the hull, nor have the least
    radius, which calipers find at once: a square's capsule of least radius is 16 % larger than need be. Exact
    finds the least area by branch and bound, with a proof that no capsule is smaller by more than 0.1 %. That
    takes some milliseconds for each volume.
    """

    name, task, title = C09.names
    study = capsule_study
    second_kind: ClassVar[str] = "obb"

    parameters_type = CapsuleParameters
    parameters: CapsuleParameters

    strips = (
        Strip("Volume tests", "", ("tests", *OTHERS), sometimes=OTHERS),
        Strip("Segment tests", "", ("segment tests",)),
        Strip("Query time", "s", ("query",)),
    )
    figure = staticmethod(draw_capsules)
    equations = (
        Equation(
            "Capsule", r"\abs{\v{x} - \v{c}(t)} \le r,  \v{c}(t) = \v{a} + t (\v{b} - \v{a}),  0 \le t \le 1"
        ),
        Equation("Radius on a direction", r"r = \frac{1}{2}(\max v - \min v)", "the course"),
        Equation(
            "Ends of the core",
            r"u_0 = \min (u_i + q_i),  u_1 = \max (u_i - q_i),  q_i^2 = r^2 - (v_i - \bar{v})^2",
        ),
        Equation("Area", r"A = 2 r L + \pi r^2", "core length L"),
        Equation("A square of side 1", r"A = 1.534,  \text{least radius: } 1.785", "the circle: 1.571"),
        Equation("Overlap", r"d(\text{core}_A, \text{core}_B) \le r_A + r_B", "Larsen and others 2000"),
        Equation(
            "Proof of the least",
            r"A \ge 2 r_1 L(\theta, r_2 + D \sin\frac{\delta}{2}) + \pi r_1^2",
            "Exact: down to 0.1 % of the area",
        ),
    )
    try_this = (
        "Switch on side by side: capsules and boxes on the same outlines, with their tests.",
        "Press W and walk through the fit: the area against the direction, and where the least lies.",
        "Open the two arcs and bring them close: boxes separate them with fewer tests.",
        "Open the square: choose Least radius, then Exact, and read the area above the exact one.",
    )

    def make_panes(self) -> Panes:
        return SideBySide(self.model, self.parameters)

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
        return [*super().warm_ups(), WarmUp("least capsule", lambda: near_least_capsule(square))]
