"""What a query between two hierarchies has found, in marks and words: crossings, volumes in contact, gap."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.physics.bounds import Nearest, traversal
from game.physics.bounds.segments import nearest_points
from game.scenes.bounds import walk_view
from game.scenes.bounds.pair import Place, TreePair
from game.scenes.bounds.panes import Pane
from game.scenes.bounds.volumes import MOST_RED
from game.scenes.shared.outlines.drawn_lines import DrawnLines
from game.ui.canvas.canvas import EXACT_DASH, Canvas

MOST_CROSSINGS, MOST_AXES = 200, 10


def length_text(length: float) -> str:
    """A length in words, with the prefix that suits it."""
    for factor, unit in ((1.0, "m"), (1e-2, "cm"), (1e-3, "mm"), (1e-6, "µm")):
        if length >= factor:
            return f"{length / factor:.3g} {unit}"
    return f"{length / 1e-9:.3g} nm"


class Annotations:
    """Draws what was found; keeps on which side of its point each of the words stands."""

    def __init__(self) -> None:
        self._sides: dict[str, int] = {}

    def draw_crossings(
        self, canvas: Canvas, lines: DrawnLines, pair: TreePair, places: list[Place], words: bool
    ) -> None:
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
            text = "1 crossing" if count == 1 else f"{count} crossings"
            self._leader(lines, max(points, key=lambda point: point[1]), text, "amber", (44.0, -34.0))

    def label_contact(self, canvas: Canvas, lines: DrawnLines, pair: TreePair, places: list[Place]) -> None:
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
            self._leader(lines, at, f"{names} overlap, segments do not meet", "vermilion", (40.0, 40.0))

    def draw_gap(self, canvas: Canvas, lines: DrawnLines, pane: Pane, gap: Nearest) -> None:
        """The line between the nearest points, and how long it is."""
        ends = [pane.point(gap.point_a), pane.point(gap.point_b)]
        canvas.line(ends[0], ends[1], "text1", 1.4, dash=EXACT_DASH, alpha=0.75)
        for point in ends:
            canvas.dot(point, 3.5, "text1")
        middle = [0.5 * (p + q) for p, q in zip(*ends, strict=True)]
        self._leader(lines, middle, f"{length_text(gap.distance)} apart", "text1", (30.0, -34.0))

    def draw_axes(self, canvas: Canvas, pair: TreePair, places: list[Place]) -> None:
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
        self, lines: DrawnLines, at: Sequence[float], words: str, color: str, offset: tuple[float, float]
    ) -> None:
        """Words beside a point, with a line to it; on the side where the fewest lines run under them."""
        canvas = lines.canvas
        dx, dy = offset
        knees = [(dx, dy), (dx, -dy), (-dx, dy), (-dx, -dy)]
        wide = canvas.fonts.size(words, 12, "semibold")[0] / canvas.k
        middles = [(x + math.copysign(17.0 + 0.5 * wide, x), y) for x, y in knees]
        side = lines.clearest(at, (wide + 6.0, 20.0), middles, self._sides.get(color, 0))
        self._sides[color] = side
        dx, dy = knees[side]
        scale = canvas.px(1.0)
        knee = (at[0] + dx * scale, at[1] - dy * scale)
        end = (knee[0] + math.copysign(12.0, dx) * scale, knee[1])
        canvas.polyline(np.array((at, knee, end)), color, 1.2)
        anchor = "left" if dx > 0 else "right"
        canvas.label(end, words, color, 12, "semibold", anchor, (math.copysign(5.0, dx), 0.0), clear=True)
