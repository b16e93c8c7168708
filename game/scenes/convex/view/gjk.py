"""How GJK is drawn: the polygons at the left, their Minkowski difference and the simplexes at the right."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase.minkowski import minkowski_difference
from game.physics.narrowphase.queries import PolytopeStep, SimplexStep
from game.scenes.convex.hand import Hand
from game.scenes.convex.level import View
from game.scenes.convex.model.gjk import GjkModel
from game.scenes.convex.view import polygons
from game.stage import Frame
from game.ui.canvas.canvas import PREDICTION_DASH, Canvas
from game.ui.look.numerals import format_si

INSET = 0.72  # width of the difference's part of the stage, over that of the polygons
MOST_DOTS = 80
FEW_NAMED = 8  # corners of a polytope that are named
WORDS = {
    "done": "no corner is nearer: v is the answer",
    "new": "w alone is nearest: keep it",
    "first and new": "keep the first corner and w",
    "second and new": "keep the second corner and w",
    "inside": "the triangle holds the origin: they overlap",
}


class Inset(NamedTuple):
    """Where the difference is drawn: (x, y) goes to (left + scale x, bottom + scale y), units."""

    scale: float
    x: float
    y: float

    def place(self, points: Floats) -> Floats:
        """Points (n, 2) of A - B where they are drawn."""
        return np.asarray(points) * self.scale + (self.x, self.y)


def words_of(step: SimplexStep | PolytopeStep) -> str:
    """What a step does."""
    if isinstance(step, SimplexStep):
        return WORDS[step.kept]
    if step.grows:
        words = "the nearest edge is not on the border: break it at w"
        inner = sum(step.dropped)
        if inner:
            words += f", which replaces {'an inner corner' if inner == 1 else f'{inner} inner corners'}"
        return words
    return "the nearest edge is on the border: the shortest displacement out of the overlap"


def frame_of(seen: View) -> Frame:
    """The view of the polygons, and the difference's part to the right of it."""
    return Frame(seen.left, seen.bottom, seen.right + INSET * (seen.right - seen.left), seen.top)


def inset_for(seen: View, difference: Floats) -> Inset:
    """Where a difference (n, 2) and the origin fit."""
    width, height = seen.right - seen.left, seen.top - seen.bottom
    points = np.vstack((difference, np.zeros((1, 2))))
    low, high = points.min(axis=0), points.max(axis=0)
    space = (0.9 * INSET * width, 0.74 * height)
    size = np.maximum(high - low, 1e-300)
    scale = float(min(space[0] / size[0], space[1] / size[1]))
    middle = 0.5 * (low + high) * scale
    return Inset(
        scale,
        seen.right + 0.5 * INSET * width - float(middle[0]),
        0.5 * (seen.top + seen.bottom) - 0.02 * height - float(middle[1]),
    )


def legend(model: GjkModel) -> list[tuple[str, str, str]]:
    """What the marks mean."""
    rows = polygons.answer_legend(model)
    if model.ready and model.parameters.minkowski:
        rows.append(("line:amber", "simplex, closest point v", str(int(model.answer[7]))))
        rows.append(("diamond:pink", "new corner w", ""))
        if model.answer[0] > 0.0:
            rows.append(("line:amber", "circle: no farther than |v|", ""))
            rows.append(("dash:pink", "circle: no nearer than v·w / |v|", ""))
    return rows


def draw(model: GjkModel, hand: Hand, canvas: Canvas) -> None:
    """All of it, from the back to the front."""
    trace, chosen = model.trace(), model.parameters
    index = len(trace) - 1 if hand.shown < 0 else min(hand.shown, len(trace) - 1)
    whole = index == len(trace) - 1
    shapes = polygons.draw_shapes(model, canvas)
    polygons.draw_hulls(model, canvas)
    if model.ready:
        if chosen.supports and trace and (hand.shown >= 0 or not whole):
            draw_supports(canvas, shapes, trace[index])
        if whole:
            polygons.draw_separated(model, canvas, shapes)
            polygons.draw_answer(model, canvas, shapes)
        if chosen.minkowski:
            draw_difference(model, canvas, shapes, trace[: index + 1])
        if trace and (hand.shown >= 0 or len(trace) > 1) and chosen.tool != "draw":
            polygons.caption(canvas, f"step {index + 1} of {len(trace)}: {words_of(trace[index])}")
    polygons.draw_hand(model, canvas)
    polygons.draw_invitation(model, canvas)


