"""The question two trees are asked: where do you overlap? Once (`tandem`), or from step to step (`Query`)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.bounds import traversal
from game.physics.bounds.building import PARENT
from game.physics.bounds.segments import SCRATCH
from game.physics.bounds.tree import BoundingTree
from game.physics.bounds.validation import as_angle, as_vector
from game.physics.kernels import elementary, linear
from game.physics.kernels.limits import LimitError

REST, ANCESTOR, OVERLAPPING = 0, 1, 2  # marks of nodes
ROUNDINGS = 64.0 * np.finfo(float).eps  # of all coordinates together, that a gap must exceed to separate
MAX_ROWS = 1 << 23  # pairs of volumes, and of segments that meet, of one answer: 1 GB at most
NOT_BEGUN = np.array([[0, 0, traversal.MET, 0, 0]], dtype=np.int32)


class QueryRecord(NamedTuple):
    """rows (n, 5), gaps (n, 3), crossings (c, 2) as in `Tandem`; counts (5,) of tests and findings."""

    rows: NDArray[np.int32]
    gaps: Floats
    crossings: Longs
    counts: Longs


class Tandem(NamedTuple):
    """What a query found.

    leaf_pairs (k, 2): leaves of both trees that overlap. crossings (c, 2): segments that meet, sorted.
    volume_tests, segment_tests: how many were made. rows (n, 5): the pairs of nodes in order, with verdict
    (traversal.APART, OPENED, MET), age, and whether the pair was tested. gaps (n, 3): for tested ones the gap
    in m and its axis, a unit vector from a to b, in the frame of the first tree.
    """

    leaf_pairs: Longs
    crossings: Longs
    volume_tests: int
    segment_tests: int
    rows: NDArray[np.int32]
    gaps: Floats

    @property
    def separated(self) -> bool:
        """Whether no two leaves overlap."""
        return len(self.leaf_pairs) == 0


@kernel
def mark_nodes(rows, count, parents_a, parents_b, marks_a, marks_b):
    """Mark leaves that overlap, and their ancestors up to the roots; ``marks`` (m,) uint8 are written."""
    for i in range(len(marks_a)):
        marks_a[i] = 0
    for i in range(len(marks_b)):
        marks_b[i] = 0
    for k in range(count):
        if rows[k, 2] != 2:
            continue
        for tree in range(2):
            marks = marks_a if tree == 0 else marks_b
            parents = parents_a if tree == 0 else parents_b
            node = rows[k, tree]
            marks[node] = 2
            node = parents[node]
            while node >= 0 and marks[node] == 0:
                marks[node] = 1
                node = parents[node]


class Query:
    """Two trees that are asked again and again; keeps its arrays, and the front if told to go on from it.

    After `run`: ``volume_tests``, ``segment_tests``, ``leaves_met``, ``crossing_count``; `answer` copies all.
    most: pairs of volumes, and of segments that meet, that there is space for: two polylines that cross
    everywhere have as many as the product of their segments. ValueError unless both trees are of one kind.
    """

    def __init__(self, tree_a: BoundingTree, tree_b: BoundingTree, most: int = MAX_ROWS):
        if tree_a.kind != tree_b.kind:
            raise ValueError(f"trees: expected two of one kind, not {tree_a.kind} and {tree_b.kind}")
        self.most = most
        self.tree_a, self.tree_b = tree_a, tree_b
        self._rows = np.zeros((256, 5), dtype=np.int32)
        self._old = np.zeros((256, 5), dtype=np.int32)
        self._old[:1] = NOT_BEGUN
        self._old_count = 1
        self._gaps = np.zeros((256, 3))
        self._crossings = np.zeros((32, 2), dtype=np.int64)
        self._stack = np.zeros((tree_a.depth + tree_b.depth + 3, 2), dtype=np.int64)
        self._counts = np.zeros(5, dtype=np.int64)
        self._place = np.array([1.0, 0.0, 0.0, 0.0])
        self._scratch = np.zeros(SCRATCH)
        self._marks = np.zeros(len(tree_a), dtype=np.uint8), np.zeros(len(tree_b), dtype=np.uint8)
        self._parents = tuple(np.ascontiguousarray(tree.links[:, PARENT]) for tree in (tree_a, tree_b))

    def run(
        self,
        offset_b: ArrayLike,
        turn_b: float = 0.0,
        *,
        exact: bool = True,
        coherent: bool = False,
        patience: int = traversal.PATIENCE,
    ) -> None:
        """Ask with the second tree turned by ``turn_b`` (rad) and moved by ``offset_b`` (2,) m.

        exact: test the segments of leaves that overlap. coherent: begin with the front of the last query.
        Axis-aligned boxes cannot be turned here: turn their tree. ValueError for what is no place; LimitError
        for more pairs than ``most``, and then the next query begins afresh.
        """
        x, y = as_vector(offset_b, "offset_b")
        turn = as_angle(turn_b, "turn_b")
        if turn != 0.0 and self.tree_a.kind == "aabb":
            raise ValueError("turn_b: axis-aligned boxes do not turn; give the tree of the turned polyline")
        self._place[:] = elementary.cos(turn), elementary.sin(turn), x, y
        if coherent:
            self._old, self._rows, self._old_count = self._rows, self._old, self.row_count
            if not self._old_count:
                self._old[:1], self._old_count = NOT_BEGUN, 1
        else:
            self._old[:1], self._old_count = NOT_BEGUN, 1
        try:
            while self._traverse(abs(x) + abs(y), exact, patience) != traversal.DONE:
                pass
        except LimitError:
            self._counts[:] = 0
            raise

    def _traverse(self, distance: float, exact: bool, patience: int) -> int:
        """One attempt; a result that does not fit gets larger arrays."""
        a, b = self.tree_a, self.tree_b
        slack = ROUNDINGS * (a.reach + b.reach + distance)
        old, scratch = self._old[: self._old_count], (self._stack, self._scratch)
        written = (self._rows, self._gaps, self._crossings, self._counts)
        status = traversal.traverse(
            a.nodes, b.nodes, self._place, slack, exact, patience, old, written, scratch
        )
        if status == traversal.MORE_ROWS:
            capacity = self._more("volumes", len(self._rows) + 1, 2 * len(self._rows))
            self._rows, self._gaps = np.zeros((capacity, 5), dtype=np.int32), np.zeros((capacity, 3))
        elif status == traversal.MORE_CROSSINGS:
            found = int(self._counts[traversal.CROSSINGS])
            capacity = self._more("segments that meet", found, 2 * found)
            self._crossings = np.zeros((capacity, 2), dtype=np.int64)
        elif len(self._gaps) < len(self._rows):
            self._gaps = np.zeros((len(self._rows), 3))
        return int(status)

    def _more(self, what: str, needed: int, wished: int) -> int:
        """The capacity for more of a kind; LimitError if those that are needed are too many."""
        if needed > self.most:
            raise LimitError(f"the outlines lie in each other: more than {self.most} pairs of {what}")
        return min(max(wished, needed), self.most)

    @property
    def row_count(self) -> int:
        """Pairs written down by the last query."""
        return int(self._counts[traversal.ROWS])

    @property
    def volume_tests(self) -> int:
        """Pairs of volumes tested by the last query."""
        return int(self._counts[traversal.VOLUMES_TESTED])

    @property
    def segment_tests(self) -> int:
        """Pairs of segments tested by the last query."""
        return int(self._counts[traversal.SEGMENTS_TESTED])

    @property
    def leaves_met(self) -> int:
        """Pairs of leaves that overlap."""
        return int(self._counts[traversal.LEAVES_MET])

    @property
    def crossing_count(self) -> int:
        """Pairs of segments that meet."""
        return int(self._counts[traversal.CROSSINGS])

    @property
    def rows(self) -> NDArray[np.int32]:
        """Rows (n, 5) of the last query, as in `Tandem`; good until the next one."""
        return self._rows[: self.row_count]

    @property
    def gaps(self) -> Floats:
        """Gaps and axes (n, 3) of the last query, as in `Tandem`; good until the next one."""
        return self._gaps[: self.row_count]

    @property
    def crossings(self) -> Longs:
        """Segments that meet (c, 2), unsorted; good until the next query."""
        return self._crossings[: self.crossing_count]

    def record(self) -> QueryRecord:
        """All that `put_back` needs to stand after this query again; views, good until the next one."""
        return QueryRecord(self.rows, self.gaps, self.crossings, self._counts)

    def put_back(self, record: QueryRecord) -> None:
        """Stand after an earlier query of the same trees; the next coherent one begins with its front.

        ValueError if the record names nodes that these trees do not have.
        """
        count = len(record.rows)
        sizes = len(self.tree_a), len(self.tree_b)
        if count and (record.rows[:, :2].min() < 0 or (record.rows[:, :2].max(axis=0) >= sizes).any()):
            raise ValueError("record: of a query of other trees")
        if count > len(self._rows):
            self._rows, self._gaps = np.zeros((2 * count, 5), dtype=np.int32), np.zeros((2 * count, 3))
        if len(record.crossings) > len(self._crossings):
            self._crossings = np.zeros((2 * len(record.crossings), 2), dtype=np.int64)
        self._rows[:count] = record.rows
        self._gaps[:count] = record.gaps
        self._crossings[: len(record.crossings)] = record.crossings
        self._counts[:] = record.counts

    def marks(self, count: int | None = None) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
        """Marks (m,) of both trees' nodes after ``count`` rows (None: all): REST, ANCESTOR, OVERLAPPING."""
        n = self.row_count if count is None else min(max(count, 0), self.row_count)
        mark_nodes(self._rows, n, *self._parents, *self._marks)
        return self._marks

    def answer(self) -> Tandem:
        """All of the last query, in arrays of its own."""
        rows, crossings = self.rows, self.crossings
        order = np.lexsort((crossings[:, 1], crossings[:, 0]))
        return Tandem(
            rows[rows[:, traversal.VERDICT] == traversal.MET, :2].astype(np.int64), crossings[order],
            self.volume_tests, self.segment_tests, rows.copy(), self.gaps.copy(),
        )  # fmt: skip

    def check(self) -> None:
        """AssertionError unless the rows cover both trees, and each gap is a certificate of separation.

        The pairs at which branches end must hold every pair of leaves just once.
        """
        rows, gaps = self.rows, self.gaps
        a, b = self.tree_a, self.tree_b
        covered = 0
        for node_a, node_b, verdict in rows[:, :3].tolist():
            if verdict != traversal.OPENED:
                covered += len(a.segments_of(node_a)) * len(b.segments_of(node_b))
        assert covered == a.segments * b.segments, f"{covered} of {a.segments * b.segments} segment pairs"
        assert int((rows[:, traversal.VERDICT] == traversal.OPENED).sum()) * 2 + 1 == len(rows)
        c, s, x, y = self._place.tolist()
        turn = np.array([[c, s], [-s, c]])
        apart = (rows[:, traversal.VERDICT] == traversal.APART) & (rows[:, traversal.TESTED] == 1)
        for k in np.flatnonzero(apart).tolist():
            axis = gaps[k, 1:]
            mine = linear.product(a.ends[a.segments_of(rows[k, 0])].reshape(-1, 2), axis)
            theirs = linear.product(
                linear.product(b.ends[b.segments_of(rows[k, 1])].reshape(-1, 2), turn) + np.array((x, y)),
                axis,
            )
            assert theirs.min() - mine.max() > 0.0, f"row {k}: not separated by its axis"


def tandem(
    tree_a: BoundingTree,
    tree_b: BoundingTree,
    offset_b: ArrayLike = (0.0, 0.0),
    turn_b: float = 0.0,
    *,
    exact: bool = True,
) -> Tandem:
    """Which leaves of two trees overlap, which of their segments meet, and how that was found.

    The second tree is turned by ``turn_b`` (rad) about its origin and moved by ``offset_b`` (2,) m. Touching
    counts. Axis-aligned boxes cannot be turned here: give ``tree_b.turned(angle)``, whose leaves are others.
    ValueError for that, for trees of different kinds, or what is no place.
    """
    query = Query(tree_a, tree_b)
    query.run(offset_b, turn_b, exact=exact)
    return query.answer()
