"""Water in a channel: shallow water to pour, push and dam, beside what is exactly known of it."""

from __future__ import annotations

from game.lab.studies.water.waves import dam_study
from game.physics.waves.effects import WAVES as ROOM
from game.scenes.waves import WAVES
from game.scenes.waves.figure import draw_fan
from game.scenes.waves.level import DEFAULT, WavesContent
from game.scenes.waves.parameters import OF_PICTURE, TOOLS, WavesParameters
from game.scenes.waves.told import readouts, waves_hand
from game.scenes.waves.view import WavesView
from game.scenes.waves.world import WavesWorld
from game.stage import Equation, Frame, Hint, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.landscape import warm_up_landscape
from game.worlds.scene import Parts, Told, WorldScene


class Waves(WorldScene):
    """Water that is shallow beside the length of its waves: from surface to bed it goes at one speed. That is
    enough for broken dams, bores, floods, tides and shores, at the price of a row of numbers.

    A dam between two depths sends a fan of waves back and a bore ahead. On dry ground there is no bore: its
    front thins out and runs at twice the speed of a wave. Both are known exactly, and drawn over the water.

    Water at rest stays at rest, over whatever bed. No water is lost, no depth is below 0.
    What it leaves out: waves of unequal length run equally fast here, and nothing breaks or splashes.

    In the equations: h depth, u speed, z height of the bed, g gravity, c speed of a wave, x place, t time.
    """

    name, task, title = WAVES.names
    parameters_type = WavesParameters
    parameters: WavesParameters
    model: WavesWorld
    parts = Parts(WavesWorld, waves_hand, WavesView)
    told = Told(readouts)
    effects = ROOM.known
    content_type, default_content = WavesContent, DEFAULT
    not_of_model = OF_PICTURE
    study = dam_study
    figure = staticmethod(draw_fan)
    tools = TOOLS
    tool_prefix = "tool-"
    painters = (("landscape", warm_up_landscape),)
    hints = (
        Hint(("Drag",), "pour, push, or draw the bed"),
        Hint(("Right click",), "pour"),
    )
    actions = tool_keys(TOOLS, "tool-")

    def shown(self) -> Frame:
        view, stretch = self.model.content.view, self.model.content.stretch
        return Frame(view.left, stretch * view.bottom, view.right, stretch * view.top)

    strips = (
        Strip(
            "Front",
            "m",
            ("front", "exact front"),
            exact=("exact front",),
            sometimes=("front", "exact front"),
        ),
        Strip("Level in the middle", "m", ("level in the middle",)),
        Strip("Fastest", "m/s", ("fastest",)),
    )
    equations = (
        Equation(
            "Water",
            r"\frac{\partial h}{\partial t} + \frac{\partial h u}{\partial x} = 0",
            "Saint-Venant 1871",
        ),
        Equation(
            "Momentum",
            r"\frac{\partial h u}{\partial t} + \frac{\partial}{\partial x} (h u^2 + \frac{1}{2} g h^2)"
            r" = - g h \frac{\partial z}{\partial x}",
        ),
        Equation("A wave", r"c = \sqrt{g h}", "Lagrange 1781"),
        Equation("Dam on dry ground", r"h = \frac{(2 c_0 - x/t)^2}{9 g}", "Ritter 1892"),
    )
    try_this = (
        "Choose constant cells: the corners of the fan are rounded off.",
        "Draw a hump into a still lake, fast: the wave that runs off is a tsunami's.",
        "Let the swell come, and draw a beach for it.",
        "Pour into dry hollows: the lower one fills, then all flows over.",
    )
