"""The fireplace: a story, and a fire to play with."""

from __future__ import annotations

from game.physics.combustion.effects import COMBUSTION
from game.physics.gas.effects import USUAL
from game.physics.heat.effects import HEAT
from game.physics.solids.effects import USUAL as SOLID_EFFECTS
from game.scenes.fireplace import A26
from game.scenes.fireplace.figure import draw_ember
from game.scenes.fireplace.hand import fire_hand
from game.scenes.fireplace.level import DEFAULT, FireplaceContent
from game.scenes.fireplace.model import FireplaceModel
from game.scenes.fireplace.parameters import OF_PICTURE, FireplaceParameters
from game.scenes.fireplace.room import warm_up_room
from game.scenes.fireplace.study import ember_study
from game.scenes.fireplace.told import hearing, names, readouts_of, saved, sizes, targets
from game.scenes.fireplace.view import FireplaceView
from game.stage import Equation, Frame, Hint, SceneAction, Strip
from game.worlds.painting.backdrops import warm_up_backdrop
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.painting.sheets import warm_up_sheets
from game.worlds.scene import Parts, Told, WorldScene


class Fireplace(WorldScene):
    """A match lights sticks, these light logs, and the fire grows until the logs are used up, break and fall.
    At the end embers glow, and cool as T⁴.

    Wood is warmed by the gas at it, by flames and by other embers, and dries first if it is wet. Above its
    ignition temperature it gives off vapour and burns itself. The vapour mixes with air and burns where it is
    hot enough, as far as there is oxygen. Hot gas expands, rises and leaves by the flue. It radiates the more
    the more soot is in it. The logs are rigid pieces, welded together: burnt ones are thinner, and break.

    All is in the plane, a metre deep. The wood is very light, so that an hour passes in a minute. Logs are
    walls of the gas, so that flames go round them. Past sticks it goes before and behind; slits narrower
    than half a cell are shut. Heat, vapour, oxygen and soot are carried in flux form: none is lost. Coal uses
    oxygen as flames do; under ash no air comes to it, and a quarter of the wood is left. The picture shows
    the plane as three sheets, one behind the other. What is smaller than a cell is drawn by chance.

    In the equations: T temperature, T_a that around, b from emissivity, area and heat capacity, Y_F and Y_O
    fuel and oxygen, s oxygen for a kilogram of fuel, k rate, g gravity, u velocity, D width of the fire.
    """

    name, task, title = A26.names
    parameters_type = FireplaceParameters
    parameters: FireplaceParameters
    model: FireplaceModel
    parts = Parts(FireplaceModel, fire_hand, FireplaceView)
    told = Told(readouts_of, saved, targets, hearing, names, sizes)
    tiny = {"tier": "own", "cells": 16}
    painters = (
        ("polygons", warm_up_painter), ("backdrop", warm_up_backdrop), ("gas", warm_up_sheets),
        ("room", warm_up_room),
    )  # fmt: skip
    effects = USUAL | COMBUSTION.known | HEAT.known | SOLID_EFFECTS
    content_type = FireplaceContent
    not_of_model = OF_PICTURE
    of_tier = ("cells",)
    default_content = DEFAULT
    study = ember_study
    may_be_infinite = frozenset(("wood.world.joints",))

    strips = (
        Strip("Power of the flames", "W/m", ("power",)),
        Strip("Ember and its law", "K", ("ember", "ember by T⁴"), ("ember by T⁴",),
              sometimes=("ember", "ember by T⁴")),
        Strip("Wood burnt", "%", ("burnt",)),
    )  # fmt: skip
    hints = (
        Hint(("Drag",), "blow, or what the tool does"),
        Hint(("Right click",), "a log more"),
        Hint(("M",), "light a match"),
    )
    actions = (
        SceneAction("match", "light a match", "M"),
        SceneAction("log", "add a log", "G"),
        SceneAction("blow", "blow into the fire", "B"),
        SceneAction("flue", "open or close the flue", "F"),
    )
    figure = staticmethod(draw_ember)
    equations = (
        Equation("An ember", r"\dot{T} = -b (T^4 - T_a^4)", "Stefan 1879, Boltzmann 1884"),
        Equation("What burns", r"k \text{min}(Y_F, \frac{Y_O}{s})", "the reactant of which there is less"),
        Equation("What is warmed expands", r"\nabla \cdot \v{u} = \frac{\dot{T}}{T}", "at constant pressure"),
        Equation("Puffs of a round fire", r"f = \frac{1.5}{\sqrt{D}}", "Cetegen and Ahmed 1993"),
    )
    try_this = (
        "Close the flue: the smoke comes into the room, and the fire lacks air.",
        "Blow into the embers: they glow, and may take fire again.",
        "Add a log to the embers before they are too cold; a minute later it burns.",
        "Wet the logs: nothing burns before the water is gone.",
        "Look at the oxygen: where it is used up, nothing burns however hot it is.",
    )

    def do(self, name: str) -> str:
        if name == "match":
            self.model.match.strike(self.model.time)
        elif name == "log":
            return "" if self.model.add_log((0.0, 0.7)) else "No more wood fits in."
        elif name == "blow":
            for x in (-0.2, 0.0, 0.2):
                self.model.blow((x, 0.1), (0.12 if x <= 0.0 else -0.12, 0.08))
        else:
            self.parameters.damper = 0.0 if self.parameters.damper > 0.5 else 1.0
            self.model.change_parameter("damper")
        return ""

    def shown(self) -> Frame:
        return Frame(-1.4, -0.22, 1.4, 1.35)
