"""How outlines, their volumes and the query between them are drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.bounds import traversal
from game.physics.bounds.building import DEPTH, middle_of
from game.physics.bounds.query import ANCESTOR, OVERLAPPING, REST
from game.physics.bounds.segments import nearest_points
from game.physics.proximity_effects import EXACT_ANSWER
from game.scenes import bounds_walk as walk
from game.scenes import bounds_walk_view as walk_view
from game.scenes.bounds_pair import Pane, Place, TreePair
from game.scenes.mass_spring_threads import draw_threads
from game.scenes.outline_editor import NOBODY
from game.scenes.outlines import handle_of
from game.ui.canvas import EXACT_DASH, Canvas

if TYPE_CHECKING:
    from game.scenes.bounds_scene import BoundsScene

Array = NDArray[np.float64]
COLORS = ("text1", "chalk")  # of A and B
GREY_ALPHA, GREEN_DASH = 0.40, (7.0, 4.0)
MOST_GREEN, MOST_RED, MOST_CROSSINGS, MOST_AXES, MOST_CORNERS = 160, 120, 200, 10, 400
SHORTEST = 4.0  # px; smaller green and red volumes have no dashes and no fill


class Shown(NamedTuple):
    """What of the hierarchies is wanted."""

    grey: bool
    green: bool
    deepest: int


def length_text(length: float) -> str:
    """A length in words, with the prefix that suits it."""
    for factor, unit in ((1.0, "m"), (1e-2, "cm"), (1e-3, "mm"), (1e-6, "µm")):
        if length >= factor:
            return f"{length / factor:.3g} {unit}"
    return f"{length / 1e-9:.3g} nm"


class BoundsView:
    """Draws the scene; keeps the arrays that drawing needs."""

    def __init__(self) -> None:
        self._pairs = np.zeros((0, 2), dtype=np.int64)

    # -- legend -------------------------------------------------------------------------------------

    def legend(self, scene: BoundsScene) -> list[tuple[str, str, str]]:
        """What the marks mean, with counts."""
        if scene.walked == "fit":
            return walk_view.fit_legend(scene)
        if scene.walked == "build":
            return [
                ("box:amber", "volume being fitted", ""),
                ("box:ghost", "fitted so far", str(scene.cursor)),
            ]
        names = {"obb": "boxes", "capsule": "capsules", "aabb": "upright boxes"}
        name = names[scene.pair.options.kind]
        red, green, rest = scene.marked()
        rows = [("box:vermilion", f"overlapping {name}", str(red))]
        if scene.ancestors:
            rows.append(("dashed-box:green", "their ancestors", str(green)))
        if scene.hierarchy:
            rows.append(("box:ghost", "rest of the hierarchy", str(rest)))
        query = scene.pair.query
        if query is not None and query.crossing_count:
            rows.append(("disc:amber", "crossing of segments", str(query.crossing_count)))
        elif query is not None:
            rows.append(("dash:text1", "least distance", ""))
        if scene.walked == "query":
            rows.append(
                ("box:amber", "pair being tested", f"{scene.cursor} of {query.row_count if query else 0}")
            )
        return rows

    # -- the whole ----------------------------------------------------------------------------------

    def draw(self, scene: BoundsScene, canvas: Canvas, alpha: float) -> None:
        """All of it, from the back to the front."""
        canvas.grid(None, "")
        now = self.places(scene, alpha)
        for pane in scene.panes():
            places = [pane.place(place) for place in now]
            for i, outline in enumerate(scene.outlines):
                points = places[i].to_world(scene.local_points(i))
                self._draw_outline(canvas, points, outline.closed, COLORS[i])
            tree_places = self._tree_places(pane.pair, places)
            if scene.walked == "fit" and scene.outlines:
                walk_view.draw_fit(scene, canvas, tree_places)
            elif scene.walked == "build" and scene.outlines:
                walk_view.draw_build(scene, canvas, tree_places)
            else:
                self._draw_query(scene, canvas, pane, tree_places)
            self._draw_names(canvas, pane.pair, tree_places)
            self._draw_hand(scene, canvas, pane, places)
            if pane.title:
                self._draw_title(scene, canvas, pane)
        if scene.walked != "off":
            walk_view.draw_caption(canvas, walk.caption(scene))

    def _draw_title(self, scene: BoundsScene, canvas: Canvas, pane: Pane) -> None:
        """What a pane shows, and what it costs."""
        seen = scene.frame()
        at = pane.point((0.5 * (seen.left + seen.right), seen.bottom))
        canvas.label(at, pane.title, "text1", 15, "semibold", offset=(0.0, 14.0))
        query = pane.pair.query
        if query is not None:
            words = f"{query.volume_tests} tests, {query.leaves_met} pairs of leaves"
            canvas.label(at, words, "text2", 12, offset=(0.0, 34.0))

    def places(self, scene: BoundsScene, alpha: float) -> list[Place]:
        """Where the outlines are, between the last two steps."""
        now = [Place(*outline.position, outline.angle) for outline in scene.outlines]
        before = scene.previous
        if before is None or len(before.places) != len(now) or scene.board.held:
            return now
        return [
            Place(
                x + alpha * (place.x - x),
                y + alpha * (place.y - y),
                angle + alpha * math.remainder(place.angle - angle, 2.0 * math.pi),
            )
            for place, (x, y, angle) in zip(now, before.places.tolist(), strict=True)
        ]

    def _tree_places(self, pair: TreePair, places: list[Place]) -> list[Place]:
        upright = pair.options.kind == "aabb"
        return [place._replace(angle=0.0) if upright else place for place in places]

    # -- outlines and hand --------------------------------------------------------------------------

    def _draw_outline(self, canvas: Canvas, points: Array, closed: bool, color: str) -> None:
        if len(points) == 1:
            canvas.dot(points[0], 3.0, color)
            return
        if closed and len(points) > 2:
            canvas.polygon(points, fill=color, fill_alpha=0.07)
        canvas.polyline(points, color, 2.2, closed=closed and len(points) > 2)

    def _draw_names(self, canvas: Canvas, pair: TreePair, places: list[Place]) -> None:
        """A and B in the middle of their outlines; side by side if these are in one place."""
        middles = []
        for tree, place in zip(pair.trees, places, strict=True):
            x, y, _, _ = middle_of(tree.kind_number, tree.volumes, 0)
            middles.append(place.to_world(np.array((x, y))).tolist())
        apart = 0.0
        if len(middles) == 2 and math.dist(*middles) < canvas.px(90.0):
            apart = 52.0
        for i, at in enumerate(middles):
            count = pair.trees[i].segments
            words = "1 segment" if count == 1 else f"{count:,} segments".replace(",", "\u202f")
            width = canvas.fonts.size(words, 12)[0] / canvas.k + 4.0
            aside, down = canvas.room_for(at, (width, 40.0), (apart * (2 * i - 1), 0.0))
            canvas.label(at, "AB"[i], COLORS[i], 22, "semibold", offset=(aside, down - 9.0))
            canvas.label(at, words, "text2", 12, offset=(aside, down + 11.0))

    def _draw_hand(self, scene: BoundsScene, canvas: Canvas, pane: Pane, places: list[Place]) -> None:
        board = scene.board
        if board.chosen != NOBODY and board.chosen < len(places):
            moved = scene.outlines[board.chosen]
            if scene.tool == "points" and len(moved.points) <= MOST_CORNERS:
                corners = places[board.chosen].to_world(scene.local_points(board.chosen))
                canvas.discs(corners, canvas.px(3.0), "accent")
                if board.corner != NOBODY:
                    canvas.ring(corners[board.corner], 7.0, "amber", 1.8)
            canvas.handle(pane.point(handle_of(moved)), board.held == "turn")
        if board.drawn:
            drawn = np.array([pane.point(point) for point in board.drawn])
            canvas.polyline(drawn, "amber", 2.2)
            canvas.line(drawn[-1], pane.point(board.pointer), "amber", 1.4, dash=(8.0, 6.0))
            canvas.discs(drawn, canvas.px(3.0), "amber")
            canvas.ring(drawn[0], 7.0, "amber", 1.8)

    # -- volumes ------------------------------------------------------------------------------------

    def _draw_query(self, scene: BoundsScene, canvas: Canvas, pane: Pane, places: list[Place]) -> None:
        pair, query = pane.pair, pane.pair.query
        count = scene.cursor if scene.walked == "query" else None
        marks: Any = [np.zeros(len(tree), dtype=np.uint8) for tree in pair.trees]
        if query is not None:
            marks = query.marks(count)
        shown = Shown(scene.hierarchy, scene.ancestors, int(scene.deepest))
        self.draw_volumes(canvas, pair, places, marks, shown)
        if query is None:
            return
        if scene.walked == "query":
            walk_view.draw_pair(scene, canvas, places)
            return
        if scene.axes:
            self._draw_axes(canvas, pair, places)
        if query.crossing_count:
            self._draw_crossings(canvas, pair, places, not pane.title)
        else:
            self._draw_gap(scene, canvas, pane)
        if EXACT_ANSWER in scene.active and not pane.title:
            self._tell_touching(canvas, pair, places)

    def draw_volumes(
        self, canvas: Canvas, pair: TreePair, places: list[Place], marks: Any, shown: Shown
    ) -> None:
        """Both hierarchies by their marks, down to a level; red ones always."""
        for i, tree in enumerate(pair.trees):
            depth = tree.links[:, DEPTH]
            if shown.grey:
                nodes = np.flatnonzero((marks[i] == REST) & (depth <= shown.deepest))
                self.draw_grey(canvas, places[i].to_world(pair.paths[i][nodes]))
            if shown.green:
                nodes = np.flatnonzero((marks[i] == ANCESTOR) & (depth <= shown.deepest))[:MOST_GREEN]
                paths = places[i].to_world(pair.paths[i][nodes])
                self._draw_green(canvas, paths, depth[nodes], max(tree.depth, 1))
        for i in range(len(pair.trees)):
            nodes = np.flatnonzero(marks[i] == OVERLAPPING)[:MOST_RED]
            for path in places[i].to_world(pair.paths[i][nodes]):
                canvas.polygon(path, fill="vermilion", fill_alpha=0.28, outline="vermilion", width=2.0)

    def draw_grey(self, canvas: Canvas, paths: Array) -> None:
        """Many closed paths (m, p, 2) as hairlines."""
        m, p = paths.shape[:2]
        if m == 0:
            return
        if len(self._pairs) < m * p or self._pairs[p - 1, 1] != 0:
            start = np.arange(m * p)
            self._pairs = np.column_stack((start, np.where(start % p == p - 1, start - p + 1, start + 1)))
        pixels, clip = canvas.raster_target
        mapped = canvas.place_all(paths.reshape(-1, 2))
        colors = np.full(m * p, canvas.ink("ghost"), dtype=np.uint32)
        torn = np.zeros(m * p, dtype=np.int64)
        draw_threads(pixels, clip, mapped, self._pairs[: m * p], torn, colors, GREY_ALPHA)

    def _draw_green(self, canvas: Canvas, paths: Array, depth: Any, deepest: int) -> None:
        if not len(paths):
            return
        sizes = (paths.max(axis=1) - paths.min(axis=1)).max(axis=1) * canvas.pixels_per_unit
        small = (sizes < SHORTEST * canvas.k).tolist()
        for path, level, plain in zip(paths, depth.tolist(), small, strict=True):
            alpha = 0.5 + 0.5 * level / deepest
            canvas.polyline(path, "green", 1.5, closed=True, dash=None if plain else GREEN_DASH, alpha=alpha)

    # -- what a query tells -------------------------------------------------------------------------

    def _draw_crossings(self, canvas: Canvas, pair: TreePair, places: list[Place], words: bool) -> None:
        """Where segments meet, up to a limit, and in words how often."""
        query = pair.query
        assert query is not None
        a, b = pair.trees
        points = []
        for i, j in query.crossings[:MOST_CROSSINGS].tolist():
            mine = places[0].to_world(a.ends[i].reshape(2, 2)).ravel().tolist()
            theirs = places[1].to_world(b.ends[j].reshape(2, 2)).ravel().tolist()
            points.append(nearest_points(*mine, *theirs)[:2])
            canvas.contact(points[-1])
        if words:
            count = query.crossing_count
            told = "1 crossing" if count == 1 else f"{count} crossings"
            self._leader(canvas, max(points, key=lambda point: point[1]), told, "amber", (44.0, -34.0))

    def _tell_touching(self, canvas: Canvas, pair: TreePair, places: list[Place]) -> None:
        """Say of one red pair without a crossing that it is one."""
        query = pair.query
        assert query is not None
        if not query.leaves_met:
            return
        a, b = pair.trees
        met = query.rows[query.rows[:, traversal.VERDICT] == traversal.MET, :2]
        crossing = {(i, j) for i, j in query.crossings.tolist()}
        lowest, at = math.inf, None
        for x, y in met[:MOST_RED].tolist():
            segments = [(i, j) for i in a.segments_of(x).tolist() for j in b.segments_of(y).tolist()]
            if crossing.isdisjoint(segments):
                middle = places[0].to_world(pair.paths[0][x]).mean(axis=0).tolist()
                if middle[1] < lowest:
                    lowest, at = middle[1], middle
        if at is not None:
            names = "boxes" if pair.options.kind != "capsule" else "capsules"
            self._leader(canvas, at, f"{names} touch, segments do not", "vermilion", (40.0, 40.0))

    def _draw_gap(self, scene: BoundsScene, canvas: Canvas, pane: Pane) -> None:
        gap = scene.gap()
        if gap is None:
            return
        ends = [pane.point(gap.point_a), pane.point(gap.point_b)]
        canvas.line(ends[0], ends[1], "text1", 1.4, dash=EXACT_DASH, alpha=0.75)
        for point in ends:
            canvas.dot(point, 3.5, "text1")
        middle = [0.5 * (p + q) for p, q in zip(*ends, strict=True)]
        self._leader(canvas, middle, f"{length_text(gap.distance)} apart", "text1", (30.0, -34.0))

    def _draw_axes(self, canvas: Canvas, pair: TreePair, places: list[Place]) -> None:
        """For the largest pairs that are apart, the line between them."""
        query = pair.query
        assert query is not None
        a, b = pair.trees
        rows = query.rows
        tested = (rows[:, traversal.VERDICT] == traversal.APART) & (rows[:, traversal.TESTED] == 1)
        apart = np.flatnonzero(tested)
        size = np.minimum(a.sizes[rows[apart, 0]], b.sizes[rows[apart, 1]])
        for k in apart[np.argsort(-size, kind="stable")][:MOST_AXES].tolist():
            walk_view.draw_separation(canvas, pair, places, k, 0.75)

    def _leader(
        self, canvas: Canvas, at: Sequence[float], words: str, color: str, offset: tuple[float, float]
    ) -> None:
        """Words beside a point, with a line to it; turned inwards at the edges of the picture."""
        x, y = canvas.place(at)
        rect, k = canvas.rect, canvas.k
        dx, dy = offset
        if x + (dx + 190.0) * k > rect.right:
            dx = -dx
        if not rect.top + 24 * k < y + dy * k < rect.bottom - 24 * k:
            dy = -dy
        scale = canvas.px(1.0)
        knee = (at[0] + dx * scale, at[1] - dy * scale)
        end = (knee[0] + math.copysign(12.0, dx) * scale, knee[1])
        canvas.polyline(np.array((at, knee, end)), color, 1.2)
        anchor = "left" if dx > 0 else "right"
        canvas.label(end, words, color, 12, "semibold", anchor, (math.copysign(5.0, dx), 0.0), clear=True)


def warm_up() -> None:
    """Compile the hairlines, by drawing one on a tiny picture."""
    pixels, clip = np.zeros((4, 4), dtype=np.uint32), np.array((0, 0, 4, 4), dtype=np.int64)
    points, pairs = np.zeros((2, 2)), np.zeros((1, 2), dtype=np.int64)
    torn, colors = np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.uint32)
    draw_threads(pixels, clip, points, pairs, torn, colors, GREY_ALPHA)
    nearest_points(0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0)
