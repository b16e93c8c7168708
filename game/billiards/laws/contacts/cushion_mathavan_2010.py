"""Ball on cushion by Mathavan, Jackson and Parkin 2010, A theoretical analysis of billiard ball dynamics
under cushion impacts (Proc. IMechE C 224, 1863).

The impact is followed along the accumulated normal impulse P at the nose, point I. Both contacts rub: the
ball on the nose (mu_w), and, pressed down by it, the ball on the cloth at point C (mu_s). Compression lasts
until the ball no longer approaches; it stores the work W of the normal force. Restitution gives e^2 W back
(Stronge's energetic restitution). In the paper's frame y points into the rail and x along it; equation
numbers are the paper's.

The impulse is cut into equal steps (the paper's own numerical scheme), the last step of each phase
shortened so that the phase ends exactly. In a step friction never more than stops the slip. The error falls
as one over the number of steps, so two runs, one of them with twice as many, are extrapolated to none
(Richardson 1911). What is left is 1e-6 of the ball's speed where its surface slips all the time, and at most
2e-3 where it begins to stick: unlike the rest of the exact table this model is not right to rounding.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.laws import state as s
from game.billiards.laws.contacts.cushion_restitution import restitution_at
from game.billiards.laws.lean import inner_kernel

STEPS = 100  # of the compression, of the coarser of the two runs
PATIENCE = 20  # times as many steps; friction that holds the ball in the rail for longer is absurd


class Motion(NamedTuple):
    """A ball in the paper's frame: velocity along the rail and into it, m/s; spin, rad/s."""

    vx: float
    vy: float
    wx: float
    wy: float
    wz: float


class Impact(NamedTuple):
    """What the impact depends on: radius (m), mass (kg), sine of the nose's angle above the ball's centre,
    restitution, friction at nose and cloth."""

    radius: float
    mass: float
    sine: float
    restitution: float
    mu_nose: float
    mu_cloth: float


@inner_kernel(inline="always")
def _share_against(slip, limit, mass):
    """Impulse per unit of slip: Coulomb's `limit` (N s), or what stops the slip of a solid sphere."""
    if slip * 2.0 * mass / 7.0 <= limit:
        return 2.0 * mass / 7.0
    return limit / slip


@inner_kernel(inline="always")
def _rub_nose(motion, pressure, impact, cosine):
    """Friction at the nose, point I (eq. 12, 14a, 15): `pressure` is mu_w dP. Returns the state and what
    part of the impulse is vertical, upwards, N s."""
    vx, vy, wx, wy, wz = motion
    radius, mass, sine = impact.radius, impact.mass, impact.sine
    slip_x = vx + radius * (wy * sine - wz * cosine)
    slip_up = -vy * sine + radius * wx
    share = _share_against(math.sqrt(slip_x * slip_x + slip_up * slip_up), pressure, mass)
    px = -share * slip_x
    up = -share * slip_up
    lever = 2.5 / (mass * radius)
    vx += px / mass
    vy -= sine * up / mass
    wx += lever * up
    wy += lever * sine * px
    wz -= lever * cosine * px
    return Motion(vx, vy, wx, wy, wz), cosine * up


@inner_kernel(inline="always")
def _rub_cloth(motion, pressure, impact):
    """Friction at the cloth, point C (eq. 13, 14b, 15): `pressure` is mu_s dP_C. Returns the state."""
    vx, vy, wx, wy, wz = motion
    radius, mass = impact.radius, impact.mass
    slip_x = vx - radius * wy
    slip_y = vy + radius * wx
    share = _share_against(math.sqrt(slip_x * slip_x + slip_y * slip_y), pressure, mass)
    lever = 2.5 / (mass * radius)
    vx -= share * slip_x / mass
    vy -= share * slip_y / mass
    wx -= lever * share * slip_y
    wy += lever * share * slip_x
    return Motion(vx, vy, wx, wy, wz)


