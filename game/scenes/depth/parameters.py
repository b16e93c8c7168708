"""What can be chosen about the depth of an overlap."""

from __future__ import annotations

from game.physics.narrowphase.depth import PRESETS
from game.stage import Choice, Param, Parameters, Toggle

OF_PICTURE = ("speed", "grid", "curve", "intervals", "ghosts")


class DepthParameters(Parameters):
    """The shapes, the search, and what is shown."""

    shape_a = Choice("comb", PRESETS, group="Shapes", label="A", help="that moves out")
    shape_b = Choice("comb", PRESETS, group="Shapes", label="B", help="that stays")
    tolerance = Param(
        1e-3, 1e-6, 0.3, unit="m", log=True, group="Search",
        help="by which a motion may be shorter than the one found",
    )  # fmt: skip
    grid = Param(31, 5, 81, whole=True, group="Search", label="Brute force",
                 help="places each way and angles of its grid")  # fmt: skip
    speed = Param(0.5, 0.01, 5.0, unit="m/s", log=True, group="Motion",
                  help="of A while it moves out: root mean square of its points")  # fmt: skip
    ghosts = Toggle(True, group="Shown", label="Ways out", help="where A would be after each motion")
    curve = Toggle(True, group="Shown", label="Curve", help="the shortest motion for each angle")
    intervals = Toggle(True, group="Shown", label="Intervals", help="and the bounds of branch and bound")
