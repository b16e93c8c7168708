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

from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import (
    CUSHION_FRICTION,
    CUSHION_HEIGHT,
    CUSHION_RESTITUTION,
    MASS,
    RADIUS,
    SLIDING_FRICTION,
    VX,
    VY,
    WX,
    WY,
    WZ,
)

STEPS = 100  # of the compression, of the coarser of the two runs
PATIENCE = 20  # times as many steps; friction that holds the ball in the rail for longer is absurd


@inner_kernel(inline="always")
def _share_against(slip, limit, mass):
    """Impulse per unit of slip: Coulomb's `limit` (N s), or what stops the slip of a solid sphere."""
    if slip * 2.0 * mass / 7.0 <= limit:
        return 2.0 * mass / 7.0
    return limit / slip


@inner_kernel(inline="always")
def _rub_nose(vx, vy, wx, wy, wz, pressure, radius, mass, sine, cosine):
    """Friction at the nose, point I (eq. 12, 14a, 15): `pressure` is mu_w dP. Returns the state and what
    part of the impulse is vertical, upwards, N s."""
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
    return vx, vy, wx, wy, wz, cosine * up


@inner_kernel(inline="always")
def _rub_cloth(vx, vy, wx, wy, pressure, radius, mass):
    """Friction at the cloth, point C (eq. 13, 14b, 15): `pressure` is mu_s dP_C. Returns the state."""
    slip_x = vx - radius * wy
    slip_y = vy + radius * wx
    share = _share_against(math.sqrt(slip_x * slip_x + slip_y * slip_y), pressure, mass)
    lever = 2.5 / (mass * radius)
    vx -= share * slip_x / mass
    vy -= share * slip_y / mass
    wx -= lever * share * slip_y
    wy += lever * share * slip_x
    return vx, vy, wx, wy


@inner_kernel
def follow_impact(vx, vy, wx, wy, wz, radius, mass, sine, restitution, mu_nose, mu_cloth, steps):
    """The impact in the paper's frame, vy > 0 into the rail: state before to state after.

    steps: into how many the compression would be cut without friction.
    """
    cosine = math.sqrt((1.0 - sine) * (1.0 + sine))
    step = mass * vy / (cosine * steps)
    stored = 0.0
    owed = 0.0
    compressing = True
    for _ in range(PATIENCE * steps):
        if compressing and vy <= 0.0:
            compressing = False
            owed = restitution * restitution * stored
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
        vy = after
        vx, vy, wx, wy, wz, up = _rub_nose(vx, vy, wx, wy, wz, mu_nose * pressed, radius, mass, sine, cosine)
        # what presses the ball on the cloth: the nose is above its centre, and may rub it down or up
        down = max(sine * pressed - up, 0.0)
        vx, vy, wx, wy = _rub_cloth(vx, vy, wx, wy, mu_cloth * down, radius, mass)
    return vx, min(vy, 0.0), wx, wy, wz


@inner_kernel(inline="always")
def _energy(vx, vy, wx, wy, wz, radius):
    """Twice the energy over the mass, m^2/s^2."""
    return vx * vx + vy * vy + 0.4 * radius * radius * (wx * wx + wy * wy + wz * wz)


@inner_kernel
def follow_to_the_limit(vx, vy, wx, wy, wz, radius, mass, sine, restitution, mu_nose, mu_cloth, steps):
    """`follow_impact` with `steps` and twice as many, extrapolated to steps without number.

    Where that would raise the energy (nothing rubs, nothing is lost), the finer run is kept as it is.
    """
    ax, ay, ap, aq, ar = follow_impact(
        vx, vy, wx, wy, wz, radius, mass, sine, restitution, mu_nose, mu_cloth, steps
    )
    bx, by, bp, bq, br = follow_impact(
        vx, vy, wx, wy, wz, radius, mass, sine, restitution, mu_nose, mu_cloth, 2 * steps
    )
    cx = bx + (bx - ax)
    cy = by + (by - ay)
    cp = bp + (bp - ap)
    cq = bq + (bq - aq)
    cr = br + (br - ar)
    if cy > 0.0 or _energy(cx, cy, cp, cq, cr, radius) > _energy(vx, vy, wx, wy, wz, radius):
        return bx, by, bp, bq, br
    return cx, cy, cp, cq, cr


@inner_kernel
def bounce_mathavan_2010(state, i, nx, ny, physics):
    """Bounce of ball i; n is the unit vector from the cushion to the ball. Needs |h/R - 1| < 1."""
    radius = state[RADIUS, i]
    # the paper's y axis is -n; its x axis then is y x z
    along_x = -ny
    along_y = nx
    vx, vy, wx, wy, wz = follow_to_the_limit(
        state[VX, i] * along_x + state[VY, i] * along_y,
        -(state[VX, i] * nx + state[VY, i] * ny),
        state[WX, i] * along_x + state[WY, i] * along_y,
        -(state[WX, i] * nx + state[WY, i] * ny),
        state[WZ, i],
        radius,
        state[MASS, i],
        physics[CUSHION_HEIGHT] / radius - 1.0,
        physics[CUSHION_RESTITUTION],
        physics[CUSHION_FRICTION],
        physics[SLIDING_FRICTION],
        STEPS,
    )
    state[VX, i] = vx * along_x - vy * nx
    state[VY, i] = vx * along_y - vy * ny
    state[WX, i] = wx * along_x - wy * nx
    state[WY, i] = wx * along_y - wy * ny
    state[WZ, i] = wz
