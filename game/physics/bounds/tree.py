"""Bounding-volume trees over polylines: boxes, capsules, and axis-aligned boxes to compare with."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.physics.bounds import building
from game.physics.bounds.building import fit_scratch, grow_tree
from game.physics.bounds.fits import ROUNDING, box_of, capsule_of
from game.physics.bounds.validation import as_angle, as_points, as_step, turns_of
from game.physics.kernels import elementary, linear

KINDS = ("obb", "capsule", "aabb")
FITS = ("search", "refined", "thinnest", "exact")
SPLITS = ("half", "median", "perimeter")


def tree_depth_bound(segments: int) -> int:
    """No tree over so many segments is deeper: halved in space at first, by number below."""
    return 3 * math.ceil(elementary.log2(max(segments, 2))) + 9


class BoundingTree:
    """A binary tree of volumes over the segments of a polyline, in the polyline's own frame.

    points (k, 2) m, ``closed`` or open; ends (n, 4) m: its segments. volumes (m, 6): rows as `box_of` and
    `capsule_of` take them, breadth first from the root 0. links (m, 5): first of two children or -1, first
    and one past the last place in ``order`` (n,), parent or -1, depth. sizes (m,) m. reach: m, greatest
    coordinate. Made by `build_tree`; nothing is changed afterwards.
    """

    def __init__(
        self,
        kind: str,
        points: Floats,
        closed: bool,
        ends: Floats,
        order: Longs,
        volumes: Floats,
        links: Longs,
        sizes: Floats,
        rebuild: Callable[[Floats], BoundingTree],
    ):
        self.kind, self.points, self.closed, self.ends, self.order = kind, points, closed, ends, order
        self.volumes, self.links, self.sizes = volumes, links, sizes
        self.kind_number = KINDS.index(kind)
        self.nodes = (self.kind_number, volumes, links, sizes, ends, order)  # plain `Nodes`, for kernels
        self.reach = float(np.abs(points).max()) + float(sizes[0])
        self._rebuild = rebuild

    def __len__(self) -> int:
        """Number of nodes."""
        return len(self.links)

    @property
    def segments(self) -> int:
        """Number of segments."""
        return len(self.ends)

    @property
    def depth(self) -> int:
        """Depth of the deepest node; the root's is 0."""
        return int(self.links[-1, building.DEPTH])

    @property
    def leaves(self) -> Longs:
        """Nodes without children."""
        return np.flatnonzero(self.links[:, building.CHILD] < 0)

    def level(self, depth: int) -> slice:
        """The nodes of a depth; they stand one behind the other."""
        first, last = np.searchsorted(self.links[:, building.DEPTH], (depth, depth + 1)).tolist()
        return slice(first, last)

    def segments_of(self, node: int) -> Longs:
        """Segments below a node."""
        return self.order[self.links[node, building.BEGIN] : self.links[node, building.END]]

    def volume(self, node: int) -> Any:
        """The `Box` or `Capsule` of a node."""
        return capsule_of(self.volumes[node]) if self.kind == "capsule" else box_of(self.volumes[node])

    def areas(self) -> Floats:
        """Areas (m,) of all volumes, m²."""
        v = self.volumes
        if self.kind != "capsule":
            return np.asarray(4.0 * v[:, 4] * v[:, 5])
        way = v[:, 2:4] - v[:, 0:2]
        return np.asarray(2.0 * v[:, 4] * np.sqrt((way * way).sum(axis=1)) + np.pi * (v[:, 4] * v[:, 4]))

    def turned(self, angle: float) -> BoundingTree:
        """The tree of the polyline turned about its origin by an angle, rad.

        Boxes and capsules turn with it; axis-aligned boxes are built again, as theirs have to stay upright.
        """
        c, s = elementary.cos(as_angle(angle, "angle")), elementary.sin(angle)
        turn = np.array([[c, s], [-s, c]])
        points = linear.product(self.points, turn)
        if self.kind == "aabb":
            return self._rebuild(points)
        volumes = self.volumes.copy()
        for column in (0, 2):
            volumes[:, column : column + 2] = linear.product(self.volumes[:, column : column + 2], turn)
        ends = (linear.product(self.ends.reshape(-1, 2), turn)).reshape(-1, 4)
        return BoundingTree(
            self.kind, points, self.closed, ends, self.order, volumes, self.links, self.sizes, self._rebuild
        )

    def check(self) -> None:
        """AssertionError if a node does not hold its points, or the links are no tree over all segments."""
        links, n = self.links, self.segments
        assert np.array_equal(np.sort(self.order), np.arange(n)), "order is no permutation"
        assert np.all(np.isfinite(self.volumes)), "a volume is not finite"
        inner = np.flatnonzero(links[:, building.CHILD] >= 0)
        children = links[inner, building.CHILD]
        assert np.array_equal(np.sort(np.concatenate(([0], children, children + 1))), np.arange(len(links)))
        assert np.array_equal(links[children, building.PARENT], inner)
        assert np.array_equal(links[children + 1, building.PARENT], inner)
        assert np.array_equal(links[children, building.BEGIN], links[inner, building.BEGIN])
        assert np.array_equal(links[children, building.END], links[children + 1, building.BEGIN])
        assert np.array_equal(links[children + 1, building.END], links[inner, building.END])
        assert np.all(links[:, building.BEGIN] < links[:, building.END]), "a node is empty"
        assert np.all(np.diff(links[:, building.DEPTH]) >= 0), "not breadth first"
        assert self.depth <= tree_depth_bound(n), f"depth {self.depth} over {n} segments"
        extent = float(np.ptp(self.points, axis=0).max())
        slack = ROUNDING * extent + 8.0 * np.finfo(float).eps * float(np.abs(self.points).max())
        for node in range(len(links)):
            outside = self.volume(node).outside(self.ends[self.segments_of(node)].reshape(-1, 2)).max()
            assert outside <= slack, f"node {node}: a point lies {outside} m outside"


