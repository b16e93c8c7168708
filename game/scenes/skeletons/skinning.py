"""C02: a figure of bones in its skin, posed by hand."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.animation.skinning import skinning_study
from game.physics.animation import JOINT_LIMITS, SKINNING
from game.physics.animation.skeleton_editing import NOWHERE
from game.physics.animation.skinning import BLENDS
from game.scenes.skeletons import C02
from game.scenes.skeletons.base import EDITING, FigureScene, warm_ups_of_figures
from game.scenes.skeletons.cells import WHOLE
from game.scenes.skeletons.figure import draw_bend
from game.scenes.skeletons.view import (
    bone_tokens,
    draw_bones,
    draw_limits,
    draw_outlines,
    draw_pen,
    draw_weights,
)
from game.stage import Equation, Hint, Readout, SceneAction, Strip, Toggle, WarmUp, blend_angles

Array = NDArray[np.float64]
ROUNDING = 1e-13  # of the farthest coordinate: blends that differ by less agree


class SkinningState(NamedTuple):
    """Angles (n,) rad and shift (2,) m in a row, time (1,) s, and the figure if it is not the level's."""

    pose: Array
    clock: Array
    figure: NDArray[np.uint8]


class Skinning(FigureScene):
    """A skeleton of bones, each with a place, an angle and a length, and a skin around it. Take a bone and
    turn it: its children come along, by products of 3 x 3 matrices, and so does the skin, each point by the
    bones near it.

    Weights come from the distance to all bones, none beyond the threshold; a point beyond every threshold
    follows the nearest bone. Blending matrices is quick and loses area at a bend, by the cosine of half the
    bend in the middle of a joint; blending rotors keeps the thickness and bulges a little.

    Make your own: New bone, click the parent, then where the bone is to end; Skin, click around the bones.
    """

    name, task, title = C02.names
    study = skinning_study

    compare = Toggle(False, group="Shown", label="The other blend", help="as a dashed outline")

    strips = (
        Strip("Area kept", "%", BLENDS),
        Strip("Blends apart", "m", ("apart",)),
        Strip("Time of the skin", "s", ("linear time", "rotor time")),
    )
    figure = staticmethod(draw_bend)
    equations = (
        Equation("Forward kinematics", r"W_i = W_{p(i)} T(o_i) R(\theta_i)", "3 × 3 matrices on (x, y, 1)"),
        Equation("Palette", r"P_i = W_i B_i^{-1}", "B: the frames when the skin was bound"),
        Equation("Linear", r"\v{v}' = \sum_i w_i P_i \v{v}", "Magnenat-Thalmann and others 1988"),
        Equation("Weights", r"w_i \propto (d_{min} / d_i)^p - (d_{min} / r)^p", "0 beyond the threshold r"),
        Equation("Collapse", r"\frac{1}{2}(1 + R(a)) = \cos(a/2) R(a/2)", "halves at a bend a"),
        Equation(
            "Rotors",
            r"\v{v}' = p^2 \v{v} + 2 q p,  p = e^{i\theta/2}, q = t p^* / 2",
            "Matsuda and others 2014",
        ),
    )
    try_this = (
        "Turn a knee or an elbow far: the strip shows the area that matrices lose; switch to rotors.",
        "Show the weights and click a bone: amber is what follows it.",
        "Set influences to 1: the skin breaks into rigid parts.",
        "Lower the threshold until the skin follows the nearest bone alone.",
        "Open the bent bar: the collapse against cos(a/2).",
    )
    hints = (
        Hint(("Drag",), "turn a bone"),
        Hint(("1", "2", "3"), "turn, bone, skin"),
        Hint(("W",), "weights"),
        Hint(("M",), "motion"),
        Hint(("Ctrl+Z",), "take back"),
    )
    actions = (
        SceneAction("pose", "turn a bone", "1"),
        SceneAction("bone", "new bone", "2"),
        SceneAction("skin", "draw a skin", "3"),
        *EDITING,
        SceneAction("show-weights", "weights", "w"),
    )

    def refresh(self) -> None:
        self.skin_areas = dict.fromkeys(BLENDS, 1.0)
        self.apart = 0.0

    def state(self) -> SkinningState:
        return SkinningState(self.rig.now, np.array([self.time]), self.document())

    def restore(self, state: SkinningState) -> None:
        self.restore_document(state.figure)
        self.take_pose(state.pose)
        self.time = float(state.clock[0])

    def action(self, name: str) -> None:
        if name == "show-weights":
            self.values["weights"] = not self.weights
        else:
            super().action(name)

    def advance(self, dt: float) -> None:
        self.time += dt
        if self.motion:
            pose = self.rig.swung(self.time)
            if JOINT_LIMITS in self.active:
                np.clip(pose[:-2], self.rig.skeleton.lower, self.rig.skeleton.upper, out=pose[:-2])
            self.take_pose(pose)
        if SKINNING in self.active:
            self._measure()

    def _measure(self) -> None:
        """Move the skin by both blends, the chosen one last."""
        rig = self.rig
        if rig.skinner is None:
            return
        whole = float(np.abs(rig.areas).sum())
        last = rig.skinned
        for blend in sorted(BLENDS, key=lambda b: b == self.blend):
            with self.watch.time(blend):
                rig.move(blend)
            self.skin_areas[blend] = float(np.abs(rig.areas_now()).sum()) / whole if whole > 0.0 else 1.0
            if blend != self.blend:
                last = rig.skinned.copy()
        off = rig.skinned - last
        apart = math.sqrt(float((off * off).sum(axis=1).max(initial=0.0)))
        self.apart = apart if apart > ROUNDING * float(np.abs(last).max(initial=0.0)) else 0.0

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        rig = self.rig
        return [
            Readout("bones", rig.skeleton.count),
            Readout("points", len(rig.skinned)),
            Readout("area kept", 100.0 * self.skin_areas[self.blend], "%"),
            Readout("skin", self.watch.median(self.blend), "s"),
            Readout("linear", 100.0 * self.skin_areas["linear"], "%"),
            Readout("rotor", 100.0 * self.skin_areas["rotor"], "%"),
            Readout("apart", self.apart, "m"),
            Readout("linear time", self.watch.median("linear"), "s"),
            Readout("rotor time", self.watch.median("rotor"), "s"),
        ]

    def standing(self) -> dict[str, float]:
        """bend: of the joint that is bent most, ° from where it was bound."""
        bends = np.degrees(self.rig.skeleton.angles - self.rig.rest)[self.rig.skeleton.parents >= 0]
        return {"bend": float(np.abs((bends + 180.0) % 360.0 - 180.0).max(initial=0.0))}

    def legend(self) -> Sequence[tuple[str, str, str]]:
        rows = []
        if self.bones:
            rows.append(("diamond:text1", "bones", str(self.rig.skeleton.count)))
        if self.weights and self.bench.chosen != NOWHERE:
            name = self.bench.figure.bones[self.bench.chosen].name
            rows.append(("scale:grid2:amber", f"weight of {name}", "0 1"))
        elif self.weights:
            rows.append(("disc:green", "points in the colours of their bones", ""))
        if self.compare:
            other = "rotors" if self.blend == "linear" else "matrices"
            rows.append(("dash:text1", f"blend of {other}", ""))
        if self.bench.chosen != NOWHERE and not self.weights:
            rows.append(("diamond:amber", self.bench.figure.bones[self.bench.chosen].name, ""))
        return rows

    def draw(self, canvas: Any, alpha: float) -> None:
        rig, bench = self.rig, self.bench
        pose = rig.now
        if self.previous is not None and self.previous.pose.shape == pose.shape:
            before = self.previous.pose
            pose = np.concatenate(
                [blend_angles(before[:-2], pose[:-2], alpha), before[-2:] + alpha * (pose[-2:] - before[-2:])]
            )
        points = rig.show(pose, self.blend)
        if SKINNING not in self.active:
            points = rig.binding.points if rig.binding is not None else points
        canvas.grid(None, "y")
        if bench.figure.ground is not None:
            canvas.ground(bench.figure.ground)
        if self.skins:
            self.painter.paint(canvas, rig, points, 0.35 if self.weights else 1.0)
        if self.weights:
            draw_weights(canvas, rig, points, bench.chosen)
        if self.compare and SKINNING in self.active:
            other = BLENDS[1 - BLENDS.index(self.blend)]
            draw_outlines(canvas, rig, rig.skin_shown(other), "text1")
        if bench.chosen != NOWHERE and JOINT_LIMITS in self.active and self.tool == "pose":
            draw_limits(canvas, rig.shown, WHOLE, bench.chosen)
        if self.bones:
            tokens = bone_tokens(rig.shown.count, bench.chosen, self.weights)
            draw_bones(canvas, rig.shown.bases, rig.shown.ends, [token or "text1" for token in tokens])
        if self.tool == "bone" and bench.chosen != NOWHERE:
            canvas.line(rig.shown.ends[bench.chosen], bench.pointer, "accent", 1.6, dash=(8.0, 6.0))
        draw_pen(canvas, bench.drawn, bench.pointer, WHOLE)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        return (*warm_ups_of_figures(), WarmUp(cls.title, lambda: cls().advance(cls.dt)))
