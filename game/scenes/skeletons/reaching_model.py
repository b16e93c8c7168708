"""C03: a chain of the figure is taken to its target by six methods, each from its own last pose."""

from __future__ import annotations

import math
from typing import NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.animation import JOINT_LIMITS, SKINNING, Solution, Solver
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.scenes.skeletons.level import FigureContent, bone_named
from game.scenes.skeletons.model import FigureModel
from game.scenes.skeletons.parameters import SHOWN, ReachingParameters

TRAIL = 90  # steps of errors that a figure shows
MAY_SWING = ("gradient", "damped-fixed")  # these show their last pose, not their best
STEADY, STEADINESS = 20, 0.01  # an error that changed by so small a share in so many steps stays
AT_LIMIT = 1e-9  # rad
UNSOLVED = Solution(0.0, 0, 0, "")


class ReachingState(NamedTuple):
    """Poses (6, n + 2) of the methods, target (2,) m, time (1,) s, errors (6, TRAIL) m, and the figure."""

    poses: Floats
    target: Floats
    clock: Floats
    trail: Floats
    figure: NDArray[np.uint8]


class ReachingModel(FigureModel):
    """methods (6, n + 2): their poses. measured: what each found last. inside: the bones of the chain.

    The rig stands in the pose of the chosen method. solver: None while there is no chain.
    """

    parameters: ReachingParameters

    def __init__(self, parameters: ReachingParameters, active: EffectSet, content: FigureContent) -> None:
        self.target = np.zeros(2)
        self.trail = np.zeros((len(SHOWN), TRAIL))
        self.measured = [UNSOLVED] * len(SHOWN)
        super().__init__(parameters, active, content)
        chain = content.chain
        if chain is not None:
            self.target[:] = chain.target
            end = self.rig.skeleton.ends[self.inside[-1]].tolist()
            self.measured = [Solution(elementary.dist(end, chain.target), 0, 0, "")] * len(SHOWN)
            self.trail[:] = self.measured[0].error

    def refresh(self) -> None:
        """The solver of the new skeleton's chain, and a pose for each method."""
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
        figure = self._with_target(self.bench.figure)
        if figure != self.bench.figure:
            self.bench = msgspec.structs.replace(self.bench, figure=figure)
            self.rig.figure = figure

    def _with_target(self, figure: FigureContent) -> FigureContent:
        """A figure, whose chain has the present target if it has a chain."""
        if figure.chain is None:
            return figure
        x, y = self.target.tolist()
        return msgspec.structs.replace(figure, chain=msgspec.structs.replace(figure.chain, target=(x, y)))

    def take_pose(self, pose: Floats) -> None:
        super().take_pose(pose)
        self.methods[:] = pose

    def poses(self) -> Floats:
        return self.methods.copy()

    def take_poses(self, poses: Floats) -> None:
        self.methods = np.array(poses)
        self.stand_as_chosen()

    def stand_as_chosen(self) -> None:
        """The rig takes the pose of the chosen method."""
        self.rig.pose(self.methods[self.parameters.master])

    def state(self) -> ReachingState:
        return ReachingState(self.methods, self.target, np.array([self.time]), self.trail, self.document())

    def restore(self, state: ReachingState) -> None:
        self.restore_document(state.figure)
        self.take_poses(state.poses)
        self.target[:] = state.target
        self.time = float(state.clock[0])
        self.trail[:] = state.trail

    def save_content(self) -> FigureContent:
        return self._with_target(super().save_content())

    def hindrance(self, k: int) -> str:
        """Why method number ``k`` does not come to its target: "out of reach", "stuck at a limit", or ""."""
        error, tolerance = self.measured[k].error, self.parameters.tolerance
        if self.solver is None or error <= tolerance:
            return ""
        chain, skeleton = self.solver.chain, self.rig.skeleton
        distance = elementary.dist(skeleton.bases[self.inside[0]].tolist(), self.target.tolist())
        if not chain.hole - tolerance <= distance <= chain.reach + tolerance:
            return "out of reach"
        steady = np.abs(self.trail[k, -STEADY:] - error).max() <= STEADINESS * error
        angles = self.methods[k, self.inside]
        lower, upper = skeleton.lower[self.inside], skeleton.upper[self.inside]
        limited = bool(np.any((angles <= lower + AT_LIMIT) | (angles >= upper - AT_LIMIT)))
        return "stuck at a limit" if steady and limited and JOINT_LIMITS in self.active else ""

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """One step: target and other bones move by themselves, then all methods go on."""
        self.time = (round(self.time / dt) + 1) * dt  # whole steps: a running sum would drift
        if self.parameters.motion:
            self._move()
        self.solve_all(first=round(self.time / dt) % len(SHOWN))

    def _move(self) -> None:
        """Target and bones outside the chain as they are at the present time."""
        swung = self.rig.swung(self.time)
        others = np.ones(len(swung), dtype=bool)
        others[self.inside] = False
        self.methods[:, others] = swung[others]
        chain = self.rig.figure.chain
        if chain is not None and chain.path is not None:
            path = chain.path
            turn = 2.0 * math.pi * path.rate * self.time
            self.target[0] = path.centre[0] + path.reach[0] * elementary.cos(turn)
            self.target[1] = path.centre[1] + path.reach[1] * elementary.sin(path.turns * turn)

    def solve_all(self, first: int) -> None:
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
        self.stand_as_chosen()
        if SKINNING in self.active:
            self.rig.move(self.parameters.blend)

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
        shown = self.parameters
        method = "damped-fixed" if SHOWN[k] == "damped" and not shown.adaptive else SHOWN[k]
        return solver.solve(
            self.target, method, shown.tolerance, int(shown.iterations), step=shown.gradient_step,
            damping=shown.damping, limited=JOINT_LIMITS in self.active, keep_best=method not in MAY_SWING,
        )  # fmt: skip
