"""What a person may change in both skeleton scenes, in skinning (C02), in inverse kinematics (C03)."""

from __future__ import annotations

from game.physics.animation import BLENDS
from game.physics.animation.ik.solver import METHODS
from game.stage import Choice, Param, Parameters, Toggle

SHOWN = METHODS[:6]  # the solvers that stand side by side
BINDING = ("threshold", "falloff", "influences", "smooth")  # parameters by which skins are bound


class FigureParameters(Parameters):
    """Of both scenes: the tool in the hand, how skins are bound and blended, what is shown."""

    tool = Choice(
        "pose", ("pose", "bone", "skin"), labels=("Turn", "New bone", "Skin"), group="Hand",
        help="what the left button does",
    )  # fmt: skip
    motion = Toggle(True, group="Hand", label="Moves by itself", help="until you take a bone")
    blend = Choice(
        "linear", BLENDS, labels=("Matrices", "Rotors"), group="Skin",
        help="what is blended between bones: matrices lose area at a bend, rotors bulge",
    )  # fmt: skip
    threshold = Param(
        0.3, 0.005, 5.0, unit="m", log=True, group="Skin", help="bones farther off than this do not count"
    )
    falloff = Param(3.0, 0.5, 16.0, log=True, group="Skin", help="how fast a weight falls with distance")
    influences = Param(4, 1, 8, whole=True, group="Skin", help="the most bones that a point follows")
    smooth = Toggle(True, group="Skin", label="Rounded", help="outlines are rounded between their points")
    bones = Toggle(True, group="Shown", label="Bones")
    skins = Toggle(True, group="Shown", label="Skins")
    weights = Toggle(False, group="Shown", label="Weights", help="as colours: of all bones, or of the chosen")

    @property
    def tools(self) -> tuple[str, ...]:
        """All tools that the hand may take."""
        tool = type(self).tool
        assert isinstance(tool, Choice)
        return tool.options


class SkinningParameters(FigureParameters):
    """Of skinning."""

    compare = Toggle(False, group="Shown", label="The other blend", help="as a dashed outline")


class ReachingParameters(FigureParameters):
    """Of inverse kinematics: another set of tools, and the solvers."""

    tool = Choice(
        "pull", ("pull", "pose", "bone", "chain", "skin"),
        labels=("Pull", "Turn a bone", "New bone", "Pick a chain", "Skin"), group="Hand",
        help="what the left button does",
    )  # fmt: skip
    method = Choice(
        "damped", SHOWN, labels=("Gradient", "Buss step", "Armijo", "Damped", "CCD", "FABRIK"),
        group="Solver", help="the one that is saved, and shown alone",
    )  # fmt: skip
    compare = Toggle(True, group="Solver", label="All six", help="side by side, or the chosen one alone")
    iterations = Param(10, 1, 300, whole=True, log=True, group="Solver", help="at most, in each step")
    tolerance = Param(1e-6, 1e-12, 0.01, unit="m", log=True, group="Solver")
    gradient_step = Param(
        1.0, 0.02, 4.0, log=True, group="Solver", label="Step of the gradient",
        help="over the safe one; from 2 on it may swing",
    )  # fmt: skip
    adaptive = Toggle(True, group="Solver", label="Damping adapts", help="else it is fixed, and may thrash")
    damping = Param(0.1, 0.001, 1.0, log=True, group="Solver", label="Fixed damping", help="λ over the reach")
    jacobian = Toggle(
        False, group="Shown", label="Jacobian",
        help="of the chosen method: its columns as arcs of the end, J^T e as arcs at the joints",
    )  # fmt: skip
    circles = Toggle(True, group="Shown", label="Reach", help="what the chain can reach, and its hole")

    @property
    def master(self) -> int:
        """Which of the methods is the chosen one."""
        return SHOWN.index(self.method)
