"""Boxes: the search by degrees, its refinement, the exact one; areas known, bounds proven, naive twins."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from game.physics.bounds import fit_obb, minimal_obb, principal_box, upright_box
from game.physics.bounds.hull import hull_of
from game.physics.bounds.validation import turns_of

HEXAGON = [(0, 0), (4, -1), (7, 1), (6.5, 3), (3, 4.5), (0.5, 3)]
FITTERS = {
    "search": fit_obb,
    "refined": lambda points: fit_obb(points, refine=True),
    "exact": minimal_obb,
    "upright": upright_box,
    "principal": principal_box,
}


def regular(n, radius=1.0, turn=0.0):
    angles = turn + 2 * np.pi * np.arange(n) / n
    return radius * np.column_stack((np.cos(angles), np.sin(angles)))


def rectangle(aspect, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([(0, 0), (aspect, 0), (aspect, 1), (0, 1)]) @ np.array([[c, s], [-s, c]])


def naive_area(points, angle):
    c, s = math.cos(angle), math.sin(angle)
    return float(np.ptp(points @ (c, s)) * np.ptp(points @ (-s, c)))


def naive_least(points):
    """Area of the least box on a side of the hull, every side tried."""
    hull = points[ConvexHull(points).vertices]
    return min(naive_area(hull, math.atan2(y, x)) for x, y in np.roll(hull, -1, axis=0) - hull)


clouds = st.lists(
    st.tuples(st.integers(-40, 40), st.integers(-40, 40)), min_size=1, max_size=40
).map(lambda rows: np.array(rows, dtype=float))  # fmt: skip


def test_areas_known_in_closed_form():
    pentagon = 2 * math.sin(math.radians(72)) * (1 + math.cos(math.radians(36)))
    assert minimal_obb(regular(5)).area == pytest.approx(pentagon, rel=1e-14)
    assert minimal_obb(HEXAGON).area == pytest.approx(34.5882352941177, rel=1e-13)
    assert fit_obb(HEXAGON).area == pytest.approx(34.5969468314805, rel=1e-13)
    assert fit_obb(HEXAGON, refine=True).area == pytest.approx(34.5882352941177, rel=1e-9)
    assert minimal_obb(regular(400)).area < 4.0


@pytest.mark.parametrize("aspect", [1, 2, 5, 10, 100])
def test_the_search_is_worst_half_a_degree_off_a_rectangle(aspect):
    """Equality of the bound 1 + (a + 1/a) sin(2 δ) / 2, and the refined box is the rectangle."""
    bound = 1 + (aspect + 1 / aspect) * math.sin(math.radians(1.0)) / 2
    points = rectangle(aspect, 0.5)
    assert fit_obb(points).area == pytest.approx(aspect * bound, rel=1e-12)
    assert fit_obb(points, refine=True).area == pytest.approx(aspect, rel=1e-7)
    assert fit_obb(rectangle(aspect, 0.0)).area == pytest.approx(aspect, rel=1e-14)


@settings(max_examples=80, deadline=None)
@given(clouds, st.floats(0.5, 20.0))
def test_the_bound_holds_for_any_points(points, step):
    best, found = minimal_obb(points), fit_obb(points, step)
    a, b = best.half
    if b <= 1e-9 * a or a == 0.0:
        return
    rest = 90.0 - step * (len(turns_of(step)) - 1)  # the last gap may be smaller
    delta = math.radians(max(step, rest))
    assert best.area <= found.area * (1 + 1e-12)
    assert found.area <= best.area * (1 + (a / b + b / a) * math.sin(delta) / 2) * (1 + 1e-12)
    refined = fit_obb(points, step, refine=True)
    assert best.area * (1 - 1e-12) <= refined.area <= found.area * (1 + 1e-12)


@settings(max_examples=80, deadline=None)
@given(clouds)
def test_calipers_and_walking_search_are_their_naive_twins(points):
    extent = max(float(np.ptp(points, axis=0).max()), 1.0)
    angles = np.radians(np.arange(90))
    least = min(naive_area(points, angle) for angle in angles)
    assert fit_obb(points).area == pytest.approx(least, rel=1e-12, abs=1e-12 * extent**2)
    hull, _ = hull_of(points)
    if len(hull) > 2:
        assert minimal_obb(points).area == pytest.approx(naive_least(points), rel=1e-11)


@pytest.mark.parametrize("name", FITTERS)
@settings(max_examples=30, deadline=None)
@given(clouds, st.floats(0, 7))
def test_every_point_is_inside_and_axes_are_unit(name, points, angle):
    c, s = math.cos(angle), math.sin(angle)
    points = points @ np.array([[c, s], [-s, c]])
    box = FITTERS[name](points)
    extent = max(float(np.ptp(points, axis=0).max()), 1e-300)
    assert box.outside(points).max() <= 1e-12 * max(extent, 1.0)
    assert math.hypot(*box.axis) == pytest.approx(1.0, abs=1e-15)
    if name != "principal":
        assert box.half[0] >= box.half[1] >= 0.0
    corners = box.corners()
    assert np.allclose(corners.mean(axis=0), box.centre, rtol=0, atol=1e-12 * max(extent, 1.0))
    x, y = corners.T
    shoelace = 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))
    assert shoelace == pytest.approx(box.area, rel=1e-9, abs=1e-12 * max(extent, 1.0) ** 2)


@settings(max_examples=100, deadline=None)
@given(clouds)
def test_hull_is_that_of_scipy(points):
    hull, origin = hull_of(points)
    x, y = hull.T
    area = 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))
    if len(hull) < 3:
        assert area == 0.0
        return
    theirs = ConvexHull(points)
    assert area == pytest.approx(theirs.volume, rel=1e-12)
    assert len(hull) <= len(theirs.vertices)
    turned = np.roll(hull, -1, axis=0) - hull
    following = np.roll(turned, -1, axis=0)
    assert np.all(turned[:, 0] * following[:, 1] - turned[:, 1] * following[:, 0] > 0.0)
    assert {tuple(p) for p in hull + origin} <= {tuple(p) for p in points}


def test_a_step_that_does_not_divide_a_right_angle():
    assert len(turns_of(1.0)) == 90 and len(turns_of(0.1)) == 900 and len(turns_of(7.0)) == 13
    assert np.array_equal(turns_of(90.0), [[1.0, 0.0]])


@pytest.mark.parametrize("step", [0.0, -1.0, 91.0, math.nan, math.inf])
def test_absurd_steps_are_refused(step):
    with pytest.raises(ValueError, match="step_degrees"):
        fit_obb(HEXAGON, step)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ([], "shape"),
        ([[0.0, math.nan]], r"points\[0\]"),
        ([[0, 0], [math.inf, 0]], r"points\[1\]"),
        ([[0, 0, 0]], "shape"),
        ([[1e300, 0.0]], r"points\[0\]"),
        (np.zeros((0, 2)), "1 to"),
        ("abc", "numbers"),
    ],
)
def test_what_are_no_points_is_refused(points, words):
    for fitter in FITTERS.values():
        with pytest.raises(ValueError, match=words):
            fitter(points)


def test_ints_lists_float32_and_odd_layouts_give_the_same():
    points = np.array(HEXAGON, dtype=float)
    same = fit_obb(points)
    readonly = points.copy()
    readonly.flags.writeable = False
    for other in (HEXAGON, points.astype(np.float32), np.asfortranarray(points), points[::1], readonly):
        assert fit_obb(other) == same
    assert fit_obb(np.repeat(points, 2, axis=0)[::2]) == same
