"""How the walks through fit, building and query are drawn."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.bounds import traversal
from game.physics.bounds.building import CHILD, middle_of
from game.scenes.bounds.pair import FINE_ROUND, Place, TreePair, rows_to_paths
from game.scenes.bounds.volumes import VolumePainter
from game.scenes.bounds.walk import FitWalk, Walk, fit_row
from game.ui.canvas.canvas import EXACT_DASH, Canvas

CHART = (300.0, 104.0)  # design px, of the curve of areas
MARGIN = 20.0


def draw_caption(canvas: Canvas, words: str) -> None:
    """A sentence at the bottom of the stage."""
    rect = canvas.rect
    at = canvas.camera.to_world(rect.left + MARGIN * canvas.k, rect.bottom - MARGIN * canvas.k)
    canvas.label(at, words, "text1", 13, "semibold", "left")


# -- the fit ------------------------------------------------------------------------------------------


def fit_legend() -> list[tuple[str, str, str]]:
    """What the marks of the fit mean."""
    return [
        ("dashed-box:amber", "on the present direction", ""),
        ("box:green", "best so far", ""),
        ("dash:text1", "exact", ""),
    ]


def draw_fit(walk: Walk, canvas: Canvas, places: list[Place]) -> None:
    """The volume on the present direction, the best one so far, and the curve of areas."""
    found = walk.fit()
    kind, place = walk.model.pair.options.kind, places[walk.model.chosen]
    k = min(max(walk.cursor - 1, 0), len(found.angles) - 1)
    best = int(found.areas[: k + 1].argmin())
    for index, color, fill, dash in ((best, "green", 0.12, None), (k, "amber", 0.0, (7.0, 4.0))):
        row = fit_row(found, float(found.angles[index]), kind)
        path = place.to_world(rows_to_paths(kind, row, FINE_ROUND)[0])
        canvas.polygon(
            path, fill=color if fill else None, fill_alpha=fill, outline=color, width=2.0, dash=dash
        )
    row = fit_row(found, float(found.angles[k]), kind)[0]
    _draw_axes_through(canvas, row, place, float(found.angles[k]))
    _draw_curve(canvas, found, k, best)


def _draw_axes_through(canvas: Canvas, row: Floats, place: Place, angle: float) -> None:
    """The two axes through the middle of the projections."""
    x, y, _, _ = middle_of(
        1 if row[5] == 0.0 and abs(row[2] ** 2 + row[3] ** 2 - 1.0) > 1e-9 else 0, row[None], 0
    )
    middle = place.to_world(np.array((x, y))).tolist()
    reach = canvas.px(70.0)
    for turn in (0.0, 0.5 * math.pi):
        c, s = math.cos(angle + place.angle + turn), math.sin(angle + place.angle + turn)
        tail = (middle[0] - reach * c, middle[1] - reach * s)
        canvas.arrow(tail, (2.0 * reach * c, 2.0 * reach * s), "text1", width=1.6)


def _draw_curve(canvas: Canvas, found: FitWalk, k: int, best: int) -> None:
    """Area against direction at the bottom right of the stage, with the exact one dashed."""
    rect, unit = canvas.rect, canvas.k
    left = rect.right - (MARGIN + CHART[0]) * unit
    bottom = rect.bottom - (MARGIN + 34.0) * unit
    known, top_area = math.isfinite(found.exact), float(found.areas.max())
    low_area = min(float(found.areas.min()), found.exact if known else math.inf)
    span = max(top_area - low_area, 1e-300)
    share_x = np.linspace(0.0, 1.0, len(found.angles)) if len(found.angles) > 1 else np.zeros(1)

    def at(x: float, y: float) -> tuple[float, float]:
        return canvas.camera.to_world(left + x * CHART[0] * unit, bottom - y * CHART[1] * unit)

    canvas.polygon(
        np.array([at(-0.04, -0.28), at(1.04, -0.28), at(1.04, 1.3), at(-0.04, 1.3)]), "panel", 0.92
    )
    heights = (found.areas - low_area) / span
    curve = np.array([at(x, y) for x, y in zip(share_x.tolist(), heights.tolist(), strict=True)])
    canvas.polyline(curve, "ghost", 1.2)
    if k > 0:
        canvas.polyline(curve[: k + 1], "chalk", 2.0)
    if known:
        exact = (found.exact - low_area) / span
        canvas.line(at(0.0, exact), at(1.0, exact), "text1", 1.4, dash=EXACT_DASH, alpha=0.75)
        canvas.label(at(1.0, 1.17), f"exact {found.exact:.4g} m²", "text2", 12, "medium", "right", halo=False)
        if found.exact > 0.0:
            words = f"best so far: {found.ratio(best):.4f} times the exact"
            canvas.label(at(0.5, -0.15), words, "green", 12, "medium", halo=False)
    canvas.dot(curve[best], 4.5, "green")
    canvas.ring(curve[k], 6.0, "amber", 1.8)
    canvas.label(at(0.0, 1.17), "Area against direction", "text1", 12, "semibold", "left", halo=False)
    degrees = f"{math.degrees(float(found.angles[-1])):.3g}°"
    canvas.label(at(0.0, -0.15), "0°", "text3", 11, "medium", "left", halo=False)
    canvas.label(at(1.0, -0.15), degrees, "text3", 11, "medium", "right", halo=False)


# -- the building -------------------------------------------------------------------------------------


def draw_build(walk: Walk, canvas: Canvas, places: list[Place], painter: VolumePainter) -> None:
    """Nodes fitted so far, the present one with the line that halves it."""
    index, node = walk.building_at()
    pair = walk.model.pair
    for i, tree in enumerate(pair.trees):
        done = len(tree) if i < index else node if i == index else 0
        if walk.cursor and done:
            painter.draw_grey(canvas, pair, i, np.arange(done), places[i])
    if not walk.cursor:
        return
    tree, place = pair.trees[index], places[index]
    path = rows_to_paths(pair.options.kind, tree.volumes[node : node + 1], FINE_ROUND)[0]
    canvas.polygon(place.to_world(path), fill="amber", fill_alpha=0.10, outline="amber", width=2.0)
    child = int(tree.links[node, CHILD])
    if child < 0:
        _draw_segments(canvas, tree.ends[tree.segments_of(node)], place, "amber")
        return
    for side, color in ((0, "green"), (1, "pink")):
        _draw_segments(canvas, tree.ends[tree.segments_of(child + side)], place, color)
    x, y, c, s = middle_of(tree.kind_number, tree.volumes, node)
    reach = 0.5 * float(tree.sizes[node])
    ends = place.to_world(np.array(((x - s * -reach, y - c * reach), (x + s * -reach, y + c * reach))))
    canvas.line(ends[0], ends[1], "amber", 1.6, dash=(8.0, 6.0))


def _draw_segments(canvas: Canvas, ends: Floats, place: Place, color: str) -> None:
    world = place.to_world(ends.reshape(-1, 2, 2))
    canvas.segments(world[:, 0], world[:, 1], color, 3.2)


# -- the query ----------------------------------------------------------------------------------------


def draw_pair(walk: Walk, canvas: Canvas, places: list[Place]) -> None:
    """The pair that is tested now, and what separates it."""
    query = walk.model.pair.query
    if query is None or walk.cursor == 0 or not query.row_count:
        return
    k = min(walk.cursor, query.row_count) - 1
    a, b, verdict = query.rows[k, :3].tolist()
    for i, node in enumerate((a, b)):
        row = walk.model.pair.trees[i].volumes[node : node + 1]
        path = places[i].to_world(rows_to_paths(walk.model.pair.options.kind, row, FINE_ROUND)[0])
        canvas.polygon(path, fill="amber", fill_alpha=0.10, outline="amber", width=2.2)
    if verdict == traversal.APART:
        draw_separation(canvas, walk.model.pair, places, k, 1.0)


def draw_separation(canvas: Canvas, pair: TreePair, places: list[Place], k: int, alpha: float) -> None:
    """The line between a pair that is apart, and how wide the gap across it is."""
    query = pair.query
    assert query is not None
    a, b = query.rows[k, :2].tolist()
    nx, ny = query.gaps[k, 1:].tolist()
    c, s = math.cos(places[0].angle), math.sin(places[0].angle)
    normal = np.array((c * nx - s * ny, s * nx + c * ny))
    along = np.array((-normal[1], normal[0]))
    mine, theirs = places[0].to_world(pair.paths[0][a]), places[1].to_world(pair.paths[1][b])
    low, high = float((mine @ normal).max()), float((theirs @ normal).min())
    middle = 0.5 * (float((mine @ along).mean()) + float((theirs @ along).mean()))
    centre = 0.5 * (low + high) * normal + middle * along
    reach = max(0.7 * min(float(np.ptp(mine @ along)), float(np.ptp(theirs @ along))), canvas.px(18.0))
    canvas.line(centre - reach * along, centre + reach * along, "amber", 1.6, dash=(8.0, 6.0), alpha=alpha)
    if high > low:
        start, end = low * normal + middle * along, high * normal + middle * along
        canvas.line(start, end, "text1", 1.6, alpha=alpha)
