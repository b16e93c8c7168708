"""Walking through the method: the fit direction by direction, the tree node by node, the query pair by pair.

A walk is a row of steps that is known from its beginning; the scene's cursor says how many have been made.
So it goes back as well as on.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.bounds import (
    Query,
    build_tree,
    fit_capsule,
    fit_obb,
    nearest,
    traversal,
)
from game.physics.bounds.boxes import write_box
from game.physics.bounds.building import CHILD, area_on_axis
from game.physics.bounds.capsules import write_capsule
from game.physics.bounds.hull import hull_of
from game.scenes.bounds.pair import least_area

if TYPE_CHECKING:
    from game.physics.bounds import BoundingTree
    from game.scenes.bounds.base import BoundsScene

Array = NDArray[np.float64]
BEAT_ROUNDING = 1e-9  # so that sixty sixtieths of a second make a whole one
WALKS = ("off", "fit", "build", "query")


class FitWalk(NamedTuple):
    """The search by angle steps on one node: angles (k,) rad and the areas (k,) m² on them; the hull."""

    angles: Array
    areas: Array
    hull: Array
    origin: Array
    exact: float  # m², area of the exact fit; NaN if it is not known

    def ratio(self, index: int) -> float:
        """Area on a direction over that of the exact fit."""
        return float(self.areas[index]) / self.exact


def node_of(scene: BoundsScene) -> int:
    """The node whose fit is walked through."""
    trees = scene.pair.trees
    return min(int(scene.node), len(trees[scene.chosen]) - 1) if trees else 0


def fit_walk(scene: BoundsScene) -> FitWalk:
    """The search on the chosen node, all of it; kept until another one is asked for."""
    tree = scene.pair.trees[scene.chosen]
    key = (node_of(scene), scene.angle_step)
    kept = scene.pair.kept_walk
    if kept is None or kept[0] is not tree or kept[1] != key:
        kept = scene.pair.kept_walk = (tree, key, _make_walk(scene, tree))
    return kept[2]


def _make_walk(scene: BoundsScene, tree: BoundingTree) -> FitWalk:
    points = tree.ends[tree.segments_of(node_of(scene))].reshape(-1, 2)
    hull, origin = hull_of(points)
    quarter = 90.0 if tree.kind == "obb" else 180.0
    count = max(1, math.ceil(quarter / scene.angle_step - 1e-9))
    angles = np.radians(scene.angle_step * np.arange(count))
    if tree.kind == "aabb":
        angles = angles[:1]
    kind = tree.kind_number if tree.kind != "aabb" else 0
    areas = np.array([area_on_axis(kind, hull, len(hull), math.cos(a), math.sin(a)) for a in angles.tolist()])
    exact = least_area(tree.kind, points)
    return FitWalk(angles, areas, hull, origin, exact)


def fit_row(walk: FitWalk, angle: float, kind: str) -> Array:
    """The volume (1, 6) on an axis at an angle (rad)."""
    row = np.zeros((1, 6))
    write = write_capsule if kind == "capsule" else write_box
    x, y = walk.origin.tolist()
    write(walk.hull, len(walk.hull), math.cos(angle), math.sin(angle), x, y, row, 0)
    return row


def length_of(scene: BoundsScene) -> int:
    """How many steps the walk in play has."""
    trees, query = scene.pair.trees, scene.pair.query
    if not trees or scene.walked == "off":
        return 0
    if scene.walked == "fit":
        if scene.pair.options.kind == "aabb":
            return 1
        quarter = 90.0 if scene.pair.options.kind == "obb" else 180.0
        return max(1, math.ceil(quarter / scene.angle_step - 1e-9))
    if scene.walked == "build":
        return sum(len(tree) for tree in trees)
    return query.row_count if query is not None else 0


def stand_at(scene: BoundsScene, cursor: int) -> None:
    """Stand after so many steps of the walk, as far as it has them; it no longer plays."""
    scene.cursor = min(max(cursor, 0), length_of(scene))
    scene.beat = 0.0
    scene.values["playing"] = False


def play(scene: BoundsScene, dt: float) -> None:
    """Go on at the chosen pace, if it plays; at its end it stands."""
    if not scene.playing:
        return
    scene.beat += scene.pace * dt
    made = int(scene.beat + BEAT_ROUNDING)
    scene.beat -= made
    scene.cursor += made
    if scene.cursor >= length_of(scene):
        stand_at(scene, scene.cursor)


def building_at(scene: BoundsScene) -> tuple[int, int]:
    """The tree and the node that are built in the present step; the root of A before the first."""
    left = max(scene.cursor - 1, 0)
    for i, tree in enumerate(scene.pair.trees):
        if left < len(tree):
            return i, left
        left -= len(tree)
    return len(scene.pair.trees) - 1, len(scene.pair.trees[-1]) - 1


def caption(scene: BoundsScene) -> str:
    """What the present step of the walk does, in words."""
    total = length_of(scene)
    if scene.cursor == 0 or not scene.pair.trees:
        return f"From the start, {total} steps: → goes on, ← back, G plays it"
    if scene.walked == "fit":
        return _fit_caption(scene, total)
    if scene.walked == "build":
        return _build_caption(scene, total)
    return _query_caption(scene, total)


def _fit_caption(scene: BoundsScene, total: int) -> str:
    walk = fit_walk(scene)
    k = min(scene.cursor, len(walk.angles)) - 1
    best = int(walk.areas[: k + 1].argmin())
    area = f"{math.degrees(walk.angles[k]):.3g}°: {walk.areas[k]:.4g} m²"
    words = f"Direction {k + 1} of {total}, {area}"
    words += ", the least so far" if best == k else f"; least so far {walk.areas[best]:.4g} m²"
    return words + (f", {walk.ratio(best):.4f} times the exact one" if walk.exact > 0.0 else "")


def _build_caption(scene: BoundsScene, total: int) -> str:
    index, node = building_at(scene)
    tree = scene.pair.trees[index]
    count = len(tree.segments_of(node))
    child = int(tree.links[node, CHILD])
    words = f"{'AB'[index]}, node {node + 1} of {len(tree)}: {count} segments, "
    if child < 0:
        return words + "a leaf"
    return words + f"halved: {len(tree.segments_of(child))} and {len(tree.segments_of(child + 1))}"


def _query_caption(scene: BoundsScene, total: int) -> str:
    query = scene.pair.query
    if query is None:
        return "Two outlines are wanted"
    k = min(scene.cursor, query.row_count) - 1
    a, b, verdict = query.rows[k, :3].tolist()
    words = f"Pair {k + 1} of {total}, A{a} and B{b}: "
    if verdict == traversal.APART:
        return words + f"apart by {query.gaps[k, 0]:.3g} m, this branch ends"
    if verdict == traversal.MET:
        return words + "two leaves overlap, their segments are tested"
    opens_a = is_opened_first(query.tree_a, query.tree_b, a, b)
    return words + f"they overlap, {'A' if opens_a else 'B'} is larger and is opened"


def is_opened_first(tree_a: BoundingTree, tree_b: BoundingTree, a: int, b: int) -> bool:
    """Whether of an overlapping pair the first tree's volume is opened."""
    if tree_b.links[b, CHILD] < 0:
        return True
    return bool(tree_a.links[a, CHILD] >= 0 and tree_a.sizes[a] >= tree_b.sizes[b])


def excess_of(scene: BoundsScene) -> float:
    """Area of both roots over that of exact ones, less 1; NaN without any, and while corners are dragged."""
    if scene.board.held == "point":
        return math.nan
    found = exact = 0.0
    for i, tree in enumerate(scene.pair.trees):
        found += float(tree.areas()[0])
        exact += scene.pair.exact_area(i)
    return found / exact - 1.0 if exact > 0.0 else math.nan


def warm_up(part: str) -> None:
    """Compile what a part of the scene needs."""
    line = [(0.0, 0.0), (1.0, 0.5), (2.0, 0.0), (2.5, 1.0)]
    tree = build_tree(line, "obb", 1)
    if part == "build":
        hull, _ = hull_of(tree.points)
        area_on_axis(0, hull, len(hull), 1.0, 0.0)
        fit_obb(line), fit_capsule(line)
    elif part == "query":
        query = Query(tree, tree)
        query.run((0.5, 0.0))
        query.marks()
    else:
        nearest(tree, tree, (5.0, 0.0))