def draw_supports(canvas: Canvas, shapes: list[Floats], step: SimplexStep | PolytopeStep) -> None:
    """The vertices farthest along the direction, and the direction at both polygons."""
    if isinstance(step, PolytopeStep):
        count = len(step.corners)
        p, q = (
            shapes[0][i % len(shapes[0])] - shapes[1][j % len(shapes[1])]
            for i, j in (step.corners[step.edge], step.corners[(step.edge + 1) % count])
        )
        length = math.sqrt(float((q - p) @ (q - p))) or 1.0
        x, y = float(q[1] - p[1]) / length, float(p[0] - q[0]) / length
        corners: tuple[tuple[int, int], ...] = (
            step.corners[step.edge],
            step.corners[(step.edge + 1) % count],
        )
    else:
        (x, y), corners = step.direction, step.corners
    for k, sign in ((0, 1.0), (1, -1.0)):
        i = step.support[k] % len(shapes[k])
        corner = shapes[k][i]
        canvas.ring(corner, 8.0, "pink", 2.0)
        canvas.dot(corner, 4.0, "pink")
        length = canvas.px(46.0)
        canvas.arrow(corner, (sign * x * length, sign * y * length), "pink", None, width=1.8)
        for pair in corners:
            canvas.dot(shapes[k][pair[k] % len(shapes[k])], 4.5, "amber")


def draw_difference(
    model: GjkModel, canvas: Canvas, shapes: list[Floats], shown: list[SimplexStep | PolytopeStep]
) -> None:
    """A - B, the origin, the simplexes so far, v and w."""
    seen = model.content.view
    difference = minkowski_difference(shapes[0], shapes[1])
    inset = inset_for(seen, difference)
    corners = inset.place(difference)
    width = seen.right - seen.left
    canvas.line((seen.right, seen.bottom), (seen.right, seen.top), "line", 1.0)
    canvas.polygon(corners, "violet", 0.09, "violet", 1.8)
    if len(corners) <= MOST_DOTS:
        canvas.discs(corners, canvas.px(2.2), "violet")
    top = (seen.right + 0.5 * INSET * width, seen.top)
    canvas.label(
        top, "Minkowski difference A − B", "violet", 13, "semibold", anchor="top", offset=(0.0, 14.0)
    )
    origin = (inset.x, inset.y)
    arm = canvas.px(9.0)
    for dx, dy in ((arm, 0.0), (0.0, arm)):
        ends = ((origin[0] - dx, origin[1] - dy), (origin[0] + dx, origin[1] + dy))
        canvas.line(*ends, "text1", 1.6)
    simplexes = [step for step in shown if isinstance(step, SimplexStep)]
    growing = [step for step in shown if isinstance(step, PolytopeStep)]
    if simplexes:
        draw_simplexes(model, canvas, shapes, inset, simplexes, bool(growing))
    if growing:
        draw_polytope(canvas, shapes, inset, growing[-1])
    place = simplexes[-1].closest if simplexes and not growing else (0.0, 0.0)
    away = (-1.0 if place[0] > 0.0 else 1.0, -1.0 if place[1] > 0.0 else 1.0)
    canvas.label(
        origin, "origin", "text1", 12, anchor="right" if away[0] < 0.0 else "left",
        offset=(-10.0 * away[0] if place != (0.0, 0.0) else 10.0, 16.0 * away[1]), clear=True,
    )  # fmt: skip


def corner_name(pair: tuple[int, int]) -> str:
    """What a corner of the difference is called: its vertices, counted from 1 as they are at the polygons."""
    return f"a{pair[0] + 1} − b{pair[1] + 1}"


def label_corners(canvas: Canvas, shapes: list[Floats], inset: Inset, pairs: list[tuple[int, int]]) -> None:
    """The names of corners of the difference, a_i - b_j, on the side away from their middle."""
    points = np.array([corner_of(shapes, inset, pair) for pair in pairs])
    middle = corner_middle(shapes, inset) if len(points) < 3 else points.mean(axis=0)
    for point, (i, j) in zip(points, pairs, strict=True):
        x, y = (point - middle).tolist()
        side = "left" if x >= 0.0 else "right"
        canvas.label(
            point, corner_name((i, j)), "amber", 12, "semibold", side,
            offset=(9.0 if x >= 0.0 else -9.0, -11.0 if y >= 0.0 else 11.0), clear=True,
        )  # fmt: skip


def corner_middle(shapes: list[Floats], inset: Inset) -> Floats:
    """The middle of the difference as it is drawn."""
    return inset.place(shapes[0].mean(axis=0) - shapes[1].mean(axis=0))


