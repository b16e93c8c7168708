"""Mass, centre and tensor of spheres: closed forms, invariants, and where digits could be lost."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.rigid import (
    inverse_moments,
    mass_properties,
    principal_axes,
    quaternion_from_axis_angle,
    quaternion_to_matrix,
    sphere_masses,
)

spheres = st.lists(
    st.tuples(*[st.floats(-5.0, 5.0)] * 3, st.floats(0.05, 2.0), st.floats(0.1, 10.0)),
    min_size=1,
    max_size=12,
)


def density_for(masses, radii):
    """Densities that give spheres these masses."""
    return np.asarray(masses) / (4.0 / 3.0 * math.pi * np.asarray(radii) ** 3)


def unpacked(rows):
    rows = np.array(rows)
    return rows[:, :3], rows[:, 3], rows[:, 4]


def test_four_spheres_to_all_digits():
    """Offset theorem, computed to 30 digits: masses 1, 1, 2, 1/2."""
    radii = (0.5, 0.5, 0.6, 0.3)
    places = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 1.5)]
    mass, center, inertia = mass_properties(places, radii, density_for((1, 1, 2, 0.5), radii))
    assert mass == pytest.approx(4.5, rel=1e-15)
    assert np.allclose(center, (2 / 9, 8 / 9, 1 / 6), rtol=1e-15)
    xx, yy, zz, xy, xz, yz = 5.95044444444444, 2.28377777777778, 5.72822222222222, 8 / 9, 1 / 6, 2 / 3
    expected = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    assert np.allclose(inertia, expected, rtol=0, atol=1e-14)
    moments, _ = principal_axes(inertia)
    assert np.allclose(moments, (1.97898239067136, 5.64345060095114, 6.34001145282195), rtol=0, atol=2e-14)


def test_volume_and_mass_of_each_sphere():
    volumes, masses = sphere_masses([1.0, 2.0], 3.0)
    assert np.allclose(volumes, (4 / 3 * math.pi, 32 / 3 * math.pi), rtol=1e-15)
    assert np.allclose(masses, 3.0 * volumes, rtol=1e-15)


def test_one_sphere_and_spheres_in_one_place():
    """Isotropic; two in one place are one of twice the mass."""
    mass, center, inertia = mass_properties([(1, 2, 3)], [0.5], 100.0)
    assert np.allclose(inertia, 0.4 * mass * 0.25 * np.eye(3), rtol=1e-15)
    twice = mass_properties([(1, 2, 3), (1, 2, 3)], [0.5, 0.5], 100.0)
    assert twice[0] == pytest.approx(2.0 * mass, rel=1e-15)
    assert np.array_equal(twice[1], center)
    assert np.allclose(twice[2], 2.0 * inertia, rtol=1e-15)


def test_spheres_in_a_row():
    """About the row only the spheres' own tensors count."""
    radii = [0.5] * 3
    _, _, inertia = mass_properties([(-1, 0), (0, 0), (1, 0)], radii, density_for([1] * 3, radii))
    assert np.allclose(inertia, np.diag((0.3, 2.3, 2.3)), rtol=1e-14, atol=1e-15)


def test_a_row_of_points_does_not_turn_about_itself():
    """With hardly any radius the tensor has no inverse; the pseudo-inverse gives no spin, not inf."""
    radii = [1e-7] * 3
    _, _, inertia = mass_properties([(-1, 0), (0, 0), (1, 0)], radii, density_for([1] * 3, radii))
    moments, _ = principal_axes(inertia)
    assert moments[2] / moments[0] > 1e12
    assert inverse_moments(moments)[0] == 0.0
    assert np.allclose(inverse_moments(moments)[1:], 0.5, rtol=1e-12)


@given(rows=spheres)
def test_the_tensor_is_one_of_a_body(rows):
    """Symmetric, positive definite, no moment above the sum of the other two."""
    mass, _, inertia = mass_properties(*unpacked(rows))
    assert np.array_equal(inertia, inertia.T)
    moments, axes = principal_axes(inertia)
    assert mass > 0.0 < moments[0]
    assert moments[0] <= moments[1] <= moments[2]
    assert moments[0] + moments[1] >= moments[2] * (1.0 - 1e-12)
    assert np.allclose(axes @ np.diag(moments) @ axes.T, inertia, rtol=0, atol=1e-13 * moments[2])
    assert np.allclose(axes.T @ axes, np.eye(3), rtol=0, atol=1e-14)
    assert np.linalg.det(axes) == pytest.approx(1.0, abs=1e-13)


@given(
    rows=spheres,
    axis=st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: sum(x * x for x in v) > 0.01),
    angle=st.floats(-4, 4),
    way=st.tuples(*[st.floats(-50, 50)] * 3),
)
def test_shifted_and_turned_bodies(rows, axis, angle, way):
    places, radii, density = unpacked(rows)
    turn = quaternion_to_matrix(quaternion_from_axis_angle(axis, angle))
    mass, center, inertia = mass_properties(places, radii, density)
    moved = mass_properties(places @ turn.T + way, radii, density)
    size = np.abs(inertia).max()
    assert moved[0] == mass
    assert np.allclose(moved[1], turn @ center + way, rtol=0, atol=1e-13)
    # the places themselves are rounded where they lie now: 60 m x 2^-52, times mass and size
    assert np.allclose(moved[2], turn @ inertia @ turn.T, rtol=0, atol=1e-12 * max(size, mass))


