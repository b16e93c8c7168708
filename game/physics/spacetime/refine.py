"""Trees of circles against each other, level by level, for as many tests as there are (Hubbard 1993).

All pairs of bodies are refined breadth first together: first the roots of all of them, then the children of
what is left, and so on. It ends when nothing is left or the budget of tests is used up. At any moment each
pair of bodies has a lower and an upper bound of its distance. Of two nodes the larger is replaced by its
children. Two leaves are compared exactly, edge by edge, each pair of edges counted as a test.
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.spacetime import tree
from game.physics.spacetime.exact import polygon_distance

LOWER, UPPER, NORMAL_X, NORMAL_Y, PLACE_X, PLACE_Y, LEVEL, WEIGHT, ESTIMATE = range(9)  # of an answer
ANSWERS = 9
UNTESTED = -1.0  # level of a pair whose roots were not compared
PAIR, A, B, DONE = range(4)  # of a pair of nodes that is left; done: compared exactly, and they meet
FIRST_NODE, SECOND_NODE, LEAVES = range(3)  # what of two nodes is replaced by its children
CAPACITY = 4096  # pairs of nodes left at a time
NO_BOUND = 1e300


@inner_kernel
def _middle(nodes, n, pose, column):
    """A node's circle (column CX) or inner disc (WX) in the world."""
    x, y = nodes[n, column], nodes[n, column + 1]
    return pose[0] + pose[2] * x - pose[3] * y, pose[1] + pose[3] * x + pose[2] * y


@inner_kernel
def _compare(forest, pose_a, pose_b, a, b):
    """Signed gap of the circles of two nodes, and the distance of their discs within the bodies, m."""
    ax, ay = _middle(forest.nodes, a, pose_a, tree.CX)
    bx, by = _middle(forest.nodes, b, pose_b, tree.CX)
    gap = (
        math.sqrt(elementary.square(bx - ax) + elementary.square(by - ay))
        - forest.nodes[a, tree.RADIUS]
        - forest.nodes[b, tree.RADIUS]
    )
    ax, ay = _middle(forest.nodes, a, pose_a, tree.WX)
    bx, by = _middle(forest.nodes, b, pose_b, tree.WX)
    discs = (
        math.sqrt(elementary.square(bx - ax) + elementary.square(by - ay))
        - forest.nodes[a, tree.INNER]
        - forest.nodes[b, tree.INNER]
    )
    return gap, max(discs, 0.0)


@inner_kernel
def _keep(left, gaps, count, p, a, b, gap):
    left[count, PAIR], left[count, A], left[count, B], left[count, DONE] = p, a, b, 0
    gaps[count] = gap
    return count + 1


@inner_kernel
def _choose(forest, a, b):
    """Tests that refining two nodes takes, and which is replaced, if any."""
    links, nodes = forest.links, forest.nodes
    if links[a, tree.CHILDREN] == 0 and links[b, tree.CHILDREN] == 0:
        return links[a, tree.CORNERS] * links[b, tree.CORNERS], LEAVES
    if links[a, tree.CHILDREN] == 0 or (
        links[b, tree.CHILDREN] > 0 and nodes[b, tree.RADIUS] > nodes[a, tree.RADIUS]
    ):
        return links[b, tree.CHILDREN], SECOND_NODE
    return links[a, tree.CHILDREN], FIRST_NODE


@inner_kernel
def _compare_roots(forest, poses, pairs, reach, budget, left, gaps, answers):
    """Begin the answers with the roots of each pair, as far as the budget goes; (tests, pairs left)."""
    tests, count = 0, 0
    for p in range(pairs.shape[0]):
        for k in range(ANSWERS):
            answers[p, k] = 0.0
        answers[p, LOWER], answers[p, UPPER], answers[p, LEVEL] = NO_BOUND, NO_BOUND, UNTESTED
        if tests >= budget or count >= CAPACITY:
            answers[p, LOWER] = 0.0
            continue
        tests += 1
        a, b = forest.roots[pairs[p, 0]], forest.roots[pairs[p, 1]]
        gap, answers[p, UPPER] = _compare(forest, poses[pairs[p, 0]], poses[pairs[p, 1]], a, b)
        answers[p, LEVEL] = 0.0
        if gap > reach[p]:
            answers[p, LOWER] = gap
        else:
            count = _keep(left, gaps, count, p, a, b, gap)
    return tests, count


@inner_kernel
def _compare_leaves(forest, pose_a, pose_b, a, b, out):
    """Put the exact distance of two leaves into an answer; True if they meet."""
    links = forest.links
    found = polygon_distance(
        forest.corners,
        links[a, tree.FIRST],
        links[a, tree.CORNERS],
        pose_a,
        links[b, tree.FIRST],
        links[b, tree.CORNERS],
        pose_b,
    )
    out[UPPER], out[LOWER] = min(out[UPPER], found), min(out[LOWER], found)
    out[ESTIMATE] = 1.0
    return found == 0.0


@inner_kernel
def _compare_children(forest, placed, node, kind, reach, out, left, gaps, count):
    """Keep what is near of one node's children and the other; how many are kept then.

    placed: both bodies' poses; node: (pair, node of the first, node of the second).
    """
    p, a, b = node
    links = forest.links
    for child in range(links[b, tree.CHILDREN] if kind == SECOND_NODE else links[a, tree.CHILDREN]):
        a_now = links[a, tree.CHILD] + child if kind == FIRST_NODE else a
        b_now = links[b, tree.CHILD] + child if kind == SECOND_NODE else b
        gap, discs = _compare(forest, placed[0], placed[1], a_now, b_now)
        out[UPPER] = min(out[UPPER], discs)
        if gap > reach:
            out[LOWER] = min(out[LOWER], gap)
        elif gap < out[UPPER] or out[UPPER] == 0.0:
            count = _keep(left, gaps, count, p, a_now, b_now, gap)
    return count


