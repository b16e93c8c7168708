"""What may be changed in the scenes of bounding-volume trees."""

from __future__ import annotations

from game.physics.bounds import FITS, KINDS, SPLITS
from game.scenes.shared.outlines import editor
from game.stage import Choice, Param, Parameters, Toggle

TREE_PARAMETERS = ("volume", "fit", "angle_step", "leaf_size", "split")  # by which trees are built
WALKS = ("off", "fit", "build", "query")
KIND_LABELS = ("Boxes", "Capsules", "Axis-aligned")
KIND_HELP = "oriented boxes, capsules, or axis-aligned boxes"


class BoundsParameters(Parameters):
    """What C08 and C09 have."""

    volume = Choice("obb", KINDS, labels=KIND_LABELS, group="Volumes", help=KIND_HELP)
    fit = Choice(
        "search", FITS, labels=("Degrees", "Refined", "Thinnest", "Exact"), group="Volumes",
        formerly={"calipers": "exact"},
        help="by angle steps; improved by golden section; of least breadth, or radius; of least area, "
        "capsules to 0.1 %",
    )  # fmt: skip
    angle_step = Param(
        1.0, 0.1, 45.0, unit="°", log=True, group="Volumes", label="Angle step",
        help="the axes are turned by so much from trial to trial",
    )  # fmt: skip
    leaf_size = Param(
        4, 1, 64, whole=True, log=True, group="Volumes", label="Segments in a leaf", help="at most"
    )
    split = Choice(
        "half", SPLITS, labels=("Half", "Median", "Perimeter"), group="Volumes", label="Halved",
        help="in the middle of the volume; of the segments; or where perimeters times segments are least",
    )  # fmt: skip
    deepest = Param(
        6, 0, 24, whole=True, group="Shown", label="Deepest level", help="of the hierarchy in grey and green"
    )
    hierarchy = Toggle(True, group="Shown", label="Whole hierarchy in grey")
    ancestors = Toggle(True, group="Shown", label="Ancestors in green")
    axes = Toggle(False, group="Shown", label="Separating axes", help="what keeps volumes apart")
    compare = Toggle(True, group="Shown", label="Count beside", help="the same query with other trees")
    walked = Choice(
        "off", WALKS, labels=("Off", "Fit", "Build", "Query"), group="Walk", label="Walk through",
        help="step by step through the method; it stands until the arrow keys go on, or it plays",
    )  # fmt: skip
    playing = Toggle(False, group="Walk", label="Play the walk", help="to its end, then it stands")
    pace = Param(
        3.5, 0.5, 60.0, unit="1/s", log=True, group="Walk", label="Steps a second",
        help="of the walk, while it plays",
    )  # fmt: skip
    node = Param(
        0, 0, 8191, whole=True, group="Walk", label="Fit of node", help="0 is the root of the chosen outline"
    )
    sway = Param(0.9, 0.0, 10.0, unit="m", group="Motion", help="how far B drifts to and fro")
    period = Param(14.0, 1.0, 100.0, unit="s", log=True, group="Motion")
    turn_a = Param(0.0, -90.0, 90.0, unit="°/s", group="Motion", label="A turns")
    turn_b = Param(0.0, -90.0, 90.0, unit="°/s", group="Motion", label="B turns")
    tool = Choice(
        "move", editor.TOOLS, labels=("Move", "Draw", "Points"), group="Tools",
        help="what the left button does: drag whole outlines, click a new one, drag corners",
    )  # fmt: skip


class CapsuleParameters(BoundsParameters):
    """What C09 has otherwise, or beside."""

    volume = Choice("capsule", KINDS, labels=KIND_LABELS, group="Volumes", help=KIND_HELP)
    fit = Choice(
        "search", FITS, labels=("Degrees", "Refined", "Least radius", "Exact"), group="Volumes",
        formerly={"calipers": "thinnest"},
        help="by angle steps; improved by golden section; least radius (boxes: breadth), by calipers; least "
        "area to 0.1 %, by branch and bound",
    )  # fmt: skip
    side_by_side = Toggle(
        False, group="Shown", help="these trees on the left, the other ones on the same outlines on the right"
    )
