"""How two convex polygons are drawn: outlines, closest points and features, what is refused, the hand."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase import Feature
from game.scenes.convex.model.pair import PairModel
from game.scenes.shared.outlines.drawn_lines import DrawnLines
from game.scenes.shared.outlines.outline import handle_of, placed
from game.ui.canvas.canvas import PREDICTION_DASH, Canvas
from game.ui.look.numerals import format_si

Point = tuple[float, float]
COLORS = ("text1", "chalk")  # of A and B
FEW = 24  # vertices that are numbered and drawn as dots


def feature_points(corners: Floats, feature: Feature) -> Floats:
    """One corner, or the two of an edge."""
    i = feature.index % len(corners)
    if feature.kind == "vertex":
        return corners[i : i + 1]
    return corners[[i, (i + 1) % len(corners)]]


def outward(corners: Floats, feature: Feature) -> Point:
    """A unit vector that leads away from a polygon at a feature."""
    points = feature_points(corners, feature)
    n, i = len(corners), feature.index % len(corners)
    if n == 1:
        return 0.0, 1.0
    if feature.kind == "edge":
        ex, ey = (points[1] - points[0]).tolist()
    else:
        before, here, after = corners[i - 1], corners[i], corners[(i + 1) % n]
        u, v = here - before, after - here
        u, v = u / math.sqrt(float(u @ u) or 1.0), v / math.sqrt(float(v @ v) or 1.0)
        ex, ey = (u + v).tolist()
        if ex * ex + ey * ey < 1e-12:
            return float(u[0]), float(u[1])
    length = math.sqrt(ex * ex + ey * ey) or 1.0
    return ey / length, -ex / length


def draw_shapes(model: PairModel, canvas: Canvas) -> list[Floats]:
    """Both outlines, with names and numbers; returns their corners."""
    canvas.grid(None, "")
    shapes = [model.drawn_corners(k) for k in range(len(model.board.outlines))]
    for k, corners in enumerate(shapes):
        refused = model.refusal(k)
        color = COLORS[k] if refused is None else "vermilion"
        if len(corners) > 2:
            dash = None if refused is None else PREDICTION_DASH
            canvas.polygon(corners, color, 0.07, color, 2.2, dash)
        elif len(corners) == 2:
            canvas.polyline(corners, color, 2.6)
        else:
            canvas.dot(corners[0], 4.0, color)
        if refused is None and 2 < len(corners) <= FEW:
            canvas.discs(corners, canvas.px(2.6), color)
    draw_names(model, canvas, shapes)
    return shapes


def draw_names(model: PairModel, canvas: Canvas, shapes: list[Floats]) -> None:
    """The letters of the polygons and their numbers of vertices: inside, or beyond if there is no space."""
    middles = [corners.mean(axis=0) for corners in shapes]
    crowded = len(shapes) == 2 and math.dist(*middles) < canvas.px(64.0)
    for k, corners in enumerate(shapes):
        wide, high = (np.ptp(corners, axis=0) * canvas.pixels_per_unit / canvas.k).tolist()
        tall = max(wide, high) >= 70.0 and high >= 44.0 and wide >= 30.0
        count = len(corners)
        noun = "point" if count == 1 else "segment" if count == 2 else f"{count} vertices"
        place, offset = tuple(middles[k].tolist()), -9.0
        if crowded or not tall or model.refusal(k) is not None:
            above = crowded and k == 0
            row = int(corners[:, 1].argmax() if above else corners[:, 1].argmin())
            place = (float(middles[k][0]), float(corners[row, 1]))
            offset = -40.0 if above else 22.0
        canvas.label(place, "AB"[k], COLORS[k], 20, "semibold", offset=(0.0, offset))
        canvas.label(place, noun, "text2", 11, offset=(0.0, offset + 20.0))
        if model.parameters.numbers and 2 < count <= FEW and tall and model.refusal(k) is None:
            number_corners(canvas, corners)


def number_corners(canvas: Canvas, corners: Floats) -> None:
    """The numbers of the vertices, from 1, inside of them."""
    inner = corners.mean(axis=0)
    for i, corner in enumerate(corners):
        inward = inner - corner
        length = math.sqrt(float(inward @ inward)) or 1.0
        canvas.label(corner + inward / length * canvas.px(13.0), str(i + 1), "text3", 11, halo=False)


def draw_hulls(model: PairModel, canvas: Canvas) -> None:
    """The hulls that are offered in place of what is refused."""
    for k, outline in enumerate(model.board.outlines):
        refused = model.refusal(k)
        if refused is None:
            continue
        hull = refused.hull.moved(*outline.position, outline.angle).vertices
        canvas.polygon(hull, "green", 0.06, "green", 1.6, PREDICTION_DASH)
        bad = model.drawn_corners(k)[refused.vertex]
        canvas.ring(bad, 9.0, "vermilion", 1.8)
        canvas.label(bad, "not convex here", "vermilion", offset=(0.0, -18.0), clear=True)
        top = hull[int(hull[:, 1].argmax())]
        canvas.label(top, "its hull: press H to take it", "green", 13, offset=(0.0, -16.0), clear=True)


def draw_feature(canvas: Canvas, corners: Floats, feature: Feature, color: str, alpha: float = 1.0) -> None:
    """A vertex as a disc, an edge as a thick line."""
    points = feature_points(corners, feature)
    if len(points) == 1:
        canvas.dot(points[0], 5.5, color, alpha)
    else:
        canvas.line(points[0], points[1], color, 4.0, alpha=alpha)


def label_beside(
    lines: DrawnLines, place: Point, words: str, color: str, size: float, offsets: Sequence[Point]
) -> None:
    """Words at the first of several offsets (design px) from a place where the outlines leave them room."""
    canvas = lines.canvas
    width = canvas.fonts.size(words, size, "semibold")[0] / canvas.k
    offset = offsets[lines.clearest(place, (width, size + 4.0), offsets)]
    canvas.label(place, words, color, size, "semibold", offset=offset, clear=True)


def label_feature(lines: DrawnLines, place: Point, words: str, toward: Point) -> None:
    """What a feature is called: on the side of its polygon, away from the other one."""
    x, y = -56.0 * toward[0], 18.0 * toward[1]
    label_beside(
        lines, place, words, "green", 12, [(x, y + rise) for rise in (0.0, -18.0, 18.0, -34.0, 34.0)]
    )


def draw_answer(model: PairModel, canvas: Canvas, shapes: list[Floats]) -> None:
    """Closest points, the line between them, the distance, and the features they lie on."""
    distance, ax, ay, bx, by, nx, ny, _ = model.answer.tolist()
    features = [Feature.of(int(code)) for code in model.features]
    lines = DrawnLines(canvas, [(corners, True) for corners in shapes])
    p, q = (ax, ay), (bx, by)
    for k, toward in ((0, (nx, ny)), (1, (-nx, -ny))):
        draw_feature(canvas, shapes[k], features[k], "green")
        if len(shapes[k]) > 1:
            side = toward if distance > 0.0 else (-toward[0], -toward[1])
            label_feature(lines, (p, q)[k], f"{features[k]} of {'AB'[k]}", side)
    middle = (0.5 * (ax + bx), 0.5 * (ay + by))
    if distance > 0.0:
        canvas.line(p, q, "amber", 2.0)
    elif distance < 0.0:
        canvas.arrow(q, (ax - bx, ay - by), "vermilion", None)
    for place in (p, q):
        canvas.dot(place, 4.5, "amber" if distance > 0.0 else "vermilion")
    if distance == 0.0:
        words, color = "they are in contact" if (nx, ny) != (0.0, 0.0) else "they overlap", "vermilion"
    else:
        words = f"{'depth' if distance < 0.0 else 'distance'} {format_si(abs(distance), 'm')}"
        color = "amber" if distance > 0.0 else "vermilion"
    sign = 1.0 if nx >= 0.0 else -1.0
    x, y = -64.0 * sign * ny, -20.0 * sign * nx
    label_beside(
        lines, middle, words, color, 13, [(x, y), (-x, -y), (1.4 * x, 1.9 * y), (-1.4 * x, -1.9 * y)]
    )


def draw_separated(model: PairModel, canvas: Canvas, shapes: list[Floats]) -> None:
    """B as it would be, shifted out of an overlap by its depth."""
    distance, nx, ny = model.answer[0], model.answer[5], model.answer[6]
    if distance < 0.0 and len(shapes[1]) > 1:
        shift = -distance / model.content.scale * np.array((nx, ny))
        canvas.polyline(shapes[1] + shift, "ghost", 1.4, True, PREDICTION_DASH)


def draw_hand(model: PairModel, canvas: Canvas) -> None:
    """The handle for turning, chosen corners, and the line being drawn."""
    board = model.board
    if 0 <= board.chosen < len(board.outlines):
        outline = board.outlines[board.chosen]
        handle = handle_of(outline)
        canvas.line(outline.position, handle, "accent", 1.2, dash=(4.0, 4.0), alpha=0.7)
        canvas.handle(handle, board.held == "turn")
        if model.parameters.tool == "points":
            for k, corner in enumerate(placed(outline).tolist()):
                canvas.handle(corner, k == board.corner)
    if board.drawn:
        points = np.array((*board.drawn, board.pointer))
        canvas.polyline(points, "accent", 1.8)
        canvas.line(board.pointer, board.drawn[0], "accent", 1.2, dash=(4.0, 4.0), alpha=0.6)
        for point in board.drawn:
            canvas.handle(point)
        canvas.label(
            board.drawn[0], "click here or press Enter to close", "accent", offset=(0.0, -16.0), clear=True
        )


def draw_invitation(model: PairModel, canvas: Canvas) -> None:
    """What the pen is for, before its first click."""
    if model.parameters.tool == "draw" and not model.board.drawn:
        count = len(model.board.outlines)
        name = "AB"[count] if count < 2 else "a new polygon"
        caption(canvas, f"click the corners of {name}; a click at the first one, or Enter, closes it")


def caption(canvas: Canvas, words: str, color: str = "text1", detail: str = "") -> None:
    """A line at the foot of the stage, and one below it that says more."""
    seen = canvas.camera.visible()
    place = (0.5 * (seen.left + seen.right), seen.bottom)
    words = words[:1].upper() + words[1:]
    rise = -32.0 if detail else -14.0
    canvas.label(place, words, color, 13, "semibold", anchor="bottom", offset=(0.0, rise))
    if detail:
        canvas.label(place, detail, "text2", 12, "medium", anchor="bottom", offset=(0.0, -14.0))


def answer_legend(model: PairModel) -> list[tuple[str, str, str]]:
    """Rows for the answer, or for what is refused."""
    if not model.ready:
        return [("dash:vermilion", "not convex: refused", ""), ("dash:green", "hull offered", "")]
    if model.answer[0] <= 0.0:
        return [("line:green", "features at the least depth", ""), ("arrow:vermilion", "depth", "")]
    return [("line:green", "closest features", ""), ("disc:amber", "closest points", "")]
