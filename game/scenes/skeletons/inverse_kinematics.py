"""C03: a chain of bones is taken to a target, by six methods side by side."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, ClassVar, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.lab.studies.animation.inverse_kinematics import reaching_study
from game.levels import Level
from game.physics.animation import JOINT_LIMITS, SKINNING, Solution, Solver
from game.physics.animation.ik.solver import METHODS
from game.scenes.skeletons import C03
from game.scenes.skeletons import bench as skeleton_bench
from game.scenes.skeletons import hand as editor
from game.scenes.skeletons.base import EDITING, FigureScene, warm_ups_of_figures
from game.scenes.skeletons.chain_view import ChainView, cell_at, cells_of
from game.scenes.skeletons.figure import draw_ccd
from game.scenes.skeletons.level import BoneEntry, ChainEntry, FigureContent, PathEntry, View, bone_named
from game.stage import (
    Choice,
    Equation,
    Frame,
    Hint,
    Param,
    Pointer,
    Readout,
    SceneAction,
    Strip,
    Toggle,
    WarmUp,
)

Array = NDArray[np.float64]
SHOWN = METHODS[:6]
NAMES = ("gradient", "Buss", "Armijo", "damped", "CCD", "FABRIK")
TRAIL = 90  # steps of errors that a figure shows
MAY_SWING = ("gradient", "damped-fixed")  # these show their last pose, not their best
UNSOLVED = Solution(0.0, 0, 0, "")


class ReachingState(NamedTuple):
    """Poses (6, n + 2) of the methods, target (2,) m, time (1,) s, errors (6, TRAIL) m, and the figure."""

    poses: Array
    target: Array
    clock: Array
    trail: Array
    figure: NDArray[np.uint8]


class InverseKinematics(FigureScene):
    """Pull the end of a chain of bones: the joints find angles by which it gets there. Six methods solve the
    same target, each from its own last pose and with so many iterations in each step; each figure says how
    many it took, what error is left, and the time, some microseconds of which are the call from Python.

    The gradient turns each joint a little the way that helps. With a fixed step it needs hundreds of
    iterations; with Buss's step, or a line search, a tenth of them. Damped least squares solves for all
    joints at once, and damps as much as it must. Cyclic coordinate descent points joint by joint, FABRIK
    pulls points along the chain.

    A target out of reach is met by a straight chain, without shaking. A straight chain with its target on
    its axis is a dead point, where every gradient is nought: it is kicked. With joint limits all six may stop
    short of a target that another pose would reach: turn the joints by hand, and they begin from there.
    """

    name, task, title = C03.names
    study = reaching_study
    shown_methods: ClassVar[tuple[str, ...]] = SHOWN
    tools: ClassVar[tuple[str, ...]] = ("pull", "pose", "bone", "chain", "skin")

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
    circles = Toggle(True, group="Shown", label="Reach", help="what the chain can reach, and its hole")

    strips = (
        Strip("Error", "m", NAMES),
        Strip("Iterations", "", tuple(f"{name} iterations" for name in NAMES)),
        Strip("Time", "s", tuple(f"{name} time" for name in NAMES)),
    )
    figure = staticmethod(draw_ccd)
    equations = (
        Equation("Error", r"\v{e} = \v{t} - \v{p}_n(\theta)", "target and end of the chain"),
        Equation(
            "Gradient", r"\Delta\theta_i = \alpha (J^T e)_i = \alpha (\v{p}_n - \v{p}_i) \times \v{e}", ""
        ),
        Equation("Buss's step", r"\alpha = \frac{e · J J^T e}{|J J^T e|^2}", "Buss 2004"),
        Equation("Damped least squares", r"\Delta\theta = J^T (J J^T + \lambda^2)^{-1} e", "Wampler 1986"),
        Equation("Reach", r"\max(0, 2 l_{max} - L) \le |\v{t}| \le L,  L = \sum l_i", "without limits"),
    )
    try_this = (
        "Pull the target out of reach and around: nobody shakes. Let damping be fixed: it thrashes.",
        "One iteration a step: who follows your hand?",
        "Set the gradient's step to 2.1 and stretch the chain.",
        "Switch joint limits off: elbows bend the wrong way.",
        "Open the dead point: what happens first?",
    )
    hints = (
        Hint(("Drag",), "pull the target"),
        Hint(("1", "2", "3", "4", "5"), "pull, turn, bone, chain, skin"),
        Hint(("C",), "all or one"),
        Hint(("M",), "motion"),
        Hint(("Ctrl+Z",), "take back"),
    )
    actions = (
        SceneAction("pull", "pull the target", "1"),
        SceneAction("pose", "turn a bone", "2"),
        SceneAction("bone", "new bone", "3"),
        SceneAction("chain", "pick a chain", "4"),
        SceneAction("skin", "draw a skin", "5"),
        *EDITING,
        SceneAction("compare-all", "all or one", "c"),
    )
    default_content: ClassVar[FigureContent] = FigureContent(
        bones=tuple(
            BoneEntry(name=f"bone {i}", parent=f"bone {i - 1}" if i else "", length=0.3, angle=20.0)
            for i in range(6)
        ),
        chain=ChainEntry(
            start="bone 0",
            end="bone 5",
            target=(0.6, 0.8),
            path=PathEntry(centre=(0.6, 0.8), reach=(0.6, 0.4)),
        ),
        view=View(left=-1.0, bottom=-0.6, right=2.0, top=2.0),
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        self.pulling = False
        self.target = np.zeros(2)
        self.trail = np.zeros((len(SHOWN), TRAIL))
        self.view = ChainView()
        self.measured = [UNSOLVED] * len(SHOWN)
        super().build(level)
        chain = self.content.chain
        if chain is not None:
            self.target[:] = chain.target
            end = self.rig.skeleton.ends[self.inside[-1]].tolist()
            self.measured = [Solution(math.dist(end, chain.target), 0, 0, "")] * len(SHOWN)
            self.trail[:] = self.measured[0].error

    def refresh(self) -> None:
        """The solver of the new skeleton's chain, and room for a pose of each method."""
        figure = self.rig.figure
        self.methods = np.tile(self.rig.start, (len(SHOWN), 1))
        self.solver: Solver | None = None
        self.inside: NDArray[np.int64] = np.zeros(0, dtype=np.int64)
        if figure.chain is not None:
            ends = bone_named(figure, figure.chain.start), bone_named(figure, figure.chain.end)
            self.solver = Solver(self.rig.skeleton, *ends)
            self.inside = self.solver.chain.bones

    def figure_changed(self) -> None:
        if self.rig.figure.chain is not None:
            self.target[:] = self.rig.figure.chain.target

    def note_target(self) -> None:
        """Let the figure have its target where it is now, so that both are remembered and taken back."""
        figure = self.save_target(self.bench.figure)
        if figure != self.bench.figure:
            self.bench = msgspec.structs.replace(self.bench, figure=figure)
            self.rig.figure = figure

    def save_target(self, figure: FigureContent) -> FigureContent:
        """A figure, whose chain has the present target if it has a chain."""
        if figure.chain is None:
            return figure
        x, y = self.target.tolist()
        return msgspec.structs.replace(figure, chain=msgspec.structs.replace(figure.chain, target=(x, y)))

    def take_pose(self, pose: Array) -> None:
        super().take_pose(pose)
        self.methods[:] = pose

    def poses(self) -> Array:
        return self.methods.copy()

    def take_poses(self, poses: Array) -> None:
        self.methods = np.array(poses)
        self.rig.pose(self.methods[self.master])

    @property
    def master(self) -> int:
        """Which of the methods is the chosen one."""
        return SHOWN.index(self.method)

    def state(self) -> ReachingState:
        return ReachingState(self.methods, self.target, np.array([self.time]), self.trail, self.document())

    def restore(self, state: ReachingState) -> None:
        self.restore_document(state.figure)
        self.take_poses(state.poses)
        self.target[:] = state.target
        self.time = float(state.clock[0])
        self.trail[:] = state.trail

    def save_content(self) -> FigureContent:
        return self.save_target(super().save_content())

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        self.time = (round(self.time / dt) + 1) * dt  # whole steps: a running sum would drift
        chain = self.rig.figure.chain
        if self.motion:
            swung = self.rig.swung(self.time)
            others = np.ones(len(swung), dtype=bool)
            others[self.inside] = False
            self.methods[:, others] = swung[others]
            if chain is not None and chain.path is not None:
                turn = 2.0 * math.pi * chain.path.rate * self.time
                self.target[0] = chain.path.centre[0] + chain.path.reach[0] * math.cos(turn)
                self.target[1] = chain.path.centre[1] + chain.path.reach[1] * math.sin(
                    chain.path.turns * turn
                )
        self._solve_all(first=round(self.time / dt) % len(SHOWN))

    def _solve_all(self, first: int) -> None:
        """Let every method go on from its own pose, the one of number ``first`` first; the figure is left in
        that of the chosen one.

        The first solver after a picture was drawn finds cold caches, which cost more than the solve. So one
        solve is made that is neither timed nor kept, and each step is to begin with another method.
        """
        if self.solver is None:
            return
        self.rig.pose(self.methods[first])
        self._solve(self.solver, first)
        for k in range(len(SHOWN)):
            self._take_solution(self.solver, (first + k) % len(SHOWN))
        self.rig.pose(self.methods[self.master])
        if SKINNING in self.active:
            self.rig.move(self.blend)

    def _take_solution(self, solver: Solver, k: int) -> None:
        """Let method number ``k`` go on from its own pose, and measure how long it takes."""
        self.rig.pose(self.methods[k])
        with self.watch.time(SHOWN[k]):
            found = self._solve(solver, k)
        self.methods[k] = self.rig.now
        self.measured[k] = found
        self.trail[k, :-1] = self.trail[k, 1:]
        self.trail[k, -1] = found.error

    def _solve(self, solver: Solver, k: int) -> Solution:
        """Move the figure from its present pose towards the target by method number ``k``."""
        method = "damped-fixed" if SHOWN[k] == "damped" and not self.adaptive else SHOWN[k]
        return solver.solve(
            self.target, method, self.tolerance, int(self.iterations), step=self.gradient_step,
            damping=self.damping, limited=JOINT_LIMITS in self.active, keep_best=method not in MAY_SWING,
        )  # fmt: skip

    # -- events -------------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        size = self.frame()
        k = cell_at(event.x, event.y, size) if self.compare else self.master
        if event.kind == "down" and event.button == 1 and self.compare:
            self.values["method"] = SHOWN[k]
            self.rig.pose(self.methods[k])
        elif self.pulling or self.bench.held:
            k = self.master  # a drag stays in the figure where it began
        x, y = cells_of(self.bench.figure, self.compare, self.master)[k].into(event.x, event.y)
        event = msgspec.structs.replace(event, x=x, y=y)
        if event.kind == "down":
            self.note_target()
        if self.tool == "pull":
            self._pull(event)
        else:
            super().pointer(event)

    def _pull(self, event: Pointer) -> None:
        if event.kind == "down" and event.button == 1:
            self.bench = skeleton_bench.remembered(self.bench, self.rig.now)
            self.values["motion"] = False
            self.pulling = True
        elif event.kind in ("up", "cancel"):
            self.pulling = False
        if self.pulling and event.kind in ("down", "move"):
            far = editor.FARTHEST
            self.target[:] = min(max(event.x, -far), far), min(max(event.y, -far), far)

    def action(self, name: str) -> None:
        if name == "compare-all":
            self.values["compare"] = not self.compare
        else:
            self.note_target()
            super().action(name)

    def parameter_changed(self, name: str) -> None:
        if name == "method":
            self.rig.pose(self.methods[self.master])
        else:
            super().parameter_changed(name)

    # -- what there is to see -----------------------------------------------------------------------

    def frame(self) -> Frame:
        view = self.bench.figure.view
        return Frame(0.0, 0.0, 3.0 * (view.right - view.left), 2.0 * (view.top - view.bottom))

    def readouts(self) -> list[Readout]:
        mine = self.measured[self.master]
        rows = [
            Readout("error", mine.error, "m"),
            Readout("iterations", mine.iterations),
            Readout("solve", self.watch.median(self.method), "s"),
            Readout("reach", self.solver.chain.reach if self.solver is not None else 0.0, "m"),
        ]
        for k, name in enumerate(NAMES):
            rows.append(Readout(name, self.measured[k].error, "m"))
            rows.append(Readout(f"{name} iterations", self.measured[k].iterations))
            rows.append(Readout(f"{name} time", self.watch.median(SHOWN[k]), "s"))
        return rows

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self, canvas, alpha)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        return (*warm_ups_of_figures(), WarmUp(cls.title, lambda: cls().advance(cls.dt)))
