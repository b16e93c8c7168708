"""What can be chosen about the tower."""

from __future__ import annotations

from game.physics.solids import SOLVERS, TIERS
from game.stage import Choice, Param, Parameters, Toggle

OF_PICTURE = ("marks", "dust")
OF_TOOLS = ("tool",)


class TowerParameters(Parameters):
    """The charges, the strength of what breaks, and the solver."""

    tool = Choice(
        "cut", ("cut", "break"), labels=("Cut a column", "Break a floor"), group="Tools",
        help="what the left button does",
    )  # fmt: skip
    first = Param(
        0, 0, 40, whole=True, group="Charges", label="First storey",
        help="whose columns are cut first, counted from the ground; 0: as the level says",
    )  # fmt: skip
    delay = Param(0.04, 0.0, 2.0, unit="s", group="Charges", help="from column to column, the left one first")
    gives_way = Toggle(
        True, group="Charges", label="Give way", help="columns below give way where the floors strike"
    )
    blast = Param(3.0, 0.0, 20.0, unit="m/s", group="Charges", help="at which pieces of columns fly off")
    strength = Param(
        4.0, 0.1, 100.0, unit="m/s", log=True, group="Strength", help="a floor that is stopped faster breaks"
    )
    joints = Param(
        2.0, 0.01, 1000.0, log=True, group="Strength", label="Joints of floors",
        help="load at which they part, in weights of a floor's bay",
    )  # fmt: skip
    friction = Param(0.5, 0.0, 2.0, group="World", help="Coulomb's coefficient of everything")
    gravity = Param(9.81, 0.5, 30.0, unit="m/s²", group="World", help="downwards")
    tier = Choice(
        "play", (*TIERS, "own"), labels=("Play", "Teach", "Film", "Own"), group="Solver", label="Quality",
        help=f"substeps: {', '.join(map(str, TIERS.values()))}, or as many as you say",
    )  # fmt: skip
    substeps = Param(4, 1, 128, whole=True, log=True, group="Solver", help="parts of a step, with Own")
    solver = Choice("soft-step", tuple(SOLVERS), group="Solver", help="what finds the impulses of contacts")
    step_length = Param(
        1.0 / 60.0, 1.0 / 2000.0, 1.0 / 30.0, unit="s", log=True, group="Solver", label="Time step"
    )
    dust = Toggle(True, group="Shown", label="Dust")
    marks = Toggle(False, group="Shown", label="Front and law", help="in a story F7 shows them as well")

    def substeps_now(self) -> int:
        """By the quality that is chosen."""
        return TIERS.get(self.tier, int(self.substeps))
