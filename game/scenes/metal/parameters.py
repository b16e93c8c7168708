"""What can be chosen about the marble run."""

from __future__ import annotations

from game.physics.solids import SOLVERS, TIERS
from game.stage import Choice, Param, Parameters, Toggle

TOOLS = ("hand", "bend", "draw", "ball", "size", "delete")
OF_PICTURE = ("marks",)
OF_TOOLS = ("tool", "radius", "bending")


class MetalParameters(Parameters):
    """Tools, balls, steps, and what is shown."""

    tool = Choice(
        "hand", TOOLS,
        labels=("Move a ball", "Bend a track", "Draw a track", "New ball", "Size of a ball", "Delete"),
        group="Tools", help="what the left button does",
    )  # fmt: skip
    radius = Param(0.12, 0.03, 0.5, unit="m", log=True, group="Tools", help="of a new ball")
    bending = Param(
        0.6, 0.05, 5.0, unit="m", log=True, group="Tools", help="how far along a track a bend reaches"
    )
    friction = Param(0.3, 0.0, 2.0, group="Balls", help="Coulomb's coefficient of steel on all it meets")
    restitution = Param(
        0.3, 0.0, 1.0, group="Balls", help="part of the speed of an impact that comes back, off the tracks"
    )
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Balls", help="downwards")
    tier = Choice(
        "play", (*TIERS, "own"), labels=("Play", "Teach", "Film", "Own"), group="Solver", label="Quality",
        help=f"substeps: {', '.join(map(str, TIERS.values()))}, or as many as you say",
    )  # fmt: skip
    substeps = Param(4, 1, 128, whole=True, log=True, group="Solver", help="parts of a step, with Own")
    solver = Choice("soft-step", tuple(SOLVERS), group="Solver", help="what finds the impulses of contacts")
    step_length = Param(
        1.0 / 120.0, 1.0 / 2000.0, 1.0 / 60.0, unit="s", log=True, group="Solver", label="Time step"
    )
    marks = Toggle(False, group="Shown", label="Contacts and speeds", help="in a story F7 shows them as well")

    def substeps_now(self) -> int:
        """By the quality that is chosen."""
        return TIERS.get(self.tier, int(self.substeps))
