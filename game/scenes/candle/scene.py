"""The candle under a glass: a story, and a flame to smother."""

from __future__ import annotations

from game.physics.combustion.effects import COMBUSTION
from game.physics.gas.effects import USUAL
from game.scenes.candle import CANDLE
from game.scenes.candle.card import draw_glass
from game.scenes.candle.parameters import CandleContent, CandleParameters
from game.scenes.candle.study import smothered_study
from game.scenes.candle.told import candle_hand, charts, hearing, names, readouts, sizes, targets
from game.scenes.candle.view import CandleView
from game.scenes.candle.world import CandleWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.painting.glowing import warm_up_glowing
from game.worlds.painting.lit import warm_up_lit
from game.worlds.scene import Parts, Told, WorldScene


class Candle(WorldScene):
    """A glass comes down over a candle. The flame burns on with the oxygen that is in the glass. It is out
    when the air beside it has no more than 16 % of oxygen by volume, though most of it is there. Then the
    wick smokes.

    Wax vapour mixes with air, and burns where it is hot enough as far as there is oxygen. The heat of the
    flame makes the vapour: with less power the wick gives less. What is hot expands and rises. Walls cool the
    gas beside them. The glass is a solid that moves in the gas. Soot burns off where it is hot.

    All is in the plane, a metre deep: powers and amounts are those of a metre of flame. Sizes and times are
    as in life. Under a glass that stands on the table gas is carried in flux form: no oxygen is lost. The
    limit is put in as measured with candles; where the flame meets it follows from how gas mixes.

    In the equations: Y_F and Y_O fuel and oxygen, s oxygen for a kilogram of fuel, k rate, ρ density of
    oxygen in air, A area of the glass in the plane, m supply of the wick, P power, H heat of combustion,
    X_0 and X_L share of oxygen by volume at first and at the limit.
    """

    name, task, title = CANDLE.names
    parameters_type = CandleParameters
    parameters: CandleParameters
    model: CandleWorld
    parts = Parts(CandleWorld, candle_hand, CandleView)
    told = Told(readouts, targets=targets, sizes=sizes, hearing=hearing, names=names, charts=charts)
    tiny = {"tier": "own", "cells": 32}
    painters = (("lit", warm_up_lit), ("gas", warm_up_glowing))
    effects = USUAL | COMBUSTION.known
    content_type, default_content = CandleContent, CandleContent()
    not_of_model = ("shown",)
    of_tier = ("cells",)
    study = smothered_study
    strips = (
        Strip("Oxygen under the glass", "%", ("oxygen in all", "oxygen by the law"),
              sometimes=("oxygen in all", "oxygen by the law")),
        Strip("Power of the flame", "W/m", ("power",)),
    )  # fmt: skip
    hints = (
        Hint(("G",), "glass down or up"), Hint(("K",), "light the wick"), Hint(("Drag",), "move the glass"),
        Hint(("Right click",), "light the wick"),
    )  # fmt: skip
    actions = (
        SceneAction("glass", "glass down or up", "G"), SceneAction("light", "light the wick", "K"),
    )  # fmt: skip
    figure = staticmethod(draw_glass)
    equations = (
        Equation("What burns", r"k \text{min}(Y_F, \frac{Y_O}{s})", "the reactant of which there is less"),
        Equation(
            "How long it can burn", r"t = \frac{\rho A}{s m} (1 - \frac{X_L}{X_0})", "if its gas is mixed"
        ),
        Equation(
            "How soot burns off",
            r"w = \frac{k_A p}{1 + k_Z p} x + k_B p (1 - x)",
            "Nagle and Strickland-Constable 1962",
        ),
        Equation("What the wick gives", r"m = m_0 \text{min}(1, \frac{P}{f m_0 H})"),
        Equation("What is warmed expands", r"\nabla \cdot \v{u} = \frac{\dot{T}}{T}", "at constant pressure"),
    )
    try_this = (
        "A wider glass: does the flame live longer, and by how much?",
        "Lift the glass a little before the flame is out: does it recover?",
        "Look at the oxygen (Shown): where in the glass is it used up first?",
        "Set the limit to 0: how much longer does it live?",
    )

    def do(self, name: str) -> str:
        if name == "light":
            return self.model.light()
        self.model.move_glass()
        return ""
