"""What can be chosen in the playground of solids."""

from __future__ import annotations

from game.scenes.solids.level import COLOURS
from game.stage import Choice, Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

TOOLS = (
    Tool("hand", "Move", "hand", "", "G", "grab"),
    Tool("throw", "Throw", "throw", "drag a body back and let go", "T", "throw"),
    Tool("select", "Select", "select", "click a body to see and change what is its own", "V", "select"),
    Tool("disc", "Disc", "disc", "drag from the middle to the rim", "D", "ball", apart=True),
    Tool("box", "Box", "box", "drag from corner to corner", "B", "box"),
    Tool("polygon", "Polygon", "polygon", "drag from the middle to a corner", "N", "polygon"),
    Tool("capsule", "Capsule", "capsule", "drag from end to end", "C", "capsule"),
    Tool("outline", "Draw an outline", "outline", "draw all around a body", "O", "outline"),
    Tool("pin", "Pin", "pin", "click a body, or where two overlap", "I", "pin", apart=True),
    Tool("weld", "Weld", "weld", "click where two overlap", "W", "weld"),
    Tool("motor", "Motor", "motor", "click a body, or where two overlap", "M", "motor"),
    Tool("rope", "Rope", "rope", "drag from body to body", "R", "rope"),
    Tool("spring", "Spring", "spring", "drag from body to body", "S", "spring"),
    Tool("duplicate", "Duplicate", "duplicate", "drag a copy away", "U", "duplicate", apart=True),
    Tool("cut", "Cut", "cut", "draw a line through bodies or joints", "X", "cut"),
    Tool("delete", "Delete", "delete with a click", "click a body or a joint", "E", "delete"),
)
OF_CHOSEN = ("own_density", "own_friction", "own_restitution", "own_colour")  # say and set what is clicked
OF_PICTURE = ("contacts", "forces", "islands", "loads")
OF_TOOLS = ("density", "sides", "motor_speed", "spring_rate")
CHOSEN_JOINT = "Chosen joint"
BEYOND = 1e6  # N, N m: the right end of a load stands for no bound
CHOSEN = "Chosen body"  # group of the parameters on the card


class SolidParameters(Parameters):
    """Tools, material, solver, and what is shown."""

    tool = choose_tool(TOOLS)
    density = Param(1.0, 0.001, 1e4, unit="kg/m²", log=True, group="Tools", help="of new bodies")
    sides = Param(5, 3, 12, whole=True, group="Tools", label="Corners", help="of a new regular polygon")
    motor_speed = Param(3.0, -30.0, 30.0, unit="rad/s", group="Tools", label="Motor", help="of new motors")
    spring_rate = Param(
        2.0, 0.1, 30.0, unit="Hz", log=True, group="Tools", label="Spring", help="frequency of new springs"
    )
    own_density = Param(
        1.0, 0.001, 1e4, unit="kg/m²", log=True, group=CHOSEN, label="Density", help="of the chosen body",
        in_panel=False,
    )  # fmt: skip
    own_friction = Param(
        0.6, 0.0, 2.0, group=CHOSEN, label="Friction", in_panel=False,
        help="of the chosen body; two that touch have the root of both their products",
    )  # fmt: skip
    own_restitution = Param(
        0.0, 0.0, 1.0, group=CHOSEN, label="Restitution", in_panel=False,
        help="of the chosen body; of two that touch the larger counts",
    )  # fmt: skip
    own_colour = Choice(
        COLOURS[0], COLOURS, group=CHOSEN, label="Colour", help="of the chosen body", in_panel=False
    )
    joint_limited = Toggle(
        False,
        group=CHOSEN_JOINT,
        label="Limits",
        help="whether the chosen joint ends somewhere",
        in_panel=False,
    )
    joint_least_turn = Param(
        -90.0, -360.0, 360.0, unit="°", group=CHOSEN_JOINT, label="Least turn", in_panel=False,
        help="of the second body against the first, from how they were joined",
    )  # fmt: skip
    joint_most_turn = Param(
        90.0, -360.0, 360.0, unit="°", group=CHOSEN_JOINT, label="Most turn", in_panel=False, help="likewise"
    )
    joint_least_way = Param(
        0.0, -20.0, 20.0, unit="m", group=CHOSEN_JOINT, label="Least", in_panel=False,
        help="of a slider from where it was joined, of a spring or distance its length",
    )  # fmt: skip
    joint_most_way = Param(
        1.0, -20.0, 20.0, unit="m", group=CHOSEN_JOINT, label="Most", in_panel=False, help="likewise"
    )
    joint_speed = Param(
        0.0, -50.0, 50.0, unit="rad/s", group=CHOSEN_JOINT, label="Motor speed", in_panel=False,
        help="that the drive of the chosen joint wants",
    )  # fmt: skip
    joint_pace = Param(
        0.0, -20.0, 20.0, unit="m/s", group=CHOSEN_JOINT, label="Motor speed", in_panel=False,
        help="that the drive of the chosen slider wants",
    )  # fmt: skip
    joint_torque = Param(
        BEYOND, 0.001, BEYOND, unit="N m", log=True, group=CHOSEN_JOINT, label="Motor torque", in_panel=False,
        help="the most of its drive; without a speed it is a brake, at the right end without a bound",
    )  # fmt: skip
    joint_force = Param(
        BEYOND, 0.001, BEYOND, unit="N", log=True, group=CHOSEN_JOINT, label="Motor force", in_panel=False,
        help="the most of its drive; without a speed it is a brake, at the right end without a bound",
    )  # fmt: skip
    joint_hertz = Param(
        0.0, 0.0, 60.0, unit="Hz", group=CHOSEN_JOINT, label="Stiffness", in_panel=False,
        help="as frequency of the two bodies on it; 0: as stiff as the solver makes it",
    )  # fmt: skip
    joint_damping = Param(
        1.0, 0.0, 5.0, group=CHOSEN_JOINT, label="Damping", in_panel=False, help="as part of the critical one"
    )
    joint_break = Param(
        BEYOND, 0.001, BEYOND, unit="N", log=True, group=CHOSEN_JOINT, label="Breaks at", in_panel=False,
        help="force at which the chosen joint breaks; at the right end it never does",
    )  # fmt: skip
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
