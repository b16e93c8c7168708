"""P14: smoke, dye and fire in a box, by the papers' own ways and by later ones."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from game.lab.studies.gases.smoke import smoke_study
from game.physics.combustion.effects import COMBUSTION
from game.physics.gas.effects import GAS
from game.scenes.smoke import SMOKE
from game.scenes.smoke.figure import draw_projection
from game.scenes.smoke.hand import SmokeHand
from game.scenes.smoke.level import DEFAULT, SmokeContent, SolidEntry
from game.scenes.smoke.model import TALL, WIDE, SmokeModel
from game.scenes.smoke.parameters import OF_PICTURE, PRINTED, SmokeParameters
from game.scenes.smoke.readouts import readouts_of
from game.scenes.smoke.view import SmokeView
from game.stage import Equation, Frame, Hint, SceneAction, SetParameter, Strip, WarmUp
from game.worlds.expectations import with_headroom
from game.worlds.painting.flames import warm_up_gas
from game.worlds.scene import ModelScene, Told


class Smoke(ModelScene):
    """Gas on a grid, to be stirred, painted and set on fire. Each cell asks where its gas was one step ago,
    and takes over what was there; then a pressure is found that leaves nothing squeezed.

    Choose how it is carried along and how the pressure is solved. See what stays of a whirl, how sharp the
    dye is and what divergence is left: by both papers as they were printed, and by what came after.

    In the equations: u velocity, p pressure over density, x a place, Δt step, ν viscosity, T temperature and
    T_a that around, g gravity, q share of the pressure that is taken at the end of a step.
    """

    name, task, title = SMOKE.names
    parameters_type = SmokeParameters
    parameters: SmokeParameters
    model: SmokeModel
    effects = GAS.known | COMBUSTION.known
    content_type = SmokeContent
    told = Told(readouts_of)
    default_content = DEFAULT
    study = smoke_study
    takes: ClassVar[frozenset[str]] = frozenset(("right",))
    figure = staticmethod(draw_projection)
    hints = (
        Hint(("Drag",), "stir, or what the tool does"),
        Hint(("Right drag",), "paint"),
        Hint(("6", "7", "8", "9"), "smoke, blue, pink, yellow"),
        Hint(("K", "T", "S", "V", "R", "D", "H"), "views of the gas"),
    )
    actions = (
        SceneAction("tool-stir", "tool: stir", "1"),
        SceneAction("tool-dye", "tool: dye", "2"),
        SceneAction("tool-fire", "tool: fire", "3"),
        SceneAction("tool-solid", "tool: solid", "4"),
        SceneAction("clear", "clear the air", "N"),
        SceneAction("dye-smoke", "paint smoke", "6"),
        SceneAction("dye-blue", "paint blue dye", "7"),
        SceneAction("dye-pink", "paint pink dye", "8"),
        SceneAction("dye-yellow", "paint yellow dye", "9"),
        SceneAction("view-smoke", "view: smoke and dyes", "K"),
        SceneAction("view-temperature", "view: temperature", "T"),
        SceneAction("view-speed", "view: speed", "S"),
        SceneAction("view-vorticity", "view: vorticity", "V"),
        SceneAction("view-pressure", "view: pressure", "R"),
        SceneAction("view-divergence", "view: divergence", "D"),
        SceneAction("view-schlieren", "view: schlieren", "H"),
    )
    strips = (
        Strip("Divergence that is left", "1/s", ("divergence",)),
        Strip("Smear of the dye", "%", ("smear",)),
        Strip("Power of the flames", "W/m", ("power",)),
    )
    equations = (
        Equation("Carried along", r"\v{u}_2(\v{x}) = \v{u}_1(\v{p}(\v{x}, - \Delta t))", "Stam 1999"),
        Equation("Pressure", r"\nabla^2 p = \frac{1}{\Delta t} \nabla \cdot \v{u}", "Chorin 1968"),
        Equation(
            "Time-centred", r"\v{u} - (1 - q) \Delta t \nabla p", "what is carried, with the old pressure"
        ),
        Equation("Lift", r"2 g \frac{T - T_a}{T + T_a}", "hot gas moves what is around it"),
    )
    try_this = (
        "Choose Stam 2003 as printed, and look at the divergence; then multigrid.",
        "Open the whirl: see how long it turns by each method.",
        "Paint a fire below the disc, and look at it as schlieren.",
        "Paint blue beside yellow (7 and 9), and stir: where they meet they are green.",
        "Drag the disc through the smoke.",
        "Set a long time step: nothing blows up, but all is smeared.",
        "Open the books: what carrying makes of heat is a row of its own; then choose flux form.",
    )

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        return (*super().warm_ups(), WarmUp("gas", warm_up_gas))

    def make(self, content: SmokeContent) -> None:
        self.model = SmokeModel(content, self.parameters, self.active)
        self.hand = SmokeHand(self.model)
        self.view = SmokeView(self.model, self.hand)

    def parameter_changed(self, name: str) -> None:
        if name not in OF_PICTURE:
            self.model.change()

    def why_idle(self, name: str) -> str:
        printed = self.parameters.method in PRINTED
        if printed and name in ("pressure", "confinement", "flux", "books"):
            return "A paper as printed has its own."
        if self.parameters.method == "stam-1999" and name == "turns":
            return "The first paper solves to the end."
        return ""

    def takes_long(self, event: Any) -> bool:
        """Another method or solver is compiled first."""
        return isinstance(event, SetParameter) and event.name in ("method", "pressure")

    def save_content(self) -> SmokeContent:
        solids = tuple(
            SolidEntry(at=(x, y), radius=radius)
            for x, y, radius, _, _ in self.model.obstacles.rows.tolist()
        )  # fmt: skip
        return SmokeContent(sources=self.model.content.sources, solids=solids, sides=self.model.content.sides,
                            start=self.model.content.start, expected=self.model.content.expected)  # fmt: skip

    def advance(self, dt: float) -> None:
        self.hand.work(dt)
        self.model.advance(dt)

    def action(self, name: str) -> None:
        if name.startswith("tool-"):
            self.parameters.tool = name.removeprefix("tool-")
        elif name.startswith("view-"):
            self.parameters.view = name.removeprefix("view-")
        elif name.startswith("dye-"):
            self.parameters.dye, self.parameters.tool = name.removeprefix("dye-"), "dye"
        else:
            self.model.clear()

    def frame(self) -> Frame:
        return with_headroom(Frame(-0.04, -0.04, WIDE + 0.04, TALL + 0.04), len(self.model.content.expected))

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas)
        self.draw_expected(canvas)
