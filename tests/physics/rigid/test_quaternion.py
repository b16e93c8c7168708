"""Quaternions against rotation matrices, and at their edges."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.rigid import (
    quaternion_conjugate,
    quaternion_from_axis_angle,
    quaternion_from_matrix,
    quaternion_from_rotation_vector,
    quaternion_multiply,
    quaternion_normalized,
    quaternion_rotate,
    quaternion_to_matrix,
    quaternion_to_rotation_vector,
    turn_between,
)

EPS = 2.0**-52
parts = st.floats(-1.0, 1.0)
units = st.tuples(parts, parts, parts, parts).filter(lambda q: sum(x * x for x in q) > 1e-3)
vectors = st.tuples(*[st.floats(-10.0, 10.0)] * 3)


def matrix_about(axis, angle):
    """Rodrigues 1840, by the matrix exponential's closed form."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)))
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross


def test_a_quarter_turn():
    q = quaternion_from_axis_angle((0, 0, 5), math.pi / 2)
    assert np.allclose(q, (math.sqrt(0.5), 0, 0, math.sqrt(0.5)), rtol=0, atol=2 * EPS)
    assert np.allclose(quaternion_rotate(q, (1, 0, 0)), (0, 1, 0), rtol=0, atol=4 * EPS)


@given(q=units, p=units, v=vectors)
def test_products_of_quaternions_are_products_of_turns(q, p, v):
    q, p = quaternion_normalized(q), quaternion_normalized(p)
    both = quaternion_rotate(quaternion_multiply(q, p), v)
    assert np.allclose(both, quaternion_rotate(q, quaternion_rotate(p, v)), rtol=0, atol=1e-14 * 20)
    matrix = quaternion_to_matrix(q)
    assert np.allclose(matrix @ v, quaternion_rotate(q, v), rtol=0, atol=1e-14 * 20)
    assert np.allclose(matrix @ matrix.T, np.eye(3), rtol=0, atol=16 * EPS)
    assert np.linalg.det(matrix) == pytest.approx(1.0, abs=16 * EPS)
    back = quaternion_rotate(quaternion_conjugate(q), quaternion_rotate(q, v))
    assert np.allclose(back, v, rtol=0, atol=1e-14 * 20)


@given(axis=vectors.filter(lambda v: sum(x * x for x in v) > 1e-6), angle=st.floats(-10.0, 10.0))
def test_axis_and_angle_against_rodrigues(axis, angle):
    q = quaternion_from_axis_angle(axis, angle)
    assert math.sqrt(float(q @ q)) == pytest.approx(1.0, abs=4 * EPS)
    assert np.allclose(quaternion_to_matrix(q), matrix_about(axis, angle), rtol=0, atol=1e-14)


@given(q=units)
def test_matrix_and_back_at_any_angle(q):
    """Q and -q are one turn; Shepperd's way keeps its digits also next to half a turn."""
    q = quaternion_normalized(q)
    back = quaternion_from_matrix(quaternion_to_matrix(q))
    assert back[0] >= 0.0
    assert min(np.abs(back - q).max(), np.abs(back + q).max()) < 16 * EPS
    assert np.array_equal(quaternion_to_matrix(q), quaternion_to_matrix(-q))
    assert turn_between(q, -q) == 0.0


@pytest.mark.parametrize("axis", range(3))
def test_half_turns(axis):
    q = np.zeros(4)
    q[1 + axis] = 1.0
    assert np.allclose(quaternion_from_matrix(quaternion_to_matrix(q)), q, rtol=0, atol=EPS)


@given(v=vectors)
def test_logarithm_undoes_exponential(v):
    v = np.array(v)
    length = np.linalg.norm(v)
    if length > math.pi:
        v *= (length % math.pi) / length
    q = quaternion_from_rotation_vector(v)
    assert np.allclose(quaternion_to_rotation_vector(q), v, rtol=0, atol=4e-15 * max(1.0, length))


@pytest.mark.parametrize("length", [0.0, 1e-300, 1e-160, 1e-9, 9.999e-4, 1.0001e-3, 0.5])
def test_small_turns_have_no_gap(length):
    """The series and the sine meet; nothing is divided by zero."""
    q = quaternion_from_rotation_vector((0.0, length, 0.0))
    assert q[0] == pytest.approx(math.cos(0.5 * length), abs=EPS)
    assert q[2] == pytest.approx(math.sin(0.5 * length), rel=2 * EPS, abs=0.0)
    assert q[1] == q[3] == 0.0


@pytest.mark.parametrize("turns", [1.0, 1.5, 40.25])
def test_turns_by_more_than_half(turns):
    """W dt above pi turns by that angle, not by less."""
    angle = 2.0 * math.pi * turns
    q = quaternion_from_rotation_vector((angle, 0.0, 0.0))
    assert np.allclose(quaternion_to_matrix(q), matrix_about((1, 0, 0), angle), rtol=0, atol=1e-13)


def test_any_length_but_none_is_a_turn():
    for size in (1e-200, 1.0, 1e200):
        assert np.allclose(quaternion_normalized((size, -size, size, size)), (0.5, -0.5, 0.5, 0.5))
    with pytest.raises(ValueError, match="no length"):
        quaternion_normalized((0, 0, 0, 0))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: quaternion_normalized((1, 0, math.nan, 0)), "quaternion"),
        (lambda: quaternion_normalized((1, 0, 0)), "quaternion: expected 4"),
        (lambda: quaternion_multiply((1, 0, 0, 0), (1, 0, 0, math.inf)), "b"),
        (lambda: quaternion_rotate((1, 0, 0, 0), (1, 0)), "vector: expected 3"),
        (lambda: quaternion_from_axis_angle((0, 0, 0), 1.0), "axis"),
        (lambda: quaternion_from_axis_angle((0, 0, 1), math.nan), "angle"),
        (lambda: quaternion_from_matrix(-np.eye(3)), "not a rotation"),
        (lambda: quaternion_from_matrix(2 * np.eye(3)), "not a rotation"),
    ],
)
def test_nonsense_is_refused(call, words):
    with pytest.raises(ValueError, match=words):
        call()
