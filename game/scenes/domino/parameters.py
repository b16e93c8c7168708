"""What can be chosen in the world of dominoes."""

from __future__ import annotations

from game.physics.solids import SOLVERS, TIERS
from game.stage import Choice, Param, Parameters, Toggle

TOOLS = ("push", "drag", "add", "remove")
OF_PICTURE = ("marks",)
OF_TOOLS = ("tool",)


class DominoParameters(Parameters):
    """The dominoes, the solver, and what the hand does."""

    tool = Choice(
        "push", TOOLS, labels=("Push", "Drag", "Add", "Remove"), group="Tools",
        help="what the left button does",
    )  # fmt: skip
    spacing = Param(
        0.3, 0.02, 0.95, unit="m", step=0.01, rebuild=True, group="Dominoes",
        help="gap between two; they are 1 m high",
    )  # fmt: skip
    friction = Param(0.2, 0.0, 1.5, group="Dominoes", help="Coulomb's coefficient between two dominoes")
    floor_friction = Param(
        1.0, 0.0, 5.0, group="Dominoes", label="On the floor",
        help="Coulomb's coefficient of dominoes and balls with a floor",
    )  # fmt: skip
    restitution = Param(0.5, 0.0, 1.0, group="Dominoes", help="of balls: part of the speed that comes back")
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Dominoes", help="downwards")
    tier = Choice(
        "play", (*TIERS, "own"), labels=("Play", "Teach", "Film", "Own"), group="Solver", label="Quality",
        help=f"substeps: {', '.join(map(str, TIERS.values()))}, or as many as you say",
    )  # fmt: skip
    substeps = Param(4, 1, 128, whole=True, log=True, group="Solver", help="parts of a step, with Own")
    iterations = Param(
        1, 1, 50, whole=True, log=True, group="Solver", help="sweeps over all contacts in each substep"
    )
    solver = Choice("soft-step", tuple(SOLVERS), group="Solver", help="what finds the impulses of contacts")
    step_length = Param(
        1.0 / 60.0, 1.0 / 2000.0, 1.0 / 30.0, unit="s", log=True, group="Solver", label="Time step"
    )
    marks = Toggle(False, group="Shown", label="Contacts and speeds", help="in a story F7 shows them as well")

    def substeps_now(self) -> int:
        """By the quality that is chosen."""
        return TIERS.get(self.tier, int(self.substeps))
