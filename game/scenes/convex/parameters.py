"""What may be changed in the V-Clip and GJK scenes."""

from __future__ import annotations

from game.physics.narrowphase.gjk import METHODS
from game.scenes.convex.level import MOST_CORNERS
from game.scenes.shared.outlines import editor
from game.stage import Choice, Param, Parameters, Toggle


class PairParameters(Parameters):
    """What both scenes have."""

    tool = Choice(
        "move", editor.TOOLS, labels=("Move", "Draw", "Corners"), group="Tools",
        help="drag and turn; click a new polygon; drag, add and take away corners",
    )  # fmt: skip
    start_a = Param(
        0, 0, 2 * MOST_CORNERS, whole=True, group="Query", label="Begin at, of A",
        help="feature without coherence: 2 i is vertex i, 2 i + 1 the edge after it",
    )  # fmt: skip
    start_b = Param(0, 0, 2 * MOST_CORNERS, whole=True, group="Query", label="Begin at, of B")
    numbers = Toggle(True, group="Shown", label="Numbers", help="of vertices, when they are few")


class VClipParameters(PairParameters):
    """Of C10."""

    regions = Toggle(
        True, group="Shown", label="Voronoi regions", help="borders; those of the two features filled"
    )
    walk = Toggle(True, group="Shown", label="Walk", help="features visited by the last query, numbered")


class GjkParameters(PairParameters):
    """Of C11."""

    exponent = Param(
        -14.0, -14.0, -1.0, step=1.0, group="Query", label="Tolerance, power of ten",
        help="relative, at which the walk may end early",
    )  # fmt: skip
    method = Choice(
        "climb", METHODS, labels=("Climb", "Scan"), group="Query", label="Farthest vertex",
        help="by climbing from the last one, or by looking at all",
    )  # fmt: skip
    minkowski = Toggle(True, group="Shown", label="Minkowski difference")
    supports = Toggle(True, group="Shown", label="Support vertices", help="asked for in the step shown")