@inner_kernel
def follow_impact(motion, impact, steps):
    """The impact in the paper's frame, vy > 0 into the rail: state before to state after.

    steps: into how many the compression would be cut without friction.
    """
    vx, vy, wx, wy, wz = motion
    mass, sine = impact.mass, impact.sine
    cosine = math.sqrt((1.0 - sine) * (1.0 + sine))
    step = mass * vy / (cosine * steps)
    stored = 0.0
    owed = 0.0
    compressing = True
    for _ in range(PATIENCE * steps):
        if compressing and vy <= 0.0:
            compressing = False
            owed = impact.restitution * impact.restitution * stored
        if not compressing and owed <= 0.0:
            break
        after = vy - cosine * step / mass
        if compressing:
            after = max(after, 0.0)
            stored += 0.5 * mass * (vy - after) * (vy + after)
        else:
            work = 0.5 * mass * (after - vy) * (after + vy)
            if work >= owed:
                after = -math.sqrt(vy * vy + 2.0 * owed / mass)
            owed -= work
        pressed = (vy - after) * mass / cosine
        motion, up = _rub_nose(Motion(vx, after, wx, wy, wz), impact.mu_nose * pressed, impact, cosine)
        # what presses the ball on the cloth: the nose is above its centre, and may rub it down or up
        down = max(sine * pressed - up, 0.0)
        vx, vy, wx, wy, wz = _rub_cloth(motion, impact.mu_cloth * down, impact)
    return Motion(vx, min(vy, 0.0), wx, wy, wz)


@inner_kernel(inline="always")
def _energy(motion, radius):
    """Twice the energy over the mass, m^2/s^2."""
    vx, vy, wx, wy, wz = motion
    return vx * vx + vy * vy + 0.4 * radius * radius * (wx * wx + wy * wy + wz * wz)


@inner_kernel
def follow_to_the_limit(motion, impact, steps):
    """`follow_impact` with `steps` and twice as many, extrapolated to steps without number.

    Where that would raise the energy (nothing rubs, nothing is lost), the finer run is kept as it is.
    """
    a = follow_impact(motion, impact, steps)
    b = follow_impact(motion, impact, 2 * steps)
    c = Motion(
        b.vx + (b.vx - a.vx),
        b.vy + (b.vy - a.vy),
        b.wx + (b.wx - a.wx),
        b.wy + (b.wy - a.wy),
        b.wz + (b.wz - a.wz),
    )
    if c.vy > 0.0 or _energy(c, impact.radius) > _energy(motion, impact.radius):
        return b
    return c


@inner_kernel
def bounce_mathavan_2010(state, i, nx, ny, physics):
    """Bounce of ball i; n is the unit vector from the cushion to the ball. Needs |h/R - 1| < 1."""
    radius = state[s.RADIUS, i]
    # the paper's y axis is -n; its x axis then is y x z
    along_x = -ny
    along_y = nx
    before = Motion(
        state[s.VX, i] * along_x + state[s.VY, i] * along_y,
        -(state[s.VX, i] * nx + state[s.VY, i] * ny),
        state[s.WX, i] * along_x + state[s.WY, i] * along_y,
        -(state[s.WX, i] * nx + state[s.WY, i] * ny),
        state[s.WZ, i],
    )
    impact = Impact(
        radius,
        state[s.MASS, i],
        physics[s.CUSHION_HEIGHT] / radius - 1.0,
        restitution_at(before.vy, physics),
        physics[s.CUSHION_FRICTION],
        physics[s.SLIDING_FRICTION],
    )
    vx, vy, wx, wy, wz = follow_to_the_limit(before, impact, STEPS)
    state[s.VX, i] = vx * along_x - vy * nx
    state[s.VY, i] = vx * along_y - vy * ny
    state[s.WX, i] = wx * along_x - wy * nx
    state[s.WY, i] = wx * along_y - wy * ny
    state[s.WZ, i] = wz
