"""The valley with its dam: a story, and a place to blow up dams."""

from __future__ import annotations

from game.lab.studies.water.dam import valley_study
from game.physics.liquid.effects import LIQUID as WATER
from game.physics.solids.effects import CONTACTS, FRICTION, JOINTS, RESTITUTION, SLEEP
from game.scenes.valley import VALLEY
from game.scenes.valley.card import draw_theory
from game.scenes.valley.parameters import TOOLS, ValleyContent, ValleyParameters
from game.scenes.valley.told import hearing, names, readouts, sizes, targets, valley_hand
from game.scenes.valley.view import ValleyView
from game.scenes.valley.world import DT, ValleyWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.landscape import warm_up_landscape
from game.worlds.painting.liquid import warm_up_liquid
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import Parts, Told, WorldScene


class Valley(WorldScene):
    """A concrete dam, 12 m high, holds back a valley full of water. A rocket breaks it.

    The water is a liquid of particles on cells; its pressure moves the pieces, and they move it, in one
    solve. The rocket is led along a curve until it meets something. It drives through the wall and explodes
    in the water behind. The charge breaks concrete within a radius by the formula for breaching. Where that
    is more than the wall is thick, the breach goes through, and what stood above it falls: torn concrete
    bears no pull. What is under water is thrown by Cole's law. The rest holds on to the valley's sides.

    Beside it runs shallow water on the same bed, whose dam is gone at once. Ritter's front is the exact one
    of shallow water on an even bed, without friction, whose water needs no time to turn: no front is ahead
    of it. That of Martin and Moyce was filmed of a column half as wide as high, and is scaled to this depth.
    Water of a long valley is ahead of such a short column, since no back wall is near it.

    All is in the plane: weights and flows are for a metre of the valley's width.

    In the equations: c speed of a wave, g gravity, h depth, x place, t time, q flow, R radius, P charge, K, C
    factors of concrete and of where the charge lies, i impulse on an area, w cube root of the charge, B a
    constant, r distance.
    """

    name, task, title = VALLEY.names
    parameters_type = ValleyParameters
    parameters: ValleyParameters
    model: ValleyWorld
    parts = Parts(ValleyWorld, valley_hand, ValleyView)
    told = Told(readouts, targets=targets, sizes=sizes, hearing=hearing, names=names)
    effects = WATER.known | CONTACTS | FRICTION | JOINTS | RESTITUTION | SLEEP
    content_type, default_content = ValleyContent, ValleyContent()
    not_of_model = ("tool", "fronts", "poured", "aim", "charge")
    may_be_infinite = frozenset(("solids.joints",))
    study = valley_study
    figure = staticmethod(draw_theory)
    tools = TOOLS
    tool_prefix = "tool-"
    painters = (("polygons", warm_up_painter), ("landscape", warm_up_landscape), ("water", warm_up_liquid))
    tiny = {"cells": 120}
    dt = DT
    strips = (
        Strip(
            "Front", "m", ("front", "front, shallow", "front, Ritter", "front, experiment"),
            exact=("front, Ritter", "front, experiment"),
            sometimes=("front", "front, shallow", "front, Ritter", "front, experiment"),
        ),
        Strip("Water behind the dam", "%", ("left behind",)),
    )  # fmt: skip
    hints = (
        Hint(("R",), "fire the rocket"),
        Hint(("Drag",), "pour water"),
        Hint(("Right click",), "drag a piece"),
    )
    actions = (SceneAction("fire", "fire the rocket", "R"), *tool_keys(TOOLS, "tool-"))
    equations = (
        Equation("Front on a dry bed", r"x = 2 \sqrt{g h} t", "Ritter 1892"),
        Equation("Depth of shallow water", r"h(x) = \frac{(2 c - x/t)^2}{9 g}", "Ritter 1892"),
        Equation("Flow at the dam", r"q = \frac{8}{27} h \sqrt{g h}", "Ritter 1892"),
        Equation("Concrete that breaks", r"R^3 = \frac{P}{K C}", "US Army FM 5-250"),
        Equation("Impulse in water", r"i = B w (\frac{w}{r})^{0.89}", "Cole 1948"),
    )
    try_this = (
        "A charge of 5 kg: does the dam hold?",
        "Let the dam vanish at once: the front lies between the short column that was filmed and Ritter's.",
        "Aim at the crest, at the foot: where does the most water run out?",
    )

    def do(self, name: str) -> str:
        return self.model.launch()
