"""Two outlines, their trees of one kind, and the query between them, kept from step to step."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.bounds import (
    BoundingTree,
    Nearest,
    Query,
    build_tree,
    minimal_capsule,
    minimal_obb,
    nearest,
)
from game.physics.bounds.fits import corners_of
from game.physics.bounds.hull import hull_of
from game.physics.bounds.query import QueryRecord
from game.physics.kernels import elementary, elementwise
from game.scenes.shared.outlines.level import array_of
from game.scenes.shared.outlines.outline import Outline

ROUND, FINE_ROUND = 9, 33  # points of one end of a capsule's outline, and where it is large
MOST_CORNERS = 48  # of a hull whose least capsule is looked for: 10 to 50 ms
MOST_PAIRS = 250_000  # of volumes, and of segments that meet: some 20 ms, 11 MB in every snapshot


class TreeOptions(NamedTuple):
    """How trees are built; see `build_tree`."""

    kind: str = "obb"
    leaf_size: int = 4
    fit: str = "search"
    step_degrees: float = 1.0
    split: str = "half"


class Place(NamedTuple):
    """Where a frame lies in the world, or in a pane of the picture: m, m, rad; and how much smaller."""

    x: float
    y: float
    angle: float
    scale: float = 1.0

    def to_world(self, points: Floats) -> Floats:
        """Points (..., 2) of the frame in the world."""
        c, s = self.scale * elementary.cos(self.angle), self.scale * elementary.sin(self.angle)
        world = np.empty(points.shape)
        x, y = points[..., 0], points[..., 1]
        world[..., 0] = c * x - s * y + self.x
        world[..., 1] = s * x + c * y + self.y
        return world


def tree_of(outline: Outline, options: TreeOptions) -> BoundingTree:
    """The tree of an outline in its own frame."""
    return build_tree(
        array_of(outline), options.kind, options.leaf_size, closed=outline.closed, fit=options.fit,
        step_degrees=options.step_degrees, split=options.split,
    )  # fmt: skip


def paths_of(tree: BoundingTree) -> Floats:
    """Outlines (m, p, 2) of all volumes in the tree's frame: corners of boxes, round ends of capsules."""
    return rows_to_paths(tree.kind, tree.volumes)


def least_area(kind: str, points: Floats) -> float:
    """Area of the least volume round points (n, 2), m²: for axis-aligned boxes, of the least box.

    Proven to 1e-3 for capsules, and polished. NaN for capsules round so many corners that the search would
    be felt.
    """
    if kind != "capsule":
        return minimal_obb(points).area
    if len(hull_of(points)[0]) > MOST_CORNERS:
        return math.nan
    return minimal_capsule(points).area


def rows_to_paths(kind: str, v: Floats, round_points: int = ROUND) -> Floats:
    """Outlines (m, p, 2) of volumes (m, 6) of a kind; ``round_points``: of one end of a capsule."""
    if kind != "capsule":
        return corners_of(v)
    core = v[:, 2:4] - v[:, 0:2]
    turn = elementwise.arctan2(core[:, 1], core[:, 0])[:, None]
    bend = np.linspace(-0.5 * np.pi, 0.5 * np.pi, round_points)[None, :]
    radius = v[:, 4][:, None, None]
    far = v[:, None, 2:4] + radius * np.stack(
        (elementwise.cos(turn + bend), elementwise.sin(turn + bend)), axis=-1
    )
    back = turn + np.pi
    near = v[:, None, 0:2] + radius * np.stack(
        (elementwise.cos(back + bend), elementwise.sin(back + bend)), axis=-1
    )
    return np.concatenate((far, near), axis=1)


class FinePaths:
    """Outlines of a tree's volumes in its frame, with finer round ends; each is made when first needed."""

    def __init__(self, tree: BoundingTree) -> None:
        self._tree = tree
        self._paths = np.empty((len(tree.volumes), 2 * FINE_ROUND, 2))
        self._made = np.zeros(len(tree.volumes), dtype=np.bool_)

    def of(self, nodes: NDArray[np.int64]) -> Floats:
        """Outlines (m, p, 2) of capsules by their nodes (m,)."""
        new = nodes[~self._made[nodes]]
        if len(new):
            self._paths[new] = rows_to_paths(self._tree.kind, self._tree.volumes[new], FINE_ROUND)
            self._made[new] = True
        return self._paths[nodes]


