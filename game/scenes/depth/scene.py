"""P32: penetration depth by translation, and with rotation by the object norm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from game.lab.studies.narrowphase.rotation import depth_study
from game.scenes.depth import DEPTH
from game.scenes.depth.figure import draw_two_ways
from game.scenes.depth.hand import NOTCH, DepthHand
from game.scenes.depth.level import DEFAULT, DepthContent
from game.scenes.depth.model import DepthModel
from game.scenes.depth.parameters import OF_PICTURE, DepthParameters
from game.scenes.depth.readouts import readouts_of
from game.scenes.depth.view import DepthView
from game.stage import Equation, Frame, Hint, SceneAction, Strip
from game.worlds.expectations import with_headroom
from game.worlds.scene import ModelScene, Told


class Depth(ModelScene):
    """How far must A move so that it no longer overlaps B? The least displacement is one answer. Often a
    little turn helps: a bar in a slot, two combs, a corner that is caught.

    To compare turns with displacements the object norm takes all points of A and the mean of the squares of
    how far they go. The shortest motion is looked for angle by angle: for each the best displacement is
    known exactly, and whole intervals of angles are left out by a bound.

    In the equations: t displacement and θ turn of A about its centroid, k its radius of gyration, d the least
    displacement for a turn, R_i the farthest point of a part of A from the centroid, w half an interval.
    """

    name, task, title = DEPTH.names
    dt = 1.0 / 60.0
    parameters_type = DepthParameters
    parameters: DepthParameters
    content_type = DepthContent
    at_once = True
    told = Told(readouts_of, DepthModel.to_content)
    default_content = DEFAULT
    takes = frozenset({"right"})
    study = depth_study
    figure = staticmethod(draw_two_ways)
    hints = (
        Hint(("Drag",), "move a shape"),
        Hint(("Shift", "Drag"), "turn it, as the right button does"),
        Hint(("M",), "A moves out"),
        Hint(("B",), "brute force"),
    )
    actions = (
        SceneAction("move-out", "A moves out, or stops", "m"),
        SceneAction("check", "check by brute force", "b"),
        SceneAction("turn-left", "turn left", "q"),
        SceneAction("turn-right", "turn right", "e"),
        SceneAction("again", "shapes as they were", "g"),
    )
    strips = (
        Strip("Depth", "m", ("translation", "generalised"), colors=("amber", "green")),
        Strip("Query", "s", ("query",)),
    )
    equations = (
        Equation(
            "Object norm",
            r"\sigma^2 = \abs{\v{t}}^2 + 4 k^2 \sin^2 (\theta / 2)",
            "Kazerounian and Rastegar 1992",
        ),
        Equation("With rotation", r"\sigma_g^2 = \min (d(\theta)^2 + 4 k^2 \sin^2 (\theta / 2))", "over θ"),
        Equation("Bound over an interval", r"\rho = 2 R_i \sin (w / 2)", "differences eroded by ρ"),
    )
    try_this = (
        "Turn the bar in its slot: straight it fits, so a small turn saves a long way.",
        "Choose a disc for A: turning it gains next to nothing.",
        "Make the tolerance coarser and finer, and watch the intervals beside the curve.",
        "Press B: brute force tests thousands of motions, and finds none shorter.",
    )

    def make(self, content: DepthContent) -> None:
        self.model = DepthModel(content, self.parameters)
        self.hand = DepthHand(self.model)
        self.view = DepthView(self.model)

    def action(self, name: str) -> None:
        if name == "move-out":
            self.model.moves = not self.model.moves
        elif name == "check":
            self.model.check_by_grid()
        elif name == "again":
            self.model.begin_again()
        else:
            self.hand.turn(NOTCH if name == "turn-left" else -NOTCH, self.hand.chosen)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return (
            ("disc:chalk", "A", ""),
            ("disc:violet", "B", ""),
            ("dash:amber", "A without turning", ""),
            ("dash:green", "A by the shortest motion", ""),
        )

    def frame(self) -> Frame:
        return with_headroom(Frame(-2.3, -2.1, 4.7, 2.1), len(self.model.content.expected))

    def parameter_changed(self, name: str) -> None:
        if name not in OF_PICTURE:
            self.model.query()

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas)
        self.draw_expected(canvas)
