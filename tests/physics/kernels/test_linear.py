"""Products, systems and eigenvectors by plain sums: numpy's answers to rounding, and always the same bits."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from game.physics.kernels import linear


@pytest.mark.parametrize(
    ("a", "b"), [((3,), (3,)), ((2, 3), (3,)), ((3,), (3, 4)), ((2, 3), (3, 4)), ((5, 2, 3), (3,)),
                 ((5, 2, 3), (3, 2)), ((0, 2), (2, 2)), ((4, 0), (0, 2)), ((5, 2, 3), (5, 3, 4))],
)  # fmt: skip
def test_products_of_every_shape(a: tuple[int, ...], b: tuple[int, ...]) -> None:
    random = np.random.default_rng(3)
    x, y = random.normal(size=a), random.normal(size=b)
    found = linear.product(x, y)
    assert np.shape(found) == np.shape(x @ y)
    assert np.allclose(found, x @ y, rtol=1e-14, atol=1e-15)


def test_a_product_is_summed_from_the_first_to_the_last() -> None:
    x, y = [0.1, 0.7, 1e16, -1e16], [3.0, 1.1, 1.0, 1.0]
    total = 0.0
    for a, b in zip(x, y, strict=True):
        total += a * b
    assert linear.product(x, y) == total
    turned = np.array([y, x]).T[:, ::-1]
    assert linear.product(x, turned).tolist() == [linear.product(x, x), total]


def test_products_that_do_not_fit() -> None:
    with pytest.raises(ValueError, match=r"\(2, 3\) and \(2,\)"):
        linear.product(np.ones((2, 3)), np.ones(2))
    with pytest.raises(ValueError, match="do not fit"):
        linear.product(np.ones(2), np.ones((2, 2, 2)))


def test_systems() -> None:
    random = np.random.default_rng(4)
    for n in (1, 2, 3, 7):
        a, b = random.normal(size=(n, n)), random.normal(size=(n, 2))
        assert np.allclose(linear.solve(a, b), np.linalg.solve(a, b), rtol=1e-9)
        assert np.allclose(linear.solve(a, b[:, 0]), np.linalg.solve(a, b[:, 0]), rtol=1e-9)
        assert np.allclose(linear.inverse(a) @ a, np.eye(n), atol=1e-10)
        assert np.isclose(linear.determinant(a), np.linalg.det(a), rtol=1e-10)
    swapped = np.array([[0.0, 2.0], [1.0, 0.0]])
    assert linear.solve(swapped, [2.0, 3.0]).tolist() == [3.0, 1.0]
    assert linear.determinant(swapped) == -2.0
    assert linear.determinant(np.ones((3, 3))) == 0.0
    with pytest.raises(np.linalg.LinAlgError, match="singular"):
        linear.solve(np.ones((2, 2)), np.ones(2))
    assert linear.solve(np.zeros((0, 0)), np.zeros(0)).shape == (0,)


def test_the_largest_of_a_column_is_the_pivot() -> None:
    a, b = np.array([[1e-20, 1.0], [1.0, 1.0]]), np.array([1.0, 2.0])
    small = Fraction(1e-20)
    exact = [float(1 / (1 - small)), float((1 - 2 * small) / (1 - small))]
    assert np.allclose(linear.solve(a, b), exact, rtol=1e-15)


def test_eigenvectors() -> None:
    random = np.random.default_rng(5)
    for n in (1, 2, 3, 8):
        a = random.normal(size=(n, n))
        a = a + a.T
        values, axes = linear.eigenvectors(a)
        assert np.allclose(values, np.linalg.eigvalsh(a), atol=1e-12)
        assert np.allclose(a @ axes, axes * values, atol=1e-12)
        assert np.allclose(axes.T @ axes, np.eye(n), atol=1e-13)
    assert linear.eigenvectors(np.diag([3.0, -1.0, 2.0]))[0].tolist() == [-1.0, 2.0, 3.0]
    assert np.allclose(linear.eigenvectors(np.array([[0.0, 1.0], [1.0, 0.0]]))[0], [-1.0, 1.0])


def test_lines_between_points() -> None:
    places, values = [0.0, 1.0, 3.0], [2.0, 4.0, -2.0]
    x = np.array([-1.0, 0.0, 0.25, 1.0, 2.0, 3.0, 9.0])
    assert linear.interpolated(x, places, values).tolist() == np.interp(x, places, values).tolist()
    assert linear.interpolated(0.5, [0.0], [7.0]) == 7.0


def test_draws_are_those_of_numpy() -> None:
    for arguments in (
        (),
        (2.0, 5.0),
        (-1.0, 1.0, 4),
        ([0.0, 1.0], [1.0, 3.0]),
        (0.5, [1.0, 2.0]),
        (0.0, 1.0, (2, 3)),
    ):
        own, other = np.random.default_rng(6), np.random.default_rng(6)
        found, expected = linear.uniform(own, *arguments), other.uniform(*arguments)
        assert np.shape(found) == np.shape(expected)
        assert np.asarray(found).tolist() == np.asarray(expected).tolist()
        assert own.random() == other.random()
