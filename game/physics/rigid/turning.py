"""How a rigid body turns in a step: kernels, one for each method that integrates q and L.

    q' = (0, w) q / 2,   L' = t,   w = R I⁻¹ Rᵀ L,   R of q

q: turn of the principal frame, a unit quaternion; L: angular momentum in the world's frame. I is diagonal in
the principal frame. Each gives q after the step, not normalized where the method makes it longer.

Triples of plain numbers throughout: moments, ascending, and their inverses (0: no turn about that axis).
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.kernels import elementary
from game.physics.rigid.quaternion import exponentiate, multiply, normalize, rotate, rotate_back


@kernel
def spin_of(q, angular, inverses):
    """Spin (world frame, rad/s) of a body with the turn q and the angular momentum angular."""
    body = rotate_back(q, angular)
    return rotate(q, (body[0] * inverses[0], body[1] * inverses[1], body[2] * inverses[2]))


@kernel
def body_spin_of(q, angular, inverses):
    """The same in the body's frame."""
    body = rotate_back(q, angular)
    return (body[0] * inverses[0], body[1] * inverses[1], body[2] * inverses[2])


@kernel
def momentum_of(q, w, moments):
    """Angular momentum (world frame) of a body that turns at w, given in its own frame."""
    return rotate(q, (moments[0] * w[0], moments[1] * w[1], moments[2] * w[2]))


@kernel
def measure(row, body):
    """Kinetic energy (J) of shift and rotation, |L|, |q|, and the spin about the principal axes (3 numbers).

    row, body: a state and its constants, see motion.
    """
    q = (row[3], row[4], row[5], row[6])
    size = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    angular = (row[10], row[11], row[12])
    l1, l2, l3 = rotate_back(normalize(q), angular)
    squared = row[7] * row[7] + row[8] * row[8] + row[9] * row[9]
    w1, w2, w3 = l1 * body[4], l2 * body[5], l3 * body[6]
    rotation = 0.5 * (l1 * w1 + l2 * w2 + l3 * w3)
    momentum = math.sqrt(angular[0] * angular[0] + angular[1] * angular[1] + angular[2] * angular[2])
    return 0.5 * squared * body[0], rotation, momentum, size, w1, w2, w3


@kernel
def shifted(v, w, h):
    """v + h w."""
    return (v[0] + h * w[0], v[1] + h * w[1], v[2] + h * w[2])


@kernel
def tangent(q, w, h):
    """q + h (0, w) q / 2: one step of Euler, which makes q longer and turns by 2 atan(|w| h / 2)."""
    d = multiply((0.0, w[0], w[1], w[2]), q)
    s = 0.5 * h
    return (q[0] + s * d[0], q[1] + s * d[1], q[2] + s * d[2], q[3] + s * d[3])


@kernel
def turned(q, w, h):
    """q turned about w (world frame) by the angle |w| h: the exponential map."""
    return multiply(exponentiate((h * w[0], h * w[1], h * w[2])), q)


@kernel
def turn_midpoint(q, angular, torque, inverses, dt):
    """With the spin in the middle of the step, reached by half a step of the exponential map."""
    middle = turned(q, spin_of(q, angular, inverses), 0.5 * dt)
    return turned(q, spin_of(middle, shifted(angular, torque, 0.5 * dt), inverses), dt)


@kernel
def slope(q, angular, inverses):
    """q', for a q that may be a little off length 1."""
    w = spin_of(normalize(q), angular, inverses)
    d = multiply((0.0, w[0], w[1], w[2]), q)
    return (0.5 * d[0], 0.5 * d[1], 0.5 * d[2], 0.5 * d[3])


@kernel
def ahead(q, k, h):
    """q + h k."""
    return (q[0] + h * k[0], q[1] + h * k[1], q[2] + h * k[2], q[3] + h * k[3])


