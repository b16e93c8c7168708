"""The circle tree of a body: each level covers it, with ever smaller circles.

After Hubbard (1996), in the plane, built by splitting: the body is cut into convex pieces. A part of it is a
set of them with the least circle about it. A part is split in four by a cut across its longer side and one
across each half. Every node also has a disc that lies within the body, so that two nodes bound the distance
of two bodies from both sides:

    |c_a - c_b| - R_a - R_b  <=  distance of the parts,   distance of the bodies  <=  |w_a - w_b| - s_a - s_b

A leaf is one convex piece, whose distance to another can be computed exactly.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.kernels import elementwise
from game.physics.spacetime.pieces import Piece, area_of, cut, least_circle, triangulate
from game.physics.spacetime.shapes import area_and_centre, outline_of

CX, CY, RADIUS, WX, WY, INNER = range(6)  # columns of nodes: circle about the part, disc within the body
CHILD, CHILDREN, DEPTH, FIRST, CORNERS = range(5)  # columns of links; children of a leaf: 0
LEAF = 0.15  # of the body's radius: no larger circle is a leaf
SMALL = 0.4  # of a part's radius: a piece smaller than that is not cut
DEEPEST = 10


class Forest(NamedTuple):
    """Trees of all bodies. nodes: (n, 6) m; links: (n, 5); corners: (k, 2) m of the leaves' pieces; roots:
    (bodies,) node of each."""

    nodes: Floats
    links: Longs
    corners: Floats
    roots: Longs


class CircleTree:
    """A body's outline (n, 2), counter-clockwise, and the tree of circles about it."""

    def __init__(self, outline: Floats):
        """ValueError unless it is a simple polygon, counter-clockwise."""
        self.outline = np.ascontiguousarray(outline, dtype=np.float64)
        if self.outline.ndim != 2 or len(self.outline) < 3 or not np.isfinite(self.outline).all():
            raise ValueError(f"outline: expected at least 3 finite points, not {self.outline.shape}")
        if area_and_centre(self.outline)[0] <= 0.0:
            raise ValueError("outline: expected a simple polygon, counter-clockwise")
        nodes: list[tuple[float, ...]] = []
        links: list[list[int]] = []
        corners: list[tuple[float, float]] = []
        parts = [(triangulate(self.outline), 0)]
        whole = 0.0
        for pieces, depth in parts:  # grows as it is read: level by level, children side by side
            circle = least_circle([p for piece in pieces for p in piece])
            whole = whole or circle[2]
            nodes.append((*circle, *self._disc_within(pieces, circle)))
            if len(pieces) == 1 and (circle[2] <= LEAF * whole or depth == DEEPEST):
                links.append([0, 0, depth, len(corners), len(pieces[0])])
                corners += pieces[0]
                continue
            children = _split_in_four(pieces, LEAF * whole)
            links.append([len(parts), len(children), depth, 0, 0])
            parts += [(child, depth + 1) for child in children]
        self.nodes, self.corners = np.array(nodes), np.array(corners)
        self.links: Longs = np.array(links, dtype=np.int64)

    def _disc_within(self, pieces: list[Piece], circle: tuple[float, float, float]) -> tuple[float, ...]:
        """A disc within the body near the middle of a part; a point of the outline if that lies outside."""
        found = [self._clearance(circle[:2])]
        if found[0][2] <= 0.0:
            largest = max(pieces, key=area_of)
            found.append(self._clearance(tuple(np.mean(largest, axis=0).tolist())))
        return max(
            found, key=lambda disc: disc[2] - elementwise.hypot(disc[0] - circle[0], disc[1] - circle[1])
        )

    def _clearance(self, place: tuple[float, ...]) -> tuple[float, float, float]:
        """The largest disc within the body about a place, or the nearest point of the outline if outside."""
        a, b = self.outline, np.roll(self.outline, -1, axis=0)
        along, away = b - a, np.asarray(place) - a
        share = np.clip(np.sum(away * along, axis=1) / np.sum(along * along, axis=1), 0.0, 1.0)
        feet = a + share[:, None] * along
        far = elementwise.hypot(*(feet - np.asarray(place)).T)
        nearest = int(np.argmin(far))
        if inside(self.outline, place):
            return place[0], place[1], float(far[nearest]) * (1.0 - 1e-12)
        return float(feet[nearest, 0]), float(feet[nearest, 1]), 0.0

    @property
    def depth(self) -> int:
        """Levels below the first."""
        return int(np.max(self.links[:, DEPTH]))

    def level(self, depth: int) -> Longs:
        """The nodes of a level: those as deep, and leaves above them."""
        deep, leaf = self.links[:, DEPTH], self.links[:, CHILDREN] == 0
        return np.flatnonzero((deep == depth) | (leaf & (deep < depth)))

    def pieces_below(self, node: int) -> list[Floats]:
        """The convex pieces (k, 2) of a node's part."""
        first, children, _, start, count = self.links[node].tolist()
        if children == 0:
            return [self.corners[start : start + count]]
        return [piece for child in range(first, first + children) for piece in self.pieces_below(child)]

    def check(self) -> None:
        """AssertionError unless every circle holds its part, and the parts of each level are the body."""
        whole = area_and_centre(self.outline)[0]
        for depth in range(self.depth + 1):
            area = 0.0
            for node in self.level(depth).tolist():
                for piece in self.pieces_below(node):
                    far = elementwise.hypot(*(piece - self.nodes[node, :2]).T)
                    assert np.all(far <= self.nodes[node, RADIUS] * (1.0 + 1e-9)), f"node {node}: too small"
                    area += area_of([(float(x), float(y)) for x, y in piece])
            assert abs(area - whole) <= 1e-9 * whole, f"level {depth}: {area} of {whole} covered"


