"""How C02 is drawn: the figure between two steps, its weights, the other blend, what is being made."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.animation import BLENDS, JOINT_LIMITS, SKINNING
from game.physics.animation.skeleton_editing import NOWHERE
from game.scenes.skeletons.cells import WHOLE
from game.scenes.skeletons.editing import joint_of, next_click
from game.scenes.skeletons.skinning_model import SkinningModel, SkinningState
from game.scenes.skeletons.view.parts import (
    bone_tokens,
    draw_bones,
    draw_limits,
    draw_next_click,
    draw_outlines,
    draw_pen,
    draw_weights,
)
from game.scenes.skeletons.view.point_weights import draw_point_weights
from game.scenes.skeletons.view.skin_painter import SkinPainter
from game.stage import blend_angles
from game.ui.canvas.canvas import Canvas


class SkinningView:
    """Draws the model; keeps the colours of its skins."""

    def __init__(self, model: SkinningModel) -> None:
        self._model, self._shown = model, model.parameters
        self._painter = SkinPainter()

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """What the marks mean."""
        model, shown, bench = self._model, self._shown, self._model.bench
        rows = []
        if shown.bones:
            rows.append(("diamond:text1", "bones", str(model.rig.skeleton.count)))
        if shown.weights and bench.chosen != NOWHERE:
            name = bench.figure.bones[bench.chosen].name
            rows.append(("scale:grid2:amber", f"weight of {name}", "0 1"))
        elif shown.weights:
            rows.append(("disc:green", "points in the colours of their bones", ""))
        if shown.compare:
            other = "rotors" if shown.blend == "linear" else "matrices"
            rows.append(("dash:text1", f"blend of {other}", ""))
        if bench.chosen != NOWHERE and not shown.weights:
            rows.append(("diamond:amber", bench.figure.bones[bench.chosen].name, ""))
        return rows

    def draw(self, canvas: Canvas, previous: SkinningState | None, alpha: float) -> None:
        """All of it, ``alpha`` from the state before the last step to now."""
        model, shown = self._model, self._shown
        rig, bench, active = model.rig, model.bench, model.active
        points = rig.show(self._pose(previous, alpha), shown.blend)
        if SKINNING not in active:
            points = rig.binding.points if rig.binding is not None else points
        canvas.grid(None, "y")
        if bench.figure.ground is not None:
            canvas.ground(bench.figure.ground)
        if shown.skins:
            self._painter.paint(canvas, rig, points, 0.35 if shown.weights else 1.0)
        if shown.weights:
            draw_weights(canvas, rig, points, bench.chosen)
        if shown.weights and shown.tool == "pose" and not bench.held:
            draw_point_weights(canvas, rig, points, bench.pointer)
        if shown.compare and SKINNING in active:
            other = BLENDS[1 - BLENDS.index(shown.blend)]
            draw_outlines(canvas, rig, rig.skin_shown(other), "text1")
        if bench.chosen != NOWHERE and JOINT_LIMITS in active and shown.tool == "pose":
            draw_limits(canvas, rig.shown, WHOLE, bench.chosen)
        if shown.bones:
            tokens = bone_tokens(rig.shown.count, bench.chosen, shown.weights)
            draw_bones(canvas, rig.shown.bases, rig.shown.ends, [token or "text1" for token in tokens])
        if shown.tool == "bone" and bench.chosen != NOWHERE:
            canvas.line(joint_of(bench, rig.shown), bench.pointer, "accent", 1.6, dash=(8.0, 6.0))
        draw_pen(canvas, bench.drawn, bench.pointer, WHOLE)
        draw_next_click(canvas, next_click(bench, shown.tool), bench.pointer, WHOLE)

    def _pose(self, previous: SkinningState | None, alpha: float) -> Floats:
        """The pose (n + 2,) between the last two steps."""
        pose = self._model.rig.now
        if previous is None or previous.pose.shape != pose.shape:
            return pose
        before = previous.pose
        return np.concatenate(
            [blend_angles(before[:-2], pose[:-2], alpha), before[-2:] + alpha * (pose[-2:] - before[-2:])]
        )
