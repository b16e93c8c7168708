"""In which order the blocks of all joints are eliminated: found once, when joints come, go or break.

Joints are the unknowns, three lines at most each; two of them are coupled where they share a body that can
move. Least degree first (Tinney and Walker 1967): a tree of bodies, as chains, bridges and rag dolls are,
gets no block that was not there; a loop gets a few.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Ints
from game.physics.kernels import elementary
from game.physics.solids.arrays.layout import BROKEN, MOUSE, NO_JOINT, Joints

MOST_UPDATES = 100_000  # products of blocks in one solve; beyond that joints are swept


class JointPlan(NamedTuple):
    """m joints in order of elimination, their blocks, and memory for them; m = 0: sweeps only."""

    order: Ints  # (m,) joints
    starts: Ints  # (m + 1,) of each one's blocks below the diagonal
    below: Ints  # (e,) place in the order of the row of a block
    links: Ints  # (l, 4) block, places of its row and of its column, body they share
    targets: Ints  # (u,) which block a product goes to, in the order they are made; diagonal: -1 - place
    slots: Ints  # (m, 3) lines of the joint that take part, -1: none
    diagonal: Floats  # (m, 9)
    blocks: Floats  # (e, 9)
    right: Floats  # (m, 3)


def empty_plan() -> JointPlan:
    """Of no joints."""
    return _with_memory([], [0], [], [], [])


def _with_memory(
    order: list[int], starts: list[int], below: list[int], links: list[tuple[int, ...]], targets: list[int]
) -> JointPlan:
    m = len(order)
    whole = [np.array(part, dtype=np.int32) for part in (order, starts, below)]
    joined = np.array(links, dtype=np.int32).reshape(-1, 4)
    return JointPlan(
        whole[0], whole[1], whole[2], joined, np.array(targets, dtype=np.int32),
        np.full((m, 3), -1, dtype=np.int32), np.zeros((m, 9)), np.zeros((len(below), 9)), np.zeros((m, 3)),
    )  # fmt: skip


def elimination_order(neighbours: dict[int, set[int]]) -> tuple[list[int], dict[int, list[int]]]:
    """Nodes by least degree (then number), and of each those that are still there when it goes."""
    left = {node: set(others) for node, others in neighbours.items()}
    order, later = [], {}
    by_degree: dict[int, set[int]] = {}
    for node, others in left.items():
        by_degree.setdefault(len(others), set()).add(node)
    while left:
        least = min(degree for degree, nodes in by_degree.items() if nodes)
        node = min(by_degree[least])
        others = left.pop(node)
        by_degree[least].discard(node)
        order.append(node)
        later[node] = sorted(others)
        for other in later[node]:
            by_degree[len(left[other])].discard(other)
            left[other] |= others
            left[other] -= {node, other}
            by_degree.setdefault(len(left[other]), set()).add(other)
    return order, later


def plan_joints(joints: Joints, moving: NDArray[np.bool_]) -> JointPlan:
    """The plan of all joints that hold and are no mouse. moving (n,): bodies that couple their joints."""
    held = (joints.kinds != NO_JOINT) & (joints.kinds != MOUSE) & (joints.flags & BROKEN == 0)
    ids = np.flatnonzero(held).tolist()
    at_body: dict[int, list[int]] = {}
    for k in ids:
        for body in joints.bodies[k].tolist():
            if moving[body]:
                at_body.setdefault(body, []).append(k)
    if sum(elementary.square(len(group)) for group in at_body.values()) > MOST_UPDATES:
        return empty_plan()
    neighbours: dict[int, set[int]] = {k: set() for k in ids}
    for group in at_body.values():
        for k in group:
            neighbours[k] |= set(group) - {k}
    order, later = elimination_order(neighbours)
    if sum(len(others) * (len(others) + 1) // 2 for others in later.values()) > MOST_UPDATES:
        return empty_plan()
    place = {k: p for p, k in enumerate(order)}
    columns = [sorted(place[other] for other in later[k]) for k in order]
    starts = np.concatenate([[0], np.cumsum([len(rows) for rows in columns])]).astype(int).tolist()
    block = {(i, p): starts[p] + e for p, rows in enumerate(columns) for e, i in enumerate(rows)}
    links: list[tuple[int, ...]] = []
    for body, group in at_body.items():
        for n, k in enumerate(group):
            for other in group[:n]:
                low, high = sorted((place[k], place[other]))
                links.append((block[high, low], high, low, body))
    targets = [
        -1 - i if i == j else block[i, j]
        for rows in columns
        for n, i in enumerate(rows)
        for j in rows[: n + 1]
    ]
    return _with_memory(order, starts, [i for rows in columns for i in rows], links, targets)
