"""Bezier curves, paths of several, Catmull-Rom curves: points, tangents, splitting, lines, lengths."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from game.physics.animation import BezierPath, CatmullRom, CubicBezier, PiecewiseCubic
from game.physics.animation.flattening import even_count

EPS = 2.0**-52
KNOWN = CubicBezier([(0, 0), (1, 2), (3, 3), (4, 0)])
U = np.linspace(0, 1, 101)
coordinates = st.floats(-10, 10).map(lambda x: round(x, 3))
quadruples = st.lists(st.tuples(coordinates, coordinates), min_size=4, max_size=4)


def test_known_point_tangent_and_length():
    assert np.abs(KNOWN.point(0.3) - (1.116, 1.449)).max() < 1e-13
    assert np.abs(KNOWN.tangent(0.3) - (4.26, 3.39)).max() < 1e-13
    assert abs(KNOWN.length - 5.829927224626640) < 1e-13
    KNOWN.check()


def test_quarter_of_a_circle():
    kappa = 4.0 * (math.sqrt(2.0) - 1.0) / 3.0
    assert kappa == pytest.approx(0.552284749830793, abs=1e-15)
    arc = CubicBezier([(1, 0), (1, kappa), (kappa, 1), (0, 1)])
    radius = np.sqrt((arc.point(np.linspace(0, 1, 200_001)) ** 2).sum(axis=1))
    assert radius.max() - 1.0 == pytest.approx(2.72530007427705e-4, abs=1e-13)


@settings(max_examples=50, deadline=None)
@given(quadruples, st.floats(-3, 3), st.floats(0, 1))
def test_invariants(points, angle, u):
    """Weights sum to 1, the hull holds the curve, maps commute with it, both ways are one, halves fit."""
    p = np.array(points)
    scale = max(np.abs(p).max(), 1e-300)
    curve = CubicBezier(p)
    ones = CubicBezier(np.ones((4, 1))).point(U)
    assert np.abs(ones - 1.0).max() <= 4 * EPS
    found = curve.point(U)
    for way in np.linspace(0, math.pi, 9):
        axis = np.array((math.cos(way), math.sin(way)))
        assert (found @ axis).max() <= (p @ axis).max() + 8 * EPS * scale
    turn = np.array(((math.cos(angle), -math.sin(angle)), (math.sin(angle), math.cos(angle))))
    moved = CubicBezier(p @ turn.T + (3.0, -2.0)).point(U)
    assert np.abs(moved - (found @ turn.T + (3.0, -2.0))).max() <= 16 * EPS * (scale * 2 + 3)
    assert np.abs(CubicBezier(p[::-1]).point(1 - U) - found).max() <= 16 * EPS * scale
    assert np.array_equal(curve.point([0.0, 1.0]), p[[0, 3]] + 0.0)
    left, right = curve.split(u)
    assert np.abs(left.point(U) - curve.point(U * u)).max() <= 32 * EPS * scale
    assert np.abs(right.point(U) - curve.point(u + U * (1 - u))).max() <= 32 * EPS * scale


@settings(max_examples=20, deadline=None)
@given(quadruples)
def test_length_is_that_of_quadrature_and_goes_back(points):
    curve = CubicBezier(points)
    speed = lambda u: float(np.linalg.norm(curve.tangent(u)))  # noqa: E731
    known, unsure = quad(speed, 0, 1, limit=200)
    polygon = np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()
    assert abs(curve.length - known) <= 10 * unsure + 1e-12 * polygon
    curve.check()
    ways = np.linspace(0, curve.length, 17)
    there = curve.parameter_at(ways)
    assert np.all(np.diff(there) >= 0.0)
    assert np.abs(curve.length_to(there) - ways).max() <= 1e-13 * polygon
    assert (there[0], there[-1]) == (0.0, 1.0) or curve.length == 0.0


def test_length_of_a_way_there_and_back():
    """On a line the length is known, and a kink of the speed lies between any points one looks at."""
    curve = CubicBezier([(1, -1), (1, 1), (1, 2), (1, -1)])
    turn = max(np.roots((-3.0, -2.0, 2.0)))  # where y' = 3 (2 (1-u)^2 + 2 u (1-u) - 3 u^2) vanishes
    top = curve.point(turn)[1]
    assert curve.length == pytest.approx(2 * (top + 1), rel=1e-15)
    for share in (0.3, 0.5 - 1e-9, 0.5, 0.5 + 1e-6, 0.9):
        u = curve.parameter_at(share * curve.length)
        y = curve.point(u)[1]
        way = y + 1 if u <= turn else 2 * top + 1 - y
        assert way == pytest.approx(share * curve.length, abs=8e-15)
    rng = np.random.default_rng(0)
    for k in range(300):
        points = rng.integers(-3, 4, size=(4, 1 + k % 2)).astype(float)
        bend = CubicBezier(points)
        ways = np.linspace(0, bend.length, 9)
        polygon = np.abs(np.diff(points, axis=0)).sum()
        assert np.abs(bend.length_to(bend.parameter_at(ways)) - ways).max() <= 1e-14 * polygon


@settings(max_examples=20, deadline=None)
@given(quadruples, st.floats(-4, 0))
def test_lines_keep_the_tolerance(points, power):
    curve, tolerance = CubicBezier(points), 10.0**power
    at = curve.point(np.linspace(0, 1, 501))
    for how in ("adaptive", "even"):
        chain = curve.flatten(tolerance, how)
        assert np.array_equal(chain[[0, -1]], curve.points[[0, 3]] + 0.0)
        assert distance_to_chain(at, chain).max() <= tolerance * (1 + 1e-9) + 1e-13


def distance_to_chain(points, chain):
    a, way = chain[:-1], np.diff(chain, axis=0)
    square = np.maximum((way * way).sum(axis=1), 1e-300)
    share = np.clip(((points[:, None] - a) * way).sum(axis=2) / square, 0, 1)
    gap = points[:, None] - a - share[:, :, None] * way
    return np.sqrt((gap * gap).sum(axis=2).min(axis=1))


def test_wang_is_tight_and_halving_needs_fewer_lines():
    """Wang's number of lines wastes little on an even bend, and much on a sharp one."""
    arc = CubicBezier([(0, 0), (1, 1.2), (3, 1.2), (4, 0)])
    at = np.linspace(0, 1, 20_001)
    for tolerance in (1e-2, 1e-3, 1e-4):
        assert even_count(arc.points, tolerance) == len(arc.flatten(tolerance, "even")) - 1
        lines = even_count(arc.points, tolerance)
        chord = np.stack(
            [np.interp(at * lines, np.arange(lines + 1), c) for c in arc.flatten(tolerance, "even").T], 1
        )
        worst = np.sqrt(((arc.point(at) - chord) ** 2).sum(axis=1)).max()
        assert 0.6 * tolerance <= worst <= tolerance * (1 + 1e-9)
    hook = CubicBezier([(0, 0), (10, 0), (10.2, 0.2), (0, 0.3)])
    assert len(hook.flatten(1e-4)) < len(hook.flatten(1e-4, "even"))
    assert len(hook.flatten(1e-300)) == 65_537
    with pytest.raises(ValueError, match="tolerance"):
        hook.flatten(0.0)


