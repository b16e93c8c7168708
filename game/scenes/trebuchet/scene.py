"""The trebuchet before a wall: a story, and a machine to shoot with."""

from __future__ import annotations

from game.lab.studies.swings import swings_study
from game.physics.fields import GRAVITY, QUADRATIC_DRAG
from game.physics.solids.effects import CONTACTS, CONTINUOUS, FRICTION, JOINTS, RESTITUTION, SLEEP
from game.scenes.trebuchet import TREBUCHET
from game.scenes.trebuchet.card import draw_levers
from game.scenes.trebuchet.parameters import TOOLS, TrebuchetContent, TrebuchetParameters
from game.scenes.trebuchet.told import hearing, names, readouts, sizes, targets, trebuchet_hand
from game.scenes.trebuchet.view import TrebuchetView
from game.scenes.trebuchet.world import TrebuchetWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.landscape import warm_up_landscape
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.painting.spheres import warm_up_spheres
from game.worlds.scene import Parts, Told, WorldScene


class Trebuchet(WorldScene):
    """A heavy weight falls a little, and a light stone flies far. The arm is a lever, the sling a second one
    that unfolds at its end: when both are stretched out, most of what the weight has given is in the stone.

    Arm, hinged weight and the links of the sling are solids on joints that are solved together. The hook lets
    go at the angle of flight for which it is filed. In the air the stone feels its weight and the drag of a
    sphere (coefficient 0.47). The wall is of loose blocks, 0.3 m deep, that only friction and weight hold.
    The winch takes seconds here, where men took a quarter of an hour.

    In the equations: M, m counterweight and stone, h fall of the weight, v its velocity as
    it leaves, y height above the landing, η efficiency, A area of the stone, ρ density of air.
    """

    name, task, title = TREBUCHET.names
    parameters_type = TrebuchetParameters
    parameters: TrebuchetParameters
    model: TrebuchetWorld
    parts = Parts(TrebuchetWorld, trebuchet_hand, TrebuchetView)
    told = Told(readouts, targets=targets, sizes=sizes, hearing=hearing, names=names)
    effects = GRAVITY | QUADRATIC_DRAG | CONTACTS | FRICTION | RESTITUTION | CONTINUOUS | SLEEP | JOINTS
    content_type, default_content = TrebuchetContent, TrebuchetContent()
    study = swings_study("trebuchet")
    tool_prefix = "tool-"
    painters = (("polygons", warm_up_painter), ("landscape", warm_up_landscape), ("spheres", warm_up_spheres))
    may_be_infinite = frozenset(("world.joints",))
    strips = (
        Strip("Height of the stone", "m", ("stone's height",)),
        Strip("Out of place", "", ("out of place",)),
    )
    hints = (
        Hint(("T",), "pull the trigger"), Hint(("W",), "wind it up again"), Hint(("Drag",), "drag a block"),
        Hint(("Right click",), "push a block"),
    )  # fmt: skip
    actions = (
        SceneAction("trigger", "pull the trigger", "T"), SceneAction("wind", "wind up", "W"),
        *tool_keys(TOOLS, "tool-"),
    )  # fmt: skip
    figure = staticmethod(draw_levers)
    equations = (
        Equation("Range without air", r"\frac{v_x}{g} (v_y + \sqrt{v_y^2 + 2 g y})"),
        Equation("Efficiency", r"\eta = \frac{m v^2 / 2 + m g y}{M g h}"),
        Equation("No range is longer", r"R = 2 \frac{M}{m} h", "Siano 2001"),
        Equation("Drag of the air", r"F = \frac{1}{2} \rho c A v^2", "Newton 1687"),
    )
    try_this = (
        "Shorten the sling to 0.4 m: how much of the weight's energy does the stone still get?",
        "On the Moon (1.62 m/s²) all goes slower, and the stone flies as far.",
        "Break the wall: have half of its blocks out of place by one stone.",
    )

    def do(self, name: str) -> str:
        return self.model.machine.pull_trigger() if name == "trigger" else self.model.machine.wind()
