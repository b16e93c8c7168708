"""Two convex polygons that are moved and turned, and the last query between them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.narrowphase import ConvexPolygon, Feature, NonConvexError, Proximity, certify
from game.physics.narrowphase.batch import PolygonSet
from game.physics.proximity_effects import COHERENCE, SHAPE_MOTION
from game.scenes.convex.level import PairContent, board_of, entry_of
from game.scenes.convex.model.polygons import KeptPolygons, drifted, is_coin
from game.scenes.convex.parameters import PairParameters
from game.scenes.shared.outlines.board import places_of, with_places
from game.stage import Part
from game.stage.messages import Messages


class PairState(NamedTuple):
    """places, rates: (2, 3) unit, unit, rad of A and B, and per s. features: (2,) found last, and where from
    (2,); answer: (8,) distance, points and normal in units, steps of the query. counts: queries, steps.
    """

    places: Floats
    rates: Floats
    features: NDArray[np.int64]
    begun: NDArray[np.int64]
    answer: Floats
    counts: NDArray[np.int64]


class PairModel(Part):
    """Outlines on a board, their polygons, and how near they are; a subclass says how that is measured.

    ``content`` says how it begins; ValueError if that makes no sense.
    """

    def __init__(self, parameters: PairParameters, active: EffectSet, content: PairContent):
        self.parameters, self.active = parameters, active
        self.content = content
        self.board = board_of(content)
        self.rates = np.array([(*e.velocity, math.radians(e.spin)) for e in (content.a, content.b)])
        self.features = np.array((parameters.start_a, parameters.start_b), dtype=np.int64)
        self.begun = self.features.copy()
        self.answer = np.zeros(8)
        self.counts = np.zeros(2, dtype=np.int64)
        self.messages = Messages()
        self.polygons = KeptPolygons(content.scale, content.origin)
        self.query(fresh=True)

    # -- how the pair is measured -------------------------------------------------------------------

    def measure(self, a: ConvexPolygon, b: ConvexPolygon, start: tuple[Feature, Feature]) -> Proximity:
        """The answer of the method."""
        raise NotImplementedError

    def measure_batch(
        self, shapes: PolygonSet, pairs: NDArray[np.int64], features: NDArray[np.int64]
    ) -> None:
        """The same query for many pairs, to be timed."""
        raise NotImplementedError

    def trace_length(self) -> int:
        """Steps of the last query that can be shown."""
        raise NotImplementedError

    # -- the polygons -------------------------------------------------------------------------------

    def shape(self, index: int) -> ConvexPolygon | None:
        """A polygon in the world, m; None if its outline is refused, or was deleted."""
        if index >= len(self.board.outlines):
            return None
        return self.polygons.in_world(index, self.board.outlines[index])

    def shapes(self) -> tuple[ConvexPolygon, ConvexPolygon] | None:
        """A and B in the world, m; None without two convex polygons."""
        a, b = self.shape(0), self.shape(1)
        return None if a is None or b is None else (a, b)

    @property
    def ready(self) -> bool:
        """True if there is a pair to measure."""
        return self.shapes() is not None

    def drawn_corners(self, index: int) -> Floats:
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
        return int(self.parameters.start_a) % limits[0], int(self.parameters.start_b) % limits[1]

    def query(self, fresh: bool = False) -> None:
        """Measure the pair as it is now. fresh: not from the last answer."""
        shapes = self.shapes()
        if shapes is None:
            return
        coherent = COHERENCE in self.active and not fresh
        self.begun[:] = self.features if coherent else self.starts()
        found = self.measure(*shapes, self.start_features(*shapes))
        self.features[:] = found.feature_a.code, found.feature_b.code
        scale, origin = self.content.scale, self.content.origin
        points = [
            value / scale - origin[k] for point in (found.point_a, found.point_b)
            for k, value in enumerate(point)
        ]  # fmt: skip
        self.answer[:] = (found.distance, *points, *found.normal, found.iterations)
        self.counts += (1, found.iterations)

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on; without coherence the next query begins anew."""
        self.active = active
        self.query(fresh=COHERENCE not in active)

    def start_features(self, a: ConvexPolygon, b: ConvexPolygon) -> tuple[Feature, Feature]:
        """Where the last query began, as features that these polygons have."""
        first, second = (int(code) for code in self.begun)
        return Feature.of(first % (2 * len(a))), Feature.of(second % (2 * len(b)))

    def present(self) -> Proximity:
        """The last answer."""
        scale, origin = self.content.scale, self.content.origin
        row = self.answer.tolist()
        point_a, point_b = (((row[k] + origin[0]) * scale, (row[k + 1] + origin[1]) * scale) for k in (1, 3))
        first, second = (Feature.of(int(code)) for code in self.features)
        return Proximity(row[0], point_a, point_b, first, second, int(row[7]), (row[5], row[6]))

    def certificate(self) -> float:
        """What the optimality certificate of the last answer lacks, in extents; infinite if it fails."""
        shapes = self.shapes()
        if shapes is None:
            return 0.0
        try:
            return certify(*shapes, self.present())
        except ValueError:
            return math.inf

    # -- a step, and what is remembered -------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """What is not held drifts on; then the pair is measured."""
        if SHAPE_MOTION in self.active:
            self.board = drifted(self.board, self.rates, self.content.view, dt)
        self.query()

    def state(self) -> PairState:
        """Where the polygons are, and the last answer."""
        places = places_of(self.board)
        if len(places) < 2:
            places = np.vstack((places, np.zeros((2 - len(places), 3))))
        return PairState(places, self.rates, self.features, self.begun, self.answer, self.counts)

    def restore(self, state: PairState) -> None:
        """Take over an earlier state."""
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

    def to_content(self) -> PairContent | None:
        """The polygons as a level has them; None without two."""
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

    def standing(self, dt: float) -> dict[str, float]:
        """corners: of the polygon that has more, 0 without two of them; turn: of one against the other in a
        step, rad; round: 1 if both are regular, of as many corners, in circles of 1 m, else 0.
        """
        shapes = self.shapes()
        turn = abs(float(self.rates[0, 2] - self.rates[1, 2])) * dt
        if shapes is None:
            return {"corners": 0.0, "turn": turn, "round": 0.0}
        a, b = shapes
        alike = len(a) == len(b) and is_coin(a) and is_coin(b)
        return {"corners": float(max(len(a), len(b))), "turn": turn, "round": float(alike)}
