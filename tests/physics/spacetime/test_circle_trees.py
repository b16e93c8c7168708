"""Circle trees cover their bodies, and bound their distances at every budget."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union

from game.lab.studies.spacetime import all_pairs, answers, pose_pairs, relative_errors
from game.physics.spacetime.motion import Laws
from game.physics.spacetime.pieces import least_circle, triangulate
from game.physics.spacetime.shapes import KINDS, area_and_centre, outline_of, second_moment
from game.physics.spacetime.tree import CHILD, CHILDREN, INNER, RADIUS, CircleTree, tree_of
from game.physics.spacetime.world import TimedBody, TimedWorld

EVERY = [(kind, variant) for kind in KINDS for variant in range(3)]
STILL = Laws(1.0, 0.0, 1.0, 9.0, 9.0)


@pytest.mark.parametrize(("kind", "variant"), EVERY)
def test_every_level_covers_the_body(kind, variant):
    tree = tree_of(kind, variant)
    tree.check()
    body = Polygon(tree.outline)
    assert body.is_valid
    for depth in range(tree.depth + 1):
        circles = [
            Point(x, y).buffer(r * 1.0005, 256) for x, y, r in tree.nodes[tree.level(depth), :3].tolist()
        ]
        assert body.difference(unary_union(circles)).area < 1e-12
    largest = [float(np.max(tree.nodes[tree.level(depth), RADIUS])) for depth in range(tree.depth + 1)]
    assert largest[-1] <= 0.16 and largest == sorted(largest, reverse=True)


@pytest.mark.parametrize(("kind", "variant"), EVERY)
def test_inner_discs_lie_within_the_body(kind, variant):
    tree = tree_of(kind, variant)
    body = Polygon(tree.outline).buffer(1e-9)
    for x, y, s in tree.nodes[:, 3:].tolist():
        assert body.covers(Point(x, y)) and body.boundary.distance(Point(x, y)) >= s * (1.0 - 1e-9)
    assert np.max(tree.nodes[:, INNER]) > 0.05


def test_check_notices_a_circle_that_is_too_small_and_a_part_that_is_gone():
    small = CircleTree(outline_of("comb"))
    small.nodes[3, RADIUS] *= 0.98
    with pytest.raises(AssertionError, match="too small"):
        small.check()
    short = CircleTree(outline_of("comb"))
    short.links[0, CHILDREN] -= 1
    with pytest.raises(AssertionError, match="covered"):
        short.check()


def test_every_node_but_the_roots_is_the_child_of_one():
    for kind, variant in EVERY:
        links = tree_of(kind, variant).links
        children = [k for first, n in links[:, [CHILD, CHILDREN]].tolist() for k in range(first, first + n)]
        assert sorted(children) == list(range(1, len(links)))


def test_bounds_hold_and_narrow_at_every_budget_and_end_at_the_exact_distance():
    for pairs in all_pairs():
        before = np.full(len(pairs.exact), math.inf)
        for budget in (1, 7, 30, 90, 300, 900, 100_000):
            found = answers(pairs, budget)
            assert np.all(found[:, 0] <= pairs.exact + 1e-12), budget
            assert np.all(found[:, 1] >= pairs.exact - 1e-12), budget
            assert np.all(found[:, 3] <= budget) and np.all(found[:, 0] <= found[:, 2])
            assert np.all(found[:, 2] <= found[:, 1])
            assert np.all(found[:, 1] <= before + 1e-12)
            before = found[:, 1]
        assert np.max(relative_errors(pairs, found)) < 1e-12
        assert np.array_equal(answers(pairs, 90), answers(pairs, 90))


def test_the_exact_distance_is_shapely_s():
    for kind in KINDS:
        pairs = pose_pairs(kind, "comb", seed=11)
        for pose, exact in zip(pairs.poses[:40], pairs.exact, strict=False):
            placed = []
            for (first, n), (x, y, c, s) in zip(pairs.world.spans.tolist(), pose.tolist(), strict=True):
                placed.append(
                    Polygon(pairs.world.outlines[first : first + n] @ np.array(((c, s), (-s, c))) + (x, y))
                )
            assert exact == pytest.approx(placed[0].distance(placed[1]), abs=1e-12)


def test_one_body_inside_the_other_is_in_contact():
    world = TimedWorld(
        [TimedBody("star", 0, 2.0, (0.0, 0.0)), TimedBody("coast", 1, 0.1, (0.1, 0.05))], (9.0, 9.0), STILL
    )
    assert world.exact(0, 1) == 0.0
    for budget in (1, 20, 100_000):
        answer, _ = world.ask(0, 1, budget)
        assert answer.lower == 0.0
    assert answer.upper == 0.0


def test_no_budget_means_no_answer():
    world = TimedWorld(
        [TimedBody("star", 0, 1.0, (0.0, 0.0)), TimedBody("star", 0, 1.0, (5.0, 0.0))], (9.0, 9.0), STILL
    )
    answer, left = world.ask(0, 1, 0)
    assert (
        answer.level == -1
        and answer.tests == 0
        and answer.lower == 0.0
        and answer.upper > 1e6
        and len(left) == 0
    )


def test_pieces_tile_their_polygon_and_the_least_circle_holds_its_points():
    chance = np.random.default_rng(2)
    for kind, variant in EVERY:
        outline = outline_of(kind, variant)
        pieces = triangulate(outline)
        assert sum(Polygon(piece).area for piece in pieces) == pytest.approx(Polygon(outline).area, rel=1e-12)
        assert area_and_centre(outline)[1] == pytest.approx((0.0, 0.0), abs=1e-12)
    for _ in range(30):
        points = [tuple(p) for p in chance.normal(size=(12, 2)).tolist()]
        x, y, radius = least_circle(points)
        far = sorted(math.hypot(px - x, py - y) for px, py in points)
        assert far[-1] <= radius <= far[-1] * (1.0 + 1e-9) and far[-2] == pytest.approx(radius, rel=1e-6)


def test_the_second_moment_of_a_square():
    square = np.array(((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)))
    assert second_moment(square) == pytest.approx(8.0 / 3.0)


@pytest.mark.parametrize(
    "outline", [[(0, 0), (1, 0)], [(0, 0), (0, 1), (1, 0)], [(0, 0), (1, 0), (math.nan, 1)]]
)
def test_nonsense_is_refused(outline):
    with pytest.raises(ValueError, match="expected"):
        CircleTree(np.array(outline, dtype=float))
    with pytest.raises(ValueError, match="kind"):
        outline_of("square")
