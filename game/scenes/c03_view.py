"""How the six methods are drawn side by side: a figure each, with its name, numbers and recent errors."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.animation import JOINT_LIMITS, SKINNING
from game.physics.animation.skeleton_editing import NOWHERE
from game.scenes.figure_cells import Cell
from game.scenes.figure_level import FigureContent
from game.scenes.figure_view import bone_tokens, draw_bones, draw_limits, draw_pen, draw_weights
from game.stage import Frame, blend_angles
from game.ui.canvas import EXACT_DASH, Canvas
from game.ui.curves import thinned
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


class Words(NamedTuple):
    """What stands beside a figure, kept for a quarter of a second."""

    error: str
    work: str


class ChainView:
    """Draws the figures of all methods."""

    def __init__(self) -> None:
        self._words: list[Words] = []
        self._quarter = -1
        self._curves: tuple[Array, float] = (np.zeros((len(TITLES), 1, 2)), 0.0)

    def draw(self, scene: InverseKinematics, canvas: Canvas, alpha: float) -> None:
        """All of it: figures, bones of all figures, words."""
        cells = cells_of(scene.bench.figure, scene.compare, scene.master)
        frame = scene.frame()
        if scene.compare:
            self._draw_lines(canvas, frame)
        shown = range(len(TITLES)) if scene.compare else (scene.master,)
        poses = self._poses(scene, alpha)
        bases, ends = [], []
        for k in shown:
            self._draw_body(scene, canvas, k, cells[k], poses[k])
            bases.append(cells[k].out(scene.rig.shown.bases))
            ends.append(cells[k].out(scene.rig.shown.ends))
        if scene.bones:
            self._draw_bones(scene, canvas, list(shown), np.concatenate(bases), np.concatenate(ends))
        self._refresh(scene)
        if scene.solver is not None:
            self._curves = self._trails(scene, canvas)
        for n, k in enumerate(shown):
            if scene.solver is not None:
                self._draw_target(scene, canvas, cells[k], ends[n][scene.inside[-1]])
            self._draw_words(scene, canvas, k, frame)
        self._draw_hand(scene, canvas, cells[scene.master], ends[list(shown).index(scene.master)])

    def _draw_bones(
        self, scene: InverseKinematics, canvas: Canvas, shown: list[int], bases: Array, ends: Array
    ) -> None:
        tokens: list[str] = []
        inside = frozenset(scene.inside.tolist())
        for k in shown:
            chosen = scene.bench.chosen if k == scene.master and scene.tool != "pull" else NOWHERE
            tokens += bone_tokens(scene.rig.shown.count, chosen, scene.weights, inside)
        draw_bones(canvas, bases, ends, tokens)

    def _draw_hand(self, scene: InverseKinematics, canvas: Canvas, cell: Cell, ends: Array) -> None:
        """What is being made by hand."""
        bench = scene.bench
        if scene.tool == "bone" and bench.chosen != NOWHERE:
            pointer = cell.out(np.array([bench.pointer]))[0]
            canvas.line(ends[bench.chosen], pointer, "accent", 1.6, dash=(8.0, 6.0))
        draw_pen(canvas, bench.drawn, bench.pointer, cell)

    def _draw_lines(self, canvas: Canvas, frame: Frame) -> None:
        for column in range(1, COLUMNS):
            x = frame.right * column / COLUMNS
            canvas.line((x, 0.0), (x, frame.top), "line", 1.0)
        canvas.line((0.0, frame.top / ROWS), (frame.right, frame.top / ROWS), "line", 1.0)

    def _poses(self, scene: InverseKinematics, alpha: float) -> Array:
        """Poses (6, n + 2) of all methods between the last two steps."""
        now, before = scene.methods, scene.previous
        if before is None or before.poses.shape != now.shape:
            return now
        poses = blend_angles(before.poses, now, alpha)
        poses[:, -2:] = before.poses[:, -2:] + alpha * (now[:, -2:] - before.poses[:, -2:])
        return poses

    def _draw_body(self, scene: InverseKinematics, canvas: Canvas, k: int, cell: Cell, pose: Array) -> None:
        """Skins, and what lies below the bones; ``rig.shown`` is posed so."""
        rig, bench, mine = scene.rig, scene.bench, k == scene.master
        figure, view = bench.figure, bench.figure.view
        few = scene.compare and not scene.weights
        points = rig.show_few(pose, scene.blend) if few else rig.show(pose, scene.blend)
        if figure.ground is not None:
            ends = cell.out(np.array([(view.left, figure.ground), (view.right, figure.ground)]))
            canvas.line(ends[0], ends[1], "line2", 1.0)
        if scene.circles and mine:
            self._draw_reach(scene, canvas, cell)
        if SKINNING in scene.active:
            if scene.skins:
                strength = 0.35 if scene.weights else 1.0
                scene.painter.paint(canvas, rig, points, strength, not few, cell)
            if scene.weights:
                draw_weights(canvas, rig, cell.out(points), bench.chosen)
        if mine and bench.chosen != NOWHERE and JOINT_LIMITS in scene.active and scene.tool == "pose":
            draw_limits(canvas, rig.shown, cell, bench.chosen)

    def _draw_reach(self, scene: InverseKinematics, canvas: Canvas, cell: Cell) -> None:
        if scene.solver is None:
            return
        first = int(scene.inside[0])
        root = cell.out(scene.rig.shown.bases[first : first + 1])[0]
        reach, hole = scene.solver.chain.reach, scene.solver.chain.hole
        canvas.circle(root, reach * cell.scale, outline="line2", width=1.0, dash=EXACT_DASH, alpha=0.8)
        if hole > 0.0:
            canvas.circle(root, hole * cell.scale, outline="line2", width=1.0, dash=EXACT_DASH, alpha=0.8)

    def _draw_target(self, scene: InverseKinematics, canvas: Canvas, cell: Cell, end: Array) -> None:
        place = cell.out(scene.target[None])[0]
        if math.dist(place, end) > canvas.px(9.0):
            canvas.line(end, place, "amber", 1.2, dash=(4.0, 4.0))
        canvas.dot(place, 3.0, "amber")
        canvas.ring(place, 8.0, "amber", 1.8)

    # -- words --------------------------------------------------------------------------------------

    def _refresh(self, scene: InverseKinematics) -> None:
        """Numbers anew, four times a second: quicker ones cannot be read."""
        quarter = math.floor(4.0 * scene.time)
        if quarter == self._quarter and self._words:
            return
        self._quarter, self._words = quarter, []
        for k, found in enumerate(scene.measured):
            error = " ".join(quantity(found.error, "m"))
            seconds = " ".join(quantity(scene.watch.median(scene.shown_methods[k]), "s"))
            times = "iteration" if found.iterations == 1 else "iterations"
            self._words.append(Words(error, f"{found.iterations} {times}, {seconds}"))

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
        words = self._words[k]
        canvas.label((x, y - canvas.px(20.0)), words.error, "text1", 12, "semibold", "topleft")
        canvas.label((x, y - canvas.px(36.0)), words.work, "text2", 11, anchor="topleft")
        self._draw_trail(canvas, k, (x, y - canvas.px(56.0)))

    def _trails(self, scene: InverseKinematics, canvas: Canvas) -> tuple[Array, float]:
        """Errors of the last steps (6, TRAIL, 2), logarithmic from the reach down, and the tolerance."""
        assert scene.solver is not None
        wide, high = canvas.px(104.0), canvas.px(30.0)
        share = 1.0 / scene.solver.chain.reach
        places = np.empty((*scene.trail.shape, 2))
        places[:, :, 0] = np.linspace(0.0, wide, scene.trail.shape[1])
        places[:, :, 1] = np.log10(np.maximum(scene.trail * share, 1e-300))
        places[:, :, 1] = high / DECADES * np.clip(places[:, :, 1], -DECADES, 0.0)
        level = high / DECADES * min(max(math.log10(scene.tolerance * share), -DECADES), 0.0)
        return places, level

    def _draw_trail(self, canvas: Canvas, k: int, corner: tuple[float, float]) -> None:
        """Recent errors of a method; the tolerance dashed."""
        places, level = self._curves
        x, y = corner
        right = x + float(places[k, -1, 0])
        canvas.line((x, y + level), (right, y + level), "text3", 1.0, dash=(3.0, 3.0), alpha=0.7)
        line = thinned(places[k] + corner, canvas.px(0.2))
        canvas.polyline(line, COLORS[k], 1.5)
        canvas.dot(line[-1], 2.2, COLORS[k])
