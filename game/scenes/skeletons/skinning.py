"""C02: a figure of bones in its skin, posed by hand."""

from __future__ import annotations

from collections.abc import Sequence

from game.lab.studies.animation.skinning import skinning_study
from game.physics.animation import BLENDS
from game.scenes.skeletons import C02
from game.scenes.skeletons.base import EDITING, FigureScene, warm_ups_of_figures
from game.scenes.skeletons.figure import draw_bend
from game.scenes.skeletons.hand import FigureHand
from game.scenes.skeletons.level import FigureContent
from game.scenes.skeletons.parameters import SkinningParameters
from game.scenes.skeletons.readouts import readouts_of_skin
from game.scenes.skeletons.skinning_model import SkinningModel
from game.scenes.skeletons.view.skinning import SkinningView
from game.stage import Equation, Hint, SceneAction, Strip, WarmUp


class Skinning(FigureScene):
    """A skeleton of bones, each with a place, an angle and a length, and a skin around it. Take a bone and
    turn it: its children come along, by products of 3 x 3 matrices, and so does the skin, each point by the
    bones near it.

    Weights come from the distance to all bones, none beyond the threshold; a point beyond every threshold
    follows the nearest bone. Blending matrices is quick and loses area at a bend, by the cosine of half the
    bend in the middle of a joint. Blending rotors keeps the thickness and bulges a little.

    In the equations: W frame of a bone in the world, p(i) its parent, T a shift by its place o, R a turn by
    its angle θ, B its frame when the skin was bound, P their palette, v a point of the skin and v' where it
    goes, w weight, d distance from a bone, r threshold, p falloff, a angle of a bend; of rotors p turns and q
    shifts by t.

    Make your own: New bone, click the parent, then where the bone is to end; Skin, click around the bones.
    """

    name, task, title = C02.names
    parameters_type = SkinningParameters
    parameters: SkinningParameters
    model: SkinningModel
    study = skinning_study

    strips = (
        Strip("Area kept", "%", BLENDS),
        Strip("Blends apart", "m", ("apart",)),
        Strip("Time of the skin", "s", ("linear time", "rotor time")),
    )
    told = FigureScene.told._replace(readouts=readouts_of_skin)
    figure = staticmethod(draw_bend)
    equations = (
        Equation("Forward kinematics", r"W_i = W_{p(i)} T(o_i) R(\theta_i)", "3 × 3 matrices on (x, y, 1)"),
        Equation("Palette", r"P_i = W_i B_i^{-1}", "B: the frames when the skin was bound"),
        Equation("Linear", r"\v{v}' = \sum_i w_i P_i \v{v}", "Magnenat-Thalmann and others 1988"),
        Equation("Weights", r"w_i \propto (d_{min} / d_i)^p - (d_{min} / r)^p", "0 beyond the threshold r"),
        Equation("Collapse", r"\frac{1}{2}(1 + R(a)) = \cos(a/2) R(a/2)", "halves at a bend a"),
        Equation(
            "Rotors",
            r"\v{v}' = p^2 \v{v} + 2 q p,  p = e^{i\theta/2}, q = t p^* / 2",
            "Matsuda and others 2014",
        ),
    )
    try_this = (
        "Turn a knee or an elbow far: the strip shows the area that matrices lose; switch to rotors.",
        "Show the weights and click a bone: amber is what follows it.",
        "With the weights shown, point at the skin: what each bone weighs there, where it alone would go.",
        "Set influences to 1: the skin breaks into rigid parts.",
        "Lower the threshold until the skin follows the nearest bone alone.",
        "Open the bent bar: the collapse against cos(a/2).",
    )
    hints = (
        Hint(("Drag",), "turn a bone"),
        Hint(("1", "2", "3"), "turn, bone, skin"),
        Hint(("W",), "weights"),
        Hint(("M",), "motion"),
        Hint(("Ctrl+Z",), "undo"),
    )
    actions = (
        SceneAction("pose", "turn a bone", "1"),
        SceneAction("bone", "new bone", "2"),
        SceneAction("skin", "draw a skin", "3"),
        *EDITING,
        SceneAction("show-weights", "weights", "w"),
    )

    # -- building and events ------------------------------------------------------------------------

    def make(self, content: FigureContent) -> None:
        self.model = SkinningModel(self.parameters, self.active, content)
        self.said = self.model.messages
        self.hand = FigureHand(self.model)
        self.view = SkinningView(self.model)

    def action(self, name: str) -> None:
        if name == "show-weights":
            self.parameters.weights = not self.parameters.weights
        else:
            super().action(name)

    # -- what there is to see -----------------------------------------------------------------------

    def standing(self) -> dict[str, float]:
        """bend: of the joint that is bent most, ° from where it was bound."""
        return {"bend": self.model.largest_bend()}

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        return (*warm_ups_of_figures(), WarmUp(cls.title, lambda: cls().advance(cls.dt)))
