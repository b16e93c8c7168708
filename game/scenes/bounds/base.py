"""What the two scenes of bounding-volume trees share: two outlines, their trees, the query, the hand."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from game.levels import Level
from game.physics.bounds import FITS, KINDS, SPLITS, Nearest
from game.physics.bounds.query import OVERLAPPING, QueryRecord
from game.physics.kernels.limits import LimitError
from game.physics.proximity_effects import COHERENCE, EXACT_ANSWER, SHAPE_MOTION
from game.scenes.bounds import hand, view, walk
from game.scenes.bounds.pair import Pane, TreeOptions, TreePair
from game.scenes.bounds.state import NO_RECORD, BoundsState, PackedShapes, outlines_of
from game.scenes.shared.outlines import editor
from game.scenes.shared.outlines.board import Board, places_of, with_outlines, with_places
from game.scenes.shared.outlines.level import (
    FARTHEST,
    CoastEntry,
    OutlinesContent,
    array_of,
    content_of,
    outline_of,
)
from game.scenes.shared.outlines.outline import Outline
from game.scenes.shared.stopwatch import Stopwatch
from game.stage import (
    Choice,
    Frame,
    Hint,
    Param,
    Pointer,
    Readout,
    Scene,
    SceneAction,
    Toggle,
    WarmUp,
)

Array = NDArray[np.float64]
GOLDEN = 0.5 * (1.0 + math.sqrt(5.0))  # of the two parts of the sway, so that it does not repeat soon
BESIDE = {"obb": "with boxes", "capsule": "with capsules", "aabb": "upright"}  # tests of the other trees
TREE_PARAMETERS = ("volume", "fit", "angle_step", "leaf_size", "split")


class BoundsScene(Scene):
    """Base of C08 and C09."""

    effects = SHAPE_MOTION | COHERENCE | EXACT_ANSWER
    dt = 1.0 / 60.0
    content_type = OutlinesContent
    second_kind: ClassVar[str] = "aabb"  # of the trees that are counted beside

    volume = Choice(
        "obb", KINDS, labels=("Boxes", "Capsules", "Upright"), group="Volumes",
        help="oriented boxes, capsules, or boxes that stay upright",
    )  # fmt: skip
    fit = Choice(
        "search", FITS, labels=("Degrees", "Refined", "Thinnest", "Exact"), group="Volumes",
        help="by angle steps; improved by golden section; of least breadth, or radius; of least area, "
        "capsules to 0.1 %",
    )  # fmt: skip
    angle_step = Param(
        1.0, 0.1, 45.0, unit="°", log=True, group="Volumes", label="Angle step",
        help="the axes are turned by so much from trial to trial",
    )  # fmt: skip
    leaf_size = Param(
        4, 1, 64, whole=True, log=True, group="Volumes", label="Segments in a leaf", help="at most"
    )
    split = Choice(
        "half", SPLITS, labels=("Half", "Median", "Perimeter"), group="Volumes", label="Halved",
        help="in the middle of the volume; of the segments; or where perimeters times segments are least",
    )  # fmt: skip
    deepest = Param(
        6, 0, 24, whole=True, group="Shown", label="Deepest level", help="of the hierarchy in grey and green"
    )
    hierarchy = Toggle(True, group="Shown", label="Whole hierarchy in grey")
    ancestors = Toggle(True, group="Shown", label="Ancestors in green")
    axes = Toggle(False, group="Shown", label="Separating axes", help="what keeps volumes apart")
    compare = Toggle(True, group="Shown", label="Count beside", help="the same query with other trees")
    walked = Choice(
        "off", walk.WALKS, labels=("Off", "Fit", "Build", "Query"), group="Walk", label="Walk through",
        help="step by step through the method; it stands until the arrow keys go on, or it plays",
    )  # fmt: skip
    playing = Toggle(False, group="Walk", label="Play the walk", help="to its end, then it stands")
    pace = Param(
        3.5,
        0.5,
        60.0,
        unit="1/s",
        log=True,
        group="Walk",
        label="Steps a second",
        help="of the walk, while it plays",
    )
    node = Param(
        0, 0, 8191, whole=True, group="Walk", label="Fit of node", help="0 is the root of the chosen outline"
    )
    sway = Param(0.9, 0.0, 10.0, unit="m", group="Motion", help="how far B drifts to and fro")
    period = Param(14.0, 1.0, 100.0, unit="s", log=True, group="Motion")
    turn_a = Param(0.0, -90.0, 90.0, unit="°/s", group="Motion", label="A turns")
    turn_b = Param(0.0, -90.0, 90.0, unit="°/s", group="Motion", label="B turns")
    tool = Choice(
        "move", editor.TOOLS, labels=("Move", "Draw", "Points"), group="Tools",
        help="what the left button does: drag whole outlines, click a new one, drag corners",
    )  # fmt: skip

    hints = (
        Hint(("Drag",), "move"),
        Hint(("Shift", "Drag"), "turn"),
        Hint(("2",), "draw a line"),
        Hint(("W",), "walk"),
        Hint(("←", "→"), "walk back, on"),
        Hint(("G",), "play the walk"),
        Hint(("B",), "from its start"),
        Hint(("↑", "↓"), "level up, down"),
        Hint(("H",), "hierarchy"),
    )
    actions = (
        SceneAction("move", "move outlines", "1"),
        SceneAction("draw", "draw an outline", "2"),
        SceneAction("points", "move corners", "3"),
        SceneAction("close", "close what is drawn", "c"),
        SceneAction("finish", "end what is drawn, open", "return"),
        SceneAction("delete", "delete", "delete"),
        SceneAction("undo", "undo", "ctrl+z"),
        SceneAction("redo", "do again", "ctrl+y"),
        SceneAction("hierarchy", "hierarchy in grey", "h"),
        SceneAction("level-up", "level up", "up"),
        SceneAction("level-down", "level down", "down"),
        SceneAction("walk", "walk through fit, build, query", "w"),
        SceneAction("walk-on", "walk on", "right"),
        SceneAction("walk-back", "walk back", "left"),
        SceneAction("walk-play", "play the walk, or stop it", "g"),
        SceneAction("walk-start", "walk from the start", "b"),
    )
    default_content: ClassVar[OutlinesContent] = OutlinesContent(
        outlines=(
            CoastEntry(seed=5, segments=120, position=(-2.0, 0.0)),
            CoastEntry(seed=8, segments=128, position=(2.0, 0.0)),
        )
    )

    # -- building -----------------------------------------------------------------------------------

    def options(self) -> TreeOptions:
        """How the trees in play are built."""
        return TreeOptions(self.volume, int(self.leaf_size), self.fit, self.angle_step, self.split)

    def build(self, level: Level | None) -> None:
        self.content: OutlinesContent = (
            level.content if level is not None and level.content is not None else self.default_content
        )
        self.board = Board(tuple(outline_of(entry) for entry in self.content.outlines))
        self.clock = np.zeros(1)
        self.cursor, self.beat = 0, 0.0  # steps of the walk made, and what there is of the next one
        self.told: deque[str] = deque(maxlen=8)
        self.packed = PackedShapes()
        self.watch, self.build_watch = Stopwatch(), Stopwatch(first=0)
        self.view = view.BoundsView()
        self._make_pairs()
        self.ask(coherent=False)

    def _make_pairs(self) -> None:
        """Trees for the query in play, and those it is counted against."""
        self.pair = TreePair(self.options())
        second = self.second_kind if self.options().kind != self.second_kind else "aabb"
        if self.options().kind == "aabb":
            second = "obb"
        self.beside = TreePair(self.options()._replace(kind=second))

    @property
    def outlines(self) -> tuple[Outline, ...]:
        """A and B, as far as there are any."""
        return self.board.outlines

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
        """The same query with the other trees, from the roots, if it is wanted."""
        if not self.compare:
            return
        try:
            self.beside.ask_if_moved(self.outlines, EXACT_ANSWER in self.active)
        except LimitError:
            self.values["compare"] = False
            self.told.append("The other trees overlap too often to be counted beside: switched off.")

    @property
    def coherent(self) -> bool:
        """Whether a query begins with the front of the last one; one that is walked through does not."""
        return COHERENCE in self.active and self.walked == "off"

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> BoundsState:
        record = self.pair.query.record() if self.pair.query is not None else NO_RECORD
        places, packed = places_of(self.board), self.packed.of(self.outlines)
        rows, gaps, crossings, counts = record
        return BoundsState(places, self.clock, *packed, rows, gaps, crossings, counts)

    def restore(self, state: BoundsState) -> None:
        self.board = with_outlines(self.board, outlines_of(state, self.outlines), remember=False)
        self.clock[:] = state.clock
        self.pair.take(self.outlines)
        self.pair.put_back(QueryRecord(*state[5:]))
        self.compare_trees()

    def save_content(self) -> OutlinesContent:
        return content_of(self.outlines, self.content.view)

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self.walked != "off":
            walk.play(self, dt)
        elif SHAPE_MOTION in self.active and not self.board.held and not self.board.drawn:
            self._drift(dt)
        self.ask(self.coherent)

    def _drift(self, dt: float) -> None:
        """Both turn, and B sways to and fro."""
        before = 2.0 * math.pi * float(self.clock[0]) / self.period
        self.clock[0] += dt
        after = 2.0 * math.pi * float(self.clock[0]) / self.period
        places = places_of(self.board)
        for i, rate in zip(range(len(places)), (self.turn_a, self.turn_b), strict=False):
            places[i, 2] = math.remainder(places[i, 2] + math.radians(rate) * dt, 2.0 * math.pi)
        if len(places) == 2:
            places[1, 0] += self.sway * (math.cos(after) - math.cos(before))
            places[1, 1] += 0.4 * self.sway * (math.sin(GOLDEN * after) - math.sin(GOLDEN * before))
        places[:, :2] = np.clip(places[:, :2], -FARTHEST, FARTHEST)  # where a level file has its end
        self.board = with_places(self.board, places)

    # -- the hand -----------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        hand.take_pointer(self, event)

    def action(self, name: str) -> None:
        hand.act(self, name)

    def parameter_changed(self, name: str) -> None:
        if name in TREE_PARAMETERS:
            self._make_pairs()
            self.ask(coherent=False)
            self.cursor = min(self.cursor, walk.length_of(self))
        elif name in ("walked", "node"):
            walk.stand_at(self, 0)
            self.ask(self.coherent)
        elif name == "playing" and self.cursor >= walk.length_of(self):
            self.cursor = 0
        elif name == "tool":
            hand.act(self, "cancel")
        elif name == "compare":
            self.compare_trees()

    def effects_changed(self) -> None:
        self.ask(coherent=False)

    # -- what is shown ------------------------------------------------------------------------------

    def panes(self) -> list[Pane]:
        """The parts of the picture."""
        return [Pane(self.pair)]

    def local_points(self, index: int) -> Array:
        """Corners (n, 2) of an outline in its own frame, m."""
        if self.pair.options.kind != "aabb":
            return self.pair.trees[index].points
        return array_of(self.outlines[index])

    @property
    def chosen(self) -> int:
        """The outline that is walked through: the chosen one, else A."""
        return max(self.board.chosen, 0) if self.board.chosen < len(self.outlines) else 0

    def gap(self) -> Nearest | None:
        """How far the outlines are apart."""
        return self.pair.distance(self.outlines)

    def marked(self) -> tuple[int, int, int]:
        """How many volumes are red, green and neither; so far, if the query is walked through."""
        total = sum(len(tree) for tree in self.pair.trees)
        if self.pair.query is None:
            return 0, 0, total
        marks = np.concatenate(self.pair.query.marks(self.cursor if self.walked == "query" else None))
        red = int(np.count_nonzero(marks == OVERLAPPING))
        green = int(np.count_nonzero(marks)) - red
        return red, green, total - red - green

    def readouts(self) -> list[Readout]:
        query, gap = self.pair.query, self.gap()
        beside = self.beside.query if self.compare else None
        kind = self.beside.options.kind
        return [
            Readout("tests", query.volume_tests if query else 0),
            Readout("crossings", query.crossing_count if query else 0),
            Readout("query", self.watch.median("query"), "s"),
            Readout("gap", gap.distance if gap is not None else math.nan, "m"),
            Readout("volumes", sum(len(tree) for tree in self.pair.trees)),
            Readout("leaf pairs", query.leaves_met if query else 0),
            Readout("segment tests", query.segment_tests if query else 0),
            *([Readout(BESIDE[kind], beside.volume_tests)] if beside else []),
            Readout("area above exact", walk.excess_of(self)),
            Readout("building", self.build_watch.median("build"), "s"),
        ]

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend(self)

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    def frame(self) -> Frame:
        seen = self.content.view
        return Frame(seen.left, seen.bottom, seen.right, seen.top)

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(self, canvas, alpha)

    def check(self) -> None:
        """AssertionError if trees or query are not what they have to be."""
        self.pair.check()

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("bounding volumes", lambda: walk.warm_up("build")),
            WarmUp("two trees", lambda: walk.warm_up("query")),
            WarmUp("distance", lambda: walk.warm_up("nearest")),
            WarmUp("picture", view.warm_up),
        ]
