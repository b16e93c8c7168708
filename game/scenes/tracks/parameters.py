"""What can be chosen about balls on tracks."""

from __future__ import annotations

from game.physics.solids import TIERS
from game.stage import Choice, Param, Parameters, Toggle

TOOLS = ("hand", "ball", "draw", "bend", "delete")
FORMS = ("disc", "sphere", "ring")
OF_TOOLS = ("tool", "radius", "form", "bending")
OF_PICTURE = ("velocities", "trails", "points")


class TrackParameters(Parameters):
    """Tools, balls, steps, and what is shown."""

    tool = Choice(
        "hand", TOOLS, labels=("Move a ball", "New ball", "Draw a track", "Bend a track", "Delete"),
        group="Tools",
        help="what the left button does",
    )  # fmt: skip
    form = Choice("disc", FORMS, group="Tools", label="New ball", help="I = ½, ⅖ or 1 times m r²")
    radius = Param(0.1, 0.01, 2.0, unit="m", log=True, group="Tools", help="of a new ball")
    bending = Param(
        0.6, 0.05, 5.0, unit="m", log=True, group="Tools", help="how far along a track a bend reaches"
    )
    friction = Param(
        0.6, 0.0, 5.0, group="World", help="Coulomb's coefficient, of balls without one of their own"
    )
    restitution = Param(0.0, 0.0, 1.0, group="World", help="part of the speed of an impact that comes back")
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    again = Toggle(
        True, group="World", label="Balls come back",
        help="a ball that has flown out of view begins again where it began",
    )  # fmt: skip
    tier = Choice(
        "play", (*TIERS, "own"), labels=("Play", "Teach", "Film", "Own"), group="Steps", label="Quality",
        help=f"substeps: {', '.join(map(str, TIERS.values()))}, or as many as you say",
    )  # fmt: skip
    substeps = Param(4, 1, 64, whole=True, log=True, group="Steps", help="parts of a step, with Own")
    step_length = Param(1.0 / 120.0, 1.0 / 2000.0, 1.0 / 20.0, unit="s", log=True, group="Steps",
                        label="Time step")  # fmt: skip
    chords = Param(
        0, 0, 800, whole=True, group="Steps", rebuild=True,
        help="tracks of a formula go through so many points; 0: as many as the level says",
    )  # fmt: skip
    velocities = Toggle(False, group="Shown", label="Velocities")
    trails = Toggle(True, group="Shown", label="Trails")
    points = Toggle(False, group="Shown", label="Points", help="that the smooth curves go through")

    def substeps_now(self) -> int:
        """By the quality that is chosen."""
        return TIERS.get(self.tier, int(self.substeps))
