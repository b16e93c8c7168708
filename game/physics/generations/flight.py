"""How one star flies: gravity, air that drags and drifts, mass that burns away, thrust.

    dv/dt = b g - (k + q |u| / m) u + thrust,   u = v - w,   m = 1 - burnt (t - t_birth)

x to the right, y up, z away from who looks. b share of gravity that is felt (smoke rises: b < 0), k 1/s and
q 1/m drag at full mass, w velocity of the air. Thrust acts along the path and gives what Tsiolkovsky (1903)
says for the mass that is lost, exactly.

Methods. Split drag (the default; Strang 1968): half of the kick, the drag alone by its exact solution, the
other half, and the way by the trapezium of both velocities. Of second order, and never past the wind however
stiff the drag: with du/dt = -(k + q |u|) u,  u(h) = u E / (1 + q |u| G),  E = exp(-k h), G = (1 - E) / k.
Explicit and semi-implicit Euler, midpoint and Runge-Kutta's fourth order take the drag as any other force.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import kernel
from game.physics.generations.effects import (
    BURNING_BIT,
    DRAG_BIT,
    GRAVITY_BIT,
    QUADRATIC_BIT,
    THRUST_BIT,
    WIND_BIT,
)
from game.physics.kernels import elementary

METHODS = ("split-drag", "explicit-euler", "semi-implicit-euler", "midpoint", "rk4")
SPLIT_DRAG, EXPLICIT_EULER, SEMI_IMPLICIT_EULER, MIDPOINT, RK4 = range(5)
LEAST_MASS = 2.0**-20  # of the full mass; what is left of a star in the last instant of its life


class Air(NamedTuple):
    """Gravity and wind: w = wind (1 + shear y), y from 0 to the ceiling."""

    gravity: float  # m/s², downwards
    wind: float  # m/s, to the right, at the ground
    shear: float  # 1/m, growth of the wind with height
    ceiling: float  # m, above which the wind grows no more
    updraught: float  # m/s


class Law(NamedTuple):
    """What of a kind its flight depends on."""

    weight: float  # share of gravity that is felt
    linear: float  # k, 1/s
    quadratic: float  # q, 1/m
    exhaust: float  # m/s, speed of the gas that a rocket throws out


class Star(NamedTuple):
    """Place (m), velocity (m/s), age (s) and share of its mass that it burns in a second (1/s)."""

    x: float
    y: float
    z: float
    vx: float
    vy: float
    vz: float
    age: float
    burnt: float


@kernel(forceinline=True)
def wind_at(mask, air, y):
    """Velocity (m/s) of the air at a height (m)."""
    if mask & WIND_BIT:
        return air.wind * (1.0 + air.shear * min(max(y, 0.0), air.ceiling)), air.updraught
    return 0.0, 0.0


@kernel(forceinline=True)
def mass_left(mask, age, burnt):
    """Share of the full mass that is left at an age (s)."""
    if mask & BURNING_BIT:
        return max(1.0 - burnt * age, LEAST_MASS)
    return 1.0


@kernel(forceinline=True)
def pull(mask, law, air):
    """Vertical acceleration (m/s²) that depends on nothing."""
    if mask & GRAVITY_BIT:
        return -law.weight * air.gravity
    return 0.0


@kernel(forceinline=True)
def drag_rate(mask, law, speed, mass):
    """Drag (1/s) at a speed (m/s) through the air."""
    rate = 0.0
    if mask & DRAG_BIT:
        rate = law.linear
    if mask & QUADRATIC_BIT:
        rate = rate + law.quadratic * speed / mass
    return rate


class Terms(NamedTuple):
    """What split drag needs of a kind for one length of step: numbers alone, so its loop has no branch."""

    kick: float  # m/s, half of what gravity gives
    wind: float  # m/s
    shear: float  # 1/m
    ceiling: float  # m
    updraught: float  # m/s
    decay: float  # E
    reach: float  # G, s, times q: 1/(m/s)
    burning: float  # 1, or 0 for mass that stays


@kernel
def terms_over(mask, law, air, h):
    """`Terms` of a kind for h (s)."""
    decay, reach = 1.0, h
    if mask & DRAG_BIT and law.linear > 0.0:
        decay = elementary.exp(-law.linear * h)
        reach = -elementary.expm1(-law.linear * h) / law.linear
    windy = 1.0 if mask & WIND_BIT else 0.0
    return Terms(
        0.5 * h * pull(mask, law, air),
        windy * air.wind,
        air.shear,
        air.ceiling,
        windy * air.updraught,
        decay,
        reach * law.quadratic if mask & QUADRATIC_BIT else 0.0,
        1.0 if mask & BURNING_BIT else 0.0,
    )


@kernel(forceinline=True)
def fly_split(terms, quadratic, star, h):
    """Place and velocity after h (s) by split drag; quadratic: whether that part of the drag is there."""
    middle = (
        star.y + 0.5 * h * star.vy
    )  # where the wind of the whole step is taken: else it is of first order
    wx = terms.wind * (1.0 + terms.shear * min(max(middle, 0.0), terms.ceiling))
    ux = star.vx - wx
    uy = star.vy + terms.kick - terms.updraught
    uz = star.vz
    factor = terms.decay
    if quadratic:
        mass = max(1.0 - terms.burning * star.burnt * (star.age + 0.5 * h), LEAST_MASS)
        factor = factor * mass / (mass + terms.reach * math.sqrt(ux * ux + uy * uy + uz * uz))
    vx = wx + ux * factor
    vy = terms.updraught + uy * factor + terms.kick
    vz = uz * factor
    half = 0.5 * h
    return (
        star.x + half * (star.vx + vx), star.y + half * (star.vy + vy), star.z + half * (star.vz + vz),
        vx, vy, vz,
    )  # fmt: skip


@kernel
def acceleration(mask, law, air, y, velocity, mass):
    """Acceleration (m/s²) of a star of some mass, with a velocity (m/s)."""
    vx, vy, vz = velocity
    wx, wy = wind_at(mask, air, y)
    ux = vx - wx
    uy = vy - wy
    rate = drag_rate(mask, law, math.sqrt(ux * ux + uy * uy + vz * vz), mass)
    return -rate * ux, pull(mask, law, air) - rate * uy, -rate * vz


@kernel
def fly_staged(method, mask, law, air, star, h):
    """Place and velocity after h (s) by a method that takes the drag as any other force."""
    place = (star.x, star.y, star.z)
    v1 = (star.vx, star.vy, star.vz)
    a1 = acceleration(mask, law, air, star.y, v1, mass_left(mask, star.age, star.burnt))
    if method == EXPLICIT_EULER:
        return (*gone_on(place, v1, h), *gone_on(v1, a1, h))
    if method == SEMI_IMPLICIT_EULER:
        faster = gone_on(v1, a1, h)
        return (*gone_on(place, faster, h), *faster)
    half = 0.5 * h
    middle = mass_left(mask, star.age + half, star.burnt)
    v2 = gone_on(v1, a1, half)
    a2 = acceleration(mask, law, air, star.y + half * v1[1], v2, middle)
    if method == MIDPOINT:
        return (*gone_on(place, v2, h), *gone_on(v1, a2, h))
    v3 = gone_on(v1, a2, half)
    a3 = acceleration(mask, law, air, star.y + half * v2[1], v3, middle)
    v4 = gone_on(v1, a3, h)
    a4 = acceleration(mask, law, air, star.y + h * v3[1], v4, mass_left(mask, star.age + h, star.burnt))
    return (*gone_on(place, weighed(v1, v2, v3, v4), h), *gone_on(v1, weighed(a1, a2, a3, a4), h))


@kernel(forceinline=True)
def gone_on(value, rate, h):
    """A vector after h (s) of an even rate."""
    return value[0] + h * rate[0], value[1] + h * rate[1], value[2] + h * rate[2]


@kernel(forceinline=True)
def weighed(a, b, c, d):
    """The mean of four stages by Runge and Kutta's weights, 1 2 2 1."""
    return (
        (a[0] + 2.0 * (b[0] + c[0]) + d[0]) / 6.0,
        (a[1] + 2.0 * (b[1] + c[1]) + d[1]) / 6.0,
        (a[2] + 2.0 * (b[2] + c[2]) + d[2]) / 6.0,
    )


