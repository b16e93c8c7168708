"""Bounding volumes: what breaks fits, trees and queries of bounding volumes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.bounds import (
    KINDS,
    Query,
    build_tree,
    fit_capsule,
    fit_obb,
    minimal_capsule,
    minimal_obb,
    nearest,
    segment_distance,
    tandem,
    thinnest_capsule,
)
from game.physics.bounds.segments import SCRATCH, segments_meet
from game.physics.bounds.tree import tree_depth_bound

FITS = (fit_obb, lambda p: fit_obb(p, refine=True), minimal_obb)
CAPSULES = (fit_capsule, lambda p: fit_capsule(p, refine=True), thinnest_capsule, minimal_capsule)
HEXAGON = np.array([(0, 0), (4, -1), (7, 1), (6.5, 3), (3, 4.5), (0.5, 3)])
DEGENERATE = {
    "one point": [(3.0, 4.0)],
    "two points": [(0.0, 0.0), (1.0, 2.0)],
    "equal points": [(1.0, 1.0)] * 7,
    "in a row": [(0.0, 0.0), (2.0, 1.0), (1.0, 0.5), (4.0, 2.0)],
}


@pytest.mark.parametrize("points", DEGENERATE.values(), ids=DEGENERATE)
def test_c08_h1_no_area(points):
    for fit in (*FITS[1:], *CAPSULES[2:]):
        volume = fit(points)
        assert volume.area <= 1e-7 * max(np.ptp(points, axis=0).max(), 1.0) ** 2
        assert volume.outside(points).max() <= 1e-14
    box = fit_obb(points)
    assert np.all(np.isfinite((*box.centre, *box.axis, *box.half))) and math.hypot(
        *box.axis
    ) == pytest.approx(1)
    assert minimal_obb(points).half[0] == pytest.approx(0.5 * math.dist(min(points), max(points)))


def rectangle(aspect, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([(0, 0), (aspect, 0), (aspect, 1), (0, 1)]) @ np.array([[c, s], [-s, c]])


@pytest.mark.parametrize(
    ("aspect", "ratio"),
    [(1, 1.01745240643728), (2, 1.0218155080466), (5, 1.04537625673694), (10, 1.08813465250828),
     (100, 1.87270758389636)],
)  # fmt: skip
def test_c08_h2_half_a_degree_is_the_worst(aspect, ratio):
    assert fit_obb(rectangle(aspect, 0.5)).area / aspect == pytest.approx(ratio, rel=1e-12)
    assert fit_obb(rectangle(aspect, 0.0)).area / aspect == pytest.approx(1.0, rel=1e-13)
    assert minimal_obb(rectangle(aspect, 0.5)).area / aspect == pytest.approx(1.0, rel=1e-12)


def test_c08_h3_slivers():
    """Many times the least area, and still within the bound."""
    rng = np.random.default_rng(1)
    worst = 1.0
    for _ in range(400):
        points = rng.uniform(size=(3, 2)) * (1.0, 10.0 ** rng.uniform(-4, 0))
        points = points @ np.linalg.qr(rng.normal(size=(2, 2)))[0]
        best = minimal_obb(points)
        a = best.half[0] / best.half[1]
        ratio = fit_obb(points).area / best.area
        assert 1 - 1e-9 <= ratio <= 1 + (a + 1 / a) * math.sin(math.radians(1.0)) / 2 + 1e-9
        worst = max(worst, ratio)
    assert worst > 5.0


def test_c08_h4_the_same_box_however_it_is_given():
    box = fit_obb(HEXAGON)
    for points in (HEXAGON[::-1], np.repeat(HEXAGON, 3, axis=0), np.roll(HEXAGON, 2, axis=0)):
        assert fit_obb(points) == box and minimal_obb(points).area == pytest.approx(
            34.5882352941177, rel=1e-12
        )
    for scale in (1e-8, 1e8):
        scaled = fit_obb(scale * HEXAGON)
        assert scaled.axis == box.axis
        assert np.allclose(scaled.half, scale * np.array(box.half), rtol=1e-12, atol=0)
        capsule = fit_capsule(scale * HEXAGON)
        assert capsule.radius == pytest.approx(scale * fit_capsule(HEXAGON).radius, rel=1e-12)
    far = fit_obb(HEXAGON + 1e6)
    assert far.axis == box.axis and np.allclose(far.half, box.half, rtol=1e-9, atol=0)
    assert fit_capsule(HEXAGON + 1e6).area == pytest.approx(fit_capsule(HEXAGON).area, rel=1e-7)


def test_c08_h5_of_equal_directions_the_first():
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    assert fit_obb(square).axis in ((1.0, 0.0), (-0.0, 1.0), (0.0, 1.0))
    for n in (4, 6, 12):
        angle = 2 * np.pi * np.arange(n) / n
        points = np.column_stack((np.cos(angle), np.sin(angle)))
        assert all(fit_obb(points) == fit_obb(points) for _ in range(3))
        assert minimal_obb(points) == minimal_obb(points.copy())


@pytest.mark.parametrize("kind", KINDS)
def test_c08_h6_touching_and_parallel(kind):
    """Closed, on every side, and with cross terms that vanish."""
    square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
    a, b = (build_tree(square, kind, 1, closed=True) for _ in range(2))
    for offset in ((2, 0), (-2, 0), (0, 2), (0, -2), (2, 2), (2, 0.5)):
        assert len(tandem(a, b, offset).crossings) > 0
        apart = 1.0 + 1e-9
        assert len(tandem(a, b, (apart * offset[0], apart * offset[1])).crossings) == 0
    assert len(tandem(a, b.turned(math.pi / 2), (2.0, 0.0)).crossings) > 0


@pytest.mark.parametrize("kind", KINDS)
def test_c08_h7_small_trees_and_trees_that_no_line_halves(kind):
    one, two = build_tree([(0, 0), (1, 1)], kind, 1), build_tree([(0, 1), (1, 0), (2, 1)], kind, 1)
    assert (len(one), len(two)) == (1, 3)
    assert tandem(one, two).crossings.tolist() == [[0, 0]]
    strokes = []
    for i in range(40):
        angle = math.pi * i / 40
        strokes += [(math.cos(angle), math.sin(angle)), (-math.cos(angle), -math.sin(angle))]
    for points in (strokes, [(1.0, 1.0)] * 50, np.column_stack((0.5 ** np.arange(300), np.zeros(300)))):
        tree = build_tree(points, kind, 1)
        tree.check()
        assert tree.depth <= tree_depth_bound(tree.segments)


def brute(a, b, offset):
    spare, found = np.zeros(SCRATCH), []
    for i, e in enumerate(a.ends.tolist()):
        for j, f in enumerate((b.ends + np.tile(offset, 2)).tolist()):
            if segments_meet(*e, *f, spare):
                found.append([i, j])
    return found


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("leaf_size", [1, 4])
def test_c08_h8_identical_inside_disjoint_touching(kind, leaf_size):
    angle = 2 * np.pi * np.arange(40) / 40
    star = np.column_stack((np.cos(angle), np.sin(angle))) * np.where(np.arange(40) % 2, 1.0, 0.5)[:, None]
    a = build_tree(star, kind, leaf_size, closed=True)
    small = build_tree(0.4 * star, kind, leaf_size, closed=True)
    for other, offset, meets in (
        (a, (0.0, 0.0), 120),
        (small, (0.0, 0.0), 0),
        (a, (5.0, 0.0), 0),
        (a, (2.0 * star[1, 0], 0.0), None),
    ):
        query = Query(a, other)
        query.run(offset)
        query.check()
        pairs = query.answer().crossings.tolist()
        assert pairs == brute(a, other, offset)
        assert meets is None or len(pairs) == meets
    query.run((5.0, 0.0))
    assert query.volume_tests == 1


LISTED = [
    ([(0, 0), (4, 0)], [(0, 1), (4, 1)], 1.0), ([(0, 0), (4, 0)], [(5, 0), (7, 0)], 1.0),
    ([(0, 0), (4, 0)], [(3, 0), (7, 0)], 0.0), ([(0, 0), (4, 0)], [(2, -1), (2, 1)], 0.0),
    ([(0, 0), (4, 0)], [(2, 0), (2, 3)], 0.0), ([(0, 0), (1, 0)], [(1.5, 1), (3, 2)], 1.11803398874989),
    ([(0, 0), (0, 0)], [(3, 4), (3, 4)], 5.0), ([(0, 0), (0, 0)], [(1, -1), (1, 5)], 1.0),
]  # fmt: skip


@pytest.mark.parametrize(("first", "second", "distance"), LISTED)
def test_c09_h1_h2_cores_of_all_sorts(first, second, distance):
    assert segment_distance(first, second) == pytest.approx(distance, rel=0, abs=1e-13)
    for kind in KINDS:
        found = nearest(build_tree(first, kind), build_tree(second, kind))
        assert found.distance == pytest.approx(distance, rel=0, abs=1e-13)


@pytest.mark.parametrize("angle", [1e-9, 1e-15, -1e-9])
def test_c09_h3_nearly_parallel(angle):
    """Ends alone decide: no quotient of small numbers."""
    first = [(-3.0, 0.0), (3.0, 0.0)]
    second = [(-2.0, 1.0), (4.0, 1.0 + 6.0 * angle)]
    expected = min(1.0, 1.0 + 5.0 * angle)
    assert segment_distance(first, second) == pytest.approx(expected, rel=0, abs=1e-12 * 7.0)
    crossing = [(-3.0, -3.0 * abs(angle)), (3.0, 3.0 * abs(angle))]
    assert segment_distance(first, crossing) == pytest.approx(0.0, abs=1e-15)


def test_c09_h4_touching_capsules_overlap():
    """d = r1 + r2 exactly, with numbers that have no rounding."""
    lozenge = [(-1.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0)]
    a, b = (build_tree(lozenge, "capsule", 4, closed=True) for _ in range(2))
    assert a.volume(0).radius == 1.0 and a.volume(0).length == 0.0
    assert len(tandem(a, b, (2.0, 0.0)).leaf_pairs) == 1
    assert len(tandem(a, b, (0.0, 2.0)).leaf_pairs) == 1
    assert tandem(a, b, (2.0 + 1e-12, 0.0)).separated


def test_c09_h5_far_away():
    """The error stays a few roundings of the coordinates."""
    rng = np.random.default_rng(3)
    for _ in range(100):
        p, q, r, s = np.round(rng.uniform(-10, 10, (4, 2)) * 64) / 64  # exact at 1e8, too
        near = segment_distance([p, q], [r, s])
        far = segment_distance([p + 1e8, q + 1e8], [r + 1e8, s + 1e8])
        assert far == pytest.approx(near, rel=0, abs=8 * np.finfo(float).eps * 1e8)


def test_c09_h6_fits_without_radius_or_without_core():
    for points in ([(0, 0), (2, 1), (1, 0.5), (4, 2)], [(0, 0), (3, 4)]):
        for fit in (thinnest_capsule, minimal_capsule):
            assert fit(points).radius <= 1e-15
        assert fit_capsule(points, refine=True).radius <= 1e-9
    angle = 2 * np.pi * np.arange(48) / 48
    circle = np.column_stack((np.cos(angle), np.sin(angle)))
    for fit in (*CAPSULES[:2], minimal_capsule):
        capsule = fit(circle)
        assert capsule.length < 0.02 and capsule.radius == pytest.approx(1.0, abs=0.01)


def test_absurd_sizes_end():
    """Any numbers: no exception but ValueError, nothing endless, nothing that is not finite."""
    for scale in (1e-300, 1e-160, 1e-30, 1e30, 1e99):
        for kind in KINDS:
            tree = build_tree(scale * HEXAGON, kind, 1, closed=True)
            assert np.all(np.isfinite(tree.volumes)) and tree.segments == 6
            assert np.isfinite(nearest(tree, tree, (3 * scale, 0)).distance)
            assert len(tandem(tree, tree).leaf_pairs) > 0
    with pytest.raises(ValueError, match="beyond"):
        build_tree(1e300 * HEXAGON)
    mixed = build_tree([(0, 0), (1e-300, 0), (1e99, 1e99), (0, 1e-10)], "capsule", 1)
    assert np.all(np.isfinite(mixed.volumes))
