"""Splashes between recorded ones: aligned in place and time, and mixed."""

from __future__ import annotations

from game.lab.studies.water.blending import blending_study
from game.physics.effects import EffectSet
from game.scenes.blend import BLEND
from game.scenes.blend.figure import draw_sheets
from game.scenes.blend.level import DEFAULT, BlendContent
from game.scenes.blend.parameters import OF_PICTURE, TOOLS, BlendParameters
from game.scenes.blend.told import blend_hand, readouts
from game.scenes.blend.view import BlendView
from game.scenes.blend.world import BlendWorld
from game.stage import Equation, Hint, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.liquid import warm_up_liquid
from game.worlds.scene import Parts, Told, WorldScene

ERRORS = ("error, aligned", "error, plain")


class SplashBlend(WorldScene):
    """Recorded runs of a liquid, and runs between them that were never computed.

    A run is kept as signed distances in place and time. A deformation carries the surface of the first run
    onto that of another: crests go to crests, also where they come later. Between the runs, each place is
    carried a part of the way, and there the distances are mixed.

    Plain mixing beside it does without the deformation: a drop that lies elsewhere in both runs vanishes.

    Where it goes wrong, link two points by hand: drag from the first tank to the same feature in another.
    What it leaves out: laws. Nothing keeps mass or momentum between the runs, so errors are measured.

    In the equations: s signed distance, w weight, u deformation, q place and time.
    """

    name, task, title = BLEND.names
    parameters_type = BlendParameters
    parameters: BlendParameters
    model: BlendWorld
    parts = Parts(BlendWorld, blend_hand, BlendView)
    told = Told(readouts)
    effects = EffectSet()
    content_type, default_content = BlendContent, DEFAULT
    not_of_model = OF_PICTURE
    study = blending_study
    figure = staticmethod(draw_sheets)
    tools = TOOLS
    tool_prefix = "tool-"
    painters = (("water", warm_up_liquid),)
    dt = 1.0 / 60.0
    hints = (
        Hint(("Drag",), "link a feature to that of another tank"),
        Hint(("Right click",), "forget links"),
    )
    actions = tool_keys(TOOLS, "tool-")
    strips = (
        Strip("Error", "", ERRORS, sometimes=ERRORS, colors=("amber", "vermilion")),
        Strip("Area", "m²", ("area now", "weighted area"), exact=("weighted area",)),
    )  # fmt: skip
    equations = (
        Equation("Plain mixing", r"s = (1 - w) s_1(q) + w s_2(q)"),
        Equation("Aligned", r"s = (1 - w) s_1(q - w u) + w s_2(q + (1 - w) u)", "Raveendran and others 2014"),
    )
    try_this = (
        "Move the weight while it runs: drop and crown go from one place to the other.",
        "Look at the plain mixing at 0.5: where is the drop?",
        "Take 4 nodes for the deformation, then 32.",
    )

    def why_idle(self, name: str) -> str:
        """Of two runs none lies above the other."""
        if name == "up" and len(self.model.runs) == 2:
            return "There are two runs, beside each other."
        return super().why_idle(name)
