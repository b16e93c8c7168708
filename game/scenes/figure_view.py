"""How a figure is drawn: skins with soft shade and outline, tapered bones, joints, weights as colours."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.physics.animation import Skeleton
from game.scenes.figure_rig import Rig
from game.ui.canvas import EXACT_DASH, Canvas

Array = NDArray[np.float64]
BONE_COLORS = ("chalk", "vermilion", "green", "pink", "violet", "yellow")
WIDEST = 0.13  # of a bone's length: half of its width
SHOULDER = 0.16  # of a bone's length: where it is widest
MOST_DIAMONDS = 160  # bones drawn as diamonds; more as lines


class Cell(NamedTuple):
    """Where a figure is drawn: its own coordinates times ``scale``, plus an origin."""

    x: float = 0.0
    y: float = 0.0
    scale: float = 1.0

    def out(self, points: Array) -> Array:
        """Places in the picture of points (m, 2) of the figure."""
        if self == WHOLE:
            return points
        return points * self.scale + (self.x, self.y)

    def into(self, x: float, y: float) -> tuple[float, float]:
        """The point of the figure at a place in the picture."""
        return (x - self.x) / self.scale, (y - self.y) / self.scale


WHOLE = Cell()
INK = pygame.Color(18, 22, 26)  # what outlines are darkened with


def fill_color(canvas: Canvas, fill: str) -> pygame.Color | str:
    """The colour of a skin; what is none is chalk."""
    if fill.startswith("#"):
        try:
            return pygame.Color(fill)
        except ValueError:
            return "chalk"
    try:
        canvas.color(fill)
    except (KeyError, ValueError, AttributeError):
        return "chalk"
    return fill


def draw_skins(canvas: Canvas, rig: Rig, points: Array, cell: Cell, strength: float = 1.0) -> None:
    """All skins, from the first to the last; an outline a little darker than its fill."""
    for i, skin in enumerate(rig.figure.skins):
        outline = cell.out(points[rig.outline(i)])
        color = fill_color(canvas, skin.fill)
        alpha = strength * skin.strength
        canvas.polygon(outline, fill=color, fill_alpha=alpha)
        if skin.outline:
            edge = canvas.color(color).lerp(INK, 0.5)
            canvas.polyline(outline, edge, 1.6, closed=True, alpha=min(1.0, alpha + 0.3))


def draw_outlines(canvas: Canvas, rig: Rig, points: Array, cell: Cell, color: str) -> None:
    """The outlines of body skins alone, dashed: what another blend makes of them."""
    for i, skin in enumerate(rig.figure.skins):
        if skin.outline and not skin.bone:
            canvas.polyline(
                cell.out(points[rig.outline(i)]), color, 1.4, closed=True, dash=EXACT_DASH, alpha=0.8
            )


def bone_color(bone: int) -> str:
    """The colour that stands for a bone; neighbours in the list differ."""
    return BONE_COLORS[bone % len(BONE_COLORS)]


def draw_weights(canvas: Canvas, rig: Rig, points: Array, cell: Cell, chosen: int) -> None:
    """Points of the skin in the colours of the bones that they follow, or by weight on the chosen one."""
    if rig.skinner is None:
        return
    weights = rig.weights
    if 0 <= chosen < weights.shape[1]:
        cold, hot = _rgb(canvas, "grid2"), _rgb(canvas, "amber")
        mixed = cold + weights[:, chosen : chosen + 1] * (hot - cold)
    else:
        mixed = weights @ np.array([_rgb(canvas, bone_color(i)) for i in range(weights.shape[1])])
    channels = np.rint(np.clip(mixed, 0.0, 255.0)).astype(np.uint32)
    colors = channels[:, 0] << 16 | channels[:, 1] << 8 | channels[:, 2]
    inner = rig.within
    if inner.stop > inner.start:
        canvas.particles(cell.out(points[inner]), np.ascontiguousarray(colors[inner]), 2.6)
    for i, skin in enumerate(rig.figure.skins):
        if skin.bone or not skin.outline:
            continue
        part = rig.outline(i)
        outline = cell.out(points[part])
        canvas.segments(outline, np.roll(outline, -1, axis=0), np.ascontiguousarray(colors[part]), 3.0)


def _rgb(canvas: Canvas, token: str) -> Array:
    color = canvas.color(token)
    return np.array((color.r, color.g, color.b), dtype=np.float64)


def draw_bones(
    canvas: Canvas, skeleton: Skeleton, cell: Cell, chosen: int, colored: bool,
    strong: frozenset[int] = frozenset(), rest: float = 1.0,
) -> None:  # fmt: skip
    """Tapered diamonds from joint to end, dots at the joints.

    strong: bones drawn in the accent colour; if there are any, the others with the strength ``rest``.
    """
    bases, ends = cell.out(skeleton.bases), cell.out(skeleton.ends)
    if skeleton.count > MOST_DIAMONDS:
        canvas.segments(bases, ends, "text1", 1.6)
    else:
        for i in range(skeleton.count):
            color = "amber" if i == chosen else "accent" if i in strong else None
            _draw_bone(
                canvas,
                bases[i],
                ends[i],
                color or (bone_color(i) if colored else "text1"),
                color is not None,
                rest if strong and color is None else 0.95,
            )
    marked = list(strong) if strong else range(skeleton.count)
    dots = np.vstack([bases[marked], ends[marked]])
    canvas.discs(dots, canvas.px(2.8), "stage")
    canvas.discs(dots, canvas.px(1.9), "text1")


def _draw_bone(canvas: Canvas, base: Array, end: Array, color: str, marked: bool, alpha: float) -> None:
    dx, dy = float(end[0] - base[0]), float(end[1] - base[1])
    length = math.sqrt(dx * dx + dy * dy)
    if length <= canvas.px(2.0):
        canvas.ring(base, 4.0, color, 1.4)
        return
    half = min(max(WIDEST * length, canvas.px(2.2)), canvas.px(7.0)) / length
    sx, sy = base[0] + SHOULDER * dx, base[1] + SHOULDER * dy
    corners = np.array(
        (
            (base[0], base[1]),
            (sx - half * dy, sy + half * dx),
            (end[0], end[1]),
            (sx + half * dy, sy - half * dx),
        )
    )
    canvas.polygon(
        corners,
        fill="panel",
        fill_alpha=0.45 * alpha,
        outline=color,
        width=2.0 if marked else 1.3,
        alpha=alpha,
    )


def draw_limits(canvas: Canvas, skeleton: Skeleton, cell: Cell, bone: int) -> None:
    """The range of a joint: a fan from one limit to the other, where there are limits."""
    if bone < 0 or not math.isfinite(float(skeleton.lower[bone]) + float(skeleton.upper[bone])):
        return
    base = cell.out(skeleton.bases[bone : bone + 1])[0]
    before = skeleton.world_angle(bone) - float(skeleton.angles[bone])
    low, high = before + float(skeleton.lower[bone]), before + float(skeleton.upper[bone])
    radius = max(0.45 * float(skeleton.lengths[bone]) * cell.scale, canvas.px(18.0))
    steps = np.linspace(low, high, max(2, math.ceil((high - low) / 0.1)))
    fan = np.column_stack([base[0] + radius * np.cos(steps), base[1] + radius * np.sin(steps)])
    canvas.polygon(np.vstack([base[None], fan]), fill="amber", fill_alpha=0.12)
    canvas.polyline(fan, "amber", 1.4, alpha=0.8)


def draw_pen(
    canvas: Canvas, drawn: tuple[tuple[float, float], ...], pointer: tuple[float, float], cell: Cell
) -> None:
    """The skin being drawn: its corners, the line to the pointer, and where it will close."""
    if not drawn:
        return
    line = cell.out(np.array([*drawn, pointer]))
    canvas.polyline(line, "accent", 2.0)
    if len(drawn) >= 3:
        canvas.polygon(line, fill="accent", fill_alpha=0.12)
    for point in line[1:-1]:
        canvas.dot(point, 2.6, "accent")
    canvas.handle(line[0], hovered=len(drawn) >= 3)
