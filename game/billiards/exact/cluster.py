"""Contacts of one moment, solved together.

Contacts whose gap is at most CONTACT_GAP at the moment of an impact belong to it: normal impulses by
`joint.solve_joint_impulses`, in rounds of what closes, then friction. One pair after another would leave a
symmetric break asymmetric by metres a second.

Friction of several contacts on one ball is shared out: in each of FRICTION_PASSES every contact gets 1/k of
what it still demands, k being the number of contacts of its busier ball. Each share alone would lower the
energy, and so does their mean, for energy is convex. Last, what closes because of the friction is solved
once more without.

All sums over contacts are of numbers on a common grid, so they are exact, and the numbering of the balls
leaves no trace: a mirror-symmetric break stays so to the last bit.
"""

from __future__ import annotations

import math

from game.billiards.laws import state as s
from game.billiards.laws.contacts import NO_FRICTION
from game.billiards.laws.contacts.ball_ball_friction import (
    friction_limit,
    slip_between,
    sticking_impulse,
    torque_direction,
)
from game.billiards.laws.contacts.ball_ball_normal import reach_of
from game.billiards.laws.joint import ContactGraph, solve_joint_impulses
from game.billiards.laws.lean import inner_kernel

FRICTION_PASSES = 8
SAME_MOMENT = 1e-9  # s; how far ahead a predicted contact is looked at as a candidate
NEW, WAITING, DONE = range(3)  # marks of balls while contacts are gathered


@inner_kernel(inline="always")
def has_company(pairs, i, j, now):
    """True if another contact of ball i or j might be of the same moment."""
    soon = now + SAME_MOMENT
    for k in range(pairs.shape[1]):
        if k != i and k != j:
            if pairs[s.MEET, i, k] <= soon or pairs[s.MEET, i, k] == s.AT_REST:
                return True
            if pairs[s.MEET, j, k] <= soon or pairs[s.MEET, j, k] == s.AT_REST:
                return True
    return False


@inner_kernel(inline="always")
def gap_at(state, i, j, now):
    """Gap of balls i and j at the time `now`, m, and the unit vector from i to j."""
    t = now - state[s.TIME, i]
    x = -(state[s.X, i] + t * (state[s.VX, i] + t * state[s.AX, i]))
    y = -(state[s.Y, i] + t * (state[s.VY, i] + t * state[s.AY, i]))
    t = now - state[s.TIME, j]
    x += state[s.X, j] + t * (state[s.VX, j] + t * state[s.AX, j])
    y += state[s.Y, j] + t * (state[s.VY, j] + t * state[s.AY, j])
    distance = math.sqrt(x * x + y * y)
    if distance == 0.0:
        return -reach_of(state[s.RADIUS, i], state[s.RADIUS, j]), 1.0, 0.0
    return distance - reach_of(state[s.RADIUS, i], state[s.RADIUS, j]), x / distance, y / distance


@inner_kernel
def gather_contacts(state, modes, pairs, i, j, now, ends, normals):
    """All contacts of this moment that hang together with the one of i and j, nearest first.

    Balls in the air are left out: each of their contacts is one of two, see `flight`.
    Writes ends, normals, and row MEMBER of modes: the balls, in the order found. Returns the numbers of
    contacts and of balls.
    """
    n = state.shape[1]
    for k in range(n):
        modes[s.MARK, k] = NEW
    modes[s.MEMBER, 0] = i
    modes[s.MEMBER, 1] = j
    modes[s.MARK, i] = WAITING
    modes[s.MARK, j] = WAITING
    found = 2
    count = 0
    soon = now + SAME_MOMENT
    head = 0
    while head < found:
        a = modes[s.MEMBER, head]
        modes[s.MARK, a] = DONE
        head += 1
        for k in range(n):
            struck = head == 1 and k == j
            near = struck or pairs[s.MEET, a, k] <= soon or pairs[s.MEET, a, k] == s.AT_REST
            if not near or modes[s.MARK, k] == DONE or modes[s.MOTION, k] == s.AIRBORNE:
                continue
            gap, nx, ny = gap_at(state, a, k, now)
            if gap > s.CONTACT_GAP and not struck:
                continue
            ends[s.FIRST, count] = a
            ends[s.SECOND, count] = k
            normals[count, 0] = nx
            normals[count, 1] = ny
            count += 1
            if modes[s.MARK, k] == NEW:
                modes[s.MARK, k] = WAITING
                modes[s.MEMBER, found] = k
                found += 1
    return count, found


