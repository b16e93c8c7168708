"""How V-Clip is drawn: Voronoi regions, and the walk from feature to feature."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase import Feature
from game.physics.narrowphase.queries import FeatureStep
from game.scenes.convex.hand import Hand
from game.scenes.convex.model.vclip import VClipModel
from game.scenes.convex.view import polygons
from game.scenes.convex.view.vclip_words import caption_of
from game.ui.canvas.canvas import Canvas

MOST_RAYS = 200  # vertices whose borders are drawn


def legend(model: VClipModel) -> list[tuple[str, str, str]]:
    """What the marks mean."""
    rows = polygons.answer_legend(model)
    if model.ready and model.parameters.walk:
        rows.append(("line:amber", "features visited", str(int(model.answer[7]))))
    if model.ready and model.parameters.regions:
        rows.append(("box:text1:chalk", "their Voronoi regions", ""))
    return rows


def draw(model: VClipModel, hand: Hand, canvas: Canvas) -> None:
    """All of it, from the back to the front."""
    trace = model.trace()
    shown = trace[: hand.shown + 1] if hand.shown >= 0 else trace
    if model.parameters.regions and model.ready:
        draw_regions(model, canvas, shown)
    shapes = polygons.draw_shapes(model, canvas)
    polygons.draw_hulls(model, canvas)
    if model.ready:
        if model.parameters.walk:
            draw_walk(canvas, shapes, shown, len(shown) == len(trace))
        if len(shown) == len(trace):
            polygons.draw_separated(model, canvas, shapes)
            polygons.draw_answer(model, canvas, shapes)
        if shown and (hand.shown >= 0 or len(trace) > 1) and model.parameters.tool != "draw":
            words, detail = caption_of(trace, len(shown) - 1, shapes, model.content.scale)
            polygons.caption(canvas, words, detail=detail)
    polygons.draw_hand(model, canvas)
    polygons.draw_invitation(model, canvas)


def draw_regions(model: VClipModel, canvas: Canvas, shown: list[FeatureStep]) -> None:
    """Borders of all Voronoi regions as hairlines, those of the present features filled."""
    seen = canvas.camera.visible()
    far = math.dist((seen.left, seen.bottom), (seen.right, seen.top))
    for k in (0, 1):
        corners = model.drawn_corners(k)
        if len(corners) < 2:
            continue
        edges = np.roll(corners, -1, axis=0) - corners
        lengths = np.sqrt((edges * edges).sum(axis=1))
        normals = np.column_stack((edges[:, 1], -edges[:, 0])) / lengths[:, None]
        color = polygons.COLORS[k]
        if shown:
            feature = (shown[-1].feature_a, shown[-1].feature_b)[k]
            canvas.polygon(region(corners, normals, feature, far), color, 0.09)
        if len(corners) <= MOST_RAYS:
            starts = np.concatenate((corners, corners))
            ends = starts + far * np.concatenate((normals, np.roll(normals, 1, axis=0)))
            canvas.segments(starts, ends, color, 1.0, alpha=0.2)


def region(corners: Floats, normals: Floats, feature: Feature, far: float) -> Floats:
    """The Voronoi region of a feature as far as it is drawn: a strip before an edge, a wedge at a vertex."""
    i, n = feature.index % len(corners), len(corners)
    if feature.kind == "edge":
        o, p = corners[i], corners[(i + 1) % n]
        return np.array((o, p, p + far * normals[i], o + far * normals[i]))
    middle = normals[i] + normals[i - 1]
    length = math.sqrt(float(middle @ middle))
    if length < 1e-9:  # the end of a segment: half a plane
        edge = corners[i] - corners[(i + 1) % n]
        middle, length = edge, math.sqrt(float(edge @ edge))
    o = corners[i]
    tip = 2.0 * far * middle / length
    return np.array((o, o + far * normals[i - 1], o + tip, o + far * normals[i]))


def draw_walk(canvas: Canvas, shapes: list[Floats], shown: list[FeatureStep], whole: bool) -> None:
    """The features visited, the newer the stronger, with the numbers of their steps."""
    count = len(shown)
    for k in (0, 1):
        feature_before = None
        for number, step in enumerate(shown, start=1):
            feature = (step.feature_a, step.feature_b)[k]
            if feature == feature_before:
                continue
            feature_before = feature
            alpha = 0.25 + 0.75 * number / count
            if not (whole and number == count):
                polygons.draw_feature(canvas, shapes[k], feature, "amber", alpha)
            last = feature == (shown[-1].feature_a, shown[-1].feature_b)[k]
            if count <= polygons.FEW and count > 1 and not (whole and last):
                place = polygons.feature_points(shapes[k], feature).mean(axis=0)
                x, y = polygons.outward(shapes[k], feature)
                canvas.label(
                    place, str(number), "amber", 12, "semibold", offset=(15.0 * x, -15.0 * y), alpha=alpha,
                    clear=True,
                )  # fmt: skip
    if not whole and shown:
        points = [
            polygons.feature_points(shapes[k], (shown[-1].feature_a, shown[-1].feature_b)[k]).mean(axis=0)
            for k in (0, 1)
        ]
        canvas.line(points[0], points[1], "amber", 1.2, dash=(6.0, 6.0), alpha=0.7)
