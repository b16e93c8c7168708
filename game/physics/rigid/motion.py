"""How rigid bodies move in a step: ten methods to integrate x, q, P, L.

    x' = P / m,   q' = (0, w) q / 2,   P' = f,   L' = t,   w = R I⁻¹ Rᵀ L,   R of q

Force f and torque t are held over a step.

| method              | order | a free body                                                               |
| ------------------- | ----- | ------------------------------------------------------------------------- |
| explicit-euler      | 1     | L exact; energy rises to its bound L²/(2 I1); all from the old state      |
| semi-implicit       | 1     | the same; under forces the momenta go first                               |
| exponential-map     | 1     | as explicit Euler, but it turns by the whole angle and q keeps its length |
| midpoint            | 2     | L exact; energy off by dt³                                                |
| rk4                 | 4     | L exact; loses energy by dt⁵                                              |
| implicit-gyroscopic | 1     | loses energy and angular momentum                                         |
| splitting           | 2     | L exact; energy swings about its value, without drift                     |
| exact               | -     | Jacobi's solution; under torque between two half kicks, of order 2        |
| body-euler          | 1     | explicit Euler of Euler's equations in the body's frame: gains energy     |
| world-euler         | 1     | explicit Euler of the spin in the world's frame: loses energy             |
"""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.rigid.free_top import turn_freely
from game.physics.rigid.quaternion import normalize, rotate, rotate_back
from game.physics.rigid.turning import (
    body_spin_of,
    gyroscopic_torque,
    momentum_of,
    shifted,
    solve_gyroscopic,
    spin_of,
    tangent,
    turn_midpoint,
    turn_rk4,
    turn_split,
    turned,
)

METHODS = (
    "explicit-euler",
    "semi-implicit",
    "exponential-map",
    "midpoint",
    "rk4",
    "implicit-gyroscopic",
    "splitting",
    "exact",
    "body-euler",
    "world-euler",
)
EXPLICIT, SEMI_IMPLICIT, EXPONENTIAL, MIDPOINT, RK4, GYROSCOPIC, SPLITTING, EXACT, BODY, WORLD = range(10)
ORDERS = dict(zip(METHODS, (1, 1, 1, 2, 4, 1, 2, 2, 1, 1), strict=True))  # the exact one's under torque

# columns of a state (n, 13): place m, turn of the principal frame, momentum, angular momentum
X, Q, P, L, STATE_SIZE = 0, 3, 7, 10, 13
# columns of constants (n, 7): 1/m, ascending principal moments, their inverses (0: no turn about that axis)
INVERSE_MASS, MOMENTS, INVERSES, CONSTANTS = 0, 1, 4, 7
FORCE, TORQUE, LOADS = 0, 3, 6  # columns of loads (n, 6): N, N m


# The parts of a step are inlined: compiled one inside the other, each would be optimised again and again.


@kernel(inline="always")
def shift(method, x, p, force, inverse_mass, dt):
    """Place and momentum after a step."""
    after = shifted(p, force, dt)
    if method in (SEMI_IMPLICIT, GYROSCOPIC):
        return shifted(x, after, dt * inverse_mass), after
    x = shifted(x, p, dt * inverse_mass)
    if method in (MIDPOINT, RK4, SPLITTING, EXACT):
        x = shifted(x, force, 0.5 * dt * dt * inverse_mass)  # for a force that is held all come to this
    return x, after


@kernel(inline="always")
def turn_by_momentum(method, q, angular, torque, moments, inverses, dt):
    """Turn after a step of a method that keeps L as its state."""
    if method == EXPLICIT:
        return tangent(q, spin_of(q, angular, inverses), dt)
    if method == SEMI_IMPLICIT:
        return tangent(q, spin_of(q, shifted(angular, torque, dt), inverses), dt)
    if method == EXPONENTIAL:
        return turned(q, spin_of(q, angular, inverses), dt)
    if method == MIDPOINT:
        return turn_midpoint(q, angular, torque, inverses, dt)
    if method == RK4:
        return turn_rk4(q, angular, torque, inverses, dt)
    middle = shifted(angular, torque, 0.5 * dt)
    if method == EXACT and inverses[0] > 0.0:
        return turn_freely(q, middle, moments, dt)
    return turn_split(q, middle, inverses, dt)


@kernel(inline="always")
def turn_by_spin(method, q, angular, torque, moments, inverses, dt):
    """Turn and angular momentum after a step of a method that keeps w as its state."""
    if method == GYROSCOPIC:
        w = solve_gyroscopic(body_spin_of(q, shifted(angular, torque, dt), inverses), moments, dt)
        after = tangent(q, rotate(q, w), dt)
        return after, momentum_of(normalize(after), w, moments)
    w = body_spin_of(q, angular, inverses)
    t, g = rotate_back(q, torque), gyroscopic_torque(moments, w)
    rate = (inverses[0] * (t[0] - g[0]), inverses[1] * (t[1] - g[1]), inverses[2] * (t[2] - g[2]))
    after = tangent(q, rotate(q, w), dt)
    unit = normalize(after)
    w = shifted(w, rate, dt)
    if method == WORLD:
        w = rotate_back(unit, rotate(q, w))  # the new spin is known in the old frame
    return after, momentum_of(unit, w, moments)


@kernel(inline="always")
def turn_once(method, q, angular, torque, moments, inverses, dt, normalizing):
    """Turn and angular momentum after a step. If not ``normalizing``, q is as long as the method makes it."""
    length = 1.0
    if not normalizing:
        length = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        q = normalize(q)
    if method in (GYROSCOPIC, BODY, WORLD):
        q, angular = turn_by_spin(method, q, angular, torque, moments, inverses, dt)
    else:
        q = turn_by_momentum(method, q, angular, torque, moments, inverses, dt)
        angular = shifted(angular, torque, dt)
    if normalizing:
        return normalize(q), angular
    return (length * q[0], length * q[1], length * q[2], length * q[3]), angular


@kernel
def advance(method, states, constants, loads, air, turning, normalizing, dt, steps):
    """Make steps of dt s by METHODS[method]. states (n, 13) are written.

    constants (n, 7) and loads (n, 6) as above. air: how bodies fall in it, m/s² along -y, and the share of
    the momenta that it leaves, each step. turning 0: bodies only translate. normalizing 0:
    |q| is left to the method.
    """
    fall, keep = air
    for i in range(states.shape[0]):
        row, body, load = states[i], constants[i], loads[i]
        inverse_mass = body[0]
        moments, inverses = (body[1], body[2], body[3]), (body[4], body[5], body[6])
        weight = fall / inverse_mass if inverse_mass > 0.0 else 0.0
        force, torque = (load[0], load[1] - weight, load[2]), (load[3], load[4], load[5])
        x, q = (row[0], row[1], row[2]), (row[3], row[4], row[5], row[6])
        p, angular = (row[7], row[8], row[9]), (row[10], row[11], row[12])
        for _ in range(steps):
            x, p = shift(method, x, p, force, inverse_mass, dt)
            if turning:
                q, angular = turn_once(method, q, angular, torque, moments, inverses, dt, normalizing)
            if keep != 1.0:
                p, angular = shifted((0.0, 0.0, 0.0), p, keep), shifted((0.0, 0.0, 0.0), angular, keep)
        for k in range(3):
            row[k], row[7 + k], row[10 + k] = x[k], p[k], angular[k]
        for k in range(4):
            row[3 + k] = q[k]