@kernel
def turn_rk4(q, angular, torque, inverses, dt):
    """Classical Runge-Kutta (Kutta 1901); L grows evenly."""
    middle, last = shifted(angular, torque, 0.5 * dt), shifted(angular, torque, dt)
    k1 = slope(q, angular, inverses)
    k2 = slope(ahead(q, k1, 0.5 * dt), middle, inverses)
    k3 = slope(ahead(q, k2, 0.5 * dt), middle, inverses)
    k4 = slope(ahead(q, k3, dt), last, inverses)
    return ahead(ahead(ahead(ahead(q, k1, dt / 6.0), k2, dt / 3.0), k3, dt / 3.0), k4, dt / 6.0)


@kernel
def gyroscopic_torque(moments, w):
    """w x I w, in the body's frame."""
    return (
        (moments[2] - moments[1]) * w[1] * w[2],
        (moments[0] - moments[2]) * w[2] * w[0],
        (moments[1] - moments[0]) * w[0] * w[1],
    )


@kernel
def solve_gyroscopic(w, moments, dt):
    """Spin after a step of backward Euler of I w' + w x I w = 0 (body's frame): one step of Newton.

    Catto 2015, "Numerical methods" (Game Developers Conference). Residual dt w x I w, Jacobian
    I + dt ([w]x I - [I w]x), solved by Cramer's rule; the spin as it was if that has no inverse.
    """
    f = gyroscopic_torque(moments, w)
    i1, i2, i3 = moments
    a, b, c = dt * w[0], dt * w[1], dt * w[2]
    # off the diagonal the two cross products leave differences of moments
    m12, m13 = (i3 - i2) * c, (i3 - i2) * b
    m21, m23 = (i1 - i3) * c, (i1 - i3) * a
    m31, m32 = (i2 - i1) * b, (i2 - i1) * a
    d1, d2, d3 = i2 * i3 - m23 * m32, m23 * m31 - m21 * i3, m21 * m32 - i2 * m31
    whole = i1 * d1 + m12 * d2 + m13 * d3
    if whole == 0.0:
        return w
    r = dt / whole
    x = f[0] * d1 + f[1] * (m13 * m32 - m12 * i3) + f[2] * (m12 * m23 - m13 * i2)
    y = f[0] * d2 + f[1] * (i1 * i3 - m13 * m31) + f[2] * (m13 * m21 - i1 * m23)
    z = f[0] * d3 + f[1] * (m12 * m31 - i1 * m32) + f[2] * (i1 * i2 - m12 * m21)
    return (w[0] - r * x, w[1] - r * y, w[2] - r * z)


@kernel
def cosine_and_sine(half):
    """cos and sin of an angle from those of its half."""
    c, s = half
    return c * c - s * s, 2.0 * s * c


@kernel
def turn_split(q, angular, inverses, dt):
    """Turns about the body's axes 1, 2, 3, 2, 1 by a half, half, whole, half, half step, each of them exact.

    The energy L1²/2I1 + L2²/2I2 + L3²/2I3 in three parts (McLachlan 1993; Reich 1994; Touma and Wisdom
    1994). A turn about an axis by an angle turns L, seen in the body, by the opposite one.
    """
    x, y, z = rotate_back(q, angular)
    half = 0.25 * dt * x * inverses[0]
    first = (elementary.cos(half), elementary.sin(half))
    c, s = cosine_and_sine(first)
    y, z = c * y + s * z, c * z - s * y
    q = multiply(q, (first[0], first[1], 0.0, 0.0))
    half = 0.25 * dt * y * inverses[1]
    second = (elementary.cos(half), elementary.sin(half))
    c, s = cosine_and_sine(second)
    z, x = c * z + s * x, c * x - s * z
    q = multiply(q, (second[0], 0.0, second[1], 0.0))
    half = 0.5 * dt * z * inverses[2]
    third = (elementary.cos(half), elementary.sin(half))
    c, s = cosine_and_sine(third)
    x, y = c * x + s * y, c * y - s * x
    q = multiply(q, (third[0], 0.0, 0.0, third[1]))
    half = 0.25 * dt * y * inverses[1]
    fourth = (elementary.cos(half), elementary.sin(half))
    c, s = cosine_and_sine(fourth)
    x = c * x - s * z
    q = multiply(q, (fourth[0], 0.0, fourth[1], 0.0))
    half = 0.25 * dt * x * inverses[0]
    return multiply(q, (elementary.cos(half), elementary.sin(half), 0.0, 0.0))