@kernel
def fly(method, mask, law, air, star, h):
    """Place (m) and velocity (m/s) of a star after h (s): (x, y, z, vx, vy, vz)."""
    if mask & THRUST_BIT and law.exhaust > 0.0:
        return fly_driven(method, mask, law, air, star, h)
    if method == SPLIT_DRAG:
        return fly_split(terms_over(mask, law, air, h), law.quadratic > 0.0, star, h)
    return fly_staged(method, mask, law, air, star, h)


@kernel
def fly_driven(method, mask, law, air, star, h):
    """As `fly`, between two halves of the thrust: by Tsiolkovsky, speed v_e ln(m / m') for each half's mass.

    The way is that of the middle velocity, plus what the thrust adds within each half.
    """
    before = max(1.0 - star.burnt * star.age, LEAST_MASS)
    middle = max(1.0 - star.burnt * (star.age + 0.5 * h), LEAST_MASS)
    after = max(1.0 - star.burnt * (star.age + h), LEAST_MASS)
    first = law.exhaust * elementary.log(before / middle)
    second = law.exhaust * elementary.log(middle / after)
    n = heading(star.vx, star.vy, star.vz)
    vx, vy, vz = gone_on((star.vx, star.vy, star.vz), n, first)
    pushed = Star(star.x, star.y, star.z, vx, vy, vz, star.age, star.burnt)
    if method == SPLIT_DRAG:
        x, y, z, vx, vy, vz = fly_split(terms_over(mask, law, air, h), law.quadratic > 0.0, pushed, h)
    else:
        x, y, z, vx, vy, vz = fly_staged(method, mask, law, air, pushed, h)
    # the first half's gain is not there all the time: exactly -v_e times the mean of ln over the whole step
    mean = mean_gain(law.exhaust, before, star.burnt, h) - first
    place = gone_on((x, y, z), n, mean * h)
    n = heading(vx, vy, vz)
    return (*place, *gone_on((vx, vy, vz), n, second))


@kernel
def mean_gain(exhaust, mass, burnt, h):
    """Mean over h (s) of the speed v_e ln(m_0 / m) that thrust has given since its beginning (m/s)."""
    lost = burnt * h
    if lost <= 0.0 or lost >= mass:
        return 0.0
    left = mass - lost
    return exhaust * (1.0 - left / lost * elementary.log(mass / left))


@kernel
def heading(vx, vy, vz):
    """Unit vector along a velocity; upwards for none."""
    speed = math.sqrt(vx * vx + vy * vy + vz * vz)
    if speed == 0.0:
        return 0.0, 1.0, 0.0
    return vx / speed, vy / speed, vz / speed
