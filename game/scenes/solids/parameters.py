"""What can be chosen in the playground of solids."""

from __future__ import annotations

from game.stage import Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

TOOLS = (
    Tool("hand", "Move", "hand"), Tool("throw", "Throw", "throw", "drag a body back and let go"),
    Tool("disc", "Disc", "disc", "drag from the middle to the rim"),
    Tool("box", "Box", "box", "drag from corner to corner"),
    Tool("polygon", "Polygon", "polygon", "drag from the middle to a corner"),
    Tool("capsule", "Capsule", "capsule", "drag from end to end"),
    Tool("outline", "Draw an outline", "outline", "draw all around a body"),
    Tool("pin", "Pin", "pin", "click a body, or where two overlap"),
    Tool("weld", "Weld", "", "click where two overlap"),
    Tool("motor", "Motor", "", "click a body, or where two overlap"),
    Tool("rope", "Rope", "", "drag from body to body"),
    Tool("spring", "Spring", "", "drag from body to body"),
    Tool("cut", "Cut", "cut", "draw a line through bodies or joints"),
    Tool("duplicate", "Duplicate", "", "drag a copy away"),
    Tool("delete", "Delete", "", "click a body or a joint"),
)  # fmt: skip
OF_PICTURE = ("contacts", "forces", "islands", "loads")
OF_TOOLS = ("density", "sides", "motor_speed", "spring_rate")


class SolidParameters(Parameters):
    """Tools, material, solver, and what is shown."""

    tool = choose_tool(TOOLS)
    density = Param(1.0, 0.001, 1e4, unit="kg/m²", log=True, group="Tools", help="of new bodies")
    sides = Param(5, 3, 12, whole=True, group="Tools", label="Corners", help="of a new regular polygon")
    motor_speed = Param(3.0, -30.0, 30.0, unit="rad/s", group="Tools", label="Motor", help="of new motors")
    spring_rate = Param(
        2.0, 0.1, 30.0, unit="Hz", log=True, group="Tools", label="Spring", help="frequency of new springs"
    )
    friction = Param(
        0.6, 0.0, 2.0, group="World", help="Coulomb's coefficient, of bodies without one of their own"
    )
    restitution = Param(0.0, 0.0, 1.0, group="World", help="part of an approach that comes back, likewise")
    impact_law = solids.choose_impact_law()
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    tier = solids.choose_quality()
    substeps = solids.choose_substeps(64)
    iterations = solids.choose_iterations(100)
    solver = solids.choose_solver()
    stiffness = solids.choose_stiffness()
    step_length = solids.choose_step(1.0 / 60.0, 1.0 / 1000.0, 1.0 / 20.0)
    contacts = Toggle(False, group="Shown", label="Contacts")
    forces = Toggle(
        False, group="Shown", label="Contact forces", help="impulse of the last substep over its length"
    )
    loads = Toggle(False, group="Shown", label="Joint forces")
    islands = Toggle(
        False, group="Shown", label="Islands", help="what touches or is joined; asleep it is pale"
    )