@inner_kernel
def _settle(forest, poses, pairs, left, gaps, count, answers):
    """Bounds, normals and places of contact from what is left."""
    nodes = forest.nodes
    for i in range(count):
        p = left[i, PAIR]
        out, a, b = answers[p], left[i, A], left[i, B]
        out[LOWER] = min(out[LOWER], max(gaps[i], 0.0))
        if gaps[i] > 0.0:
            continue
        ax, ay = _middle(nodes, a, poses[pairs[p, 0]], tree.CX)
        bx, by = _middle(nodes, b, poses[pairs[p, 1]], tree.CX)
        dx, dy = bx - ax, by - ay
        far = math.sqrt(dx * dx + dy * dy)
        weight = max(nodes[a, tree.RADIUS] + nodes[b, tree.RADIUS] - far, 0.0)
        if far > 0.0:
            share = (nodes[a, tree.RADIUS] - 0.5 * weight) / far
            out[NORMAL_X] += weight * dx / far
            out[NORMAL_Y] += weight * dy / far
            out[PLACE_X] += weight * (ax + share * dx)
            out[PLACE_Y] += weight * (ay + share * dy)
            out[WEIGHT] += weight
    for p in range(pairs.shape[0]):
        out = answers[p]
        out[LOWER] = min(out[LOWER], out[UPPER])
        if out[ESTIMATE] > 0.0:  # leaves were compared: the upper bound is hardly ever beaten from then on
            out[ESTIMATE] = out[UPPER]
        elif out[LOWER] > 0.0:
            out[ESTIMATE] = 0.5 * (out[LOWER] + out[UPPER])
        long, weight = math.sqrt(out[NORMAL_X] * out[NORMAL_X] + out[NORMAL_Y] * out[NORMAL_Y]), out[WEIGHT]
        if weight > 0.0:
            out[PLACE_X] /= weight
            out[PLACE_Y] /= weight
        pose_a, pose_b = poses[pairs[p, 0]], poses[pairs[p, 1]]
        dx, dy = pose_b[0] - pose_a[0], pose_b[1] - pose_a[1]
        if long > 0.05 * weight:  # else circles on all sides: along the centres
            dx, dy = out[NORMAL_X], out[NORMAL_Y]
        long = max(math.sqrt(dx * dx + dy * dy), 1e-300)
        out[NORMAL_X], out[NORMAL_Y] = dx / long, dy / long


@lean_kernel
def refine(forest, poses, pairs, reach, budget, left, gaps, answers):
    """Answer how far pairs of bodies are apart, by at most ``budget`` tests; (tests, nodes left).

    poses: (bodies, 4) x, y, cosine, sine; pairs: (k, 2) bodies; reach: (k,) m, beyond which no more need be
    known; left: (2, CAPACITY, 4) and gaps: (2, CAPACITY), work, of which the first holds what is left in the
    end; answers: (k, ANSWERS). A pair whose roots were not compared has level UNTESTED and no bounds. The
    estimate is the middle of the bounds, or 0 where circles overlap; once leaves were compared, the upper.
    """
    tests, count = _compare_roots(forest, poses, pairs, reach, budget, left[0], gaps[0], answers)
    now, level, stopped, changed = 0, 0, False, True
    while changed and not stopped:
        changed, level, after = False, level + 1, 0
        next_left, next_gaps = left[1 - now], gaps[1 - now]
        for i in range(count):
            p, a, b, gap = left[now, i, PAIR], left[now, i, A], left[now, i, B], gaps[now, i]
            out = answers[p]
            if gap >= out[UPPER] and out[UPPER] > 0.0:
                continue
            price, kind = _choose(forest, a, b)
            full = after + price + count - i > CAPACITY and kind != LEAVES
            stopped = stopped or tests + price > budget or full
            if stopped or left[now, i, DONE] == 1 or out[UPPER] == 0.0:
                after = _keep(next_left, next_gaps, after, p, a, b, gap)
                next_left[after - 1, DONE] = left[now, i, DONE]
                continue
            changed, tests = True, tests + price
            out[LEVEL] = level
            pose_a, pose_b = poses[pairs[p, 0]], poses[pairs[p, 1]]
            if kind != LEAVES:
                after = _compare_children(
                    forest, (pose_a, pose_b), (p, a, b), kind, reach[p], out, next_left, next_gaps, after
                )
            elif _compare_leaves(forest, pose_a, pose_b, a, b, out):
                after = _keep(next_left, next_gaps, after, p, a, b, min(gap, 0.0))
                next_left[after - 1, DONE] = 1
        now, count = 1 - now, after
    if now == 1:
        for i in range(count):
            _keep(left[0], gaps[0], i, left[1, i, PAIR], left[1, i, A], left[1, i, B], gaps[1, i])
    _settle(forest, poses, pairs, left[0], gaps[0], count, answers)
    return tests, count


@kernel
def refine_many(forest, poses, budget, left, gaps, out):
    """Bounds of the distance of the first two bodies at many poses (q, 2, 4), each by its own budget.

    out: (q, 4): lower, upper, estimate, tests.
    """
    pairs = np.array([[0, 1]])
    reach = np.full(1, NO_BOUND)
    answers = np.zeros((1, ANSWERS))
    for q in range(poses.shape[0]):
        tests, _ = refine(forest, poses[q], pairs, reach, budget, left, gaps, answers)
        out[q, 0], out[q, 1], out[q, 2] = answers[0, LOWER], answers[0, UPPER], answers[0, ESTIMATE]
        out[q, 3] = tests