def test_directions_where_the_derivative_vanishes():
    """The next derivative that is not zero says where the curve goes."""
    cases = {
        "first two alike": ([(0, 0), (0, 0), (1, 1), (3, 1)], [(1, 1), (2, 0)]),
        "last two alike": ([(0, 0), (1, 1), (3, 1), (3, 1)], [(1, 1), (2, 0)]),
        "first three alike": ([(0, 0), (0, 0), (0, 0), (3, 4)], [(3, 4), (3, 4)]),
        "last three alike": ([(0, 0), (3, 4), (3, 4), (3, 4)], [(3, 4), (3, 4)]),
        "all alike": ([(2, 1)] * 4, [(0, 0), (0, 0)]),
    }
    for points, ends in cases.values():
        curve = CubicBezier(points)
        for u, way in zip((0.0, 1.0), ends, strict=True):
            size = math.hypot(*way)
            expected = np.array(way) / size if size else np.zeros(2)
            assert np.abs(curve.direction(u) - expected).max() < 1e-15
        assert np.isfinite(curve.direction(U)).all()
    cusp = CubicBezier([(0, 0), (1, 1), (0, 1), (1, 0)])
    assert np.abs(cusp.tangent(0.5)).max() == 0.0
    assert cusp.direction(0.5).tolist() == [0.0, -1.0]
    assert cusp.direction(0.4999)[1] > 0.99


