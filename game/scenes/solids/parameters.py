"""What can be chosen in the playground of solids."""

from __future__ import annotations

from game.physics.solids import SOLVERS, TIERS
from game.stage import Choice, Param, Parameters, Toggle

TOOLS = (
    "hand", "throw", "disc", "box", "polygon", "capsule", "outline", "pin", "weld", "motor", "rope", "spring",
    "cut", "duplicate", "delete",
)  # fmt: skip
TOOL_LABELS = (
    "Move", "Throw", "Disc", "Box", "Polygon", "Capsule", "Draw an outline", "Pin", "Weld", "Motor", "Rope",
    "Spring", "Cut", "Duplicate", "Delete",
)  # fmt: skip
OF_PICTURE = ("contacts", "forces", "islands", "loads")
OF_TOOLS = ("tool", "density", "sides", "motor_speed", "spring_rate")


class SolidParameters(Parameters):
    """Tools, material, solver, and what is shown."""

    tool = Choice("hand", TOOLS, labels=TOOL_LABELS, group="Tools", help="what the left button does")
    density = Param(1.0, 0.001, 1e4, unit="kg/m²", log=True, group="Tools", help="of new bodies")
    sides = Param(5, 3, 12, whole=True, group="Tools", label="Corners", help="of a new regular polygon")
    motor_speed = Param(3.0, -30.0, 30.0, unit="rad/s", group="Tools", label="Motor", help="of new motors")
    spring_rate = Param(
        2.0, 0.1, 30.0, unit="Hz", log=True, group="Tools", label="Spring", help="frequency of new springs"
    )
    friction = Param(
        0.6, 0.0, 2.0, group="World", help="Coulomb's coefficient, of bodies without one of their own"
    )
    restitution = Param(
        0.0, 0.0, 1.0, group="World", help="part of the speed of approach that comes back, likewise"
    )
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    tier = Choice(
        "play", (*TIERS, "own"), labels=("Play", "Teach", "Film", "Own"), group="Solver", label="Quality",
        help=f"substeps: {', '.join(map(str, TIERS.values()))}, or as many as you say",
    )  # fmt: skip
    substeps = Param(4, 1, 64, whole=True, log=True, group="Solver", help="parts of a step, with Own")
    iterations = Param(
        1, 1, 100, whole=True, log=True, group="Solver", help="sweeps over all contacts in each substep"
    )
    solver = Choice("soft-step", tuple(SOLVERS), group="Solver", help="what finds the impulses of contacts")
    stiffness = Param(
        0.0, 0.0, 480.0, unit="Hz", group="Solver", label="Contact frequency",
        help="of soft contacts: a stack sinks by its inverse square; 0: an eighth of the substeps a second",
    )  # fmt: skip
    step_length = Param(1.0 / 60.0, 1.0 / 1000.0, 1.0 / 20.0, unit="s", log=True, group="Solver",
                        label="Time step")  # fmt: skip
    contacts = Toggle(False, group="Shown", label="Contacts")
    forces = Toggle(
        False, group="Shown", label="Contact forces", help="impulse of the last substep over its length"
    )
    loads = Toggle(False, group="Shown", label="Joint forces")
    islands = Toggle(
        False, group="Shown", label="Islands", help="what touches or is joined; asleep it is pale"
    )

    def substeps_now(self) -> int:
        """By the quality that is chosen."""
        return TIERS.get(self.tier, int(self.substeps))
