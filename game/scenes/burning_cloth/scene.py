"""The burning cloth: a story, and a cloth to write on and to burn."""

from __future__ import annotations

from game.lab.studies.fire.cloth import front_study
from game.physics.cloth.effects import CLOTH
from game.physics.combustion.effects import FLAMES, SOOT_LOSS
from game.physics.gas.effects import ADVECTION, BUOYANCY, PRESSURE
from game.physics.heat.effects import HEAT
from game.scenes.burning_cloth import A10
from game.scenes.burning_cloth.figure import draw_front
from game.scenes.burning_cloth.hand import cloth_hand
from game.scenes.burning_cloth.level import DEFAULT, BurningClothContent
from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.parameters import OF_PICTURE, BurningClothParameters
from game.scenes.burning_cloth.picture.sheet_painter import warm_up_sheet
from game.scenes.burning_cloth.picture.yard import warm_up_yard
from game.scenes.burning_cloth.told import hearing, names, readouts_of, saved, targets
from game.scenes.burning_cloth.view import BurningClothView
from game.stage import Equation, Frame, Hint, SceneAction, Strip
from game.worlds.painting.backdrops import warm_up_backdrop
from game.worlds.painting.glowing import warm_up_glowing
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import Parts, Told, WorldScene


class BurningCloth(WorldScene):
    """A cotton cloth hangs from two hooks. It was treated with a flame retardant; the letters were written
    on it with a solution of saltpetre, which has dried. A match lights each letter at its foot: a front of
    embers creeps along what is written, and only that burns through.

    No script says what burns. Treated cloth does nothing below 640 K, more than half of it stays as char. The
    heat that it gives is less than it loses, so a fire in it goes out. Saltpetre takes fire at 500 K, brings
    its own oxygen and leaves nothing: its front keeps itself hot. What leaves as vapour burns in the air
    before the cloth. Where a mesh has lost its threads a hole opens, and what hangs on nothing any more
    falls.

    Limits. The gas is solved in the plane of the cloth, as a layer 0.2 m deep with the same velocity all
    through. The cloth itself swings in space. The gas does not feel the cloth's drag, and does not expand by
    its warmth. Heat spreads along the threads as quickly as it does with the hot gas close to a cloth (2
    cm²/s). Threads keep the heat capacity of a whole one until they fall.

    In the equations: u temperature above that around over what the fuel's heat would give, u_i ignition,
    f fuel left, D diffusivity, r rate of burning, h loss, c speed of the front.
    """

    name, task, title = A10.names
    parameters_type = BurningClothParameters
    parameters: BurningClothParameters
    model: BurningClothModel
    parts = Parts(BurningClothModel, cloth_hand, BurningClothView)
    told = Told(readouts_of, saved, targets, hearing, names)
    tiny = {"tier": "own", "meshes": 16}
    painters = (
        ("polygons", warm_up_painter), ("cloth", warm_up_sheet), ("backdrop", warm_up_backdrop),
        ("gas", warm_up_glowing), ("yard", warm_up_yard),
    )  # fmt: skip
    effects = ADVECTION | PRESSURE | BUOYANCY | FLAMES | SOOT_LOSS | HEAT.known | CLOTH.known
    content_type = BurningClothContent
    not_of_model = OF_PICTURE
    of_tier = ("meshes",)
    default_content = DEFAULT
    study = front_study

    strips = (
        Strip("Front of embers", "m/s", ("front", "by its law", "Fisher-KPP"),
              ("by its law", "Fisher-KPP"), sometimes=("front",)),
        Strip("Power of the flames", "W", ("power",)),
        Strip("Burnt", "%", ("letters burnt", "rest burnt")),
    )  # fmt: skip
    hints = (
        Hint(("Drag",), "what the tool does"),
        Hint(("Right click",), "wet the cloth"),
        Hint(("M",), "strike the match"),
    )
    actions = (
        SceneAction("match", "strike the match", "M"),
        SceneAction("turn", "turn the wind", "B"),
        SceneAction("wet", "wet the whole cloth", "G"),
    )
    figure = staticmethod(draw_front)
    equations = (
        Equation(
            "A front of embers", r"\dot{u} = D \Delta u - h u + r f", "burns where u ≥ u_i, a law of steps"
        ),
        Equation(
            "Its speed without losses", r"c = \sqrt{D r \frac{1 - u_i}{u_i}}", "closed form of that law"
        ),
        Equation("Fisher-KPP", r"c = 2 \sqrt{D r}", "Fisher 1937; Kolmogorov, Petrovsky, Piskunov 1937"),
        Equation("A hot cloth shines", r"q = 2 ε σ (T^4 - T_a^4)", "Stefan 1879, Boltzmann 1884; two sides"),
    )
    try_this = (
        "Set the retardant to 0: the whole cloth burns, and what was written cannot be read.",
        "Wet the cloth across a letter: the front stops at 373 K until the water is gone.",
        "Choose Fisher's law: embers begin wherever it is a little warm, and the front slows down for long.",
        "Write a word of your own with the brush, and hold the match to it.",
        "Turn the wind while it burns: cloth, flames and smoke go with it.",
        "Switch radiation off: the front comes up to the speed that its law has without losses.",
    )

    def why_idle(self, name: str) -> str:
        if name == "word" and self.model.content.words is not None:
            return "The level says what is written."
        return super().why_idle(name)

    def do(self, name: str) -> str:
        if name == "match":
            self.model.strike()
        elif name == "turn":
            self.parameters.wind = -self.parameters.wind if self.parameters.wind != 0.0 else 1.5
            self.model.change_parameter("wind")
        else:
            self.model.wet_all()
        return ""

    def shown(self) -> Frame:
        return Frame(-1.62, -0.16, 1.62, 1.98)
