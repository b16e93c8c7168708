"""Contacts carried out: a ball meets a rail, two balls meet each other."""

from __future__ import annotations

import math

from game.billiards.laws import contacts
from game.billiards.laws import state as s
from game.billiards.laws.contacts.ball_ball_friction import rub_in_contact
from game.billiards.laws.contacts.ball_ball_normal import collide_along_normal
from game.billiards.laws.contacts.chatter import (
    ALLOWED_REPEATS,
    CHATTER_TIME,
    LAST_REPEATS,
    least_separating_speed,
    separate,
)
from game.billiards.laws.contacts.cushion_han_2005 import bounce_han_2005
from game.billiards.laws.contacts.cushion_mathavan_2010 import bounce_mathavan_2010
from game.billiards.laws.contacts.cushion_restitution import bounce, restitution_at
from game.billiards.laws.contacts.cushion_stronge_2000 import bounce_stronge_2000
from game.billiards.laws.lean import inner_kernel


@inner_kernel(inline="always")
def bounce_off(state, i, nx, ny, physics):
    """Bounce ball i off a rail with the table's model; n is the unit vector from the rail to the ball."""
    if physics[s.CUSHION_LAW] == contacts.HAN_2005:
        bounce_han_2005(state, i, nx, ny, physics)
    elif physics[s.CUSHION_LAW] == contacts.MATHAVAN_2010:
        bounce_mathavan_2010(state, i, nx, ny, physics)
    elif physics[s.CUSHION_LAW] == contacts.STRONGE_2000:
        bounce_stronge_2000(state, i, nx, ny, physics)
    else:
        closing = -(state[s.VX, i] * nx + state[s.VY, i] * ny)
        bounce(state, i, nx, ny, restitution_at(closing, physics))


@inner_kernel
def hit_rail(state, modes, i, event, element, cushions, jaws, physics):
    """Ball i, already at the contact, meets a cushion or a jaw. Returns if it is stuck: see `settling`."""
    if event == s.BALL_JAW:
        nx = state[s.X, i] - jaws[element, 0]
        ny = state[s.Y, i] - jaws[element, 1]
        distance = math.sqrt(nx * nx + ny * ny)
        nx /= distance
        ny /= distance
    else:
        nx = cushions[element, s.NORMAL_X]
        ny = cushions[element, s.NORMAL_Y]
    bounce_off(state, i, nx, ny, physics)
    now = state[s.TIME, i]
    repeats = modes[s.RAIL_COUNT, i] + 1 if now - state[s.RAIL_TIME, i] < CHATTER_TIME else 0
    modes[s.RAIL_COUNT, i] = repeats
    state[s.RAIL_TIME, i] = now
    if repeats >= ALLOWED_REPEATS:
        separated = separate(state, i, -1, -nx, -ny, least_separating_speed(repeats))
        return repeats >= LAST_REPEATS and not separated
    return False


@inner_kernel(inline="always")
def normal_between(state, i, j):
    """Unit vector from ball i to ball j, both at the same time."""
    nx = state[s.X, j] - state[s.X, i]
    ny = state[s.Y, j] - state[s.Y, i]
    distance = math.sqrt(nx * nx + ny * ny)
    if distance == 0.0:
        return 1.0, 0.0
    return nx / distance, ny / distance


@inner_kernel(inline="always")
def collide_pair(state, i, j, nx, ny, physics):
    """Two balls in contact collide by the table's model."""
    impulse = collide_along_normal(state, i, j, nx, ny, physics[s.BALL_RESTITUTION])
    if physics[s.BALL_LAW] != contacts.NO_FRICTION:
        rub_in_contact(state, i, j, nx, ny, impulse, physics)


@inner_kernel
def end_chatter(state, pairs, i, j, nx, ny, now):
    """Count repeats of a contact, in planes MET and REPEATS of pairs; separate the balls if it chatters.

    Returns whether they are stuck: see `settling`.
    """
    count = pairs[s.REPEATS, i, j] + 1.0 if now - pairs[s.MET, i, j] < CHATTER_TIME else 0.0
    pairs[s.REPEATS, i, j] = count
    pairs[s.REPEATS, j, i] = count
    pairs[s.MET, i, j] = now
    pairs[s.MET, j, i] = now
    if count >= ALLOWED_REPEATS:
        separated = separate(state, i, j, nx, ny, least_separating_speed(int(count)))
        return count >= LAST_REPEATS and not separated
    return False
