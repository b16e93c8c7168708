"""How the broad-phase scenes are drawn: the world with its boxes on the right, and a column of findings."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pygame
from numpy.typing import NDArray

from game.scenes.boxes.level import HEIGHT, WIDTH
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import quantity
from game.ui.painters.boxes import HIDDEN, BoxPainter, paint_raster, shades

if TYPE_CHECKING:
    from game.scenes.boxes.base import BoxesScene

COLUMN_LEFT, COLUMN_RIGHT = -4.45, -0.5  # m, where the findings stand beside the world
COLUMN_TOP = 5.3  # m, below the legend
FREE, OVERLAPPING, IN_HAND = 0, 1, 2  # kinds of boxes
TALL = 400  # design px of a column that has room for times beside what is told of few boxes
MOST_LINES = 6_000
LEAST_CELL = 5.0  # px; smaller cells are shaded together

_boxes = BoxPainter(
    (
        ("body", 0.9, "text3", 0.75),
        ("vermilion", 0.34, "vermilion", 1.0),
        ("chalk", 0.4, "chalk", 1.0),
    )
)


def draw_ground(canvas: Canvas) -> None:
    """The world's boundary."""
    corners = np.array([(0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT)])
    canvas.polygon(corners, outline="line2", width=1.5)


def draw_boxes(scene: BoxesScene, canvas: Canvas, alpha: float) -> None:
    """All boxes: those that overlap filled and solid, the others in hairlines; lines between pairs."""
    kinds = np.where(scene.alive == 1, FREE, HIDDEN).astype(np.uint8)
    kinds[scene.pairs.ravel()] = OVERLAPPING
    if scene.held >= 0:
        kinds[scene.held] = IN_HAND
    before = scene.previous
    same = before is not None and len(before.lowers) == len(scene.lowers)
    leap = _longest_way(scene)
    _boxes.paint(
        canvas, scene.lowers, scene.uppers, kinds,
        (before.lowers, before.uppers) if same else None, alpha, leap,
    )  # fmt: skip
    if scene.lines and 0 < len(scene.pairs) <= MOST_LINES:
        _draw_lines(scene, canvas, alpha if same else 1.0, leap)
    if scene.anchor is not None:
        (x0, y0), (x1, y1) = scene.anchor, scene.reach
        canvas.polygon(
            np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]), outline="chalk", width=2.0, dash=(8.0, 6.0)
        )


def _longest_way(scene: BoxesScene) -> float:
    """What a box can move in a step, m; one that moved further has leapt and is not drawn on its way."""
    speed = max(
        float(np.abs(scene.velocities).max(initial=0.0)), float(np.abs(scene.growth).max(initial=0.0))
    )
    return 2.0 * speed * scene.step_length + 1e-9


def _draw_lines(scene: BoxesScene, canvas: Canvas, alpha: float, leap: float) -> None:
    """A line between the centres of each pair of finite boxes."""
    low, high = places_between(scene, alpha, leap)
    with np.errstate(invalid="ignore", over="ignore"):
        centers = 0.5 * (low + high)
    canvas.segments(centers[scene.pairs[:, 0]], centers[scene.pairs[:, 1]], "vermilion", 1.4)


def places_between(scene: BoxesScene, alpha: float, leap: float | None = None) -> tuple[Any, Any]:
    """Lower and upper corners (n, 2) m as they are drawn: on the way from the state before, but for leaps."""
    low, high, before = scene.lowers, scene.uppers, scene.previous
    if alpha >= 1.0 or before is None or len(before.lowers) != len(low):
        return low, high
    leap = _longest_way(scene) if leap is None else leap
    with np.errstate(invalid="ignore", over="ignore"):
        near = (np.abs(low - before.lowers) <= leap).all(axis=1)[:, None]
        return (
            np.where(near, before.lowers + alpha * (low - before.lowers), low),
            np.where(near, before.uppers + alpha * (high - before.uppers), high),
        )


