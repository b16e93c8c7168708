"""What may be changed in the broad-phase scenes."""

from __future__ import annotations

from game.physics.broadphase.workloads import WORKLOADS
from game.stage import Choice, Param, Parameters, Toggle

KINDS = ("equal", "heavy-tail", "power-law", "clustered", "line", "lattice")
WORKLOAD_HELP = "how boxes are made; on one line and on a lattice they tremble about their places"
KIND_LABELS = ("Equal sizes", "Two sizes", "Heavy-tailed sizes", "Clustered", "On one line", "Lattice")
RATIO, SHARE = 20.0, 0.01  # of large boxes, in scenes without parameters for them
MAKING = ("workload", "fill", "ratio", "share")  # parameters by which random boxes are made
COUNT_HELP = "boxes are added or removed while the others go on; their density stays"
FILL_HELP = "area of equal boxes over that of the world; a box overlaps four times as many"
CONTESTANTS = ("naive", "uniform", "covering", "hierarchical", "sweep", "bsp", "kinetic")  # of the race


def _ratio() -> Param:
    return Param(
        RATIO, 1.0, 1000.0, log=True, group="Boxes", label="Large to small", rebuild=True,
        help="size of the largest boxes of the heavy tail over that of the small ones",
    )  # fmt: skip


def _share() -> Param:
    return Param(
        SHARE, 0.0, 0.5, group="Boxes", label="Share of large ones", rebuild=True,
        help="where there are two sizes",
    )  # fmt: skip


class BoxesParameters(Parameters):
    """What all broad-phase scenes have."""

    count = Param(500, 1, 100_000, whole=True, log=True, group="Boxes", label="Number", help=COUNT_HELP)
    workload = Choice("equal", KINDS, labels=KIND_LABELS, group="Boxes", rebuild=True, help=WORKLOAD_HELP)
    fill = Param(0.1, 0.01, 2.0, log=True, group="Boxes", label="Density", rebuild=True, help=FILL_HELP)
    speed = Param(
        0.6, 0.01, 100.0, log=True, unit="m/s", group="Boxes", help="of every box, in any direction"
    )
    leaps = Param(
        0.0, 0.0, 1.0, group="Disturbance", label="Leaps",
        help="share of the boxes that leap anywhere each step",
    )  # fmt: skip
    turnover = Param(
        0.0, 0.0, 1000.0, whole=True, group="Disturbance", label="Replaced",
        help="boxes that go each step, and come",
    )  # fmt: skip
    step_length = Param(
        1.0 / 60.0, 1.0 / 960.0, 0.25, log=True, unit="s", group="Step", label="Length of a step",
        help="boxes are tested at its end: what meets and separates within is missed",
    )  # fmt: skip
    swept = Toggle(
        False, group="Step", label="Swept boxes",
        help="test what a box covers during the step: none is missed",
    )  # fmt: skip
    lines = Toggle(True, group="Shown", label="Pairs", help="a line between the centres of a pair")

    def large(self) -> tuple[float, float]:
        """Ratio and share of large boxes: what the scene's parameters say, if it has them."""
        return self.values.get("ratio", RATIO), self.values.get("share", SHARE)


class GridParameters(BoxesParameters):
    """Of C05."""

    cell = Param(
        2.0, 0.25, 32.0, log=True, group="Grid", label="Cell size",
        help="edge of a cell over the size of most boxes",
    )  # fmt: skip
    storage = Choice(
        "corner", ("corner", "covered"), labels=("One cell", "All covered"), group="Grid",
        label="A box stands in", help="the cell of its lower corner, or every cell that it covers",
    )  # fmt: skip
    heat = Toggle(True, group="Shown", label="Cell load", help="cells shaded by the boxes in them")


class ComparedParameters(BoxesParameters):
    """Of scenes that hold one broad phase against testing every box against every other."""

    manager = Choice(
        "matrix", ("matrix", "hash"), labels=("Full matrix", "Hash table"), group="Pairs",
        label="Pair manager",
        help="where pairs are kept from step to step; above 4096 boxes always a hash table",
    )  # fmt: skip


class HierarchyParameters(ComparedParameters):
    """Of C06."""

    step_ratio = Choice(
        "2", ("2", "4", "8", "16"), labels=("2", "4", "8", "16"), group="Levels",
        label="Cells from level to level", help="how many times larger the cells of the next level are",
    )  # fmt: skip
    workload = Choice(
        "heavy-tail", KINDS, labels=KIND_LABELS, group="Boxes", rebuild=True, help=WORKLOAD_HELP
    )
    ratio = _ratio()
    share = _share()
    cells = Toggle(
        True, group="Shown", label="Cells", help="cells that hold boxes, in the colour of their level"
    )
    stack = Toggle(
        False, group="Shown", label="Tilted stack",
        help="level upon level, each with its hash table beside it",
    )  # fmt: skip


class SweepParameters(ComparedParameters):
    """Of C07."""

    resort = Toggle(
        True, group="Pairs", label="Sort again when cheaper",
        help="a step with too many swaps is finished by sorting; if off, only one of above 4 million swaps",
    )  # fmt: skip
    count = Param(200, 1, 100_000, whole=True, log=True, group="Boxes", label="Number", help=COUNT_HELP)
    speed = Param(
        0.25, 0.01, 100.0, log=True, unit="m/s", group="Boxes", help="of every box, in any direction"
    )
    axes = Toggle(
        True, group="Shown", label="Sorted axes", help="end points beside the world; amber: swapped"
    )


class RaceParameters(BoxesParameters):
    """Of the race."""

    workload = Choice(
        "equal", WORKLOADS, labels=(*KIND_LABELS, "All leap each step"), group="Workload", rebuild=True,
        help="how boxes are made, and whether they leap",
    )  # fmt: skip
    count = Param(400, 1, 100_000, whole=True, log=True, group="Workload", label="Number", help=COUNT_HELP)
    fill = Param(0.1, 0.01, 2.0, log=True, group="Workload", label="Density", rebuild=True, help=FILL_HELP)
    ratio = _ratio()
    share = _share()
    cell = Param(
        1.25, 0.25, 32.0, log=True, group="Boxes", label="Cell size",
        help="of the uniform grid, over that of boxes",
    )  # fmt: skip
    naive = Toggle(True, group="Contestants", label="Naive")
    uniform = Toggle(True, group="Contestants", label="Uniform grid")
    covering = Toggle(True, group="Contestants", label="Grid, all cells covered")
    hierarchical = Toggle(True, group="Contestants", label="Hierarchical grids")
    sweep = Toggle(True, group="Contestants", label="Sweep and prune")
    bsp = Toggle(True, group="Contestants", label="BSP tree")
    kinetic = Toggle(True, group="Contestants", label="Kinetic sweep")
    slabs = Choice(
        "8", ("4", "8", "16"), group="Contestants", label="Sides of a bound",
        help="of the kinetic sweep: a slab lies across the motion, in the nearest of half as many directions",
    )  # fmt: skip
    cuts = Toggle(False, group="Shown", label="Cuts of the BSP tree")
    bounds = Toggle(
        False, group="Shown", label="Bounds of the kinetic sweep",
        help="what boxes are to cover until they are looked at again; below, in how many steps that is",
    )  # fmt: skip

    def chosen(self) -> tuple[str, ...]:
        """The contestants that are switched on."""
        return tuple(name for name in CONTESTANTS if self.values[name])