def test_a_path_of_pieces_has_smooth_joints_when_asked():
    rng = np.random.default_rng(2)
    path = BezierPath(rng.normal(size=(5, 2)), rng.normal(size=(5, 2, 2)))
    assert path.pieces == 4
    assert path.joint_gaps()[:, 0].max() == 0.0
    assert path.joint_gaps()[:, 1].min() > 0.1
    smooth = path.smooth()
    assert smooth.joint_gaps().max() < 1e-15
    assert np.array_equal(smooth.point(np.arange(5.0)), path.knots)
    assert path.length == pytest.approx(sum(CubicBezier(piece).length for piece in path.controls), rel=1e-14)
    chain = path.flatten(1e-3)
    assert all(np.any(np.all(chain == knot, axis=1)) for knot in path.knots)


def test_pieces_that_do_not_meet_have_lines_of_their_own():
    gap = PiecewiseCubic([[(0, 0), (1, 0), (2, 0), (3, 0)], [(3, 5), (4, 5), (5, 5), (6, 5)]])
    assert gap.flatten(0.1).tolist() == [[0, 0], [3, 0], [3, 5], [6, 5]]
    assert gap.length == pytest.approx(6.0)
    assert gap.point([0.999999, 1.0])[:, 1].tolist() == [0.0, 5.0]


@pytest.mark.parametrize("kind", ["uniform", "centripetal", "chordal"])
@pytest.mark.parametrize("closed", [False, True])
def test_catmull_rom_goes_through_its_points_by_the_known_recursion(kind, closed):
    """Against the pyramid of Barry and Goldman 1988."""
    rng = np.random.default_rng(6)
    points = rng.normal(size=(7, 2))
    curve = CatmullRom(points, kind, closed)
    assert curve.pieces == 6 + closed
    assert np.array_equal(curve.point(np.arange(7.0)), points)
    power = {"uniform": 0.0, "centripetal": 0.5, "chordal": 1.0}[kind]
    p = points[1:5]
    knots = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1) ** power)))
    for u in (0.1, 0.5, 0.9):
        t = knots[1] + u * (knots[2] - knots[1])

        def mix(a, b, i, j, t=t):
            return ((knots[j] - t) * a + (t - knots[i]) * b) / (knots[j] - knots[i])

        a = [mix(p[i], p[i + 1], i, i + 1) for i in range(3)]
        b = [mix(a[i], a[i + 1], i, i + 2) for i in range(2)]
        assert np.abs(curve.point(2 + u) - mix(b[0], b[1], 1, 2)).max() < 1e-13
    if closed:
        ways = curve.direction(np.array([0.0, curve.pieces]))
        assert np.abs(ways[0] - ways[1]).max() < 1e-9


def test_catmull_rom_with_points_in_one_place():
    for kind in ("uniform", "centripetal", "chordal"):
        curve = CatmullRom([(0, 0), (1, 0), (1, 0), (2, 1), (2, 1)], kind)
        assert np.isfinite(curve.point(np.linspace(0, 4, 101))).all()
        assert np.isfinite(curve.length)
        assert CatmullRom([(1, 1)] * 3, kind).length == 0.0


def test_one_point_is_no_curve():
    with pytest.raises(ValueError, match=r"^points: expected two or more, not"):
        CatmullRom([(0.0, 0.0)])


@pytest.mark.parametrize(
    "make",
    [
        lambda: CubicBezier([(0, 0), (1, 1)]),
        lambda: CubicBezier([(0, 0), (1, 1), (2, 2), (3, math.nan)]),
        lambda: PiecewiseCubic(np.zeros((0, 4, 2))),
        lambda: BezierPath([(0, 0)], np.zeros((1, 2, 2))),
        lambda: BezierPath([(0, 0), (1, 1)], np.zeros((1, 2, 2))),
        lambda: CatmullRom([(0, 0)]),
        lambda: CatmullRom([(0, 0), (1, 1)], "cubic"),
        lambda: CatmullRom([(0, 0), (1, math.inf)]),
        lambda: KNOWN.point(math.nan),
        lambda: KNOWN.parameter_at(math.inf),
        lambda: KNOWN.split(1.5),
    ],
)
def test_what_makes_no_sense_is_refused(make):
    with pytest.raises(ValueError):
        make()
