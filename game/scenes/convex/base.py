"""What the V-Clip and GJK scenes share: two convex polygons that are drawn, moved, turned and measured."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from time import perf_counter
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.levels import Level
from game.physics.narrowphase import ConvexPolygon, Feature, NonConvexError, Proximity, certify
from game.physics.narrowphase.batch import PolygonSet
from game.physics.proximity_effects import COHERENCE, EXACT_ANSWER, SHAPE_MOTION
from game.scenes.convex import hand
from game.scenes.convex.level import MOST_CORNERS, PairContent, ShapeEntry, board_of, entry_of
from game.scenes.convex.polygons import KeptPolygons, drifted, is_coin
from game.scenes.shared.outlines import editor
from game.scenes.shared.outlines.board import places_of, with_places
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
    Strip,
    Toggle,
    WarmUp,
)

Array = NDArray[np.float64]
REPEATS = 64  # queries that are timed together


class PairState(NamedTuple):
    """places, rates: (2, 3) unit, unit, rad of A and B, and per s. features: (2,) found last, and where from
    (2,); answer: (8,) distance, points and normal in units, steps of the query. counts: queries, steps.
    """

    places: Array
    rates: Array
    features: NDArray[np.int64]
    begun: NDArray[np.int64]
    answer: Array
    counts: NDArray[np.int64]


class ConvexPairScene(Scene):
    """Base of C10 and C11. A subclass says how the pair is measured and what of it is drawn."""

    effects = SHAPE_MOTION | COHERENCE | EXACT_ANSWER
    dt = 1.0 / 60.0
    content_type = PairContent
    takes: ClassVar[frozenset[str]] = frozenset()

    tool = Choice(
        "move", editor.TOOLS, labels=("Move", "Draw", "Corners"), group="Tools",
        help="drag and turn; click a new polygon; drag, add and take away corners",
    )  # fmt: skip
    start_a = Param(
        0, 0, 2 * MOST_CORNERS, whole=True, group="Query", label="Begin at, of A",
        help="feature without coherence: 2 i is vertex i, 2 i + 1 the edge after it",
    )  # fmt: skip
    start_b = Param(0, 0, 2 * MOST_CORNERS, whole=True, group="Query", label="Begin at, of B")
    numbers = Toggle(True, group="Shown", label="Numbers", help="of vertices, when they are few")

    hints = (
        Hint(("Drag",), "move"),
        Hint(("Shift", "Drag"), "turn"),
        Hint(("←", "→"), "walk through the query"),
        Hint(("H",), "take the hull"),
    )
    actions = (
        SceneAction("earlier", "step of the query before", "left"),
        SceneAction("later", "next step of the query", "right"),
        SceneAction("all", "all steps of the query", "up"),
        SceneAction("start", "begin at the next features", "s"),
        SceneAction("hull", "take the hull", "h"),
        SceneAction("move", "move", "1"),
        SceneAction("draw", "draw", "2"),
        SceneAction("points", "corners", "3"),
        SceneAction("turn-left", "turn left", "q"),
        SceneAction("turn-right", "turn right", "e"),
        SceneAction("close", "close the line", "return"),
        SceneAction("delete", "delete", "delete"),
        SceneAction("undo", "take back", "ctrl+z"),
        SceneAction("redo", "do again", "ctrl+y"),
    )
    strips = (
        Strip("Steps", "per query", ("steps",)),
        Strip("Distance", "m", ("distance",)),
        Strip("Query", "s", ("query",)),
    )
    default_content: ClassVar[PairContent] = PairContent(
        a=ShapeEntry(corners=7, radius=1.4, flat=0.75, position=(-1.8, 0.0), spin=9.0),
        b=ShapeEntry(corners=5, radius=1.2, position=(1.9, 0.1), spin=-24.0),
    )

    # -- how the pair is measured -------------------------------------------------------------------

    def measure(self, a: ConvexPolygon, b: ConvexPolygon, start: tuple[Feature, Feature]) -> Proximity:
        """The answer of the scene's method."""
        raise NotImplementedError

    def time_batch(self, shapes: PolygonSet, pairs: NDArray[np.int64], features: NDArray[np.int64]) -> None:
        """The same query for many pairs, to be timed."""
        raise NotImplementedError

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        self.content: PairContent = (
            level.content if level is not None and level.content is not None else self.default_content
        )
        self.board = board_of(self.content)
        self.rates = np.array(
            [(*entry.velocity, math.radians(entry.spin)) for entry in (self.content.a, self.content.b)]
        )
        self.features = np.array((self.start_a, self.start_b), dtype=np.int64)
        self.begun = self.features.copy()
        self.answer = np.zeros(8)
        self.counts = np.zeros(2, dtype=np.int64)
        self.shown = hand.WHOLE
        self.told: deque[str] = deque(maxlen=8)
        self.watch = Stopwatch()
        self.polygons = KeptPolygons(self.content.scale, self.content.origin)
        self.query(fresh=True)

    def shape(self, index: int) -> ConvexPolygon | None:
        """A polygon in the world, m; None if its outline is refused, or was deleted."""
        if index >= len(self.board.outlines):
            return None
        return self.polygons.in_world(index, self.board.outlines[index])

    def drawn_corners(self, index: int) -> Array:
        """Corners (n, 2) of an outline in the level's unit: those that count, or all if it is refused."""
        return self.polygons.corners(self.board.outlines[index])

    def refusal(self, index: int) -> NonConvexError | None:
        """Why an outline is refused; None if it is convex."""
        found = self.polygons.found(self.board.outlines[index])
        return found if isinstance(found, NonConvexError) else None

    # -- the query ----------------------------------------------------------------------------------

    def starts(self) -> tuple[int, int]:
        """The chosen features where a query without coherence begins."""
        limits = [max(2 * len(shape), 1) if (shape := self.shape(k)) else 1 for k in (0, 1)]
        return int(self.start_a) % limits[0], int(self.start_b) % limits[1]

    def query(self, fresh: bool = False) -> None:
        """Measure the pair as it is now. fresh: not from the last answer."""
        if len(self.board.outlines) < 2:
            return
        a, b = self.shape(0), self.shape(1)
        if a is None or b is None:
            return
        coherent = COHERENCE in self.active and not fresh
        self.begun[:] = self.features if coherent else self.starts()
        found = self.measure(a, b, self.start_features(a, b))
        self.features[:] = found.feature_a.code, found.feature_b.code
        scale, origin = self.content.scale, self.content.origin
        points = [
            value / scale - origin[k] for point in (found.point_a, found.point_b)
            for k, value in enumerate(point)
        ]  # fmt: skip
        self.answer[:] = (found.distance, *points, *found.normal, found.iterations)
        self.counts += (1, found.iterations)

    def start_features(self, a: ConvexPolygon, b: ConvexPolygon) -> tuple[Feature, Feature]:
        """Where the last query began, as features that these polygons have."""
        first, second = (int(code) for code in self.begun)
        return Feature.of(first % (2 * len(a))), Feature.of(second % (2 * len(b)))

    @property
    def ready(self) -> bool:
        """True if there is a pair to measure."""
        return len(self.board.outlines) == 2 and self.shape(0) is not None and self.shape(1) is not None

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> PairState:
        places = places_of(self.board)
        if len(places) < 2:
            places = np.vstack((places, np.zeros((2 - len(places), 3))))
        return PairState(places, self.rates, self.features, self.begun, self.answer, self.counts)

    def restore(self, state: PairState) -> None:
        count = len(self.board.outlines)
        self.board = with_places(self.board, state.places[:count])
        for array, then in (
            (self.rates, state.rates),
            (self.features, state.features),
            (self.begun, state.begun),
            (self.answer, state.answer),
            (self.counts, state.counts),
        ):
            np.copyto(array, then)

    def save_content(self) -> PairContent | None:
        if len(self.board.outlines) < 2:
            return None
        entries = [
            entry_of(outline, (float(x), float(y)), math.degrees(spin))
            for outline, (x, y, spin) in zip(self.board.outlines, self.rates.tolist(), strict=True)
        ]
        return PairContent(
            a=entries[0], b=entries[1], scale=self.content.scale, origin=self.content.origin,
            view=self.content.view,
        )  # fmt: skip

    # -- a step -------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if SHAPE_MOTION in self.active:
            self.board = drifted(self.board, self.rates, self.content.view, dt)
        self.query()

    def pointer(self, event: Pointer) -> None:
        hand.take_pointer(self, event)

    def action(self, name: str) -> None:
        hand.act(self, name)

    def trace_length(self) -> int:
        """Steps of the last query that can be shown."""
        raise NotImplementedError

    def parameter_changed(self, name: str) -> None:
        if name in ("start_a", "start_b"):
            self.query(fresh=True)
        elif name == "tool":
            hand.act(self, "cancel")
        else:
            self.query()

    def effects_changed(self) -> None:
        self.query(fresh=COHERENCE not in self.active)

    def messages(self) -> Sequence[str]:
        new = tuple(self.told)
        self.told.clear()
        return new

    # -- what there is to see -----------------------------------------------------------------------

    def readouts(self) -> list[Readout]:
        distance, steps = (
            (float(self.answer[0]), float(self.answer[7])) if self.ready else (math.nan, math.nan)
        )
        queries, total = (int(count) for count in self.counts)
        rows = [
            Readout("distance", distance, "m"),
            Readout("steps", steps),
            Readout("query", self.query_time(), "s"),
            Readout("mean steps", total / max(queries, 1)),
        ]
        if self.ready:
            rows.append(Readout("certificate lacks", self.certificate()))
        return rows

    def standing(self) -> dict[str, float]:
        """corners: of the polygon that has more, 0 without two of them; turn: of one against the other in a
        step, rad; round: 1 if both are regular, of as many corners, in circles of 1 m, else 0.
        """
        a, b = self.shape(0), self.shape(1)
        turn = abs(float(self.rates[0, 2] - self.rates[1, 2])) * self.dt
        if a is None or b is None:
            return {"corners": 0.0, "turn": turn, "round": 0.0}
        alike = len(a) == len(b) and is_coin(a) and is_coin(b)
        return {"corners": float(max(len(a), len(b))), "turn": turn, "round": float(alike)}

    def certificate(self) -> float:
        """What the optimality certificate of the last answer lacks, in extents; infinite if it fails."""
        a, b = self.shape(0), self.shape(1)
        if a is None or b is None:
            return 0.0
        try:
            return certify(a, b, self.present())
        except ValueError:
            return math.inf

    def present(self) -> Proximity:
        """The last answer."""
        scale, origin = self.content.scale, self.content.origin
        row = self.answer.tolist()
        point_a, point_b = (((row[k] + origin[0]) * scale, (row[k + 1] + origin[1]) * scale) for k in (1, 3))
        first, second = (Feature.of(int(code)) for code in self.features)
        return Proximity(row[0], point_a, point_b, first, second, int(row[7]), (row[5], row[6]))

    def query_time(self) -> float:
        """Time of a query as a batch has it, s: for the picture alone."""
        a, b = self.shape(0), self.shape(1)
        if len(self.board.outlines) < 2 or a is None or b is None:
            return math.nan
        shapes = PolygonSet((a, b))
        pairs = np.tile(np.array((0, 1), dtype=np.int64), (REPEATS, 1))
        features = np.tile(self.begun, (REPEATS, 1))
        began = perf_counter()
        self.time_batch(shapes, pairs, features)
        self.watch.add("query", (perf_counter() - began) / REPEATS)
        return self.watch.median("query")

    def frame(self) -> Frame:
        view = self.content.view
        return Frame(view.left, view.bottom, view.right, view.top)

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        corners = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
        return (
            WarmUp("outlines", lambda: ConvexPolygon(corners)),
            WarmUp("query", lambda: cls().advance(cls.dt)),
            WarmUp("many queries", lambda: cls().readouts()),
        )
