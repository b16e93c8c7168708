"""Two shapes that overlap, and the shortest motions that part them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase.depth import Escape, ShapePair, preset
from game.scenes.depth.level import DepthContent, PlacedShape
from game.scenes.depth.parameters import DepthParameters
from game.stage import Part
from game.worlds.stopwatch import Stopwatch

OUT = 1e-9  # m: a shorter motion is rounding
NOTHING = (0.0,) * len(Escape._fields)
SLIDE, FOUND, CHECKED = range(3)


class DepthState(NamedTuple):
    """places: (2, 3) m, m, rad of A and B; answers: (3, 6) the motion without turning, the shortest one, and
    that of brute force (0 evaluations: none was asked for), see `Escape`."""

    places: Floats
    answers: Floats


class DepthModel(Part):
    """The shapes where they are, and what was found of them."""

    def __init__(self, content: DepthContent, parameters: DepthParameters):
        self.content, self.parameters = content, parameters
        self.moves = content.moves
        self.places = np.array([_place(content.a), _place(content.b)])
        self.answers = np.zeros((3, len(Escape._fields)))
        self.watch = Stopwatch(first=0)
        self._names = ("", "")
        self.pair = self._made()
        self.query()

    def _made(self) -> ShapePair:
        chosen, content = self.parameters, self.content
        self._names = (str(chosen.shape_a), str(chosen.shape_b))
        a, b = (
            preset(name, entry.size, entry.flat)
            for name, entry in zip(self._names, (content.a, content.b), strict=True)
        )
        return ShapePair(a, b)

    # -- changes --------------------------------------------------------------------------------------

    def change_shapes(self) -> None:
        """Take the shapes that are chosen, if they are others, where those before are."""
        if self._names != (self.parameters.shape_a, self.parameters.shape_b):
            self.pair = self._made()

    def query(self) -> None:
        """Find both motions for the shapes as they are."""
        self.change_shapes()
        self._settle()
        with self.watch.time("query"):
            found = self.pair.generalised(self.parameters.tolerance)
        self.answers[SLIDE] = self.pair.translational()
        self.answers[FOUND] = found
        self.answers[CHECKED] = NOTHING

    def _settle(self) -> None:
        a, b = ((x, y, turn) for x, y, turn in self.places.tolist())
        self.pair.place(a, b)

    def put(self, which: int, place: tuple[float, float, float]) -> None:
        """Put A (0) or B (1) somewhere, m, m, rad."""
        self.places[which] = place
        self.query()

    def check_by_grid(self) -> None:
        """Look for a shorter motion by brute force."""
        count = int(self.parameters.grid)
        self.answers[CHECKED] = self.pair.by_grid(count, count)

    def begin_again(self) -> None:
        """Put both where the level has them."""
        self.places[:] = _place(self.content.a), _place(self.content.b)
        self.moves = False
        self.query()

    # -- what was found -------------------------------------------------------------------------------

    @property
    def slide(self) -> Escape:
        """The shortest displacement."""
        return _escape(self.answers[SLIDE])

    @property
    def found(self) -> Escape:
        """The shortest motion."""
        return _escape(self.answers[FOUND])

    @property
    def checked(self) -> Escape | None:
        """What brute force found; None if it was not asked."""
        checked = _escape(self.answers[CHECKED])
        return checked if checked.evaluations else None

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """A moves a little along the shortest motion, which is then looked for again."""
        if not self.moves:
            return
        found = self.found
        if found.sigma <= OUT:
            self.moves = False
            return
        self.put(0, self.pair.moved(found, min(1.0, self.parameters.speed * dt / found.sigma)))

    def state(self) -> DepthState:
        """All that later steps depend on."""
        return DepthState(self.places, self.answers)

    def restore(self, state: DepthState) -> None:
        """Take over an earlier state."""
        np.copyto(self.places, state.places)
        np.copyto(self.answers, state.answers)
        self.change_shapes()
        self._settle()
        self.pair.generalised(self.parameters.tolerance)  # for its intervals, which are drawn

    def to_content(self) -> DepthContent:
        """The shapes where they are, as a level has them."""
        entries = zip(self.places.tolist(), (self.content.a, self.content.b), strict=True)
        a, b = (
            PlacedShape(
                position=(_within(x), _within(y)), turn=math.degrees(math.remainder(turn, math.tau)),
                size=entry.size, flat=entry.flat,
            )
            for (x, y, turn), entry in entries
        )  # fmt: skip
        return DepthContent(a=a, b=b, moves=self.moves)


def _within(value: float) -> float:
    return min(max(value, -3.0), 3.0)


def _place(entry: PlacedShape) -> tuple[float, float, float]:
    return *entry.position, math.radians(entry.turn)


def _escape(row: Floats) -> Escape:
    sigma, x, y, angle, certain, evaluations = row.tolist()
    return Escape(sigma, x, y, angle, certain, int(evaluations))
