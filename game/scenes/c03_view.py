"""How the six methods are drawn side by side: a figure each, with its name, numbers and recent errors."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game.physics.animation import JOINT_LIMITS, SKINNING
from game.physics.animation.skeleton_editing import NOWHERE
from game.scenes.figure_level import FigureContent
from game.scenes.figure_view import Cell, draw_bones, draw_limits, draw_pen, draw_skins, draw_weights
from game.stage import Frame, blend_angles
from game.ui.canvas import EXACT_DASH, Canvas
from game.ui.numerals import quantity

if TYPE_CHECKING:
    from game.scenes.c03_inverse_kinematics import InverseKinematics

Array = NDArray[np.float64]
COLUMNS, ROWS = 3, 2
TITLES = ("Gradient", "Buss step", "Armijo", "Damped least squares", "CCD", "FABRIK")
COLORS = ("chalk", "green", "pink", "violet", "yellow", "vermilion")  # as the charts have them
DECADES = 8.0  # of the small chart, below the reach


def cells_of(figure: FigureContent, compare: bool, chosen: int) -> list[Cell]:
    """Where each method's figure stands; without comparison the chosen one, twice as large, in the middle."""
    view = figure.view
    wide, high = view.right - view.left, view.top - view.bottom
    if not compare:
        return [Cell(0.5 * wide - 2.0 * view.left, -2.0 * view.bottom, 2.0)] * (COLUMNS * ROWS)
    return [
        Cell(column * wide - view.left, (ROWS - 1 - row) * high - view.bottom)
        for row in range(ROWS)
        for column in range(COLUMNS)
    ]


def cell_at(x: float, y: float, frame: Frame) -> int:
    """Which method's figure is at a place of the picture."""
    column = math.floor(COLUMNS * x / frame.right)
    row = ROWS - 1 - math.floor(ROWS * y / frame.top)
    return min(max(row, 0), ROWS - 1) * COLUMNS + min(max(column, 0), COLUMNS - 1)


