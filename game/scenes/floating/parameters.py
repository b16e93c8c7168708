"""Controls of a floating body, and the tools of the hand."""

from __future__ import annotations

from game.physics.hydrostatics import FloatingSettings
from game.stage import Choice, Param, Parameters, Toggle, control_of
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members.solids import choose_quality, choose_substeps

TOOLS = (
    Tool("grab", "Grab", "grab", "drag the body, in either tank", icon="grab"),
    Tool("draw", "Draw a body", "draw a body", "draw an outline; it closes as you let go", icon="polygon"),
    Tool("tilt", "Set it down", "set it down tilted", "drag from the body to where its top is to point",
         icon="bend"),
    Tool("ballast", "Put ballast", "put ballast", "click in the body: lead is there", icon="box"),
)  # fmt: skip
SHAPES = ("hull", "beam", "square", "triangle", "disc", "plank", "drawn")
OF_PICTURE = ("tool", "marks", "look")


class FloatingParameters(Parameters):
    """The body, the water, two ways to move it, and what is shown."""

    tool = choose_tool(TOOLS)
    shape = Choice(
        "hull", SHAPES, labels=("Hull", "Beam", "Square log", "Triangle", "Disc", "Hinged plank", "Drawn"),
        group="Body", help="what floats; Drawn: by your own line",
    )  # fmt: skip
    weight = Param(0.45, 0.01, 4.0, log=True, group="Body", label="Density", help="beside water's")
    ballast = Param(0.0, 0.0, 3.0, group="Body", label="Ballast", help="mass of lead beside the body's own")
    tilt = Param(0.0, -180.0, 180.0, unit="°", group="Body", label="Set down at",
                 help="angle at which it is set on the water")  # fmt: skip
    hinge = Param(0.3, 0.02, 0.6, unit="m", group="Body", label="Hinge", help="depth of the plank's hinge")
    gravity = Param(9.81, 0.5, 30.0, unit="m/s²", group="World", help="downwards")
    added = control_of(
        FloatingSettings, "added", labels=("None", "Half an ellipse"), group="By hydrostatics",
        label="Added mass",
    )  # fmt: skip
    drag = control_of(FloatingSettings, "drag", group="By hydrostatics", label="Drag coefficient")
    waves = control_of(FloatingSettings, "waves", group="By hydrostatics", label="Lost to waves")
    both = Toggle(True, group="In the liquid", label="Compute it", help="the same body in a liquid")
    cells = Param(64, 24, 200, whole=True, log=True, group="In the liquid", rebuild=True,
                  help="along the tank")  # fmt: skip
    tier = choose_quality("In the liquid")
    substeps = choose_substeps(32, "In the liquid")
    marks = Toggle(True, group="Shown", label="G, B and M", help="weight, lift and metacentre")
    look = Choice("water", ("water", "dots"), labels=("Water", "Particles"), group="Shown", label="Liquid",
                  help="its surface, or its particles")  # fmt: skip
