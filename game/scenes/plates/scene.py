"""Plates that fall in air."""

from __future__ import annotations

from game.lab.studies.plates import plate_study
from game.physics.plates.effects import PLATES
from game.scenes.plates import FALLING
from game.scenes.plates.figure import draw_forces
from game.scenes.plates.hand import PlatesHand
from game.scenes.plates.level import DEFAULT, PlatesContent
from game.scenes.plates.model import CEILING, FLOOR, LEFT, PlatesModel
from game.scenes.plates.parameters import OF_PICTURE, PlatesParameters
from game.scenes.plates.readouts import readouts_of
from game.scenes.plates.view import MAP_RIGHT, PlatesView
from game.stage import Equation, Frame, Hint, SceneAction, Strip
from game.worlds.scene import BuiltScene, Told


class FallingPlates(BuiltScene):
    """A sheet of paper let go does not fall straight: it swings to and fro, or turns over and over, or does
    both without order. What it does depends on its inertia beside that of the air it takes along.

    The law is that of Andersen, Pesavento and Wang (2005), put together from what the air does to a thin
    plate: it takes air along, more broadside than edge on. It is lifted by air that turns about it, as it
    glides and as it spins. It is dragged. Plates may bend about their middle, and may be heavier at one end,
    which makes them glide.

    Distances are measured by the half chord a, speeds by U, at which the weight is about the drag: then
    falling paper and falling steel are the same but for their inertia I* and thickness β.

    In the equations: u velocity through the air along (x) and across (y) the plate, ω spin, I inertia, β
    thickness, Γ circulation, F drag, g gravity, C_T, C_R, A, B, μ coefficients, α incidence.
    """

    name, task, title = FALLING.names
    parameters_type = PlatesParameters
    parameters: PlatesParameters
    model: PlatesModel
    hand: PlatesHand
    effects = PLATES.known
    content_type = PlatesContent
    told = Told(readouts_of)
    not_of_model = OF_PICTURE
    default_content = DEFAULT
    study = plate_study
    takes = frozenset(("right",))
    legend_in_panel = True
    figure = staticmethod(draw_forces)
    hints = (
        Hint(("Click",), "drop a plate, or choose one"),
        Hint(("Drag",), "throw it"),
        Hint(("Right click",), "take one away"),
    )
    actions = (
        SceneAction("clear", "No plates", "n"),
        SceneAction("row", "A row of plates of all inertias", "o"),
        SceneAction("next", "Measure the next", "e"),
    )
    strips = (
        Strip("Descent", "U", ("descent", "descent, reference"), exact=("descent, reference",),
              sometimes=("descent", "descent, reference")),
        Strip("Spin", "U/a", ("spin now",)),
        Strip("What they do", "", ("flutter", "tumble", "irregular")),
    )  # fmt: skip
    equations = (
        Equation(
            "Along the plate",
            r"(I + \beta^2) \dot{u}_x = (I + 1) \omega u_y - \Gamma u_y + (I - \beta) g_x - F_x",
            "Andersen, Pesavento and Wang 2005",
        ),
        Equation(
            "Across it", r"(I + 1) \dot{u}_y = -(I + \beta^2) \omega u_x + \Gamma u_x + (I - \beta) g_y - F_y"
        ),
        Equation("Circulation", r"\Gamma = \frac{2}{\pi} (C_R \omega - C_T \frac{u_x u_y}{\abs{\v{u}}})"),
        Equation("Drag", r"\v{F} = \frac{1}{\pi} (A - B \cos 2 \alpha) \abs{\v{u}} \v{u}"),
        Equation("Torque", r"-(1 - \beta^2) u_x u_y - (\mu_1 + \mu_2 \abs{\omega}) \omega"),
    )
    try_this = (
        "Drop plates of inertia 1.20 and 1.23: one swings over to almost upright, the other over the top.",
        "Two plates of inertia 2, tilted by a millionth apart, part after a dozen swings.",
        "Give a plate a balance of 0.3: with its mass ahead of the middle it glides.",
        "Raise Thickness to 1: a round bar is not turned, and falls straight.",
        "Make it bend at 5 Hz and curl it up by 0.5: a leaf that sails down softly.",
        "Raise the wind at once to 10 m/s: half of it is taken over in that step, by the air taken along.",
    )

    def make(self, content: PlatesContent) -> None:
        self.model = PlatesModel(content, self.parameters, self.active)
        self.hand = PlatesHand(self.model)
        self.view = PlatesView(self.model, self.hand)

    def action(self, name: str) -> None:
        model = self.model
        if name == "next":
            model.chosen = (model.chosen + 1) % max(len(model.plates), 1) if len(model.plates) else -1
            return
        model.clear()
        if name == "row":
            for entry in DEFAULT.plates:
                model.add(entry.plate(), entry.at, entry.tilt, entry.velocity, entry.spin)

    def shown(self) -> Frame:
        return Frame(LEFT - 0.02, FLOOR - 0.04, MAP_RIGHT + 0.04, CEILING + 0.02)
