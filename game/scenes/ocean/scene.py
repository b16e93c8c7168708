"""Sailing the ocean: a story, and a boat to sail, load and knock down."""

from __future__ import annotations

from game.lab.studies.water.sea import sea_study
from game.physics.waves.effects import SEA
from game.scenes.ocean import OCEAN
from game.scenes.ocean.card import draw_arms
from game.scenes.ocean.parameters import OceanContent, OceanParameters
from game.scenes.ocean.told import charts, hearing, names, ocean_hand, readouts, sizes, targets
from game.scenes.ocean.view import OceanView
from game.scenes.ocean.world import OceanWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.painting.clouds import warm_up_sky
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.painting.sea.painter import warm_up_sea
from game.worlds.scene import Parts, Told, WorldScene


class Ocean(WorldScene):
    """A boat with one sail on a sea of many waves. Each wave runs at the speed of its own length. How high
    they are, the wind says, by a spectrum that was measured at sea.

    The water lifts the hull by the volume that is under its surface, section by section. So it heaves,
    pitches and heels, and rights itself as long as its lift is beside its weight. Sections count as upright
    when it pitches, so steep pitch is not exact. The sail is a cloth: the wind presses it, its force drives
    the boat and heels it. Where sections strike the water, drops fly.

    A helmsman keeps the course: drift and turning are left out, and waves do not feel the boat. Waves are low
    ones that do not break: foam stands where they would. The sea grows in seconds, not hours. Mast and sail
    have no lift of their own in the water, and the boat takes none in.

    In the equations: w rate, k wave number, g gravity, U wind, V wind at the sail, s sine of its angle to the
    cloth, A area, I inertia, m mass, GM height of the metacentre over the middle of mass, c coefficient.
    """

    name, task, title = OCEAN.names
    parameters_type = OceanParameters
    parameters: OceanParameters
    model: OceanWorld
    parts = Parts(OceanWorld, ocean_hand, OceanView)
    told = Told(readouts, targets=targets, sizes=sizes, hearing=hearing, names=names, charts=charts)
    tiny = {"tier": "own", "waves": 8}
    painters = (("sea", warm_up_sea), ("sky", warm_up_sky), ("polygons", warm_up_painter))
    effects = SEA.known
    content_type, default_content = OceanContent, OceanContent()
    not_of_model = ("astern",)
    of_tier = ("waves",)
    study = sea_study
    strips = (
        Strip("Heel and pitch", "°", ("heel", "pitch")),
        Strip("Wave height", "m", ("wave height", "height by law"), exact=("height by law",)),
        Strip("Boat", "m/s", ("boat speed", "wind")),
    )  # fmt: skip
    hints = (
        Hint(("Drag",), "lift the boat, let it fall"), Hint(("Right click",), "send a gust"),
        Hint(("O",), "pull the mast over"), Hint(("J",), "press the boat down"),
    )  # fmt: skip
    actions = (
        SceneAction("gust", "send a gust", "U"), SceneAction("pull", "pull the mast over", "O"),
        SceneAction("press", "press the boat down", "J"),
    )  # fmt: skip
    figure = staticmethod(draw_arms)
    equations = (
        Equation("Waves on deep water", r"w^2 = g k", "Airy 1845"),
        Equation("A full sea", r"\frac{\alpha g^2}{w^5} e^{-0.74 (g / U w)^4}", "Pierson, Moskowitz 1964"),
        Equation("Rolling by a little", r"T = 2 \pi \sqrt{\frac{I}{m g GM}}", "Bouguer 1746"),
        Equation("Wind on the cloth", r"c \frac{\rho}{2} V^2 A \frac{2 s}{1 + s^2}", "Duchemin 1842"),
    )
    try_this = (
        "No wind, and a swell of 60 m: how fast is its crest? And one of four times the length?",
        "Haul the sheet in to 10° with the wind from the side: more heel, less speed.",
        "Take all ballast out, and send gusts: how far does it come back from?",
        "Let a storm blow for a minute over a fetch of 300 km.",
    )

    def do(self, name: str) -> str:
        {"gust": self.model.gust, "pull": self.model.pull_over, "press": self.model.press_down}[name]()
        return ""
