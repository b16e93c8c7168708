"""How the six methods are drawn side by side: a figure each, with its name, numbers and recent errors."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pygame

from game.arrays import Floats
from game.physics.animation import JOINT_LIMITS, SKINNING
from game.physics.animation.skeleton_editing import NOWHERE
from game.scenes.skeletons.cells import COLUMNS, ROWS, Cell, cells_of, frame_of_cells
from game.scenes.skeletons.editing import next_click
from game.scenes.skeletons.parameters import SHOWN
from game.scenes.skeletons.reaching_model import ReachingModel, ReachingState
from game.scenes.skeletons.view.jacobian import draw_jacobian
from game.scenes.skeletons.view.parts import (
    bone_tokens,
    draw_bones,
    draw_limits,
    draw_next_click,
    draw_pen,
    draw_weights,
)
from game.scenes.skeletons.view.skin_painter import SkinPainter
from game.stage import Frame, blend_angles
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.ui.look.numerals import quantity
from game.ui.look.shapes import draw_disc
from game.ui.raster.curves import thinned

TITLES = ("Gradient", "Buss step", "Armijo", "Damped least squares", "CCD", "FABRIK")
COLORS = ("chalk", "green", "pink", "violet", "yellow", "vermilion")  # as the charts have them
DECADES = 8.0  # of the small chart, below the reach
TRAIL_DOWN, TRAIL_WIDE, TRAIL_HIGH = 72.0, 84.0, 30.0  # design px: where the small chart is, its size
CARD_WIDE, CARD_HIGH, MOST_CARDS = 180.0, 139.0, 64


class Words(NamedTuple):
    """What stands beside a figure."""

    error: str
    work: str
    seconds: str
    why: str  # it does not come to its target


class ChainView:
    """Draws the figures of all methods. words: what stands beside each."""

    def __init__(self, model: ReachingModel) -> None:
        self._model, self._shown = model, model.parameters
        self._painter = SkinPainter()
        self.words = [Words("", "", "", "")] * len(TITLES)
        self._measured = False
        self._cards: dict[tuple[Any, ...], pygame.Surface] = {}
        self._curves: tuple[Floats, float] = (np.zeros((len(TITLES), 1, 2)), 0.0)

    def draw(self, canvas: Canvas, previous: ReachingState | None, alpha: float) -> None:
        """All of it: figures, bones of all figures, words."""
        model, view = self._model, self._model.bench.figure.view
        compare, master = self._shown.compare, self._shown.master
        cells, frame = cells_of(view, compare), frame_of_cells(view)
        if compare:
            self._draw_lines(canvas, frame)
        places = list(range(len(TITLES))) if compare else [master]
        poses = self._poses(previous, alpha)
        bases, ends = [], []
        for k in places:
            self._draw_body(canvas, k, cells[k], poses[k])
            bases.append(cells[k].out(model.rig.shown.bases))
            ends.append(cells[k].out(model.rig.shown.ends))
        if self._shown.bones:
            self._draw_bones(canvas, places, np.concatenate(bases), np.concatenate(ends))
        self._refresh(canvas.fresh)
        if model.solver is not None:
            self._curves = self._trails(canvas)
        for n, k in enumerate(places):
            if model.solver is not None:
                self._draw_target(canvas, cells[k], ends[n][model.inside[-1]])
                if self._shown.jacobian and k == master:
                    self._draw_jacobian(canvas, cells[k], bases[n], ends[n])
            self._draw_words(canvas, k, frame)
        mine = places.index(master)
        self._draw_hand(canvas, cells[master], bases[mine], ends[mine])

    def _draw_jacobian(self, canvas: Canvas, cell: Cell, bases: Floats, ends: Floats) -> None:
        inside = self._model.inside
        target = cell.out(self._model.target[None])[0]
        draw_jacobian(canvas, bases[inside], ends[inside[-1]], target)

    def _draw_bones(self, canvas: Canvas, places: list[int], bases: Floats, ends: Floats) -> None:
        """Bones of the figures of these methods, all in one call."""
        model, shown = self._model, self._shown
        tokens: list[str] = []
        inside = frozenset(model.inside.tolist())
        for k in places:
            mine = k == shown.master and shown.tool != "pull"
            chosen = model.bench.chosen if mine else NOWHERE
            tokens += bone_tokens(model.rig.shown.count, chosen, shown.weights, inside)
        draw_bones(canvas, bases, ends, tokens)

    def _draw_hand(self, canvas: Canvas, cell: Cell, bases: Floats, ends: Floats) -> None:
        """What is being made by hand."""
        bench = self._model.bench
        if self._shown.tool == "bone" and bench.chosen != NOWHERE:
            pointer = cell.out(np.array([bench.pointer]))[0]
            length = float(self._model.rig.skeleton.lengths[bench.chosen])
            part = 1.0 if bench.socket is None or length == 0.0 else bench.socket / length
            start = bases[bench.chosen] + part * (ends[bench.chosen] - bases[bench.chosen])
            canvas.line(start, pointer, "accent", 1.6, dash=(8.0, 6.0))
        draw_pen(canvas, bench.drawn, bench.pointer, cell)
        draw_next_click(canvas, next_click(bench, self._shown.tool), bench.pointer, cell)

    def _draw_lines(self, canvas: Canvas, frame: Frame) -> None:
        for column in range(1, COLUMNS):
            x = frame.right * column / COLUMNS
            canvas.line((x, 0.0), (x, frame.top), "line", 1.0)
        canvas.line((0.0, frame.top / ROWS), (frame.right, frame.top / ROWS), "line", 1.0)

    def _poses(self, previous: ReachingState | None, alpha: float) -> Floats:
        """Poses (6, n + 2) of all methods between the last two steps."""
        now, before = self._model.methods, previous
        if before is None or before.poses.shape != now.shape:
            return now
        poses = blend_angles(before.poses, now, alpha)
        poses[:, -2:] = before.poses[:, -2:] + alpha * (now[:, -2:] - before.poses[:, -2:])
        return poses

    def _draw_body(self, canvas: Canvas, k: int, cell: Cell, pose: Floats) -> None:
        """Skins, and what lies below the bones; ``rig.shown`` is posed so."""
        model, shown = self._model, self._shown
        rig, bench, mine = model.rig, model.bench, k == shown.master
        figure, view = bench.figure, bench.figure.view
        few = shown.compare and not shown.weights
        points = rig.show_few(pose, shown.blend) if few else rig.show(pose, shown.blend)
        if figure.ground is not None:
            ends = cell.out(np.array([(view.left, figure.ground), (view.right, figure.ground)]))
            canvas.line(ends[0], ends[1], "line2", 1.0)
        if shown.circles and mine:
            self._draw_reach(canvas, cell)
        if SKINNING in model.active:
            if shown.skins:
                strength = 0.35 if shown.weights else 1.0
                self._painter.paint(canvas, rig, points, strength, not few, cell)
            if shown.weights:
                draw_weights(canvas, rig, cell.out(points), bench.chosen)
        turning = shown.tool == "pose" and JOINT_LIMITS in model.active
        if mine and turning and bench.chosen != NOWHERE:
            draw_limits(canvas, rig.shown, cell, bench.chosen)

    def _draw_reach(self, canvas: Canvas, cell: Cell) -> None:
        if self._model.solver is None:
            return
        first = int(self._model.inside[0])
        root = cell.out(self._model.rig.shown.bases[first : first + 1])[0]
        reach, hole = self._model.solver.chain.reach, self._model.solver.chain.hole
        canvas.circle(root, reach * cell.scale, outline="line2", width=1.0, dash=EXACT_DASH, alpha=0.8)
        if hole > 0.0:
            canvas.circle(root, hole * cell.scale, outline="line2", width=1.0, dash=EXACT_DASH, alpha=0.8)

    def _draw_target(self, canvas: Canvas, cell: Cell, end: Floats) -> None:
        place = cell.out(self._model.target[None])[0]
        if math.dist(place, end) > canvas.px(9.0):
            canvas.line(end, place, "amber", 1.2, dash=(4.0, 4.0))
        canvas.dot(place, 3.0, "amber")
        canvas.ring(place, 8.0, "amber", 1.8)

    # -- words --------------------------------------------------------------------------------------

    def _refresh(self, fresh: bool) -> None:
        """New numbers, in the pictures in which all numbers of the window change."""
        if not fresh and self._measured:
            return
        self._measured = True
        for k, found in enumerate(self._model.measured):
            seconds = " ".join(quantity(self._model.watch.median(SHOWN[k]), "s"))
            times = "iteration" if found.iterations == 1 else "iterations"
            error = " ".join(quantity(found.error, "m"))
            why = self._model.hindrance(k)
            self.words[k] = Words(error, f"{found.iterations} {times}", seconds, why)

    def _draw_words(self, canvas: Canvas, k: int, frame: Frame) -> None:
        """Name, what it took, and the errors of the last steps, at the top left of a figure's place."""
        if not canvas.words:
            return
        column, row = (k % COLUMNS, k // COLUMNS) if self._shown.compare else (0, 0)
        x = frame.right * column / COLUMNS + canvas.px(10.0)
        y = frame.top * (ROWS - row) / ROWS - canvas.px(8.0)
        mine = k == self._shown.master
        title = TITLES[k] if self._shown.adaptive or k != 3 else "Damped, fixed"
        words = self.words[k] if self._model.solver is not None else None
        canvas.blit(self._card(canvas, k, title, mine, words), (x, y), "topleft")
        if words is not None:
            self._draw_trail(canvas, k, (x, y - canvas.px(TRAIL_DOWN)))

    def _card(self, canvas: Canvas, k: int, title: str, mine: bool, words: Words | None) -> pygame.Surface:
        """A picture of the words, and of the tolerance under the errors; kept while it holds."""
        level = self._curves[1] / canvas.px(1.0) if words is not None else 0.0
        key = (canvas.theme.name, canvas.k, k, title, mine, words, round(level, 3))
        found = self._cards.get(key)
        if found is None:
            if len(self._cards) >= MOST_CARDS:
                self._cards.clear()
            found = self._cards[key] = _paint_card(canvas, COLORS[k], title, mine, words, level)
        return found

    def _trails(self, canvas: Canvas) -> tuple[Floats, float]:
        """Errors of the last steps (6, TRAIL, 2), logarithmic from the reach down, and the tolerance."""
        assert self._model.solver is not None
        wide, high = canvas.px(TRAIL_WIDE), canvas.px(TRAIL_HIGH)
        share = 1.0 / self._model.solver.chain.reach
        places = np.empty((*self._model.trail.shape, 2))
        places[:, :, 0] = np.linspace(0.0, wide, self._model.trail.shape[1])
        places[:, :, 1] = np.log10(np.maximum(self._model.trail * share, 1e-300))
        places[:, :, 1] = high / DECADES * np.clip(places[:, :, 1], -DECADES, 0.0)
        level = high / DECADES * min(max(math.log10(self._shown.tolerance * share), -DECADES), 0.0)
        return places, level

    def _draw_trail(self, canvas: Canvas, k: int, corner: tuple[float, float]) -> None:
        """Recent errors of a method."""
        line = thinned(self._curves[0][k] + corner, canvas.px(0.2))
        canvas.polyline(line, COLORS[k], 1.5)
        canvas.dot(line[-1], 2.2, COLORS[k])


def _paint_card(
    canvas: Canvas, color: str, title: str, mine: bool, words: Words | None, level: float
) -> pygame.Surface:
    """Name, error, work, time and what hinders it below each other. The tolerance dashed, ``level`` design px
    from the top of the errors, and named beside the chosen figure.
    """
    fonts, k = canvas.fonts, canvas.k
    card = pygame.Surface((round(CARD_WIDE * k), round(CARD_HIGH * k)), pygame.SRCALPHA, 32)
    card.fill((*canvas.halo[:3], 0))
    draw_disc(card, (4.0 * k, 8.0 * k), 4.0 * k, canvas.color(color))
    rows = [(14.0, 0.0, title, 13, "semibold", "accent" if mine else "text1")]
    if words is None:
        rows.append((0.0, 20.0, "pick a chain", 12, "medium", "text3"))
    else:
        rows.append((0.0, 20.0, words.error, 12, "semibold", "text1"))
        rows.append((0.0, 36.0, words.work, 11, "medium", "text2"))
        rows.append((0.0, 50.0, words.seconds, 11, "medium", "text2"))
        at, foot = TRAIL_DOWN - level, TRAIL_DOWN + TRAIL_HIGH + 2.0
        if words.why:
            rows.append((0.0, foot, words.why, 11, "semibold", "amber"))
            foot += 15.0
        if mine:
            rows.append((0.0, foot, "dashed: tolerance", 11, "medium", "text3"))
        for dash in range(0, int(TRAIL_WIDE), 6):
            card.fill(
                canvas.color("text3"), (round(dash * k), round(at * k), round(3.0 * k), max(round(k), 1))
            )
    for x, y, text, size, weight, token in rows:
        ink = canvas.look.color(token, words=True)
        card.blit(fonts.render_on_halo(text, size, weight, ink, canvas.halo), (round(x * k), round(y * k)))
    return card