def inside(outline: Floats, place: tuple[float, ...]) -> bool:
    """Whether a place lies in a polygon (n, 2), by the crossings of a ray."""
    x, y = place[0], place[1]
    a, b = outline, np.roll(outline, -1, axis=0)
    spans = (a[:, 1] > y) != (b[:, 1] > y)
    rise = np.where(spans, b[:, 1] - a[:, 1], 1.0)
    return bool(np.count_nonzero(spans & (x < a[:, 0] + (y - a[:, 1]) / rise * (b[:, 0] - a[:, 0]))) % 2)


def _split_in_four(pieces: list[Piece], small: float) -> list[list[Piece]]:
    halves = _split(pieces, small)
    return [quarter for half in halves for quarter in (_split(half, small) if len(half) > 1 else [half])]


def _split(pieces: list[Piece], small: float) -> list[list[Piece]]:
    """Two parts by a cut in the middle across the longer side.

    Pieces that are small, against the part or by themselves (m), go whole to the side of their middle.
    """
    points = np.array([p for piece in pieces for p in piece])
    low, high = points.min(axis=0), points.max(axis=0)
    axis = int(high[1] - low[1] > high[0] - low[0])
    at, small = float(0.5 * (low[axis] + high[axis])), max(small, SMALL * float(high[axis] - low[axis]))
    halves: tuple[list[Piece], list[Piece]] = ([], [])
    for piece in pieces:
        across = [p[axis] for p in piece]
        whole = max(across) - min(across) <= small and len(pieces) > 1
        if whole or max(across) <= at or min(across) >= at:
            halves[sum(across) / len(across) > at].append(piece)
            continue
        for half, rest in zip(halves, cut(piece, axis, at), strict=True):
            half.append(rest)
    if not (halves[0] and halves[1]):
        order = sorted(pieces, key=lambda piece: sum(p[axis] for p in piece) / len(piece))
        return [order[: len(order) // 2], order[len(order) // 2 :]]
    return [halves[0], halves[1]]


@lru_cache(maxsize=64)
def tree_of(kind: str, variant: int) -> CircleTree:
    """The tree of an outline of `shapes`, kept."""
    return CircleTree(outline_of(kind, variant))


def plant(trees: list[CircleTree], sizes: list[float]) -> Forest:
    """All trees in arrays, each grown to a size (m of its outline's farthest corner from 1)."""
    nodes, links, corners, roots = [], [], [], []
    known = 0
    taken = 0
    for tree, size in zip(trees, sizes, strict=True):
        moved = tree.links.copy()
        moved[moved[:, CHILDREN] > 0, CHILD] += known
        moved[:, FIRST] += taken
        nodes.append(tree.nodes * size)
        links.append(moved)
        corners.append(tree.corners * size)
        roots.append(known)
        known, taken = known + len(tree.nodes), taken + len(tree.corners)
    return Forest(
        np.concatenate(nodes), np.concatenate(links), np.concatenate(corners), np.array(roots, dtype=np.int64)
    )