def draw_bounds(canvas: Canvas, inset: Inset, step: SimplexStep, scale: float, left: float) -> None:
    """What is known of the distance after a step, as circles about the origin: between v·w/|v| and |v|.

    left: x where the difference's part of the stage begins.
    """
    for distance, color, dash in ((step.distance, "amber", None), (step.bound, "pink", PREDICTION_DASH)):
        radius = distance / scale * inset.scale
        if radius > canvas.px(3.0):
            reach = math.acos(min(max((left - inset.x) / radius, -1.0), 1.0))
            turn = np.linspace(-reach, reach, 181)
            points = radius * np.column_stack((np.cos(turn), np.sin(turn))) + (inset.x, inset.y)
            canvas.polyline(points, color, 1.4, False, dash, 0.75)


def corner_of(shapes: list[Floats], inset: Inset, pair: tuple[int, int]) -> Floats:
    """Where a corner a - b of the difference is drawn."""
    return inset.place(shapes[0][pair[0] % len(shapes[0])] - shapes[1][pair[1] % len(shapes[1])])


def draw_polytope(canvas: Canvas, shapes: list[Floats], inset: Inset, step: PolytopeStep) -> None:
    """EPA's polygon, its nearest edge, the vector to it from the origin, and the corner beyond it."""
    corners = np.array([corner_of(shapes, inset, pair) for pair in step.corners])
    canvas.polygon(corners, "amber", 0.13, "amber", 1.8)
    canvas.discs(corners, canvas.px(3.0), "amber")
    p, q = corners[step.edge], corners[(step.edge + 1) % len(corners)]
    color = "amber" if step.grows else "green"
    canvas.line(p, q, color, 4.0)
    ex, ey = (q - p).tolist()
    length = math.sqrt(ex * ex + ey * ey)
    if length > 0.0:
        origin = np.array((inset.x, inset.y))
        part = ((origin - p) @ (q - p)) / (length * length)
        out = p + part * (q - p) - origin
        canvas.arrow(
            tuple(origin.tolist()), tuple(out.tolist()), color if step.grows else "vermilion", None, width=2.0
        )
    label_corners(canvas, shapes, inset, list(step.corners) if len(corners) <= FEW_NAMED else [])
    if step.grows:
        new = corner_of(shapes, inset, step.support)
        canvas.ring(new, 7.0, "pink", 2.0)
        name = f"w = {corner_name(step.support)}"
        canvas.label(new, name, "pink", 12, "semibold", offset=(0.0, -19.0), clear=True)


def draw_simplexes(
    model: GjkModel, canvas: Canvas, shapes: list[Floats], inset: Inset, shown: list[SimplexStep], past: bool
) -> None:
    """Simplexes, the newer the stronger; of the last one, unless EPA has gone past it, also v and w."""
    scale = model.content.scale
    for number, step in enumerate(shown, start=1):
        alpha = (0.2 + 0.8 * number / len(shown)) * (0.4 if past else 1.0)
        points = [corner_of(shapes, inset, pair) for pair in step.corners]
        if len(points) == 2:
            canvas.line(points[0], points[1], "amber", 2.6 if number == len(shown) else 1.6, alpha=alpha)
        for point in points:
            canvas.dot(point, 4.0, "amber", alpha)
    last = shown[-1]
    if past:
        return
    draw_bounds(canvas, inset, last, scale, model.content.view.right)
    label_corners(canvas, shapes, inset, list(last.corners))
    new = corner_of(shapes, inset, last.support)
    if last.kept == "inside":
        triangle = np.array([*(corner_of(shapes, inset, pair) for pair in last.corners), new])
        canvas.polygon(triangle, "amber", 0.15, "amber", 2.0)
    tip = inset.place(np.array(last.closest) / scale)
    origin = (inset.x, inset.y)
    if math.dist(tip, origin) > canvas.px(4.0):
        color = "green" if last.kept == "done" else "amber"
        canvas.arrow(origin, (tip[0] - origin[0], tip[1] - origin[1]), color, "v", width=2.0)
    canvas.ring(new, 7.0, "pink", 2.0)
    below = float(new[1]) <= float(tip[1])
    if last.support not in last.corners:
        name = f"w = {corner_name(last.support)}"
        canvas.label(new, name, "pink", 12, "semibold", offset=(0.0, 19.0 if below else -19.0), clear=True)
    if last.kept == "done" and model.answer[0] > 0.0 and math.dist(tip, origin) > canvas.px(110.0):
        words = f"|v| = {format_si(float(model.answer[0]), 'm')}"
        canvas.label(
            (0.5 * (tip[0] + origin[0]), 0.5 * (tip[1] + origin[1])), words, "green", 12, "semibold",
            offset=(0.0, -16.0), clear=True,
        )  # fmt: skip
