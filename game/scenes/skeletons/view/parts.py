"""How a figure is drawn: skins with soft shade and outline, tapered bones, joints, weights as colours."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.animation import Skeleton
from game.scenes.skeletons.cells import Cell
from game.scenes.skeletons.rig import Rig
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.worlds.painting.polygons import NO_EDGE, paint

BONE_COLORS = ("chalk", "vermilion", "green", "pink", "violet", "yellow")
WIDEST = 0.13  # of a bone's length: half of its width
SHOULDER = 0.16  # of a bone's length: where it is widest
MOST_DIAMONDS = 160  # bones drawn as diamonds; more are lines


def draw_outlines(canvas: Canvas, rig: Rig, points: Floats, color: str) -> None:
    """The outlines of body skins alone, dashed: what another blend makes of them."""
    for i, skin in enumerate(rig.figure.skins):
        if skin.outline and len(skin.bones) != 1:
            canvas.polyline(points[rig.outline(i)], color, 1.4, closed=True, dash=EXACT_DASH, alpha=0.8)


def bone_color(bone: int) -> str:
    """The colour that stands for a bone; neighbours in the list differ."""
    return BONE_COLORS[bone % len(BONE_COLORS)]


def draw_weights(canvas: Canvas, rig: Rig, points: Floats, chosen: int) -> None:
    """Points of the skin in the colours of the bones that they follow, or by weight on the chosen one."""
    bound = rig.binding
    if bound is None:
        return
    if 0 <= chosen < rig.skeleton.count:
        cold, hot = _rgb(canvas, "grid2"), _rgb(canvas, "amber")
        share = np.where(bound.bones == chosen, bound.weights, 0.0).sum(axis=1)
        mixed = cold + share[:, None] * (hot - cold)
    else:
        inks = np.array([_rgb(canvas, token) for token in BONE_COLORS])
        mixed = np.einsum("vk,vkc->vc", bound.weights, inks[bound.bones % len(BONE_COLORS)])
    channels = np.rint(np.clip(mixed, 0.0, 255.0)).astype(np.uint32)
    colors = channels[:, 0] << 16 | channels[:, 1] << 8 | channels[:, 2]
    inner = rig.within
    if inner.stop > inner.start:
        canvas.particles(points[inner], np.ascontiguousarray(colors[inner]), 2.6)
    for i, skin in enumerate(rig.figure.skins):
        if len(skin.bones) == 1 or not skin.outline:
            continue
        part = rig.outline(i)
        outline = points[part]
        canvas.segments(outline, np.roll(outline, -1, axis=0), np.ascontiguousarray(colors[part]), 3.0)


def _rgb(canvas: Canvas, token: str) -> Floats:
    color = canvas.color(token)
    return np.array((color.r, color.g, color.b), dtype=np.float64)


def bone_tokens(count: int, chosen: int, colored: bool, strong: frozenset[int] = frozenset()) -> list[str]:
    """Colours of bones by name: the chosen one, those of a chain, or of all; "" is a thin line.

    strong: the bones of a chain; if there are any, the others are thin lines.
    """
    if count > MOST_DIAMONDS:
        return ["accent" if i in strong else "" for i in range(count)]
    return [
        "amber" if i == chosen
        else "accent" if i in strong
        else "" if strong
        else bone_color(i) if colored
        else "text1"
        for i in range(count)
    ]  # fmt: skip


@lru_cache(maxsize=8)
def _sorted_bones(tokens: tuple[str, ...]) -> tuple[NDArray[np.int64], NDArray[np.int64], tuple[str, ...]]:
    """Which bones are thin lines, which are shown, and the colours of these by name."""
    quiet = np.array([i for i, token in enumerate(tokens) if not token], dtype=np.int64)
    shown = np.array([i for i, token in enumerate(tokens) if token], dtype=np.int64)
    return quiet, shown, tuple(token for token in tokens if token)


def draw_bones(canvas: Canvas, bases: Floats, ends: Floats, tokens: Sequence[str]) -> None:
    """Tapered diamonds from ``bases`` to ``ends`` (n, 2) in the colours named, dots at their joints."""
    quiet, shown, names = _sorted_bones(tuple(tokens))
    if len(quiet):
        canvas.segments(bases[quiet], ends[quiet], "text1", 1.2, alpha=0.45)
    if not len(shown):
        return
    bases, ends = bases[shown], ends[shown]
    if len(shown) > MOST_DIAMONDS:
        canvas.segments(bases, ends, names[0], 1.6)
        return
    inks = {token: canvas.ink(token) for token in set(names)}
    colors = np.array([inks[name] for name in names], dtype=np.uint32)
    corners = diamonds(bases, ends, canvas.px(2.2), canvas.px(7.0))
    count = len(shown)
    fills = np.full(count, canvas.ink("panel"), dtype=np.int64)
    none = np.full(count, NO_EDGE, dtype=np.int64)
    starts = 4 * np.arange(count + 1)
    paint(canvas, corners, starts, fills, np.full(count, 0.45), none, np.zeros((4, 2)))
    after = corners.reshape(-1, 4, 2)[:, (1, 2, 3, 0)].reshape(-1, 2)
    canvas.segments(corners, after, np.repeat(colors, 4), 1.4)
    dots = np.concatenate((bases, ends))
    canvas.discs(dots, canvas.px(2.8), "stage")
    canvas.discs(dots, canvas.px(1.9), "text1")


def diamonds(bases: Floats, ends: Floats, narrowest: float, widest: float) -> Floats:
    """Corners (4 n, 2) of bones: joint, side, end, side. Half widths are between those two lengths."""
    along = ends - bases
    length = np.sqrt((along * along).sum(axis=1, keepdims=True))
    half = np.clip(WIDEST * length, narrowest, widest) / np.maximum(length, 1e-300)
    half = np.where(length > 0.0, half, 0.0)
    across = half * np.column_stack([-along[:, 1], along[:, 0]])
    middle = bases + SHOULDER * along
    return np.stack([bases, middle + across, ends, middle - across], axis=1).reshape(-1, 2)


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


def draw_next_click(canvas: Canvas, words: str, pointer: tuple[float, float], cell: Cell) -> None:
    """What the next click does, beside the pointer; nothing before the pointer was seen first."""
    if words and pointer != (0.0, 0.0):
        place = cell.out(np.array([pointer]))[0]
        canvas.label(tuple(place), words, "accent", 12, anchor="left", offset=(14.0, 18.0))
