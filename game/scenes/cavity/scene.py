"""S08: the flow in a cavity."""

from __future__ import annotations

from collections.abc import Sequence
from operator import attrgetter
from typing import Any

from game.lab.studies.gases.flows import cavity_study
from game.physics.gas import GAS
from game.physics.gas.effects import CONFINEMENT
from game.scenes.cavity import CAVITY
from game.scenes.cavity.figure import draw_profiles
from game.scenes.cavity.hand import CavityHand
from game.scenes.cavity.level import DEFAULT, CavityContent
from game.scenes.cavity.model import CavityModel
from game.scenes.cavity.parameters import OF_MAKING, OF_PICTURE, CavityParameters
from game.scenes.cavity.readouts import readouts_of
from game.scenes.cavity.view import CavityView
from game.stage import Equation, Frame, Hint, Strip
from game.worlds.expectations import draw_captions
from game.worlds.scene import ModelScene, Told


class Cavity(ModelScene):
    """A square box of gas under a lid that moves. The lid drags the gas along, and after a while one large
    eddy stands in the box, with small ones in the corners: the flow that every program for fluids is first
    tried on, for its speeds on the two centre lines are known to six figures.

    Choose another method, a coarser grid or longer steps, and see at the dots how much of the eddy is lost.
    With a hot and a cold wall instead of the lid it is warmth that drives it.

    In the equations: u velocity, p pressure over density, ν viscosity, U speed of the lid, L width, T
    temperature, β its expansion, κ how fast it spreads, g gravity.
    """

    name, task, title = CAVITY.names
    parameters_type = CavityParameters
    parameters: CavityParameters
    model: CavityModel
    effects = GAS.known.without(CONFINEMENT)
    content_type = CavityContent
    told = Told(readouts_of, attrgetter("content"))
    not_of_model = (*OF_PICTURE, *OF_MAKING)
    default_content = DEFAULT
    study = cavity_study
    figure = staticmethod(draw_profiles)
    hints = (Hint(("Drag",), "stir"),)
    strips = (
        Strip("Speeds on the centre lines", "", ("least u", "most v", "least v")),
        Strip("Error", "%", ("error",), sometimes=("error", "Nusselt error")),
        Strip("Change", "m/s²", ("change",)),
    )
    equations = (
        Equation(
            "Flow", r"\frac{d \v{u}}{d t} = - \nabla p + \nu \nabla^2 \v{u}", "Navier 1822, Stokes 1845"
        ),
        Equation("No divergence", r"\nabla \cdot \v{u} = 0", "what flows in flows out"),
        Equation("Reynolds number", r"Re = \frac{U L}{\nu}", "Ghia, Ghia and Shin 1982: 100 to 10000"),
        Equation("Rayleigh number", r"Ra = \frac{g \beta \Delta T L^3}{\nu \kappa}", "de Vahl Davis 1983"),
    )
    try_this = (
        "Choose the advection of 1999: the eddy is weaker, as if the gas were thicker than it is.",
        "Go from 64 to 128 cells: the error falls to little more than a quarter.",
        "Turn the pressure off, and see that an eddy needs one.",
        "Heat a wall instead: the Nusselt number says how much more heat the eddy carries than gas at rest.",
    )

    def make(self, content: CavityContent) -> None:
        self.model = CavityModel(content, self.parameters, self.active, self.seed)
        self.hand = CavityHand(self.model)
        self.view = CavityView(self.model)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        if self.model.heated:
            return (("line:green", "u across the middle", ""), ("line:amber", "v across the middle", ""))
        return (
            ("line:green", "u on the vertical", ""),
            ("line:amber", "v on the horizontal", ""),
            ("disc:text1", "Ghia 1982, as printed", ""),
            ("ring:vermilion", "extremes, extrapolated", ""),
        )

    def frame(self) -> Frame:
        return Frame(-0.08, -0.06, 1.08, 1.1)

    def draw_expected(self, canvas: Any) -> None:
        draw_captions(canvas, (0.5, 0.985), self.captions())
