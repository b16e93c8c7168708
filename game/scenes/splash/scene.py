"""A drop falls into a pool: a story, and a pool to throw drops into."""

from __future__ import annotations

from game.lab.studies.water.drop import drop_study
from game.physics.liquid.effects import LIQUID
from game.scenes.splash import SPLASH
from game.scenes.splash.card import draw_limit
from game.scenes.splash.parameters import STEP, TOOLS, SplashContent, SplashParameters
from game.scenes.splash.told import charts, hearing, let_go, names, readouts, sizes, splash_hand, targets
from game.scenes.splash.view import SplashView
from game.scenes.splash.world import SplashWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.liquid import warm_up_liquid
from game.worlds.painting.lit import warm_up_lit
from game.worlds.scene import Parts, Told, WorldScene


class Splash(WorldScene):
    """A drop falls into a pool. It pushes the water aside and down. A crater opens, and at its rim a thin
    crown flies up. Then the weight of the water closes the crater, and where its walls meet a jet rises.

    All is in the plane: the drop is a round bar of water, seen from its end, and its crater a trench. So the
    crown is two sheets, and waves do not get lower as they run apart. No jet pinches off by surface tension,
    which is not computed: for a drop as thick as an arm it hardly matters, as its energy in the chart shows.
    Amounts are those of a metre of water across the picture.

    Where sheets are thinner than two cells they tear. So how many drops fly, and how high, depends on the
    cells; the crater hardly does.

    In the equations: A area of the drop, U its speed, R radius of a half round crater, g gravity, y height
    and v upward speed of what flies, k number and w rate of a wave, h depth, p pressure of air, ρ density of
    water, r radius and f frequency of a bubble.
    """

    name, task, title = SPLASH.names
    parameters_type = SplashParameters
    parameters: SplashParameters
    model: SplashWorld
    parts = Parts(SplashWorld, splash_hand, SplashView)
    told = Told(readouts, targets=targets, sizes=sizes, hearing=hearing, names=names, charts=charts)
    effects = LIQUID.known
    content_type, default_content = SplashContent, SplashContent()
    not_of_model = ("law", "tool")
    study = drop_study
    figure = staticmethod(draw_limit)
    tools = TOOLS
    tool_prefix = "tool-"
    painters = (("water", warm_up_liquid), ("garden", warm_up_lit))
    tiny = {"cells": 48}
    may_be_infinite = frozenset(("waves",))
    dt = STEP
    strips = (
        Strip("Energy", "J/m", ("kinetic energy", "potential energy", "surface energy")),
        Strip("Crater", "cm", ("crater", "limit"), exact=("limit",), sometimes=("crater", "limit")),
        Strip("Volume error", "%", ("volume error",)),
    )
    hints = (
        Hint(("D",), "let a drop fall"), Hint(("T",), "two drops"), Hint(("C",), "still water"),
        Hint(("Right click",), "a drop from there"), Hint(("V",), "five drops"),
    )  # fmt: skip
    actions = (
        SceneAction("drop", "let a drop fall", "D"), SceneAction("two", "two drops", "T"),
        SceneAction("five", "five drops", "V"),
        SceneAction("calm", "still water", "C"), SceneAction("foresee", "foresee the ripples", "O"),
        *tool_keys(TOOLS, "tool-"),
    )  # fmt: skip
    equations = (
        Equation(
            "No crater is deeper", r"\frac{1}{2} \rho A U^2 = \frac{2}{3} \rho g R^3", "after Engel 1966"
        ),
        Equation("Into deep water", r"\frac{1}{2} U", "of two equal streams: Birkhoff and others 1948"),
        Equation("What flies free", r"y + \frac{v^2}{2 g}", "Galilei 1638"),
        Equation("Ripples", r"w^2 = g k \text{tanh} (k h)", "Airy 1841"),
        Equation("A bubble rings", r"f = \frac{1}{2 \pi r} \sqrt{3 \gamma p / \rho}", "Minnaert 1933"),
    )
    try_this = (
        "Let fast and slow drops fall into still water: how does the crater grow with speed?",
        "Make the pool 6 cm deep: where does the energy go now?",
        "Choose PIC and FLIP with no share of FLIP: how high is the jet?",
        "Let a second drop fall into the crater of the first.",
        "Throw a drop flat along the water: drag from it to where it should fly.",
    )

    def do(self, name: str) -> str:
        return let_go(self.model, name)
