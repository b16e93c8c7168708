"""Capsules: closed forms, naive twins, and the proof that the least one is the least."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize, minimize_scalar
from scipy.spatial import ConvexHull

from game.physics.bounds import (
    FITS,
    Capsule,
    build_tree,
    fit_capsule,
    least_capsule,
    minimal_capsule,
    near_least_capsule,
    thinnest_capsule,
)

FITTERS = {
    "search": fit_capsule,
    "refined": lambda points: fit_capsule(points, refine=True),
    "thinnest": thinnest_capsule,
    "exact": near_least_capsule,
}
clouds = st.lists(
    st.tuples(st.integers(-30, 30), st.integers(-30, 30)), min_size=1, max_size=30
).map(lambda rows: np.array(rows, dtype=float))  # fmt: skip


def area_along(points, angle):
    """Area of the capsule in the middle of the projection, as the definition has it."""
    c, s = math.cos(angle), math.sin(angle)
    u, v = points @ (c, s), points @ (-s, c)
    radius = 0.5 * float(np.ptp(v))
    q = np.sqrt(np.maximum(radius**2 - (v - 0.5 * (v.max() + v.min())) ** 2, 0.0))
    length = max(float((u - q).max() - (u + q).min()), 0.0)
    return 2 * radius * length + math.pi * radius**2


def least_by_descent(points, tries=8):
    """The least area that a general minimiser finds from many starts."""

    def area(x):
        c, s = math.cos(x[0]), math.sin(x[0])
        u, v = points @ (c, s), points @ (-s, c)
        low, high = sorted(x[2:])
        beyond = np.maximum(np.maximum(low - u, u - high), 0.0)
        radius = float(np.sqrt((v - x[1]) ** 2 + beyond**2).max())
        return 2 * radius * (high - low) + math.pi * radius**2

    rng = np.random.default_rng(5)
    best = math.inf
    for _ in range(tries):
        angle = rng.uniform(0, math.pi)
        u, v = points @ (math.cos(angle), math.sin(angle)), points @ (-math.sin(angle), math.cos(angle))
        half = 0.5 * np.ptp(u) * rng.uniform(0, 1)
        middle = 0.5 * (u.max() + u.min())
        x = [angle, 0.5 * (v.max() + v.min()), middle - half, middle + half]
        for _ in range(2):
            found = minimize(area, x, method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-12})
            x = found.x
        best = min(best, float(found.fun))
    return best


def test_area_of_a_capsule():
    assert Capsule((0.0, 0.0), (3.0, 0.0), 0.5).area == pytest.approx(3.78539816339745, rel=1e-14)


@settings(max_examples=40, deadline=None)
@given(clouds)
def test_the_search_is_its_naive_twin(points):
    extent = max(float(np.ptp(points, axis=0).max()), 1.0)
    least = min(area_along(points, math.radians(angle)) for angle in range(180))
    rounding = 4 * extent**2 * math.sqrt(8 * np.finfo(float).eps)  # a root of what should be 0 at the ends
    assert fit_capsule(points).area == pytest.approx(least, rel=0, abs=rounding)
    assert fit_capsule(points, refine=True).area <= least + rounding


@pytest.mark.parametrize("name", FITTERS)
@settings(max_examples=40, deadline=None)
@given(clouds, st.floats(0, 7))
def test_every_point_is_within_the_radius(name, points, angle):
    c, s = math.cos(angle), math.sin(angle)
    points = points @ np.array([[c, s], [-s, c]])
    capsule = FITTERS[name](points)
    extent = max(float(np.ptp(points, axis=0).max()), 1e-300)
    assert capsule.outside(points).max() <= 4e-16 * capsule.radius + 1e-14 * extent


@settings(max_examples=60, deadline=None)
@given(clouds)
def test_the_thinnest_has_half_the_width_of_the_hull(points):
    capsule = thinnest_capsule(points)
    if np.linalg.matrix_rank(points - points[0]) < 2:
        assert capsule.radius <= 1e-12
        return
    hull = points[ConvexHull(points).vertices]
    sides = np.roll(hull, -1, axis=0) - hull
    normals = np.column_stack((-sides[:, 1], sides[:, 0])) / np.linalg.norm(sides, axis=1)[:, None]
    assert capsule.radius == pytest.approx(0.5 * np.ptp(hull @ normals.T, axis=0).min(), rel=1e-10)


def rectangle_least(aspect):
    """Least 4 a r - 4 r sqrt(r² - b²) + π r² with half sides a, b = 1/2."""
    a, b = 0.5 * aspect, 0.5
    found = minimize_scalar(
        lambda r: 4 * a * r - 4 * r * math.sqrt(max(r * r - b * b, 0.0)) + math.pi * r * r,
        bounds=(b, 1.3 * b), method="bounded", options={"xatol": 1e-10},
    )  # fmt: skip
    return float(found.fun)


@pytest.mark.compiled
@pytest.mark.parametrize("aspect", [1.0, 2.0, 10.0])
def test_the_least_capsule_of_a_rectangle_has_its_corners_on_its_ends(aspect):
    """Not the one of least radius: its ends are cheaper when they reach a little beyond the long sides."""
    points = np.array([(0, 0), (aspect, 0), (aspect, 1), (0, 1)])
    capsule, bound = least_capsule(points)
    assert capsule.area == pytest.approx(rectangle_least(aspect), rel=1e-9)
    assert capsule.radius > 0.5 and capsule.area < thinnest_capsule(points).area
    assert (1 - 1e-3) * capsule.area <= bound <= capsule.area
    assert capsule.outside(points).max() <= 1e-13


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(3))
def test_the_least_capsule_is_that_of_a_general_minimiser(seed):
    points = np.random.default_rng(seed).normal(size=(12, 2)) * (1.0 + 2.0 * seed, 1.0)
    capsule, bound = least_capsule(points)
    other = least_by_descent(points)
    assert capsule.area <= other * (1 + 1e-8)
    assert bound <= other and bound >= (1 - 1e-3) * capsule.area
    assert minimal_capsule(points) == capsule
    assert capsule.area <= fit_capsule(points, refine=True).area


def test_least_capsules_that_are_plain():
    assert minimal_capsule([(3, 4)]).area == 0.0
    assert minimal_capsule([(0, 0), (3, 4)]).length == pytest.approx(5.0)
    assert minimal_capsule([(0, 0), (1, 1), (5, 5)]).radius == 0.0
    pentagon = np.array([(math.cos(2 * math.pi * i / 5), math.sin(2 * math.pi * i / 5)) for i in range(5)])
    circle, bound = least_capsule(pentagon, tolerance=0.02)
    assert circle.area == pytest.approx(math.pi, rel=1e-9) and bound >= 0.98 * circle.area
    with pytest.raises(ValueError, match="tolerance"):
        least_capsule(pentagon, tolerance=0.0)


def least_by_dense_search(points, directions=180, radii=60, heights=41):
    """The least area over a grid of directions, radii and heights of the core; every one of them fits."""
    best = math.inf
    for angle in np.arange(directions) * math.pi / directions:
        c, s = math.cos(angle), math.sin(angle)
        u, v = points @ (c, s), points @ (-s, c)
        breadth = float(np.ptp(v))
        radius = 0.5 * breadth * np.geomspace(1.0, 2.5, radii)[:, None, None]
        room = radius - 0.5 * breadth
        middle = 0.5 * (v.max() + v.min()) + room * np.linspace(-1.0, 1.0, heights)[None, :, None]
        q = np.sqrt(np.maximum(radius**2 - (v - middle) ** 2, 0.0))
        length = np.maximum((u - q).max(axis=2) - (u + q).min(axis=2), 0.0)
        r = radius[:, :, 0]
        best = min(best, float((2.0 * r * length + math.pi * r * r).min()))
    return best


def shapes_for_exact():
    """The square, rectangles, regular and random polygons, thin and round clouds."""
    rng = np.random.default_rng(12)
    made = [np.array([(0, 0), (a, 0), (a, 1), (0, 1)], dtype=float) for a in (1.0, 1.2, 2.0, 8.0)]
    for n in (3, 5, 6, 12):
        angle = 2 * math.pi * np.arange(n) / n
        made.append(np.column_stack((np.cos(angle), np.sin(angle))))
    made += [
        rng.normal(size=(n, 2)) * (stretch, 1.0) for n in (3, 4, 9, 30) for stretch in (1.0, 1.5, 4.0, 20.0)
    ]
    return made


@pytest.mark.compiled
@pytest.mark.parametrize("number", range(len(shapes_for_exact())))
def test_no_capsule_is_smaller_than_the_exact_one_by_more_than_the_tolerance(number):
    """Against a dense search over directions, radii and heights, and against all other fits of a tree."""
    points = shapes_for_exact()[number]
    found = near_least_capsule(points).area
    others = [build_tree(points, "capsule", 64, closed=True, fit=fit).areas()[0] for fit in FITS]
    least = min(least_by_dense_search(points), *others)
    assert found <= least / (1 - 1e-3)
    assert others[FITS.index("exact")] == found
    assert near_least_capsule(1e-150 * points).area == pytest.approx(1e-300 * found, rel=2e-3)


def test_the_least_radius_is_not_the_least_area_on_a_square():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    assert thinnest_capsule(square).area / near_least_capsule(square).area == pytest.approx(
        (1 + math.pi / 4) / 1.534411, rel=1e-3
    )


@pytest.mark.compiled
def test_every_node_of_an_exact_tree_is_proven():
    """Not the root alone: 1e-3 above the proven bound of `least_capsule`, at most."""
    angle = 2 * math.pi * np.arange(40) / 40
    points = (1.0 + 0.3 * np.sin(5 * angle))[:, None] * np.column_stack((np.cos(angle), np.sin(angle)))
    tree = build_tree(points, "capsule", 4, closed=True, fit="exact")
    for node in range(len(tree)):
        capsule, bound = least_capsule(tree.ends[tree.segments_of(node)].reshape(-1, 2))
        assert bound - 1e-12 <= tree.areas()[node] <= capsule.area / (1 - 1e-3) + 1e-12
