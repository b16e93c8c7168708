"""How outlines, their volumes and the query between them are drawn."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.bounds.building import middle_of
from game.physics.bounds.segments import nearest_points
from game.physics.proximity_effects import EXACT_ANSWER
from game.scenes.bounds import volumes, walk_view
from game.scenes.bounds.annotations import Annotations
from game.scenes.bounds.model import BoundsModel
from game.scenes.bounds.pair import Place, TreePair
from game.scenes.bounds.panes import Pane, Panes
from game.scenes.bounds.state import BoundsState
from game.scenes.bounds.volumes import Shown, VolumePainter
from game.scenes.bounds.walk import Walk
from game.scenes.bounds.walk_words import caption
from game.scenes.shared.outlines.board import NOBODY
from game.scenes.shared.outlines.drawn_lines import DrawnLines
from game.scenes.shared.outlines.outline import handle_of
from game.ui.canvas.canvas import Canvas

COLORS = ("text1", "chalk")  # of A and B
MOST_CORNERS = 400  # that are drawn as dots
ASIDE = ((0.0, 0.0), (0.0, -36.0), (0.0, 36.0), (-62.0, 0.0), (62.0, 0.0))  # design px, where names may stand
DRAW_FIRST = (
    "Click the corners of {}; end at the first one to close the line, or press Enter to leave it open."
)
DRAW_ON = (
    "Click on. The ringed corner closes the line, Enter leaves it open, Delete takes the last corner back."
)


class BoundsView:
    """Draws the scene; keeps the arrays that drawing needs."""

    def __init__(self, model: BoundsModel, walk: Walk, panes: Panes):
        self.model, self.walk = model, walk
        self._panes = panes
        self._volumes = VolumePainter()
        self._annotations = Annotations()
        self._names = [0, 0]  # where the names of A and B stand, of ASIDE

    # -- legend -------------------------------------------------------------------------------------

    def legend(self) -> list[tuple[str, str, str]]:
        """What the marks mean, with counts."""
        pair, parameters, cursor = self.model.pair, self.model.parameters, self.walk.cursor
        if parameters.walked == "fit":
            return walk_view.fit_legend()
        if parameters.walked == "build":
            return [
                ("box:amber", "volume being fitted", ""),
                ("box:ghost", "fitted so far", str(cursor)),
            ]
        names = {"obb": "boxes", "capsule": "capsules", "aabb": "axis-aligned boxes"}
        red, green, rest = self.model.marked(cursor if parameters.walked == "query" else None)
        rows = [("box:vermilion", f"overlapping {names[pair.options.kind]}", str(red))]
        if parameters.ancestors:
            rows.append(("dashed-box:green", "their ancestors", str(green)))
        if parameters.hierarchy:
            rows.append(("box:ghost", "rest of the hierarchy", str(rest)))
        query = pair.query
        if query is not None and query.crossing_count and not self.walk.under_way:
            rows.append(("disc:amber", "crossing of segments", str(query.crossing_count)))
        elif query is not None and not query.crossing_count:
            rows.append(("dash:text1", "least distance", ""))
        if parameters.walked == "query":
            total = query.row_count if query else 0
            rows.append(("box:amber", "pair being tested", f"{cursor} of {total}"))
        return rows

    # -- the whole ----------------------------------------------------------------------------------

    def draw(self, canvas: Canvas, before: BoundsState | None, alpha: float) -> None:
        """All of it, from the back to the front, ``alpha`` of the step after the state ``before``."""
        canvas.grid(None, "")
        now = self._places(before, alpha)
        for pane in self._panes():
            self._draw_pane(canvas, pane, [pane.place(place) for place in now])
        if self.model.parameters.walked != "off":
            walk_view.draw_caption(canvas, caption(self.walk))
        elif self.model.parameters.tool == "draw":
            count = len(self.model.outlines)
            first = DRAW_FIRST.format("AB"[count] if count < 2 else "a new outline")
            walk_view.draw_caption(canvas, DRAW_ON if self.model.board.drawn else first)

    def _draw_pane(self, canvas: Canvas, pane: Pane, places: list[Place]) -> None:
        """Outlines, volumes and hand in a part of the picture; ``places``: of the outlines there."""
        model, walked = self.model, self.model.parameters.walked
        drawn = []
        for i, outline in enumerate(model.outlines):
            points = places[i].to_world(model.local_points(i))
            aside = walked == "fit" and i != model.chosen  # the walk is through the other one
            self._draw_outline(canvas, points, outline.closed, "ghost" if aside else COLORS[i])
            drawn.append((points, outline.closed))
        lines = DrawnLines(canvas, drawn)
        tree_places = self._tree_places(pane.pair, places)
        if walked == "fit" and model.outlines:
            walk_view.draw_fit(self.walk, canvas, tree_places)
        elif walked == "build" and model.outlines:
            walk_view.draw_build(self.walk, canvas, tree_places, self._volumes)
        else:
            self._draw_query(canvas, lines, pane, tree_places)
        named = () if walked == "fit" else range(len(tree_places))
        self._draw_names(canvas, lines, pane.pair, tree_places, named)
        self._draw_hand(canvas, pane, places)
        if pane.title:
            self._draw_title(canvas, pane)

    def _draw_title(self, canvas: Canvas, pane: Pane) -> None:
        """What a pane shows, and what it costs."""
        seen = self.model.content.view
        at = pane.point((0.5 * (seen.left + seen.right), seen.bottom))
        canvas.label(at, pane.title, "text1", 15, "semibold", offset=(0.0, 14.0))
        query = pane.pair.query
        if query is not None:
            tests = "1 test" if query.volume_tests == 1 else f"{query.volume_tests} tests"
            pairs = "1 pair" if query.leaves_met == 1 else f"{query.leaves_met} pairs"
            words = f"{tests}, {pairs} of leaves"
            canvas.label(at, words, "text2", 12, offset=(0.0, 34.0))

    def _places(self, before: BoundsState | None, alpha: float) -> list[Place]:
        """Where the outlines are, between the last two steps."""
        now = [Place(*outline.position, outline.angle) for outline in self.model.outlines]
        if before is None or len(before.places) != len(now) or self.model.board.held:
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
        aligned = pair.options.kind == "aabb"
        return [place._replace(angle=0.0) if aligned else place for place in places]

    # -- outlines and hand --------------------------------------------------------------------------

    def _draw_outline(self, canvas: Canvas, points: Floats, closed: bool, color: str) -> None:
        if len(points) == 1:
            canvas.dot(points[0], 3.0, color)
            return
        if closed and len(points) > 2:
            canvas.polygon(points, fill=color, fill_alpha=0.07)
        canvas.polyline(points, color, 2.2, closed=closed and len(points) > 2)

    def _draw_names(
        self, canvas: Canvas, lines: DrawnLines, pair: TreePair, places: list[Place], named: Sequence[int]
    ) -> None:
        """A and B in the middle of their outlines, or beside thin ones; side by side if these coincide."""
        middles = []
        for tree, place in zip(pair.trees, places, strict=True):
            x, y, _, _ = middle_of(tree.kind_number, tree.volumes, 0)
            middles.append(place.to_world(np.array((x, y))).tolist())
        apart = 0.0
        if len(middles) == 2 and math.dist(*middles) < canvas.px(90.0):
            apart = 52.0
        for i in named:
            at, tree = middles[i], pair.trees[i]
            words = f"{tree.segments:,} segments".replace(",", "\u202f")
            if tree.segments == 1:
                words = "a point" if len(tree.points) == 1 else "1 segment"
            width = canvas.fonts.size(words, 12)[0] / canvas.k + 4.0
            offsets = [(x + apart * (2 * i - 1), y) for x, y in ASIDE]
            self._names[i] = lines.clearest(at, (width, 40.0), offsets, self._names[i])
            aside, down = canvas.room_for(at, (width, 40.0), offsets[self._names[i]])
            canvas.label(at, "AB"[i], COLORS[i], 22, "semibold", offset=(aside, down - 9.0))
            canvas.label(at, words, "text2", 12, offset=(aside, down + 11.0))

    def _draw_hand(self, canvas: Canvas, pane: Pane, places: list[Place]) -> None:
        model, board = self.model, self.model.board
        if board.chosen != NOBODY and board.chosen < len(places):
            moved = model.outlines[board.chosen]
            if model.parameters.tool == "points" and len(moved.points) <= MOST_CORNERS:
                corners = places[board.chosen].to_world(model.local_points(board.chosen))
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

    # -- volumes and what was found -----------------------------------------------------------------

    def _draw_query(self, canvas: Canvas, lines: DrawnLines, pane: Pane, places: list[Place]) -> None:
        pair, query, parameters = pane.pair, pane.pair.query, self.model.parameters
        count = self.walk.cursor if parameters.walked == "query" else None
        marks: Any = [np.zeros(len(tree), dtype=np.uint8) for tree in pair.trees]
        if query is not None:
            marks = query.marks(count)
        shown = Shown(parameters.hierarchy, parameters.ancestors, int(parameters.deepest))
        self._volumes.draw_volumes(canvas, pair, places, marks, shown)
        if query is None:
            return
        if parameters.walked == "query":
            walk_view.draw_pair(self.walk, canvas, places)
            return
        if parameters.axes:
            self._annotations.draw_axes(canvas, pair, places)
        if query.crossing_count:
            self._annotations.draw_crossings(canvas, lines, pair, places, not pane.title)
        elif (gap := self.model.gap()) is not None:
            self._annotations.draw_gap(canvas, lines, pane, gap)
        if EXACT_ANSWER in self.model.active and not pane.title:
            self._annotations.label_contact(canvas, lines, pair, places)


def warm_up() -> None:
    """Compile what drawing needs."""
    volumes.warm_up()
    nearest_points(0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0)
