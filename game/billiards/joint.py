"""Simultaneous frictionless impacts, solved jointly.

Newton's law u' >= -e u at every contact, impulses that only push, impulse or slack zero: one linear
complementarity problem for all contacts that close at once, instead of pair after pair in index order. So a
mirror-symmetric hit has a mirror-symmetric outcome, whatever the numbering of the balls: to the last bit,
because sums over the contacts of a ball do not depend on their order (see `solve_complementarity`).

Which contacts take part is the caller's choice, and for Newton's cradle the two answers differ:

- ``join_resting=False``: only closing contacts; what closes because of their impulses comes next, as a new
  round, until nothing closes (generalised reflections; Smith, Kaufman, Vouga, Tamstorf, Grinspun 2012,
  "Reflections on Simultaneous Impact"). A cradle's last ball leaves with v and the others rest: what is
  seen on real cradles and racks. One ball onto two: both contacts close at once, (-1/5, 2 sqrt(3)/5).
- ``join_resting=True``: contacts that touch without closing take part too (Newton's law imposed on all
  contacts at once; Moreau 1988). Three balls of a cradle leave with (-1/3, 2/3, 2/3).

A contact with e = 0 takes part as soon as it touches, either way: without rebound nothing would come after.

Both conserve momentum, and neither ever raises the energy: only closing or resting contacts take part in a
round, so every impulse J adds (1/2) J (u' + u) = -(1/2) J (1 - e) |u| <= 0, also where e differs from
contact to contact.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.jit import kernel

SPARE_ROUNDS = 16  # impacts within one instant beyond two per contact; then all contacts stop closing at once
MAX_ITERATIONS = 3_000  # a touching rack needs 250, a ball 10,000 times lighter than its two neighbours 2,500
CLOSING = 1e-13  # of the fastest closing speed; slower ones count as resting
SETTLED = 2.0**-51  # a change of impulse that is rounding only, relative to the largest demand

# columns of the scratch array of balls
_COARSE_X, _FINE_X, _COARSE_Y, _FINE_Y, _VALENCE = 0, 1, 2, 3, 4
# columns of the scratch array of contacts
_DEMAND, _STEP, _NOW, _BEFORE, _AHEAD, _SLOPE = 0, 1, 2, 3, 4, 5


class JointScratch(NamedTuple):
    """Room to work in: balls (n, 5), contacts (m, 6)."""

    balls: NDArray[np.float64]
    contacts: NDArray[np.float64]


def joint_scratch(balls: int, contacts: int) -> JointScratch:
    """Scratch arrays for up to so many balls and contacts. ValueError if a number is negative."""
    if balls < 0 or contacts < 0:
        raise ValueError(
            f"joint scratch: numbers must not be negative, got {balls!r} balls, {contacts!r} contacts"
        )
    return JointScratch(np.zeros((balls, 5)), np.zeros((contacts, 6)))


@kernel
def closing_speed(i, first, second, normals, velocities):
    """Speed at which contact i closes, m/s; negative where it opens."""
    a = first[i]
    b = second[i]
    if b < 0:
        return velocities[a, 0] * normals[i, 0] + velocities[a, 1] * normals[i, 1]
    dvx = velocities[a, 0] - velocities[b, 0]
    dvy = velocities[a, 1] - velocities[b, 1]
    return dvx * normals[i, 0] + dvy * normals[i, 1]


@kernel
def _power_above(magnitude):
    """Power of two above a positive magnitude; 0 for 0, and for what is not finite."""
    if not (magnitude > 0.0 and magnitude < 1e300):
        return 0.0
    return math.ldexp(1.0, math.frexp(magnitude)[1])


@kernel
def _sum_impulses(count, first, second, normals, inverse_masses, column, contacts, balls):
    """Change of velocity of each ball by the impulses in a column, to `balls`; order-free.

    Each addend is split into a coarse part, a multiple of 2^-32 of a power of two above all of them, and a
    fine part, a multiple of 2^-80: sums of either are exact, so any order gives the same bits (two-fold
    reproducible summation; Demmel and Nguyen 2015).
    """
    largest = 0.0
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            mass = inverse_masses[first[i]]
            if second[i] >= 0:
                mass = max(mass, inverse_masses[second[i]])
            largest = max(largest, abs(contacts[i, column]) * mass)
            balls[first[i], _COARSE_X:_VALENCE] = 0.0
            if second[i] >= 0:
                balls[second[i], _COARSE_X:_VALENCE] = 0.0
    unit = _power_above(largest)
    coarse = 1.5 * unit * 2.0**20  # adding and subtracting it rounds to its last place, unit * 2^-32
    fine = 1.5 * unit * 2.0**-28
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            for side in range(2):
                ball = first[i] if side == 0 else second[i]
                if ball >= 0 and inverse_masses[ball] > 0.0:
                    sign = -1.0 if side == 0 else 1.0
                    size = sign * contacts[i, column] * inverse_masses[ball]
                    for axis in range(2):
                        addend = size * normals[i, axis]
                        high = (addend + coarse) - coarse
                        low = ((addend - high) + fine) - fine
                        balls[ball, 2 * axis] += high
                        balls[ball, 2 * axis + 1] += low


@kernel
def _steepness(count, first, second, inverse_masses, contacts, balls):
    """Step length of each contact by mass splitting (Tonge, Benevolenski, Voroshilov 2012); True if coupled.

    A ball of k contacts is shared out among them, k times as light; the steps then never overshoot jointly.
    Contacts with nothing to move, or nothing demanded (step 0), take no part.
    """
    for i in range(count):
        balls[first[i], _VALENCE] = 0.0
        if second[i] >= 0:
            balls[second[i], _VALENCE] = 0.0
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            balls[first[i], _VALENCE] += 1.0
            if second[i] >= 0:
                balls[second[i], _VALENCE] += 1.0
    coupled = False
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            a = first[i]
            b = second[i]
            shared = inverse_masses[a] * balls[a, _VALENCE]
            coupled = coupled or (balls[a, _VALENCE] > 1.0 and inverse_masses[a] > 0.0)
            if b >= 0:
                shared += inverse_masses[b] * balls[b, _VALENCE]
                coupled = coupled or (balls[b, _VALENCE] > 1.0 and inverse_masses[b] > 0.0)
            contacts[i, _STEP] = 1.0 / shared if shared > 0.0 else 0.0
    return coupled


@kernel
def _closing_change(i, first, second, normals, balls):
    """How much the summed impulses change the closing speed of contact i, m/s."""
    a = first[i]
    b = second[i]
    dvx = balls[a, _COARSE_X] + balls[a, _FINE_X]
    dvy = balls[a, _COARSE_Y] + balls[a, _FINE_Y]
    if b >= 0:
        dvx -= balls[b, _COARSE_X] + balls[b, _FINE_X]
        dvy -= balls[b, _COARSE_Y] + balls[b, _FINE_Y]
    return dvx * normals[i, 0] + dvy * normals[i, 1]


@kernel
def _descend(count, first, second, normals, contacts, balls):
    """One projected step from the column _AHEAD to _NOW (the old one to _BEFORE).

    Returns how far the step still went (m/s), and the largest speed it handled (m/s).
    """
    moved = 0.0
    scale = 0.0
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            change = _closing_change(i, first, second, normals, balls)
            ahead = contacts[i, _AHEAD]
            wanted = max(0.0, ahead + contacts[i, _STEP] * (contacts[i, _DEMAND] + change))
            contacts[i, _BEFORE] = contacts[i, _NOW]
            contacts[i, _NOW] = wanted
            moved = max(moved, abs(wanted - ahead) / contacts[i, _STEP])
            scale = max(scale, abs(contacts[i, _DEMAND]), abs(change))
    return moved, scale


@kernel
def _turns_back(count, contacts):
    """True if the last step went against the momentum (restart test of O'Donoghue and Candes 2015)."""
    largest = 0.0
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            onward = contacts[i, _NOW] - contacts[i, _BEFORE]
            contacts[i, _SLOPE] = (contacts[i, _AHEAD] - contacts[i, _NOW]) * onward / contacts[i, _STEP]
            largest = max(largest, abs(contacts[i, _SLOPE]))
    rounding = 1.5 * _power_above(largest) * 2.0**20
    uphill = 0.0
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            uphill += (contacts[i, _SLOPE] + rounding) - rounding
    return uphill > 0.0


@kernel
def solve_complementarity(count, first, second, normals, inverse_masses, contacts, balls, max_iterations):
    """Least impulses J >= 0 that meet each contact's demand: A J >= d, J . (A J - d) = 0.

    contacts[:, _DEMAND] d and contacts[:, _STEP] > 0 for those that take part are read; contacts[:, _NOW]
    and the sums of the balls are written. A demand is a change of closing speed (m/s), or, to part balls
    that overlap, a distance (m). Accelerated projected gradient (Nesterov 1983; Mazhar, Heyn, Negrut,
    Tasora 2015) whose every sum and test is independent of the order of the contacts. Contradictory demands
    (a ball between walls too narrow for it) end as a compromise after `max_iterations`. Returns iterations.
    """
    coupled = _steepness(count, first, second, inverse_masses, contacts, balls)
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            contacts[i, _BEFORE] = 0.0
            contacts[i, _NOW] = max(0.0, contacts[i, _DEMAND] * contacts[i, _STEP])
            contacts[i, _AHEAD] = contacts[i, _NOW]
    iterations = 1
    momentum = 1.0
    while coupled and iterations < max_iterations:
        _sum_impulses(count, first, second, normals, inverse_masses, _AHEAD, contacts, balls)
        moved, scale = _descend(count, first, second, normals, contacts, balls)
        iterations += 1
        if not (moved > SETTLED * scale):
            break
        following = 0.5 * (1.0 + math.sqrt(1.0 + 4.0 * momentum * momentum))
        gain = (momentum - 1.0) / following
        momentum = following
        if _turns_back(count, contacts):
            momentum = 1.0
            gain = 0.0
        for i in range(count):
            if contacts[i, _STEP] > 0.0:
                contacts[i, _AHEAD] = contacts[i, _NOW] + gain * (contacts[i, _NOW] - contacts[i, _BEFORE])
    _sum_impulses(count, first, second, normals, inverse_masses, _NOW, contacts, balls)
    return iterations


@kernel
def _choose_contacts(count, first, second, normals, restitutions, velocities, join_resting, contacts):
    """Set demand and participation for one round; returns the number of contacts that close."""
    fastest = 0.0
    for i in range(count):
        speed = closing_speed(i, first, second, normals, velocities)
        contacts[i, _DEMAND] = speed
        fastest = max(fastest, abs(speed))
    threshold = CLOSING * fastest
    closing = 0
    for i in range(count):
        speed = contacts[i, _DEMAND]
        contacts[i, _STEP] = 0.0
        if speed > threshold:
            closing += 1
            contacts[i, _STEP] = 1.0
            contacts[i, _DEMAND] = (1.0 + restitutions[i]) * speed
        elif (join_resting or restitutions[i] == 0.0) and speed >= -threshold:
            contacts[i, _STEP] = 1.0
    return closing


@kernel
def _apply_impulses(count, first, second, inverse_masses, contacts, balls, velocities, impulses):
    """Add the round's impulses to the totals, and their sums to the velocities of the balls, once each."""
    for i in range(count):
        if contacts[i, _STEP] > 0.0:
            impulses[i] += contacts[i, _NOW]
            for side in range(2):
                ball = first[i] if side == 0 else second[i]
                if ball >= 0:
                    velocities[ball, 0] += balls[ball, _COARSE_X] + balls[ball, _FINE_X]
                    velocities[ball, 1] += balls[ball, _COARSE_Y] + balls[ball, _FINE_Y]
                    balls[ball, _COARSE_X:_VALENCE] = 0.0


@kernel
def solve_joint_impulses(
    count,
    first,
    second,
    normals,
    restitutions,
    inverse_masses,
    velocities,
    impulses,
    join_resting,
    contacts,
    balls,
):
    """Resolve `count` simultaneous impacts, in rounds, until no contact closes; returns the rounds.

    first, second (m,) int: balls of each contact; second -1 is a wall. normals (m, 2): unit, from first to
    second (into the wall). restitutions (m,): 0 to 1. inverse_masses (n,) 1/kg, 0 does not yield.
    velocities (n, 2 or more) m/s: columns 0 and 1 are changed. impulses (m,) N s: total of each contact,
    written. join_resting: see the module. contacts, balls: `joint_scratch`.

    If impacts go on without end (e < 1 between touching balls), the last of 2 m + SPARE_ROUNDS rounds lets
    every contact stop closing without rebound; that too conserves momentum and cannot raise the energy.
    """
    impulses[:count] = 0.0
    limit = 2 * count + SPARE_ROUNDS
    for rounds in range(limit):
        closing = _choose_contacts(
            count, first, second, normals, restitutions, velocities, join_resting, contacts
        )
        if closing == 0:
            return rounds
        if rounds == limit - 1:
            for i in range(count):
                contacts[i, _STEP] = 1.0
                contacts[i, _DEMAND] = closing_speed(i, first, second, normals, velocities)
        solve_complementarity(count, first, second, normals, inverse_masses, contacts, balls, MAX_ITERATIONS)
        _apply_impulses(count, first, second, inverse_masses, contacts, balls, velocities, impulses)
    return limit
