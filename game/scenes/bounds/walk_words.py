"""What the present step of a walk does, in words."""

from __future__ import annotations

import math

from game.physics.bounds import BoundingTree, traversal
from game.physics.bounds.building import CHILD
from game.scenes.bounds.walk import Walk


def caption(walk: Walk) -> str:
    """A sentence on the present step."""
    total = walk.length()
    if walk.cursor == 0 or not walk.model.pair.trees:
        return f"From the start, {total} steps: → goes on, ← back, G plays it"
    walked = walk.model.parameters.walked
    if walked == "fit":
        return _fit_caption(walk, total)
    if walked == "build":
        return _build_caption(walk)
    return _query_caption(walk, total)


def _fit_caption(walk: Walk, total: int) -> str:
    fit = walk.fit()
    k = min(walk.cursor, len(fit.angles)) - 1
    best = int(fit.areas[: k + 1].argmin())
    area = f"{math.degrees(fit.angles[k]):.3g}°: {fit.areas[k]:.4g} m²"
    words = f"Direction {k + 1} of {total}, {area}"
    words += ", the least so far" if best == k else f"; least so far {fit.areas[best]:.4g} m²"
    return words + (f", {fit.ratio(best):.4f} times the exact one" if fit.exact > 0.0 else "")


def _build_caption(walk: Walk) -> str:
    index, node = walk.building_at()
    tree = walk.model.pair.trees[index]
    count = len(tree.segments_of(node))
    child = int(tree.links[node, CHILD])
    words = f"{'AB'[index]}, node {node + 1} of {len(tree)}: {count} segments, "
    if child < 0:
        return words + "a leaf"
    return words + f"halved: {len(tree.segments_of(child))} and {len(tree.segments_of(child + 1))}"


def _query_caption(walk: Walk, total: int) -> str:
    query = walk.model.pair.query
    if query is None:
        return "There is no query: it needs two outlines"
    k = min(walk.cursor, query.row_count) - 1
    a, b, verdict = query.rows[k, :3].tolist()
    words = f"Pair {k + 1} of {total}, A{a + 1} and B{b + 1}: "
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