class TreePair:
    """Trees of two outlines, and the query. Axis-aligned boxes are built again when an outline has turned."""

    def __init__(self, options: TreeOptions):
        self.options = options
        self.trees: list[BoundingTree] = []
        self.paths: list[Floats] = []
        self.fine: list[FinePaths] = []
        self.query: Query | None = None
        self._shapes: list[tuple[object, bool, float]] = []
        self._asked: object = None
        self._exact: list[float] = []
        self._gap: tuple[Outline, Outline, Nearest] | None = None  # the distance that is known, and of what

    def exact_area(self, index: int) -> float:
        """Area of the least volume of the kind round an outline, m²; see `least_area`."""
        if self._exact[index] < 0.0:
            self._exact[index] = least_area(self.options.kind, self.trees[index].points)
        return self._exact[index]

    def angle_of(self, outline: Outline) -> float:
        """How far the frame of an outline's tree is turned, rad: axis-aligned boxes have the world's."""
        return 0.0 if self.options.kind == "aabb" else outline.angle

    def _fits(self, i: int, outline: Outline) -> bool:
        """Whether tree ``i`` is that of an outline."""
        if i >= len(self._shapes):
            return False
        points, closed, turn = self._shapes[i]
        same = points is outline.points or points == outline.points
        return same and closed == outline.closed and turn == outline.angle - self.angle_of(outline)

    def is_stale(self, outlines: Sequence[Outline]) -> bool:
        """Whether a tree has to be built for these outlines."""
        return len(outlines) != len(self.trees) or not all(map(self._fits, range(len(outlines)), outlines))

    def take(self, outlines: Sequence[Outline]) -> None:
        """Let the trees be those of these outlines."""
        if not self.is_stale(outlines):
            return
        kept = [i < len(self.trees) and self._fits(i, outline) for i, outline in enumerate(outlines)]
        turns = [outline.angle - self.angle_of(outline) for outline in outlines]
        trees = []
        for i, outline in enumerate(outlines):
            tree = self.trees[i] if kept[i] else tree_of(outline, self.options)
            trees.append(tree if kept[i] or turns[i] == 0.0 else tree.turned(turns[i]))
        self.paths = [self.paths[i] if kept[i] else paths_of(tree) for i, tree in enumerate(trees)]
        self.fine = [self.fine[i] if kept[i] else FinePaths(tree) for i, tree in enumerate(trees)]
        self._shapes = [
            (outline.points, outline.closed, turn) for outline, turn in zip(outlines, turns, strict=True)
        ]
        self._exact = [self._exact[i] if kept[i] else -1.0 for i in range(len(trees))]
        self.trees = trees
        self.query = Query(trees[0], trees[1], MOST_PAIRS) if len(trees) == 2 else None
        self._asked = None
        self._gap = None

    def place(self, outline: Outline) -> Place:
        """Where the frame of an outline's tree lies."""
        return Place(*outline.position, self.angle_of(outline))

    def relative(self, outlines: Sequence[Outline]) -> tuple[tuple[float, float], float]:
        """Place of the second tree in the frame of the first: offset m, turn rad."""
        a, b = self.place(outlines[0]), self.place(outlines[1])
        c, s = elementary.cos(a.angle), elementary.sin(a.angle)
        dx, dy = b.x - a.x, b.y - a.y
        return (c * dx + s * dy, c * dy - s * dx), b.angle - a.angle

    def ask(self, outlines: Sequence[Outline], exact: bool = True, coherent: bool = False) -> None:
        """Run the query where the outlines are."""
        if self.query is None:
            return
        offset, turn = self.relative(outlines)
        self.query.run(offset, turn, exact=exact, coherent=coherent)
        self._asked = (outlines[0], outlines[1], exact)

    def ask_if_moved(self, outlines: Sequence[Outline], exact: bool = True) -> None:
        """The same from the roots, if outlines or places are others than last time."""
        self.take(outlines)
        if self.query is not None and self._asked != (outlines[0], outlines[1], exact):
            self.ask(outlines, exact)

    def put_back(self, record: QueryRecord) -> None:
        """Stand after an earlier query; nothing if there is none."""
        if self.query is not None and len(record.rows):
            self.query.put_back(record)

    def distance(self, outlines: Sequence[Outline]) -> Nearest | None:
        """How far the outlines are apart, the points in the world; None unless there are two."""
        if self.query is None:
            return None
        if self._gap is not None and self._gap[0] is outlines[0] and self._gap[1] is outlines[1]:
            return self._gap[2]
        offset, turn = self.relative(outlines)
        found = nearest(self.trees[0], self.trees[1], offset, turn)
        ends = self.place(outlines[0]).to_world(np.array((found.point_a, found.point_b)))
        a, b = ends.tolist()
        found = found._replace(point_a=(a[0], a[1]), point_b=(b[0], b[1]))
        self._gap = (outlines[0], outlines[1], found)
        return found

    def check(self) -> None:
        """AssertionError if trees or query are not what they have to be."""
        for tree in self.trees:
            tree.check()
        if self.query is not None and self.query.row_count:
            self.query.check()
