"""One pair at a time: `vclip`, `gjk`, `sat`, and their traces."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.narrowphase import epa as epa_kernels
from game.physics.narrowphase import gjk as gjk_kernels
from game.physics.narrowphase import vclip as vclip_kernels
from game.physics.narrowphase.convex import ConvexPolygon, as_polygon
from game.physics.narrowphase.features import Feature
from game.physics.narrowphase.gjk import METHODS
from game.physics.narrowphase.proximity import Proximity, certify
from game.physics.narrowphase.separating_axis import overlap_query
from game.physics.narrowphase.vclip import vclip_query

Start = Proximity | tuple[Feature, Feature] | None


def vclip(
    a: Any, b: Any, start: Start = None, deep: bool = True, trace: Floats = vclip_kernels.NO_TRACE
) -> Proximity:
    """Distance, closest points and features of two convex polygons by V-Clip (Mirtich 1998).

    a, b: `ConvexPolygon` or points (n, 2) m; errors as there. start: the last answer, or two features,
    from which the walk begins. ``iterations`` counts the steps of the walk. deep: whether the depth of an
    overlap is measured; else the distance is 0 and the normal (0, 0). trace: rows to write, see
    `vclip_trace`.
    """
    a, b = as_polygon(a), as_polygon(b)
    found, steps = vclip_query(_pair(a, b), *_codes(start), deep, trace)
    return checked(a, b, found, steps)


def gjk(
    a: Any,
    b: Any,
    start: Start = None,
    tolerance: float = gjk_kernels.TOLERANCE,
    method: str = "climb",
    limit: int = gjk_kernels.LIMIT,
    deep: bool = True,
    trace: Floats = gjk_kernels.NO_TRACE,
) -> Proximity:
    """Distance, closest points and features of two convex polygons by GJK.

    a, b: `ConvexPolygon` or points (n, 2) m; errors as there. start: the last answer, or two features,
    whose simplex the walk begins with. tolerance: relative, at which it may end before the exact answer.
    method: how support vertices are found, "climb" or "scan". deep: as for `vclip`. ValueError for
    others, and for a limit below 1.
    """
    _check_options("gjk", tolerance, method)
    if limit < 1:
        raise ValueError(f"gjk: limit must be at least 1, not {limit}")
    a, b = as_polygon(a), as_polygon(b)
    pair = _pair(a, b)
    search = (float(tolerance), int(limit), METHODS.index(method))
    found, steps = gjk_kernels.gjk_query(pair, _start(a, b, pair, start), search, deep, trace)
    if tolerance > gjk_kernels.TOLERANCE or limit < gjk_kernels.LIMIT:
        return _proximity(a, found, steps)
    return checked(a, b, found, steps)


def sat(a: Any, b: Any) -> Proximity:
    """The edge that separates two polygons best (separating axis).

    The depth is exact, but it knows no distance of two vertices: for polygons that are apart the distance is
    a lower bound.
    """
    a, b = as_polygon(a), as_polygon(b)
    found = overlap_query(_pair(a, b))
    return _proximity(a, found, len(a) + len(b))


def epa(
    a: Any,
    b: Any,
    start: Start = None,
    tolerance: float = gjk_kernels.TOLERANCE,
    method: str = "climb",
    deep: bool = True,
    trace: Floats = gjk_kernels.NO_TRACE,
    expansion: Floats = epa_kernels.NO_TRACE,
    first: NDArray[np.int64] = epa_kernels.NO_CORNERS,
) -> Proximity:
    """`gjk`, with the depth of an overlap by expanding a polygon (EPA) instead of looking at all edges.

    Arguments as for `gjk`. ``iterations`` counts the steps of both.
    """
    _check_options("epa", tolerance, method)
    a, b = as_polygon(a), as_polygon(b)
    pair = _pair(a, b)
    search = (float(tolerance), gjk_kernels.LIMIT, METHODS.index(method))
    capacity = len(a) + len(b) + 3
    polytope = (np.empty((capacity, 2), dtype=np.int64), np.empty(capacity))
    traces = (trace, expansion, first)
    found, steps, more = epa_kernels.epa_query(
        pair, _start(a, b, pair, start), search, deep, polytope, traces
    )
    if tolerance > gjk_kernels.TOLERANCE:
        return _proximity(a, found, steps + more)
    return checked(a, b, found, steps + more)


def _check_options(name: str, tolerance: float, method: str) -> None:
    if method not in METHODS:
        raise ValueError(f"{name}: method must be climb or scan, not {method!r}")
    if not 0.0 <= tolerance < 1.0:
        raise ValueError(f"{name}: tolerance must be from 0 to below 1, not {tolerance}")


class FeatureStep(NamedTuple):
    """A step of V-Clip: the features it stood on, and what it decided there (see ``VERDICTS``)."""

    feature_a: Feature
    feature_b: Feature
    verdict: str


VERDICTS = ("closest", "overlap", "repair A", "repair B", "moved A", "moved B", "circle")


def vclip_trace(
    a: Any, b: Any, start: Start = None, deep: bool = True
) -> tuple[Proximity, list[FeatureStep]]:
    """`vclip`, and the steps of its walk; the last of them stands on the answer or finds the overlap."""
    a, b = as_polygon(a), as_polygon(b)
    rows = np.empty((4 * (len(a) + len(b)) + 9, vclip_kernels.TRACE_WIDTH))
    rows[:, 2] = -1.0
    found = vclip(a, b, start, deep, rows)
    return found, [
        FeatureStep(Feature.of(int(i)), Feature.of(int(j)), VERDICTS[int(verdict)])
        for i, j, verdict in rows[rows[:, 2] >= 0.0].tolist()
    ]


class SimplexStep(NamedTuple):
    """A step of GJK.

    corners: one or two pairs (vertex of A, vertex of B) of the simplex; closest: v, its point closest to
    the origin, m; direction: unit vector from v to the origin; support: the pair farthest along it, and
    corner: that corner w of A - B; distance: \\|v\\|; bound: no point of A - B is nearer than that; kept:
    what becomes of
    the simplex ("done", "new", "first and new", "second and new", "inside").
    """

    corners: tuple[tuple[int, int], ...]
    closest: tuple[float, float]
    direction: tuple[float, float]
    support: tuple[int, int]
    corner: tuple[float, float]
    distance: float
    bound: float
    kept: str


KEPT = ("done", "new", "first and new", "second and new", "inside")


def gjk_trace(a: Any, b: Any, start: Start = None, **options: Any) -> tuple[Proximity, list[SimplexStep]]:
    """`gjk`, and its steps."""
    rows = np.full((gjk_kernels.LIMIT, gjk_kernels.TRACE_WIDTH), np.nan)
    found = gjk(a, b, start, trace=rows, **options)
    return found, _simplex_steps(rows)


def _simplex_steps(rows: Floats) -> list[SimplexStep]:
    steps = []
    for row in rows[np.isfinite(rows[:, 0])].tolist():
        corners = ((int(row[1]), int(row[2])), (int(row[3]), int(row[4])))
        steps.append(
            SimplexStep(
                corners[: int(row[0])],
                (row[7], row[8]),
                (row[5], row[6]),
                (int(row[9]), int(row[10])),
                (row[11], row[12]),
                row[13],
                row[14],
                KEPT[int(row[15])],
            )
        )
    return steps


class PolytopeStep(NamedTuple):
    """A step of EPA.

    corners: pairs (vertex of A, vertex of B) of the polygon, counterclockwise; edge: the place of the corner
    where its nearest edge begins; height: its distance from the origin, m; support: the pair farthest along
    its normal; grows: whether that lies beyond it, and is the next corner; dropped: corners before and behind
    the new one that then lie within the polygon, and are left out of the next.
    """

    corners: tuple[tuple[int, int], ...]
    edge: int
    height: float
    support: tuple[int, int]
    grows: bool
    dropped: tuple[int, int] = (0, 0)


def epa_trace(
    a: Any, b: Any, start: Start = None, **options: Any
) -> tuple[Proximity, list[SimplexStep], list[PolytopeStep]]:  # fmt: skip
    """`epa`, the steps of GJK, and then those of EPA."""
    a, b = as_polygon(a), as_polygon(b)
    rows = np.full((gjk_kernels.LIMIT, gjk_kernels.TRACE_WIDTH), np.nan)
    more = np.full((2 * (len(a) + len(b)) + 7, epa_kernels.TRACE_WIDTH), np.nan)
    first = np.full((3, 2), -1, dtype=np.int64)
    found = epa(a, b, start, trace=rows, expansion=more, first=first, **options)
    steps = _simplex_steps(rows)
    expansion: list[PolytopeStep] = []
    corners = [(i, j) for i, j in first.tolist() if i >= 0]
    for edge, height, i, j, grows, before, behind in more[np.isfinite(more[:, 0])].tolist():
        support, dropped = (int(i), int(j)), (int(before), int(behind))
        expansion.append(PolytopeStep(tuple(corners), int(edge), height, support, bool(grows), dropped))
        if grows:
            _break_edge(corners, int(edge), support, dropped)
    return found, steps, expansion


def _break_edge(
    corners: list[tuple[int, int]], edge: int, support: tuple[int, int], dropped: tuple[int, int]
) -> None:
    """Put a new corner behind the one where an edge begins; drop neighbours of it, as `break_edge` did."""
    corners.insert(edge + 1, support)
    new = edge + 1
    for side, count in ((1, dropped[1]), (-1, dropped[0])):
        for _ in range(count):
            place = (new + side) % len(corners)
            del corners[place]
            new -= place < new


def checked(a: ConvexPolygon, b: ConvexPolygon, found: Any, steps: int) -> Proximity:
    """The answer, certified in debug runs (not with python -O)."""
    answer = _proximity(a, found, steps)
    if __debug__ and len(a) + len(b) < 64:
        certify(a, b, answer)
    return answer


def _pair(a: ConvexPolygon, b: ConvexPolygon) -> tuple[Any, Any, Any]:
    """Two polygons where they lie, as the plain tuples of a `Pair`."""
    x, y = (b.anchor - a.anchor).tolist()
    return (a.local, 0, len(a)), (b.local, 0, len(b)), (1.0, 0.0, x, y)


def _start(a: ConvexPolygon, b: ConvexPolygon, pair: Any, start: Start) -> tuple[int, int, float, float]:
    """The plain tuple of a `gjk.Start` for a `_pair`."""
    x, y = (b.centre - a.centre).tolist()
    return *_codes(start), x + pair[2][2], y + pair[2][3]


def _codes(start: Start) -> tuple[int, int]:
    if start is None:
        return -1, -1
    pair = (start.feature_a, start.feature_b) if isinstance(start, Proximity) else start
    return pair[0].code, pair[1].code


def _proximity(a: ConvexPolygon, found: Any, steps: int) -> Proximity:
    distance, ax, ay, bx, by, nx, ny, feature_a, feature_b = found
    x, y = float(a.anchor[0]), float(a.anchor[1])
    if not math.isfinite(distance):
        raise ValueError("proximity: the polygons are too large or too far apart")
    return Proximity(
        distance, (ax + x, ay + y), (bx + x, by + y), Feature.of(feature_a), Feature.of(feature_b), steps,
        (nx, ny),
    )  # fmt: skip
