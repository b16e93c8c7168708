"""Many pairs in one call: polygons packed in a row, poses, features kept from call to call.

Arrays of a set: vertices (N, 2) m, first (k + 1,), centres (k, 2) m, poses (k, 4): x, y, cos,
sin; pairs (m, 2).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.narrowphase.coarse import coarse_outlines, coarse_polygon, finer_feature, levels_of
from game.physics.narrowphase.convex import ConvexPolygon, as_polygon
from game.physics.narrowphase.features import Frame, Pair, Polygon, point_in, turned_back
from game.physics.narrowphase.gjk import LIMIT, METHODS, TOLERANCE, Start, gjk_query
from game.physics.narrowphase.simplex import support_scan
from game.physics.narrowphase.vclip import vclip_query

COLUMNS = 7  # distance, x and y of A's point, of B's point, of the normal


class PolygonSet:
    """Polygons packed into one array, for queries of many pairs.

    vertices: (N, 2) m, each polygon from its own anchor; first: (k + 1,) where each begins; anchors, centres:
    (k, 2) m. outlines: (M, 2) m, the coarse ones of all (see ``coarse``), a seventh of the vertices of large
    polygons; coarse: (k,) where those of each begin.
    """

    __slots__ = ("anchors", "centres", "coarse", "first", "outlines", "vertices")

    def __init__(self, shapes: Sequence[Any]) -> None:
        """ValueError, naming the shape, for what `ConvexPolygon` refuses, and for no shapes."""
        polygons: list[ConvexPolygon] = []
        for k, shape in enumerate(shapes):
            try:
                polygons.append(as_polygon(shape))
            except ValueError as error:
                raise ValueError(f"shapes[{k}]: {error}") from error
        if not polygons:
            raise ValueError("shapes: expected at least one")
        self.vertices = np.concatenate([polygon.local for polygon in polygons])
        self.first = np.cumsum([0, *map(len, polygons)])
        coarser = [coarse_outlines(polygon.local) for polygon in polygons]
        self.outlines = np.concatenate([np.empty((0, 2)), *chain.from_iterable(coarser)])
        self.coarse = np.cumsum([0, *(sum(map(len, own)) for own in coarser[:-1])])
        self.anchors = np.array([polygon.anchor for polygon in polygons])
        self.centres = np.array([polygon.centre for polygon in polygons])

    def __len__(self) -> int:
        return len(self.anchors)

    def side(self, poses: Floats) -> tuple[Floats, Longs, Floats, Longs, Floats, Floats, Floats]:
        """The plain tuple of a `Side`, with poses (k, 4)."""
        return self.vertices, self.first, self.outlines, self.coarse, self.anchors, self.centres, poses


class Proximities(NamedTuple):
    """Answers of a batch, a row for each pair; see `Proximity`. Feature 2 i is a vertex, 2 i + 1 an edge."""

    distance: Floats  # (m,) m
    point_a: Floats  # (m, 2) m
    point_b: Floats
    feature_a: Longs  # (m,)
    feature_b: Longs
    iterations: Longs
    normal: Floats  # (m, 2)


class Side(NamedTuple):
    """The polygons of one side of a batch, as kernels take them; see `PolygonSet`."""

    vertices: Floats  # (N, 2) m
    first: Longs  # (k + 1,)
    outlines: Floats  # (M, 2) m
    coarse: Longs  # (k,)
    anchors: Floats  # (k, 2) m
    centres: Floats  # (k, 2) m
    poses: Floats  # (k, 4) x, y, cos, sin


class Answers(NamedTuple):
    """Where kernels write what they found, a row for each pair."""

    numbers: Floats  # (m, COLUMNS)
    features: Longs  # (m, 2) where to begin (or -1), then what was found
    iterations: Longs  # (m,)


@inner_kernel
def relative_pair(a, k, b, m):
    """Polygons k and m of two sides as a `Pair`."""
    px, py, pc, ps = a.poses[k, 0], a.poses[k, 1], a.poses[k, 2], a.poses[k, 3]
    qx, qy, qc, qs = b.poses[m, 0], b.poses[m, 1], b.poses[m, 2], b.poses[m, 3]
    bx, by = b.anchors[m, 0], b.anchors[m, 1]
    dx, dy = qc * bx - qs * by + qx - px, qs * bx + qc * by + qy - py
    frame = Frame(
        pc * qc + ps * qs,
        pc * qs - ps * qc,
        pc * dx + ps * dy - a.anchors[k, 0],
        pc * dy - ps * dx - a.anchors[k, 1],
    )
    first = Polygon(a.vertices, a.first[k], a.first[k + 1] - a.first[k])
    second = Polygon(b.vertices, b.first[m], b.first[m + 1] - b.first[m])
    return Pair(first, second, frame)


@inner_kernel
def write_answer(found, steps, a, k, answers, row):
    """Write what was found, taken from the frame of polygon k of A into the world."""
    distance, ax, ay, bx, by, nx, ny, feature_a, feature_b = found
    numbers, features, iterations = answers
    px, py, pc, ps = a.poses[k, 0], a.poses[k, 1], a.poses[k, 2], a.poses[k, 3]
    x, y = a.anchors[k, 0], a.anchors[k, 1]
    ax, ay, bx, by = ax + x, ay + y, bx + x, by + y
    numbers[row, 0] = distance
    numbers[row, 1], numbers[row, 2] = pc * ax - ps * ay + px, ps * ax + pc * ay + py
    numbers[row, 3], numbers[row, 4] = pc * bx - ps * by + px, ps * bx + pc * by + py
    numbers[row, 5], numbers[row, 6] = pc * nx - ps * ny, ps * nx + pc * ny
    features[row, 0], features[row, 1] = feature_a, feature_b
    iterations[row] = steps


@lean_kernel
def gjk_many(a, b, pairs, search, deep, trace, answers):
    """GJK for each pair (m, 2) of polygons of two sides; sides, search and answers in plain tuples."""
    a, b = Side(*a), Side(*b)
    answers = Answers(*answers)
    for row in range(pairs.shape[0]):
        k, m = pairs[row, 0], pairs[row, 1]
        pair = relative_pair(a, k, b, m)
        x, y = point_in(pair.frame, b.centres[m, 0], b.centres[m, 1])
        start = Start(
            answers.features[row, 0], answers.features[row, 1], x - a.centres[k, 0], y - a.centres[k, 1]
        )
        found, steps = gjk_query(pair, start, search, deep, trace)
        write_answer(found, steps, a, k, answers, row)


@inner_kernel
def coarse_start(a, k, b, m, pair, level, trace):
    """Features of a pair where a walk without a last answer begins: (of A, of B, steps made to find them).

    On the outlines of ``level``, the coarsest, the vertices farthest towards the other polygon's centre.
    From there V-Clip on them, then on finer ones, each from where the coarser were closest: a few steps on
    each of log n outlines. From the first vertices, where that of two small polygons begins, the walk would
    pass n / 2 others.
    """
    x, y = point_in(pair.frame, b.centres[m, 0], b.centres[m, 1])
    x, y = x - a.centres[k, 0], y - a.centres[k, 1]
    feature_a = 2 * support_scan(coarse_polygon(a, k, level), x, y)
    x, y = turned_back(pair.frame, -x, -y)
    feature_b = 2 * support_scan(coarse_polygon(b, m, level), x, y)
    steps = 0
    while level > 0:
        outlines = Pair(coarse_polygon(a, k, level), coarse_polygon(b, m, level), pair.frame)
        found, more = vclip_query(outlines, feature_a, feature_b, False, trace)
        steps += more
        level -= 1
        feature_a = finer_feature(found[7], outlines.a.size, coarse_polygon(a, k, level).size)
        feature_b = finer_feature(found[8], outlines.b.size, coarse_polygon(b, m, level).size)
    return feature_a, feature_b, steps


@lean_kernel
def vclip_many(a, b, pairs, deep, trace, answers):
    """V-Clip for each pair (m, 2) of polygons of two sides; sides and answers in plain tuples."""
    a, b = Side(*a), Side(*b)
    answers = Answers(*answers)
    features = answers.features
    for row in range(pairs.shape[0]):
        k, m = pairs[row, 0], pairs[row, 1]
        pair = relative_pair(a, k, b, m)
        feature_a, feature_b, before = features[row, 0], features[row, 1], 0
        if feature_a < 0 and feature_b < 0:
            level = max(levels_of(pair.a.size), levels_of(pair.b.size))
            if level > 0:
                feature_a, feature_b, before = coarse_start(a, k, b, m, pair, level, trace)
        found, steps = vclip_query(pair, feature_a, feature_b, deep, trace)
        write_answer(found, before + steps, a, k, answers, row)


NO_GJK_TRACE = np.empty((0, 16))
NO_VCLIP_TRACE = np.empty((0, 3))


def gjk_batch(
    a: PolygonSet | Sequence[Any],
    b: PolygonSet | Sequence[Any],
    pairs: Any = None,
    poses_a: Any = None,
    poses_b: Any = None,
    features: Longs | None = None,
    tolerance: float = TOLERANCE,
    deep: bool = True,
    method: str = "climb",
) -> Proximities:
    """GJK for many pairs of convex polygons.

    a, b: sets or sequences of shapes. pairs: (m, 2) of indices into a and b, else the k-th with the k-th.
    poses_a, poses_b: (k, 4) x, y, cos, sin of each shape, else as given. features: (m, 2) int64, where
    each walk begins (-1: afresh); overwritten with what it found, so that handing it in again begins warm.
    deep: whether the depth of overlaps is measured (else their distance is 0). ValueError for what does not
    fit.
    """
    query = _Query(a, b, pairs, poses_a, poses_b, features)
    search = (float(tolerance), LIMIT, METHODS.index(method))
    gjk_many(*query.sides, query.pairs, search, deep, NO_GJK_TRACE, query.written)
    return query.answers()


def vclip_batch(
    a: PolygonSet | Sequence[Any],
    b: PolygonSet | Sequence[Any],
    pairs: Any = None,
    poses_a: Any = None,
    poses_b: Any = None,
    features: Longs | None = None,
    deep: bool = True,
) -> Proximities:
    """V-Clip for many pairs of convex polygons; arguments as for `gjk_batch`.

    A walk that begins afresh takes coarse outlines of large polygons; its iterations count the steps on them
    too.
    """
    query = _Query(a, b, pairs, poses_a, poses_b, features)
    vclip_many(*query.sides, query.pairs, deep, NO_VCLIP_TRACE, query.written)
    return query.answers()


class _Query:
    """The arrays of a batch, checked."""

    def __init__(self, a: Any, b: Any, pairs: Any, poses_a: Any, poses_b: Any, features: Any) -> None:
        self.a = a if isinstance(a, PolygonSet) else PolygonSet(a)
        self.b = self.a if b is a else b if isinstance(b, PolygonSet) else PolygonSet(b)
        self.pairs = self._pairs(pairs)
        placed = _poses("poses_a", poses_a, len(self.a))
        same = poses_b is poses_a and self.a is self.b
        self.sides = (
            self.a.side(placed),
            self.b.side(placed if same else _poses("poses_b", poses_b, len(self.b))),
        )
        m = len(self.pairs)
        if features is None:
            features = np.full((m, 2), -1, dtype=np.int64)
        elif features.shape != (m, 2) or features.dtype != np.int64 or not features.flags.c_contiguous:
            raise ValueError(f"features: expected an int64 array ({m}, 2)")
        self.written = (np.empty((m, COLUMNS)), features, np.empty(m, dtype=np.int64))

    def _pairs(self, pairs: Any) -> Longs:
        if pairs is None:
            if len(self.a) != len(self.b):
                raise ValueError(
                    f"pairs: {len(self.a)} shapes cannot be paired with {len(self.b)} one by one"
                )
            return np.repeat(np.arange(len(self.a)), 2).reshape(-1, 2)
        given = np.ascontiguousarray(pairs, dtype=np.int64)
        if given.ndim != 2 or given.shape[1] != 2:
            raise ValueError(f"pairs: expected rows of two indices, not an array {given.shape}")
        for column, shapes in ((0, self.a), (1, self.b)):
            if len(given) and not 0 <= given[:, column].min() <= given[:, column].max() < len(shapes):
                raise ValueError(f"pairs: column {column} must be from 0 to {len(shapes) - 1}")
        return given

    def answers(self) -> Proximities:
        """The answers, as views of the arrays that the kernel wrote."""
        numbers, features, iterations = self.written
        return Proximities(
            numbers[:, 0], numbers[:, 1:3], numbers[:, 3:5], features[:, 0], features[:, 1], iterations,
            numbers[:, 5:7],
        )  # fmt: skip


def _poses(name: str, given: Any, count: int) -> Floats:
    if given is None:
        return np.tile((0.0, 0.0, 1.0, 0.0), (count, 1))
    poses = np.ascontiguousarray(given, dtype=np.float64)
    if poses.shape != (count, 4):
        raise ValueError(f"{name}: expected rows x, y, cos, sin for {count} shapes, not {poses.shape}")
    if not np.isfinite(poses).all():
        raise ValueError(f"{name}: must be finite")
    return poses
