"""What a scene of bounding-volume trees remembers, as arrays: outlines, their places, the last query."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.bounds.query import QueryRecord
from game.scenes.shared.outlines.level import array_of
from game.scenes.shared.outlines.outline import Outline

NO_RECORD = QueryRecord(
    np.zeros((0, 5), dtype=np.int32), np.zeros((0, 3)), np.zeros((0, 2), dtype=np.int64),
    np.zeros(5, dtype=np.int64),
)  # fmt: skip


class BoundsState(NamedTuple):
    """Outlines, where they are, and the last query.

    places (k, 3) m, m, rad; clock (1,) s of own motion; points (n, 2) m of all outlines, starts (k + 1,),
    closed (k,); rows, gaps, crossings, counts: see `QueryRecord`.
    """

    places: Floats
    clock: Floats
    points: Floats
    starts: NDArray[np.int64]
    closed: NDArray[np.int64]
    rows: NDArray[np.int32]
    gaps: Floats
    crossings: NDArray[np.int64]
    counts: NDArray[np.int64]


class PackedShapes:
    """The corners of all outlines in arrays, packed again only when an outline has others."""

    def __init__(self) -> None:
        self._points: list[object] = [None]
        self._arrays: tuple[Floats, NDArray[np.int64], NDArray[np.int64]]

    def of(self, outlines: Sequence[Outline]) -> tuple[Floats, NDArray[np.int64], NDArray[np.int64]]:
        """Corners (n, 2) m, where each outline starts (k + 1,), whether it is closed (k,)."""
        points: list[object] = [outline.points for outline in outlines]
        if len(points) != len(self._points) or any(
            a is not b for a, b in zip(points, self._points, strict=True)
        ):
            arrays = [array_of(outline) for outline in outlines]
            starts = np.cumsum([0, *(len(array) for array in arrays)], dtype=np.int64)
            closed = np.array([outline.closed for outline in outlines], dtype=np.int64)
            self._arrays = (np.concatenate(arrays) if arrays else np.zeros((0, 2)), starts, closed)
            self._points = points
        return self._arrays


def outlines_of(state: BoundsState, before: Sequence[Outline]) -> tuple[Outline, ...]:
    """The outlines of a state; those that are as ``before`` share its points, so that trees are kept."""
    outlines = []
    for i, (x, y, angle) in enumerate(state.places.tolist()):
        points = state.points[state.starts[i] : state.starts[i + 1]]
        own: Any = tuple(map(tuple, points.tolist()))
        if i < len(before) and before[i].points == own:
            own = before[i].points
        outlines.append(Outline(own, bool(state.closed[i]), (x, y), angle))
    return tuple(outlines)