class ChainView:
    """Draws the figures of all methods."""

    def draw(self, scene: InverseKinematics, canvas: Canvas, alpha: float) -> None:
        """All of it, figure by figure."""
        cells = cells_of(scene.bench.figure, scene.compare, scene.master)
        frame = scene.frame()
        if scene.compare:
            self._draw_lines(canvas, frame)
        for k in range(len(TITLES)) if scene.compare else (scene.master,):
            self._draw_figure(scene, canvas, k, cells[k], alpha)
            self._draw_words(scene, canvas, k, frame)

    def _draw_lines(self, canvas: Canvas, frame: Frame) -> None:
        for column in range(1, COLUMNS):
            x = frame.right * column / COLUMNS
            canvas.line((x, 0.0), (x, frame.top), "line", 1.0)
        canvas.line((0.0, frame.top / ROWS), (frame.right, frame.top / ROWS), "line", 1.0)

    def _pose(self, scene: InverseKinematics, k: int, alpha: float) -> Array:
        now, before = scene.methods[k], scene.previous
        if before is None or before.poses.shape != scene.methods.shape:
            return now
        old = before.poses[k]
        return np.concatenate(
            [blend_angles(old[:-2], now[:-2], alpha), old[-2:] + alpha * (now[-2:] - old[-2:])]
        )

    def _draw_figure(
        self, scene: InverseKinematics, canvas: Canvas, k: int, cell: Cell, alpha: float
    ) -> None:
        rig, bench, mine = scene.rig, scene.bench, k == scene.master
        figure, view = bench.figure, bench.figure.view
        points = rig.show(self._pose(scene, k, alpha), scene.blend)
        if figure.ground is not None:
            ends = cell.out(np.array([(view.left, figure.ground), (view.right, figure.ground)]))
            canvas.line(ends[0], ends[1], "line2", 1.0)
        if scene.circles and mine:
            self._draw_reach(scene, canvas, cell)
        if scene.skins and SKINNING in scene.active:
            draw_skins(canvas, rig, points, cell, 0.35 if scene.weights else 1.0)
        if scene.weights and SKINNING in scene.active:
            draw_weights(canvas, rig, points, cell, bench.chosen)
        if mine and bench.chosen != NOWHERE and JOINT_LIMITS in scene.active and scene.tool == "pose":
            draw_limits(canvas, rig.shown, cell, bench.chosen)
        if scene.bones:
            chosen = bench.chosen if mine and scene.tool != "pull" else NOWHERE
            draw_bones(canvas, rig.shown, cell, chosen, scene.weights, frozenset(scene.inside.tolist()), 0.4)
        if mine:
            if scene.tool == "bone" and bench.chosen != NOWHERE:
                ends = cell.out(np.array([rig.shown.ends[bench.chosen], bench.pointer]))
                canvas.line(ends[0], ends[1], "accent", 1.6, dash=(8.0, 6.0))
            draw_pen(canvas, bench.drawn, bench.pointer, cell)
        if scene.solver is not None:
            self._draw_target(scene, canvas, cell)

    def _draw_reach(self, scene: InverseKinematics, canvas: Canvas, cell: Cell) -> None:
        if scene.solver is None:
            return
        first = int(scene.inside[0])
        root = cell.out(scene.rig.shown.bases[first : first + 1])[0]
        reach, hole = scene.solver.chain.reach, scene.solver.chain.hole
        canvas.circle(root, reach * cell.scale, outline="line2", width=1.0, dash=EXACT_DASH, alpha=0.8)
        if hole > 0.0:
            canvas.circle(root, hole * cell.scale, outline="line2", width=1.0, dash=EXACT_DASH, alpha=0.8)

    def _draw_target(self, scene: InverseKinematics, canvas: Canvas, cell: Cell) -> None:
        place = cell.out(np.array([scene.target]))[0]
        last = int(scene.inside[-1])
        end = cell.out(scene.rig.shown.ends[last : last + 1])[0]
        if math.dist(place, end) > canvas.px(9.0):
            canvas.line(end, place, "amber", 1.2, dash=(4.0, 4.0))
        canvas.dot(place, 3.0, "amber")
        canvas.ring(place, 8.0, "amber", 1.8)

    # -- words --------------------------------------------------------------------------------------

    def _draw_words(self, scene: InverseKinematics, canvas: Canvas, k: int, frame: Frame) -> None:
        """Name, what it took, and the errors of the last steps, at the top left of a figure's place."""
        column, row = (k % COLUMNS, k // COLUMNS) if scene.compare else (0, 0)
        x = frame.right * column / COLUMNS + canvas.px(10.0)
        y = frame.top * (ROWS - row) / ROWS - canvas.px(8.0)
        mine = k == scene.master
        title = TITLES[k] if scene.adaptive or k != 3 else "Damped, fixed"
        canvas.dot((x + canvas.px(4.0), y - canvas.px(8.0)), 4.0, COLORS[k])
        canvas.label(
            (x + canvas.px(14.0), y), title, "accent" if mine else "text1", 13, "semibold", "topleft"
        )
        if scene.solver is None:
            canvas.label((x, y - canvas.px(20.0)), "pick a chain", "text3", 12, anchor="topleft")
            return
        found = scene.measured[k]
        error, unit = quantity(found.error, "m")
        seconds, second_unit = quantity(
            scene.watch.median(("gradient", "buss", "armijo", "damped", "ccd", "fabrik")[k]), "s"
        )
        times = "iteration" if found.iterations == 1 else "iterations"
        canvas.label((x, y - canvas.px(20.0)), f"{error} {unit}", "text1", 12, "semibold", "topleft")
        canvas.label(
            (x, y - canvas.px(36.0)), f"{found.iterations} {times}, {seconds} {second_unit}", "text2", 11,
            anchor="topleft",
        )  # fmt: skip
        self._draw_trail(scene, canvas, k, x, y - canvas.px(56.0))

    def _draw_trail(self, scene: InverseKinematics, canvas: Canvas, k: int, left: float, top: float) -> None:
        """Errors of the last steps on a logarithmic scale, from the reach down; the tolerance dashed."""
        assert scene.solver is not None
        wide, high = canvas.px(104.0), canvas.px(30.0)
        reach = scene.solver.chain.reach

        def height(error: float | Array) -> Array:
            part = np.log10(np.maximum(error, 1e-300) / reach) / DECADES
            return top + high * np.clip(part, -1.0, 0.0)

        level = float(height(scene.tolerance))
        canvas.line((left, level), (left + wide, level), "text3", 1.0, dash=(3.0, 3.0), alpha=0.7)
        errors = scene.trail[k]
        x = left + wide * np.arange(len(errors)) / (len(errors) - 1)
        line = np.column_stack([x, height(errors)])
        canvas.polyline(line, COLORS[k], 1.5)
        canvas.dot(line[-1], 2.2, COLORS[k])