def _integers(count: int) -> Longs:
    return np.empty(count, dtype=np.int64)


def build_tree(
    polyline: ArrayLike,
    kind: str = "obb",
    leaf_size: int = 4,
    *,
    closed: bool = False,
    fit: str = "search",
    step_degrees: float = 1.0,
    split: str = "half",
) -> BoundingTree:
    """The tree of the segments of a polyline (k, 2) m, top down, every node fitted again.

    kind: "obb", "capsule" or "aabb". leaf_size: most segments in a leaf. fit: "search" by angle steps,
    "refined" by golden section after that, "thinnest" (least breadth or radius), "exact" (least area: boxes
    to rounding, capsules to 1e-3, which takes up to some milliseconds a node). split: "half" in the middle of
    the volume across its longer side, "median" of the segments' middles, or where perimeters times numbers
    are least. A single point is a segment without length. ValueError for what is no
    polyline or no such option.
    """
    points = as_points(polyline, "polyline")
    for name, value, options in (("kind", kind, KINDS), ("fit", fit, FITS), ("split", split, SPLITS)):
        if value not in options:
            raise ValueError(f"{name}: expected one of {', '.join(options)}, not {value!r}")
    if isinstance(leaf_size, bool) or leaf_size != int(leaf_size) or leaf_size < 1:
        raise ValueError(f"leaf_size: expected a whole number above 0, not {leaf_size!r}")
    step = as_step(step_degrees)
    following = np.roll(points, -1, axis=0)
    ends = np.hstack((points, following))
    if not (closed and len(points) > 2) and len(points) > 1:
        ends = ends[:-1].copy()
    n, turns = len(ends), turns_of(step)
    loose = ends.reshape(-1, 2)
    order, sorted_ids = np.arange(n), np.lexsort((loose[:, 1], loose[:, 0]))
    volumes, links, sizes = np.zeros((2 * n, 6)), np.zeros((2 * n, 5), dtype=np.int64), np.zeros(2 * n)
    count = grow_tree(
        (KINDS.index(kind), FITS.index(fit), turns, math.radians(step)),
        SPLITS.index(split),
        int(leaf_size),
        2 * math.ceil(elementary.log2(max(n, 2))) + 8,
        (KINDS.index(kind), volumes, links, sizes, ends, order),
        loose,
        sorted_ids,
        (np.empty((4 * n + 2, 2)), _integers(n), np.empty(n), _integers(n), _integers(2 * n)),
        tuple(fit_scratch(len(turns))),
    )

    def rebuild(turned: Floats) -> BoundingTree:
        return build_tree(
            turned, kind, leaf_size, closed=closed, fit=fit, step_degrees=step_degrees, split=split
        )

    return BoundingTree(
        kind, points, closed, ends, order, volumes[:count].copy(), links[:count].copy(), sizes[:count].copy(),
        rebuild,
    )  # fmt: skip