@inner_kernel
def _demand_friction(state, count, ends, normals, forces, physics):
    """Tangential impulse that each contact demands in this pass, shared out. Returns the largest, N s."""
    largest = 0.0
    for m in range(count):
        forces[s.PX, m] = 0.0
        forces[s.PY, m] = 0.0
        forces[s.PZ, m] = 0.0
        if forces[s.IMPULSE, m] <= 0.0:
            continue
        i = ends[s.FIRST, m]
        j = ends[s.SECOND, m]
        cx, cy, cz, cosine = slip_between(state, i, j, normals[m, 0], normals[m, 1])
        slip = math.sqrt(cx * cx + cy * cy + cz * cz)
        if slip == 0.0:
            continue
        limit = friction_limit(slip, forces[s.IMPULSE, m], physics) / cosine
        demand = min(limit - forces[s.RUBBED, m], sticking_impulse(state, i, j, slip))
        demand /= max(state[s.VALENCE, i], state[s.VALENCE, j])
        if demand > 0.0:
            forces[s.PX, m] = -demand * cx / slip
            forces[s.PY, m] = -demand * cy / slip
            forces[s.PZ, m] = -demand * cz / slip
            forces[s.RUBBED, m] += demand
            largest = max(largest, demand)
    return largest


@inner_kernel
def _sum_friction(state, count, ends, normals, forces, grid):
    """Sum impulses and torques of each ball, on a grid: adding and subtracting `grid` rounds to it."""
    for m in range(count):
        if forces[s.IMPULSE, m] <= 0.0:
            continue
        i = ends[s.FIRST, m]
        j = ends[s.SECOND, m]
        px = (forces[s.PX, m] + grid) - grid
        py = (forces[s.PY, m] + grid) - grid
        turn_x, turn_y, turn_z = torque_direction(
            state, i, j, normals[m, 0], normals[m, 1], forces[s.PX, m], forces[s.PY, m], forces[s.PZ, m]
        )
        state[s.PUSH_X, i] += px
        state[s.PUSH_Y, i] += py
        state[s.PUSH_X, j] -= px
        state[s.PUSH_Y, j] -= py
        for side in range(2):
            ball = ends[side, m]
            state[s.TURN_X, ball] += (turn_x + grid) - grid
            state[s.TURN_Y, ball] += (turn_y + grid) - grid
            state[s.TURN_Z, ball] += (turn_z + grid) - grid


@inner_kernel
def _rub_jointly(state, modes, found, count, ends, normals, forces, physics):
    """Friction of all contacts that got an impulse."""
    for q in range(found):
        state[s.VALENCE, modes[s.MEMBER, q]] = 0.0
    for m in range(count):
        forces[s.RUBBED, m] = 0.0
        if forces[s.IMPULSE, m] > 0.0:
            state[s.VALENCE, ends[s.FIRST, m]] += 1.0
            state[s.VALENCE, ends[s.SECOND, m]] += 1.0
    for _ in range(FRICTION_PASSES):
        largest = _demand_friction(state, count, ends, normals, forces, physics)
        if largest == 0.0:
            return
        for q in range(found):
            for row in range(s.PUSH_X, s.VALENCE):
                state[row, modes[s.MEMBER, q]] = 0.0
        # the grid is 2^-40 of the largest; sums of 2^10 numbers on it are exact
        _sum_friction(state, count, ends, normals, forces, 1.5 * math.ldexp(1.0, math.frexp(largest)[1] + 12))
        for q in range(found):
            k = modes[s.MEMBER, q]
            lever = 2.5 * state[s.INVERSE_MASS, k] / state[s.RADIUS, k]
            state[s.VX, k] += state[s.PUSH_X, k] * state[s.INVERSE_MASS, k]
            state[s.VY, k] += state[s.PUSH_Y, k] * state[s.INVERSE_MASS, k]
            state[s.WX, k] += state[s.TURN_X, k] * lever
            state[s.WY, k] += state[s.TURN_Y, k] * lever
            state[s.WZ, k] += state[s.TURN_Z, k] * lever


@inner_kernel
def collide_jointly(state, modes, found, count, cluster, physics):
    """Solve `count` contacts of one moment between the first `found` balls of row MEMBER of modes.

    cluster: ends and normals come from `gather_contacts`; row IMPULSE of forces is written, the sum of each
    contact's normal impulses, N s; the rest is scratch.
    """
    ends, forces, normals, velocities, scratch = cluster
    graph = ContactGraph(ends[s.FIRST], ends[s.SECOND], normals)
    for m in range(count):
        forces[s.RESTITUTION, m] = physics[s.BALL_RESTITUTION]
        forces[s.IMPULSE, m] = 0.0
    for turn in range(2):
        for q in range(found):
            k = modes[s.MEMBER, q]
            velocities[k, 0] = state[s.VX, k]
            velocities[k, 1] = state[s.VY, k]
        solve_joint_impulses(
            count,
            graph,
            forces[s.RESTITUTION],
            state[s.INVERSE_MASS],
            velocities,
            forces[s.JOINT_IMPULSE],
            False,
            scratch,
        )
        for q in range(found):
            k = modes[s.MEMBER, q]
            state[s.VX, k] = velocities[k, 0]
            state[s.VY, k] = velocities[k, 1]
        for m in range(count):
            forces[s.IMPULSE, m] += forces[s.JOINT_IMPULSE, m]
        if turn == 1 or physics[s.BALL_LAW] == NO_FRICTION:
            return
        _rub_jointly(state, modes, found, count, ends, normals, forces, physics)
