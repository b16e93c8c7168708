"""Trees and their queries: against brute force, from step to step, with certificates."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.bounds import (
    FITS,
    KINDS,
    SPLITS,
    Query,
    build_tree,
    nearest,
    tandem,
    traversal,
)
from game.physics.bounds.query import ANCESTOR, OVERLAPPING, REST
from game.physics.bounds.segments import SCRATCH, segments_meet
from game.physics.bounds.tree import tree_depth_bound
from tests.physics.bounds.outline_pairs import INSIDE, PAIRS

kinds = pytest.mark.parametrize("kind", KINDS)
SPARE = np.zeros(SCRATCH)


@kinds
@pytest.mark.parametrize("extent", [1.0, 1e3, 1e9])
def test_volumes_hold_segments_that_are_a_line_but_for_rounding(kind, extent):
    """Where rounding alone turns the outline, its far end must not be taken for a point on its way."""
    random = np.random.default_rng(1)
    for _ in range(300):
        count, angle = int(random.integers(2, 6)), 0.0 if kind == "aabb" else random.normal()
        along, across = np.sort(random.random(count)), random.normal(0.0, 1e-16, count)
        line = extent * turned(np.column_stack((along, across)), angle, (0.0, 0.0))
        trees = [build_tree(line * scale, kind, 1) for scale in (1.0, random.uniform(0.1, 1.5))]
        for tree in trees:
            tree.check()
        query = Query(*trees)
        query.run(
            line[-1] * random.normal() + extent * 1e-13, 0.0 if kind == "aabb" else random.normal(0, 1e-12)
        )
        query.check()
        assert query.volume_tests >= 1


def arc(n, radius, start=0.3, sweep=math.pi / 2):
    angles = np.linspace(start, start + sweep, n + 1)
    return radius * np.column_stack((np.cos(angles), np.sin(angles)))


def walk(seed, n, size=1.0):
    """A random polyline that crosses itself."""
    return size * np.cumsum(np.random.default_rng(seed).normal(size=(n + 1, 2)), axis=0) / math.sqrt(n)


def turned(points, angle, offset):
    c, s = math.cos(angle), math.sin(angle)
    return (
        np.column_stack((c * points[:, 0] - s * points[:, 1], s * points[:, 0] + c * points[:, 1])) + offset
    )


def brute(tree_a, tree_b, offset, angle=0.0):
    """Pairs of segments that meet, every pair tested."""
    c, s = math.cos(angle), math.sin(angle)
    pairs = []
    for j, (x0, y0, x1, y1) in enumerate(tree_b.ends.tolist()):
        moved = [
            c * x0 - s * y0 + offset[0], s * x0 + c * y0 + offset[1],
            c * x1 - s * y1 + offset[0], s * x1 + c * y1 + offset[1],
        ]  # fmt: skip
        pairs += [(i, j) for i, end in enumerate(tree_a.ends.tolist()) if segments_meet(*end, *moved, SPARE)]
    return sorted(pairs)


@kinds
@pytest.mark.parametrize("fit", FITS)
@pytest.mark.parametrize("split", SPLITS)
def test_trees_hold_their_points_whatever_the_options(kind, fit, split):
    for leaf_size, closed in ((1, True), (5, False)):
        tree = build_tree(walk(3, 60), kind, leaf_size, fit=fit, split=split, closed=closed)
        tree.check()
        assert tree.segments == 60 + closed
        sizes = [len(tree.segments_of(node)) for node in tree.leaves]
        assert max(sizes) <= leaf_size and sum(sizes) == tree.segments
        assert len(tree) == 2 * len(sizes) - 1


def test_better_fits_have_less_area_and_each_level_is_refitted():
    points = walk(5, 200)
    area = {fit: build_tree(points, "obb", 1, fit=fit).areas()[0] for fit in FITS}
    assert area["exact"] <= area["refined"] * (1 + 1e-9) <= area["search"] * (1 + 1e-9)
    tree = build_tree(arc(256, 1.0), "obb", 1, fit="exact")
    by_level = [tree.areas()[tree.level(depth)].sum() for depth in range(tree.depth)]
    assert all(b < 0.3 * a for a, b in pairwise(by_level[:7]))


@kinds
def test_a_tree_turned_is_the_tree_of_the_turned_line(kind):
    points = walk(7, 50)
    tree = build_tree(points, kind, 3)
    for angle in (0.0, 0.4, -2.0, math.pi):
        other = tree.turned(angle)
        other.check()
        assert np.allclose(other.points, turned(points, angle, 0.0), rtol=0, atol=1e-14)
        if kind != "aabb":
            assert np.array_equal(other.order, tree.order)
            assert np.allclose(other.areas(), tree.areas(), rtol=1e-12, atol=1e-15)


@kinds
@settings(max_examples=25, deadline=None)
@given(
    st.integers(0, 10**6), st.integers(1, 40), st.integers(1, 40), st.integers(1, 6), st.floats(-1.5, 1.5),
    st.floats(-1.5, 1.5), st.floats(-4, 4),
)  # fmt: skip
def test_the_pairs_are_those_of_brute_force(kind, seed, n, m, leaf_size, x, y, angle):
    a, b = build_tree(walk(seed, n), kind, leaf_size), build_tree(walk(seed + 1, m), kind, leaf_size)
    if kind == "aabb":
        b, angle = b.turned(angle), 0.0
    answer = tandem(a, b, (x, y), angle)
    assert [tuple(row) for row in answer.crossings.tolist()] == brute(a, b, (x, y), angle)
    query = Query(a, b)
    query.run((x, y), angle)
    query.check()
    assert query.volume_tests == answer.volume_tests == len(answer.rows)
    assert query.leaves_met == len(answer.leaf_pairs)
    loose = tandem(a, b, (x, y), angle, exact=False)
    assert loose.segment_tests == 0 and len(loose.crossings) == 0
    assert np.array_equal(loose.leaf_pairs, answer.leaf_pairs)


lattice_lines = st.lists(
    st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=1, max_size=12
).map(lambda rows: np.array(rows, dtype=float))  # fmt: skip


@kinds
@settings(max_examples=40, deadline=None)
@given(lattice_lines, lattice_lines, st.integers(-4, 4), st.integers(-4, 4))
def test_touching_on_a_lattice_is_never_missed(kind, first, second, x, y):
    """Everything touches exactly, boxes have no breadth, points come twice."""
    a, b = build_tree(first, kind, 1), build_tree(second, kind, 1)
    a.check()
    answer = tandem(a, b, (x, y))
    assert [tuple(row) for row in answer.crossings.tolist()] == brute(a, b, (x, y))


@kinds
@pytest.mark.parametrize("pair", PAIRS, ids=lambda pair: pair[0])
def test_outlines_of_known_distance(kind, pair):
    """The distance by both trees; the flag of meeting where it is certain."""
    name, first, second, distance, tolerance, certain = pair
    a, b = build_tree(first, kind, 2, closed=True), build_tree(second, kind, 2, closed=True)
    a.check()
    inside = name.startswith("containment")
    found = nearest(a, b)
    if not inside:
        assert found.distance == pytest.approx(distance, rel=0, abs=tolerance)
        assert math.dist(found.point_a, found.point_b) == pytest.approx(found.distance, rel=1e-12, abs=1e-300)
    meets = len(tandem(a, b).crossings) > 0
    if certain:
        assert meets == (distance == 0.0 and not inside)
    elif "touching" in name or "ulp" in name or "gap" in name:  # decided exactly all the same
        assert meets == (distance == 0.0)
    assert any(word in name for word in INSIDE) or certain or tolerance < 1.0


@kinds
def test_nearest_is_brute_force_and_volumes_are_no_nearer(kind):
    for seed in range(6):
        a, b = build_tree(walk(seed, 30), kind, 2), build_tree(walk(seed + 50, 25), kind, 2)
        offset, angle = (2.5 * math.cos(seed), 2.5 * math.sin(seed)), 0.3 * seed
        found = nearest(a, b, offset, angle)
        b = b.turned(angle)
        from_all = math.inf
        for e in a.ends:
            for f in b.ends + np.tile(offset, 2):
                from_all = min(from_all, segment_distance_of(e, f))
        assert found.distance == pytest.approx(from_all, rel=1e-9, abs=1e-12)
        answer = tandem(a, b, offset)
        if len(answer.crossings) == 0:
            assert found.distance > 0.0
            for (node_a, node_b, verdict, *_), gap in zip(
                answer.rows.tolist(), answer.gaps[:, 0], strict=True
            ):
                if verdict == traversal.APART and node_a == node_b == 0:
                    assert gap <= found.distance * (1 + 1e-12)


def segment_distance_of(e, f):
    from game.physics.bounds import segment_distance

    return segment_distance(e.reshape(2, 2), f.reshape(2, 2))


@kinds
def test_separating_needs_few_tests_where_boxes_hug_the_curve(kind):
    """Concentric arcs a gap g apart: 1/g tests for axis-aligned boxes, 1/sqrt(g) for the others."""
    tests = []
    for gap in (0.1, 0.01, 0.001):
        answer = tandem(
            build_tree(arc(1024, 1.0), kind, 1, fit="exact"),
            build_tree(arc(1024, 1.0 + gap), kind, 1, fit="exact"),
        )
        assert len(answer.crossings) == 0
        tests.append(answer.volume_tests)
    growth = tests[2] / tests[1]
    assert 6.0 < growth < 12.0 if kind == "aabb" else 2.5 < growth < 6.5
    assert tests[2] > 3000 if kind == "aabb" else tests[2] < 450


@kinds
def test_a_front_gives_the_same_crossings_with_fewer_tests(kind):
    a, b = build_tree(walk(11, 120), kind, 2), build_tree(walk(12, 120), kind, 2)
    with_front, again = Query(a, b), Query(a, b)
    kept = fresh = 0
    for i in range(60):
        offset = (0.3 * math.cos(0.01 * i), 0.4 * math.sin(0.013 * i))
        with_front.run(offset, coherent=i > 0)
        again.run(offset)
        with_front.check()
        if i:
            kept += with_front.volume_tests
            fresh += again.volume_tests
        assert np.array_equal(with_front.answer().crossings, again.answer().crossings)
        met = {tuple(pair) for pair in with_front.answer().leaf_pairs.tolist()}
        assert met >= {tuple(pair) for pair in again.answer().leaf_pairs.tolist()}
    assert kept < 0.85 * fresh
    for _ in range(100):  # far apart, the front draws back to the roots
        with_front.run((50.0, 0.0), coherent=True)
    assert with_front.row_count == 1 and with_front.volume_tests == 1


def test_a_query_can_be_kept_and_taken_up_again():
    a, b = build_tree(walk(21, 300)), build_tree(walk(22, 300))
    query, twin = Query(a, b), Query(a, b)
    query.run((0.1, 0.0))
    kept = type(query.record())(*(part.copy() for part in query.record()))
    before = query.answer()
    query.run((0.11, 0.0), coherent=True)
    twin.put_back(kept)
    assert twin.volume_tests == before.volume_tests and np.array_equal(twin.rows, before.rows)
    assert np.array_equal(twin.answer().crossings, before.crossings)
    twin.run((0.11, 0.0), coherent=True)
    assert np.array_equal(twin.rows, query.rows) and np.array_equal(twin.gaps, query.gaps)
    small = Query(build_tree([(0, 0), (1, 1)]), b)
    with pytest.raises(ValueError, match="other trees"):
        small.put_back(kept)


def test_marks_are_leaves_and_their_ancestors_up_to_the_roots():
    a, b = build_tree(arc(64, 1.0, 0, 3.0), leaf_size=4), build_tree(arc(64, 1.0, 0, 3.0), leaf_size=4)
    query = Query(a, b)
    query.run((0.3, 0.0))
    marks_a, marks_b = query.marks()
    answer = query.answer()
    for tree, marks, column in ((a, marks_a, 0), (b, marks_b, 1)):
        red = np.unique(answer.leaf_pairs[:, column])
        assert np.array_equal(np.flatnonzero(marks == OVERLAPPING), red)
        green = set()
        for node in red.tolist():
            while (node := int(tree.links[node, 3])) >= 0:
                green.add(node)
        assert set(np.flatnonzero(marks == ANCESTOR).tolist()) == green and 0 in green
    query.run((9.0, 0.0))
    assert query.answer().separated
    assert np.all(query.marks()[0] == REST) and np.all(query.marks()[1] == REST)
    first, _ = query.marks(0)
    assert not first.any()


def test_more_pairs_than_there_is_room_for():
    points = np.zeros((60, 2))
    tree = build_tree(points, leaf_size=1)
    answer = tandem(tree, tree)
    assert len(answer.crossings) == 59 * 59 == len(answer.leaf_pairs)
    assert tree.depth <= tree_depth_bound(59)


def test_clustered_points_make_no_deep_tree():
    points = np.column_stack((0.5 ** np.arange(900), np.zeros(900)))
    for split in SPLITS:
        tree = build_tree(points, leaf_size=1, split=split)
        tree.check()
        assert tree.depth <= tree_depth_bound(tree.segments)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"kind": "sphere"}, "kind"),
        ({"leaf_size": 0}, "leaf_size"),
        ({"leaf_size": 1.5}, "leaf_size"),
        ({"leaf_size": True}, "leaf_size"),
        ({"fit": "guess"}, "fit"),
        ({"split": "thirds"}, "split"),
        ({"step_degrees": 0.0}, "step_degrees"),
        ({"polyline": []}, "polyline"),
        ({"polyline": [(0, 0), (math.nan, 1)]}, r"polyline\[1\]"),
    ],
)
def test_what_is_no_tree_is_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        build_tree(**{"polyline": [(0, 0), (1, 1)], **arguments})


def test_what_is_no_query_is_refused():
    box, capsule = build_tree([(0, 0), (1, 1)]), build_tree([(0, 0), (1, 1)], "capsule")
    upright = build_tree([(0, 0), (1, 1)], "aabb")
    for call in (tandem, nearest):
        with pytest.raises(ValueError, match="one kind"):
            call(box, capsule)
        with pytest.raises(ValueError, match="offset_b"):
            call(box, box, (math.nan, 0.0))
        with pytest.raises(ValueError, match="turn_b"):
            call(box, box, (0.0, 0.0), math.inf)
    for ask in (Query(upright, upright).run, lambda *place: tandem(upright, upright, *place)):
        with pytest.raises(ValueError, match="do not turn"):
            ask((0, 0), 0.5)
    assert len(tandem(upright, upright.turned(math.pi / 2)).crossings) == 1


def test_pairs_are_of_leaves_that_the_caller_has():
    """Every pair names a leaf of each tree that was given, also where the tree had to be turned before."""
    for kind in KINDS:
        a, b = build_tree(walk(1, 40), kind, 3), build_tree(walk(2, 40), kind, 3).turned(0.7)
        answer = tandem(a, b)
        assert len(answer.leaf_pairs) > 0
        assert set(answer.leaf_pairs[:, 0].tolist()) <= set(a.leaves.tolist())
        assert set(answer.leaf_pairs[:, 1].tolist()) <= set(b.leaves.tolist())
        for i, j in answer.crossings.tolist():
            assert any(i in a.segments_of(m) and j in b.segments_of(n) for m, n in answer.leaf_pairs.tolist())


@kinds
def test_the_reach_of_a_tree_holds_its_volumes(kind):
    """Corners of a slanting box lie farther out than any point; what counts as rounding goes by the reach."""
    points = turned(np.array([(-1.0, 0.0), (1.0, 0.0), (0.0, 0.9)]), math.pi / 4, 0.0)
    tree = build_tree(points, kind, 3, closed=True)
    row = tree.volumes[0]
    if kind == "capsule":
        outermost = np.abs(row[:4]).max() + row[4]
    else:
        along, across = row[2:4] * row[4], np.array([-row[3], row[2]]) * row[5]
        outermost = max(np.abs(row[:2] + a * along + b * across).max() for a in (-1, 1) for b in (-1, 1))
    if kind == "obb":
        assert outermost > np.abs(points).max() + 0.3
    assert tree.reach >= outermost
