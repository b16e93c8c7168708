"""Unit quaternions (w, x, y, z), scalar first: a turn by the angle a about the unit axis n is
(cos a/2, n sin a/2), and turns the vector v into q v q*. q and -q are the same turn (Hamilton 1843).

Kernels take and give tuples of four (or three) floats, which the compiler keeps in registers; they check
nothing. The functions named `quaternion_...` take anything like an array, check it and give arrays.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.kernels import elementary, linear

IDENTITY = (1.0, 0.0, 0.0, 0.0)
SMALL_TURN = 1e-3  # rad, below which sin(a/2)/a is taken from its series, whose error is then 2e-22


@kernel
def multiply(a, b):
    """The turn b and after it the turn a."""
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
        a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1],
    )


@kernel
def normalize(q):
    """The same turn at length 1; none at all for a quaternion without length."""
    length = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    if not length > 0.0:
        return (1.0, 0.0, 0.0, 0.0)
    return (q[0] / length, q[1] / length, q[2] / length, q[3] / length)


@kernel
def rotate(q, v):
    """The vector v (3 numbers) turned by the unit quaternion q: from the body's frame to the world's."""
    # v + 2 w (u x v) + 2 u x (u x v), which takes 15 products in place of 28
    tx = 2.0 * (q[2] * v[2] - q[3] * v[1])
    ty = 2.0 * (q[3] * v[0] - q[1] * v[2])
    tz = 2.0 * (q[1] * v[1] - q[2] * v[0])
    return (
        v[0] + q[0] * tx + q[2] * tz - q[3] * ty,
        v[1] + q[0] * ty + q[3] * tx - q[1] * tz,
        v[2] + q[0] * tz + q[1] * ty - q[2] * tx,
    )


@kernel
def rotate_back(q, v):
    """The vector v turned by the opposite of q: from the world's frame to the body's."""
    return rotate((q[0], -q[1], -q[2], -q[3]), v)


@kernel
def exponentiate(v):
    """The turn about the vector v by its length (rad), for any length and also for none (Grassia 1998)."""
    squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
    if squared < SMALL_TURN * SMALL_TURN:
        s = 0.5 - squared / 48.0 + squared * squared / 3840.0
        w = 1.0 - squared / 8.0 + squared * squared / 384.0
    else:
        angle = math.sqrt(squared)
        s = elementary.sin(0.5 * angle) / angle
        w = elementary.cos(0.5 * angle)
    return (w, s * v[0], s * v[1], s * v[2])


@kernel
def matrix_of(q):
    """Rotation matrix of a unit quaternion, row by row, 9 numbers."""
    w, x, y, z = q
    return (
        1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y),
        2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x),
        2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y),
    )  # fmt: skip


@kernel
def quaternion_of(m):
    """Quaternion, w >= 0, of a rotation matrix given as by `matrix_of`; its length is 1 as far as m is one.

    Shepperd 1978: divides by the largest of the four parts, so that no precision is lost at any angle.
    """
    trace = m[0] + m[4] + m[8]
    if trace >= max(m[0], max(m[4], m[8])):
        r = math.sqrt(max(1.0 + trace, 1.0))
        s = 0.5 / r
        return (0.5 * r, s * (m[7] - m[5]), s * (m[2] - m[6]), s * (m[3] - m[1]))
    if m[0] >= m[4] and m[0] >= m[8]:
        r = math.sqrt(1.0 + m[0] - m[4] - m[8])
        s = math.copysign(0.5, m[7] - m[5]) / r
        return (s * (m[7] - m[5]), s * r * r, s * (m[3] + m[1]), s * (m[2] + m[6]))
    if m[4] >= m[8]:
        r = math.sqrt(1.0 + m[4] - m[0] - m[8])
        s = math.copysign(0.5, m[2] - m[6]) / r
        return (s * (m[2] - m[6]), s * (m[3] + m[1]), s * r * r, s * (m[7] + m[5]))
    r = math.sqrt(1.0 + m[8] - m[0] - m[4])
    s = math.copysign(0.5, m[3] - m[1]) / r
    return (s * (m[3] - m[1]), s * (m[2] + m[6]), s * (m[7] + m[5]), s * r * r)


@kernel
def angle_between(p, q):
    """Angle (rad, 0 to pi) of the turn that leads from p to q, of any length; q and -q are the same."""
    w, x, y, z = multiply((p[0], -p[1], -p[2], -p[3]), q)
    return 2.0 * elementary.atan2(math.sqrt(x * x + y * y + z * z), abs(w))


# -- validation -------------------------------------------------------------------------------------


def quaternion_normalized(q: ArrayLike) -> Floats:
    """(4,) of length 1. ValueError if q has no length (or one whose square is no number)."""
    given = _numbers("quaternion", q, 4)
    largest = max(map(abs, given))
    if largest == 0.0:
        raise ValueError("quaternion: has no length, so it is no turn")
    scaled = tuple(part / largest for part in given)  # so that the square of the length is a number
    return np.array(normalize(scaled))


def quaternion_multiply(a: ArrayLike, b: ArrayLike) -> Floats:
    """Hamilton's product a b (4,): for unit quaternions the turn b and after it a."""
    return np.array(multiply(_numbers("a", a, 4), _numbers("b", b, 4)))