def draw_loads(
    canvas: Canvas, loads: NDArray[np.int32], cell: float, full: float, color: str = "chalk"
) -> None:
    """Cells shaded by the number of boxes in them, from none to ``full`` and above; small cells together."""
    together = max(math.ceil(LEAST_CELL * canvas.k / (cell * canvas.pixels_per_unit)), 1)
    rows, columns = loads.shape
    if together > 1:
        high, wide = -(-rows // together), -(-columns // together)
        padded = np.zeros((high * together, wide * together), dtype=np.int32)
        padded[:rows, :columns] = loads
        across = padded.reshape(high, together, wide * together).sum(axis=1)
        shaded = across.reshape(high, wide, together).sum(axis=2) / together**2
    else:
        shaded = loads.astype(np.float64)
    height, width = (n * together * cell for n in shaded.shape)
    paint_raster(canvas, shades(canvas, 0.42 * shaded / full, color), (0.0, 0.0), (width, height))
    if together == 1 and cell * canvas.pixels_per_unit >= 9.0 * canvas.k:
        _draw_cells(canvas, rows, columns, cell)


def _draw_cells(canvas: Canvas, rows: int, columns: int, cell: float) -> None:
    """Borders of cells on whole pixels, as the grid of every stage has them: sharp, and quickly filled."""
    to_screen, surface, color = canvas.camera.to_screen, canvas.surface, canvas.color("grid2")
    (left, bottom), (right, top) = (to_screen(0.0, 0.0), to_screen(columns * cell, rows * cell))
    area = pygame.Rect(int(left), int(top), int(right) - int(left) + 1, int(bottom) - int(top) + 1)
    area = area.clip(canvas.rect)
    for i in range(columns + 1):
        x = int(left + i * (right - left) / columns)
        if area.left <= x < area.right:
            surface.fill(color, (x, area.top, 1, area.h))
    for i in range(rows + 1):
        y = int(bottom + i * (top - bottom) / rows)
        if area.top <= y < area.bottom:
            surface.fill(color, (area.left, y, area.w, 1))


def grouped(number: float) -> str:
    """A whole number in groups of three."""
    return f"{round(number):,}".replace(",", "\u202f")


def seconds_text(seconds: float) -> str:
    """A time with its unit, or a dash where there is none."""
    return " ".join(quantity(seconds, "s")) if math.isfinite(seconds) else "–"


def bytes_text(count: float) -> str:
    """An amount of memory with its unit."""
    return " ".join(quantity(float(count), "B"))


class Column:
    """Writes findings down a column of the world, from the top; heights in design px."""

    def __init__(
        self, canvas: Canvas, scene: BoxesScene, top: float = COLUMN_TOP, right: float = COLUMN_RIGHT
    ):
        self.canvas = canvas
        self._written = 0
        edge = right + canvas.px(10)
        if scene.lowers[:, 0].min(initial=0.0) < edge:  # boxes that come so far are hardly seen
            ground = np.array([(-99.0, -99.0), (edge, -99.0), (edge, 99.0), (-99.0, 99.0)])
            canvas.polygon(ground, fill="stage", fill_alpha=0.9)
        self.y = top
        self.left, self.right = COLUMN_LEFT, right
        self._bottom = scene.frame().bottom

    @property
    def room_px(self) -> float:
        """Design px that are left above the foot of the picture."""
        return (self.y - self._bottom) / self.canvas.px(1.0)

    def space(self, height_px: float) -> None:
        """Leave room."""
        self.y -= self.canvas.px(height_px)

    def _figure(self, words: str) -> str:
        """Words whose number changes together with all other numbers in the window."""
        self._written += 1
        return self.canvas.figure((self._written, "".join(filter(str.isalpha, words))), words)

    def head(self, words: str, remark: str = "") -> None:
        """A section's head, with a remark at its right."""
        words, remark = self._figure(words), self._figure(remark)
        self.canvas.label((self.left, self.y), words, "text1", 12, "semibold", "left", halo=False)
        if remark:
            self.canvas.label((self.right, self.y), remark, "text3", 11, "medium", "right", halo=False)
        self.space(18)

    def row(self, words: str, value: str, color: str = "text2") -> None:
        """Words on the left, a value on the right."""
        words, value = self._figure(words), self._figure(value)
        self.canvas.label((self.left, self.y), words, color, 12, "medium", "left", halo=False)
        self.canvas.label((self.right, self.y), value, "text1", 12, "semibold", "right", halo=False)
        self.space(19)

    def bar(self, words: str, value: str, share: float, color: str, hollow: bool = False) -> None:
        """A row with a bar below it, ``share`` of the column long."""
        canvas = self.canvas
        self.row(words, value)
        y = self.y + canvas.px(6)
        canvas.line((self.left, y), (self.right, y), "inset", 4.0)
        if share > 0.0:
            end = self.left + min(share, 1.0) * (self.right - self.left)
            canvas.line((self.left, y), (end, y), color, 4.0, alpha=0.4 if hollow else 1.0)
        self.space(10)

    def words(self, text: str, color: str = "text2") -> None:
        """A sentence, in as many lines as it takes."""
        canvas = self.canvas
        width = int((self.right - self.left) * canvas.pixels_per_unit)
        for line in canvas.fonts.wrap(text, 12, "medium", width):
            canvas.label((self.left, self.y), line, color, 12, "medium", "left", halo=False)
            self.space(17)

    def picture(self, colors: NDArray[np.uint32], height_px: float) -> tuple[float, float, float, float]:
        """A raster over the width of the column; returns its left, bottom, right and top, m."""
        canvas = self.canvas
        lower = (self.left, self.y - canvas.px(height_px))
        paint_raster(canvas, colors, lower, (self.right, self.y))
        corners = np.array([lower, (self.right, lower[1]), (self.right, self.y), (self.left, self.y)])
        canvas.polygon(corners, outline="line2", width=1.0)
        top = self.y
        self.space(height_px + 14)
        return self.left, lower[1], self.right, top


def log_share(seconds: float, least: float = 1e-6, most: float = 1.0) -> float:
    """Where a time lies between two others on a logarithmic bar; 0 where there is none."""
    if not seconds > 0.0 or not math.isfinite(seconds):
        return 0.0
    return min(max(math.log(seconds / least) / math.log(most / least), 0.02), 1.0)
