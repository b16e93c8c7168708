"""A ball in the air against a cushion or a jaw, and what makes a ball hop off a cushion.

Seen along it, a cushion is a wall as high as its nose, h, with a level top: a ball meets the wall while its
centre is not above h, as on the slate. Else it meets the edge of the nose (a horizontal line, at a jaw a
circle), else the top. At wall and nose the impulse acts along N, which points from the nose to the ball's
centre. That is the law of Han 2005 (`contacts.cushion_han_2005`, th = asin((h - z)/R - 1)) with vertical
speed and impulse: restitution along N, and across it the lesser of what stops the slip, 2/7 m |c|, and of mu
times the normal impulse. So it is for all models of the cushion but `restitution` and `mirror`, which have a
smooth upright wall below h.

A cushion presses a ball that lies on the slate down, for its nose is above the centre. It presses for
milliseconds, which the slate's own impact does not take, so that most of the bounce is lost: CUSHION_HOP says
what share of the slate's restitution is left, 0 for none (the ball stays down, as Han 2005 and Mathavan,
Jackson and Parkin 2010 take it), 1 for an impact.
"""

from __future__ import annotations

import math

from game.billiards.flight.air import enter_air_or_slate
from game.billiards.flight.slate import bounce_on_level
from game.billiards.laws import state as s
from game.billiards.laws.contacts import RESTITUTION
from game.billiards.laws.contacts.cushion_restitution import restitution_at
from game.billiards.laws.lean import inner_kernel


@inner_kernel
def rail_normal(state, i, event, element, cushions, jaws):
    """Unit vector along the bed from a cushion or jaw to ball i, and how far its centre is from it, m."""
    if event == s.BALL_JAW:
        x = state[s.X, i] - jaws[element, 0]
        y = state[s.Y, i] - jaws[element, 1]
        distance = math.sqrt(x * x + y * y)
        return x / distance, y / distance, distance - jaws[element, 2]
    nx = cushions[element, s.NORMAL_X]
    ny = cushions[element, s.NORMAL_Y]
    gap = (state[s.X, i] - cushions[element, s.FROM_X]) * nx + (
        state[s.Y, i] - cushions[element, s.FROM_Y]
    ) * ny
    return nx, ny, gap


@inner_kernel
def _tilt(state, i, gap, physics):
    """Cosine and sine of the angle by which N points up; `gap`: along the bed from the nose, m."""
    above = state[s.Z, i] + state[s.RADIUS, i] - physics[s.CUSHION_HEIGHT]
    if above > 0.0:
        across = max(gap, 0.0)
        distance = math.sqrt(across * across + above * above)
        return across / distance, above / distance
    if physics[s.CUSHION_LAW] == RESTITUTION:
        return 1.0, 0.0
    sine = max(above / state[s.RADIUS, i], -1.0)
    return math.sqrt(1.0 - sine * sine), sine


@inner_kernel
def _nose_impulse(state, i, normal, physics):
    """Impulse over mass (3 numbers, m/s) that ball i gets where N is `normal`, and the closing speed."""
    nx, ny, nz = normal
    closing = -(state[s.VX, i] * nx + state[s.VY, i] * ny + state[s.VZ, i] * nz)
    if closing <= 0.0:
        return 0.0, 0.0, 0.0, closing
    gentle = closing <= s.LANDING_SPEED and nz > 0.0
    restitution = 1.0 if gentle else restitution_at(closing, physics)
    normal_impulse = (1.0 + restitution) * closing
    px = normal_impulse * nx
    py = normal_impulse * ny
    pz = normal_impulse * nz
    if physics[s.CUSHION_LAW] == RESTITUTION or gentle:
        return px, py, pz, closing
    radius = state[s.RADIUS, i]
    # slip of the point at -R N: v - R w x N, less its part along N
    cx = state[s.VX, i] - radius * (state[s.WY, i] * nz - state[s.WZ, i] * ny) + closing * nx
    cy = state[s.VY, i] - radius * (state[s.WZ, i] * nx - state[s.WX, i] * nz) + closing * ny
    cz = state[s.VZ, i] - radius * (state[s.WX, i] * ny - state[s.WY, i] * nx) + closing * nz
    slip = math.sqrt(cx * cx + cy * cy + cz * cz)
    if slip > 0.0:
        share = min(physics[s.CUSHION_FRICTION] * normal_impulse, 2.0 / 7.0 * slip) / slip
        px -= share * cx
        py -= share * cy
        pz -= share * cz
    return px, py, pz, closing


@inner_kernel
def _take_impulse(state, i, normal, impulse):
    """Give ball i an impulse over mass (m/s) at the point -R N."""
    nx, ny, nz = normal
    px, py, pz = impulse
    lever = -2.5 / state[s.RADIUS, i]
    state[s.VX, i] += px
    state[s.VY, i] += py
    state[s.VZ, i] += pz
    state[s.WX, i] += lever * (ny * pz - nz * py)
    state[s.WY, i] += lever * (nz * px - nx * pz)
    state[s.WZ, i] += lever * (nx * py - ny * px)


@inner_kernel
def hit_nose(state, modes, i, event, element, cushions, jaws, physics):
    """Ball i, in the air and already at the contact, meets a cushion or a jaw."""
    nx, ny, gap = rail_normal(state, i, event, element, cushions, jaws)
    cosine, sine = _tilt(state, i, gap, physics)
    normal = (cosine * nx, cosine * ny, sine)
    px, py, pz, closing = _nose_impulse(state, i, normal, physics)
    if closing <= 0.0:  # it slips down past the nose, into the wall
        normal = (nx, ny, 0.0)
        px, py, pz, closing = _nose_impulse(state, i, normal, physics)
    _take_impulse(state, i, normal, (px, py, pz))
    if sine <= 0.0:
        into = min(state[s.VX, i] * nx + state[s.VY, i] * ny, 0.0)
        state[s.VX, i] -= into * nx
        state[s.VY, i] -= into * ny
    if state[s.Z, i] <= 0.0 and state[s.VZ, i] < 0.0:
        bounce_on_level(state, i, physics)
    enter_air_or_slate(state, modes, i, physics)


@inner_kernel
def hop_of(state, i, event, element, cushions, jaws, physics):
    """Vertical speed, m/s, with which ball i, lying and about to meet a cushion or jaw, leaves the slate."""
    if physics[s.CUSHION_HOP] == 0.0:
        return 0.0
    nx, ny, gap = rail_normal(state, i, event, element, cushions, jaws)
    cosine, sine = _tilt(state, i, gap, physics)
    lift = _nose_impulse(state, i, (cosine * nx, cosine * ny, sine), physics)[2]
    return lift if lift > 0.0 else -lift * physics[s.CUSHION_HOP] * physics[s.SLATE_RESTITUTION]
