"""Two outlines, the trees round them, and where these overlap."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.bounds import Nearest
from game.physics.bounds.query import OVERLAPPING, QueryRecord
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.physics.kernels.limits import LimitError
from game.physics.proximity_effects import COHERENCE, EXACT_ANSWER, SHAPE_MOTION
from game.scenes.bounds.pair import TreeOptions, TreePair
from game.scenes.bounds.parameters import BoundsParameters
from game.scenes.bounds.state import NO_RECORD, BoundsState, PackedShapes, outlines_of
from game.scenes.shared.outlines.board import Board, places_of, with_outlines, with_places
from game.scenes.shared.outlines.level import FARTHEST, OutlinesContent, array_of, content_of, outline_of
from game.scenes.shared.outlines.outline import Outline
from game.stage import Part
from game.stage.messages import Messages
from game.worlds.stopwatch import Stopwatch

GOLDEN = 0.5 * (1.0 + math.sqrt(5.0))  # of the two parts of the sway, so that it does not repeat soon


class BoundsModel(Part):
    """Outlines on a board, and two pairs of trees round them: those in play, and those counted beside.

    ``content`` says how it begins; ``second_kind``: of the trees beside, unless it is that in play.
    """

    def __init__(
        self, parameters: BoundsParameters, active: EffectSet, content: OutlinesContent, second_kind: str
    ):
        self.parameters, self.active = parameters, active
        self.content, self.second_kind = content, second_kind
        self.board = Board(tuple(outline_of(entry) for entry in content.outlines))
        self.clock = np.zeros(1)
        self.messages = Messages()
        self.packed = PackedShapes()
        self.watch, self.build_watch = Stopwatch(), Stopwatch(first=0)
        self.build_trees()

    @property
    def outlines(self) -> tuple[Outline, ...]:
        """A and B, as far as there are any."""
        return self.board.outlines

    @property
    def chosen(self) -> int:
        """The outline that is walked through: the chosen one, else A."""
        return max(self.board.chosen, 0) if self.board.chosen < len(self.outlines) else 0

    @property
    def coherent(self) -> bool:
        """Whether a query begins with the front of the last one; one that is walked through does not."""
        return COHERENCE in self.active and self.parameters.walked == "off"

    # -- trees and query ----------------------------------------------------------------------------

    def build_trees(self) -> None:
        """Trees as the parameters say, for the query in play and for those it is counted against."""
        parameters = self.parameters
        options = TreeOptions(
            parameters.volume, int(parameters.leaf_size), parameters.fit, parameters.angle_step,
            parameters.split,
        )  # fmt: skip
        second = self.second_kind if options.kind != self.second_kind else "aabb"
        if options.kind == "aabb":
            second = "obb"
        self.pair = TreePair(options)
        self.beside = TreePair(options._replace(kind=second))
        self.ask(coherent=False)

    def ask(self, coherent: bool) -> None:
        """Build what has changed, and ask the trees where they overlap."""
        if len(self.pair.trees) != len(self.outlines):
            coherent = False
        built = self.pair.is_stale(self.outlines)
        if built:
            with self.build_watch.time("build"):
                self.pair.take(self.outlines)
        with self.watch.time("query"):
            self.pair.ask(self.outlines, EXACT_ANSWER in self.active, coherent and not built)
        self.compare_trees()

    def compare_trees(self) -> None:
        """The same query with the other trees, from the roots, if that is asked for."""
        if not self.parameters.compare:
            return
        try:
            self.ask_beside()
        except LimitError:
            self.parameters.compare = False
            self.messages.say("The other trees overlap too often to be counted beside: switched off.")

    def ask_beside(self) -> None:
        """Ask the other trees, unless they have been; LimitError if they overlap too often to be kept."""
        self.beside.ask_if_moved(self.outlines, EXACT_ANSWER in self.active)

    def local_points(self, index: int) -> Floats:
        """Corners (n, 2) of an outline in its own frame, m."""
        if self.pair.options.kind != "aabb":
            return self.pair.trees[index].points
        return array_of(self.outlines[index])

    def gap(self) -> Nearest | None:
        """How far the outlines are apart."""
        return self.pair.distance(self.outlines)

    def marked(self, count: int | None = None) -> tuple[int, int, int]:
        """How many volumes are red, green and neither, after so many pairs of the query or all of them."""
        total = sum(len(tree) for tree in self.pair.trees)
        if self.pair.query is None:
            return 0, 0, total
        marks = np.concatenate(self.pair.query.marks(count))
        red = int(np.count_nonzero(marks == OVERLAPPING))
        green = int(np.count_nonzero(marks)) - red
        return red, green, total - red - green

    # -- a step -------------------------------------------------------------------------------------

    def drift(self, dt: float) -> None:
        """Both turn, and B sways to and fro, unless a hand is at work."""
        if SHAPE_MOTION not in self.active or self.board.held or self.board.drawn:
            return
        parameters = self.parameters
        before = 2.0 * math.pi * float(self.clock[0]) / parameters.period
        self.clock[0] += dt
        after = 2.0 * math.pi * float(self.clock[0]) / parameters.period
        places = places_of(self.board)
        for i, rate in zip(range(len(places)), (parameters.turn_a, parameters.turn_b), strict=False):
            places[i, 2] = math.remainder(places[i, 2] + math.radians(rate) * dt, 2.0 * math.pi)
        if len(places) == 2:
            places[1, 0] += parameters.sway * (elementary.cos(after) - elementary.cos(before))
            places[1, 1] += (
                0.4 * parameters.sway * (elementary.sin(GOLDEN * after) - elementary.sin(GOLDEN * before))
            )
        places[:, :2] = np.clip(places[:, :2], -FARTHEST, FARTHEST)  # where a level file has its end
        self.board = with_places(self.board, places)

    # -- what is remembered -------------------------------------------------------------------------

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on; the next query begins anew."""
        self.active = active
        self.ask(coherent=False)

    def state(self) -> BoundsState:
        """The outlines and the last query."""
        record = self.pair.query.record() if self.pair.query is not None else NO_RECORD
        packed, (rows, gaps, crossings, counts) = self.packed.of(self.outlines), record
        return BoundsState(places_of(self.board), self.clock, *packed, rows, gaps, crossings, counts)

    def restore(self, state: BoundsState) -> None:
        """Take over an earlier state."""
        self.board = with_outlines(self.board, outlines_of(state, self.outlines), remember=False)
        self.clock[:] = state.clock
        self.pair.take(self.outlines)
        self.pair.put_back(QueryRecord(*state[5:]))
        self.compare_trees()

    def to_content(self) -> OutlinesContent:
        """The outlines as a level has them."""
        return content_of(self.outlines, self.content.view)