@given(rows=spheres)
def test_order_and_density(rows):
    places, radii, density = unpacked(rows)
    mass, center, inertia = mass_properties(places, radii, density)
    turned = mass_properties(places[::-1], radii[::-1], density[::-1])
    assert turned[0] == mass
    assert np.allclose(turned[1], center, rtol=0, atol=1e-14)
    denser = mass_properties(places, radii, 2.0 * density)
    assert denser[0] == 2.0 * mass
    assert np.array_equal(denser[1], center)
    assert np.allclose(denser[2], 2.0 * inertia, rtol=0, atol=1e-307)  # equal but for denormal numbers


def exact_tensor(places, radii, masses):
    """The same in rational numbers."""
    places = [[Fraction(float(x)) for x in row] for row in places]
    masses = [Fraction(float(m)) for m in masses]
    total = sum(masses)
    center = [sum(m * p[k] for m, p in zip(masses, places, strict=True)) / total for k in range(3)]
    tensor = [[Fraction(0)] * 3 for _ in range(3)]
    for m, p, r in zip(masses, places, radii, strict=True):
        d = [p[k] - center[k] for k in range(3)]
        square = sum(x * x for x in d)
        for i in range(3):
            for j in range(3):
                own = Fraction(2, 5) * m * Fraction(float(r)) ** 2 + m * square if i == j else Fraction(0)
                tensor[i][j] += own - m * d[i] * d[j]
    return np.array([[float(x) for x in row] for row in tensor])


def test_a_millionfold_in_mass_a_million_away():
    """Against rational numbers, to 1e-12 of the largest moment."""
    far = np.array((1e6, -2e6, 3e6))
    places = far + np.array([(0, 0, 0), (1.5, 0.25, 0), (0, -0.75, 2.0), (0.5, 0.5, 0.5)])
    radii = np.array((1.0, 0.01, 0.01, 0.2))
    _, masses = sphere_masses(radii, 1000.0)
    assert masses.max() / masses.min() == pytest.approx(1e6)
    exact = exact_tensor(places, radii, masses)
    _, _, inertia = mass_properties(places, radii, 1000.0)
    assert np.abs(inertia - exact).max() < 1e-12 * np.abs(exact).max()
    naive = exact_tensor(places - far, radii, masses)
    assert np.allclose(exact, naive, rtol=0, atol=1e-9)


def test_small_moments_keep_their_digits():
    """Jacobi's method gives a thin body's smallest moment to rounding; ascending, right-handed."""
    turn = quaternion_to_matrix(quaternion_from_axis_angle((1, 2, 3), 0.7))
    moments, axes = principal_axes(turn @ np.diag((1e-6, 1.0, 1.0)) @ turn.T)
    assert moments[0] == pytest.approx(1e-6, rel=1e-9)
    assert np.allclose(np.abs(axes[:, 0]), np.abs(turn[:, 0]), rtol=0, atol=1e-12)
    moments, axes = principal_axes((3.0, 1.0, 2.0))
    assert moments.tolist() == [1.0, 2.0, 3.0]
    assert set(np.abs(axes).ravel().tolist()) == {0.0, 1.0}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (([], [], 1.0), "positions"),
        (([(0, 0)], [0.0], 1.0), "^radii: must"),
        (([(0, 0)], [-1.0], 1.0), "^radii: must"),
        (([(0, 0)], [1.0], 0.0), "^density: must"),
        (([(0, 0)], [1.0], math.nan), "density"),
        (([(0, math.inf)], [1.0], 1.0), "positions"),
        (([(0, 0), (1, 1)], [1.0], 1.0), "radii"),
        (([(0, 0)], [1.0, 1.0], 1.0), "radii"),
        (([(0, 0), (1, 1)], [1.0, 1.0], [1.0, 2.0, 3.0]), "density"),
        (([(0, 0, 0, 0)], [1.0], 1.0), "positions"),
        (([(1e300, 0), (-1e300, 0)], [1.0, 1.0], 1.0), "inertia"),
        (([(0, 0)], [1e-300], 1.0), "mass"),
        (([(0, 0)], [1e300], 1.0), "mass"),
    ],
)
def test_nonsense_is_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        mass_properties(*arguments)


@pytest.mark.parametrize(
    ("inertia", "words"),
    [
        ([[1, 2], [2, 1]], "inertia"),
        (np.diag((1, 1, -1)), "negative"),
        ([[1, 2, 0], [0, 1, 0], [0, 0, 1]], "symmetric"),
        (np.zeros((3, 3)), "is zero"),
        ((1, 1, math.nan), "inertia"),
    ],
)
def test_tensors_that_are_none_are_refused(inertia, words):
    with pytest.raises(ValueError, match=words):
        principal_axes(inertia)


def test_any_kind_of_array_is_taken():
    plain = mass_properties([(0, 0, 0), (1, 0, 0)], [1, 2], 3)
    places = np.zeros((4, 6), dtype=np.float32)[::2, ::2]
    places[1, 0] = 1.0
    other = mass_properties(places, np.array([1, 2], dtype=np.int32), np.float32(3.0))
    assert plain[0] == other[0]
    assert np.array_equal(plain[2], other[2])