def quaternion_conjugate(q: ArrayLike) -> Floats:
    """(w, -x, -y, -z): the opposite turn."""
    w, x, y, z = _numbers("quaternion", q, 4)
    return np.array((w, -x, -y, -z))


def quaternion_rotate(q: ArrayLike, v: ArrayLike) -> Floats:
    """The vector v (3,) turned by q (4,), which need not have length 1."""
    return np.array(rotate(_unit(q), _numbers("vector", v, 3)))


def quaternion_from_axis_angle(axis: ArrayLike, angle: float) -> Floats:
    """The turn by `angle` rad about `axis` (3,) of any length but 0: ValueError for that."""
    x, y, z = _numbers("axis", axis, 3)
    largest = max(abs(x), abs(y), abs(z))
    if largest == 0.0:
        raise ValueError("axis: has no length")
    x, y, z = x / largest, y / largest, z / largest
    (half,) = _numbers("angle", (0.5 * angle,), 1)
    s = elementary.sin(half) / math.sqrt(x * x + y * y + z * z)
    return np.array((elementary.cos(half), s * x, s * y, s * z))


def quaternion_from_rotation_vector(vector: ArrayLike) -> Floats:
    """The turn about `vector` (3,) by its length, rad: the exponential map."""
    return np.array(exponentiate(_numbers("vector", vector, 3)))


def quaternion_to_rotation_vector(q: ArrayLike) -> Floats:
    """Axis times angle (3,), the angle 0 to pi: the logarithm, the short way round."""
    w, x, y, z = _unit(q)
    if w < 0.0:
        w, x, y, z = -w, -x, -y, -z
    sine = math.sqrt(x * x + y * y + z * z)
    factor = 2.0 * elementary.atan2(sine, w) / sine if sine > 0.0 else 2.0
    return factor * np.array((x, y, z))


def quaternion_to_matrix(q: ArrayLike) -> Floats:
    """Rotation matrix (3, 3) of q (4,), which need not have length 1."""
    return np.array(matrix_of(_unit(q))).reshape(3, 3)


def quaternion_from_matrix(matrix: ArrayLike) -> Floats:
    """Quaternion (4,), w >= 0, of a rotation matrix (3, 3); ValueError if it is none (to 1e-6)."""
    m = np.array(_numbers("matrix", matrix, 9)).reshape(3, 3)
    off = np.abs(linear.product(m, m.T) - np.eye(3)).max()
    if not off < 1e-6 or linear.determinant(m) < 0.0:
        raise ValueError("matrix: is not a rotation")
    return np.array(normalize(quaternion_of(tuple(m.reshape(-1).tolist()))))


def turn_between(p: ArrayLike, q: ArrayLike) -> float:
    """Angle (rad, 0 to pi) of the turn that leads from orientation p to q; q and -q are the same."""
    return float(angle_between(_numbers("p", p, 4), _numbers("q", q, 4)))


def _unit(q: ArrayLike) -> tuple[float, ...]:
    return tuple(quaternion_normalized(q).tolist())


def _numbers(name: str, values: ArrayLike, count: int) -> tuple[float, ...]:
    """So many finite floats, or ValueError."""
    array = np.array(values, dtype=np.float64).reshape(-1)
    if array.size != count or not np.isfinite(array).all():
        raise ValueError(f"{name}: expected {count} finite number{'s' if count > 1 else ''}")
    return tuple(array.tolist())
