"""Simultaneous frictionless impacts, solved jointly.

Newton's law u' >= -e u at every contact, impulses that only push, impulse or slack zero: one linear
complementarity problem for all contacts that close at once, instead of pair after pair in index order. So a
mirror-symmetric hit has a mirror-symmetric outcome, whatever the numbering of the balls: to the last bit,
because sums over the contacts of a ball do not depend on their order (see `solve_complementarity`).

Which contacts are involved is the caller's choice, and for Newton's cradle the two answers differ:

- ``join_resting=False``: only closing contacts; what closes because of their impulses comes next, as a new
  round, until nothing closes (generalised reflections; Smith, Kaufman, Vouga, Tamstorf, Grinspun 2012,
  "Reflections on Simultaneous Impact"). A cradle's last ball leaves with v and the others rest: what is
  seen on real cradles and racks. One ball onto two: both contacts close at once, (-1/5, 2 sqrt(3)/5).
- ``join_resting=True``: contacts that neither close nor open are involved too (Newton's law imposed on all
  contacts at once; Moreau 1988). Three balls of a cradle leave with (-1/3, 2/3, 2/3).

A contact with e = 0 is involved as soon as there is no gap, in either case: without rebound nothing would
come after.

Both conserve momentum, and neither ever raises the energy: only closing or resting contacts are involved in a
round, so every impulse J adds (1/2) J (u' + u) = -(1/2) J (1 - e) |u| <= 0, also where e differs from
contact to contact.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel

SPARE_ROUNDS = 16  # impacts within one instant beyond two per contact; then all contacts stop closing at once
MAX_ITERATIONS = 3_000  # a tight rack needs 250, a ball 10,000 times lighter than its two neighbours 2,500
CLOSING = 1e-13  # of the fastest closing speed; slower ones count as resting
SETTLED = 2.0**-51  # a change of impulse that is rounding only, relative to the largest demand

# columns of the scratch array of balls
_COARSE_X, _FINE_X, _COARSE_Y, _FINE_Y, _VALENCE = 0, 1, 2, 3, 4
# columns of the scratch array of contacts; the first three are for callers
DEMAND, STEP, SPEED, _NOW, _BEFORE, _AHEAD, _SLOPE = 0, 1, 2, 3, 4, 5, 6
CONTACT_COLUMNS, BALL_COLUMNS = 7, 5


class ContactGraph(NamedTuple):
    """Which balls are in contact: first, second (m,) int, second -1 (or less) is a wall; normals (m, 2).

    A normal is a unit vector from the first to the second (into the wall).
    """

    first: NDArray[np.int64]
    second: NDArray[np.int64]
    normals: NDArray[np.float64]


class JointScratch(NamedTuple):
    """Scratch arrays: contacts (m, CONTACT_COLUMNS), balls (n, BALL_COLUMNS)."""

    contacts: NDArray[np.float64]
    balls: NDArray[np.float64]


def joint_scratch(balls: int, contacts: int) -> JointScratch:
    """Scratch arrays for up to so many balls and contacts. ValueError if a number is negative."""
    if balls < 0 or contacts < 0:
        raise ValueError(
            f"joint scratch: numbers must not be negative, got {balls!r} balls, {contacts!r} contacts"
        )
    return JointScratch(np.zeros((contacts, CONTACT_COLUMNS)), np.zeros((balls, BALL_COLUMNS)))


@kernel
def _sum_impulses(count, graph, inverse_masses, scratch, ahead):
    """Change of velocity of each ball by the impulses (_AHEAD or _NOW), to `balls`; order-free.

    Each addend is split into a coarse and a fine part. The coarse one is a multiple of 2^-32 of a power of
    two above all of them, the fine one, a multiple of 2^-80: sums of either are exact, so any order gives the
    same bits (two-fold reproducible summation; Demmel and Nguyen 2015).
    """
    first, second, normals = graph
    contacts, balls = scratch
    column = _AHEAD if ahead else _NOW
    largest = 0.0
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            for side in range(2):
                ball = first[i] if side == 0 else second[i]
                if ball >= 0:
                    largest = max(largest, abs(contacts[i, column]) * inverse_masses[ball])
                    balls[ball, :_VALENCE] = 0.0
    unit = math.ldexp(1.0, math.frexp(largest)[1]) if largest < 1e300 else 0.0
    coarse = 1.5 * unit * 2.0**20  # adding and subtracting it rounds to its last place, unit * 2^-32
    fine = 1.5 * unit * 2.0**-28
    for i in range(count):
        if contacts[i, STEP] > 0.0:
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
def _share_out(count, graph, inverse_masses, scratch):
    """Step length of each contact by mass splitting (Tonge, Benevolenski, Voroshilov 2012); True if coupled.

    A ball of k contacts is shared out among them, k times as light; the steps then never overshoot jointly.
    Contacts with nothing to move get step 0 and are left out.
    """
    first, second, _ = graph
    contacts, balls = scratch
    for i in range(count):
        balls[first[i], _VALENCE] = 0.0
        if second[i] >= 0:
            balls[second[i], _VALENCE] = 0.0
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            balls[first[i], _VALENCE] += 1.0
            if second[i] >= 0:
                balls[second[i], _VALENCE] += 1.0
    coupled = False
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            shared = 0.0
            for side in range(2):
                ball = first[i] if side == 0 else second[i]
                if ball >= 0 and inverse_masses[ball] > 0.0:
                    shared += inverse_masses[ball] * balls[ball, _VALENCE]
                    coupled = coupled or balls[ball, _VALENCE] > 1.0
            contacts[i, STEP] = 1.0 / shared if shared > 0.0 else 0.0
    return coupled


@kernel
def _descend(count, graph, scratch):
    """One projected step from the column _AHEAD to _NOW (the old one to _BEFORE).

    Returns how far the step still went (m/s), and the largest speed it handled (m/s).
    """
    first, second, normals = graph
    contacts, balls = scratch
    moved = 0.0
    scale = 0.0
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            a = first[i]
            b = second[i]
            vx = balls[a, _COARSE_X] + balls[a, _FINE_X]
            vy = balls[a, _COARSE_Y] + balls[a, _FINE_Y]
            if b >= 0:
                vx -= balls[b, _COARSE_X] + balls[b, _FINE_X]
                vy -= balls[b, _COARSE_Y] + balls[b, _FINE_Y]
            change = vx * normals[i, 0] + vy * normals[i, 1]
            ahead = contacts[i, _AHEAD]
            target = max(0.0, ahead + contacts[i, STEP] * (contacts[i, DEMAND] + change))
            contacts[i, _BEFORE] = contacts[i, _NOW]
            contacts[i, _NOW] = target
            moved = max(moved, abs(target - ahead) / contacts[i, STEP])
            scale = max(scale, abs(contacts[i, DEMAND]), abs(change))
    return moved, scale


@kernel
def _turns_back(count, contacts):
    """True if the last step went against the momentum (restart test of O'Donoghue and Candes 2015)."""
    largest = 0.0
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            onward = contacts[i, _NOW] - contacts[i, _BEFORE]
            contacts[i, _SLOPE] = (contacts[i, _AHEAD] - contacts[i, _NOW]) * onward / contacts[i, STEP]
            largest = max(largest, abs(contacts[i, _SLOPE]))
    rounding = 1.5 * math.ldexp(1.0, math.frexp(largest)[1]) * 2.0**20 if largest < 1e300 else 0.0
    uphill = 0.0
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            uphill += (contacts[i, _SLOPE] + rounding) - rounding
    return uphill > 0.0


@kernel
def solve_complementarity(count, graph, inverse_masses, targets, impulses, scratch, max_iterations):
    """Least impulses J >= 0 that meet each contact's demand: A J >= d, J . (A J - d) = 0; and apply them.

    Of the scratch contacts[:, DEMAND] d and contacts[:, STEP] > 0 for those involved are read. targets (n, 2
    or more): velocities, if a demand is a change of closing speed (m/s), or positions, if it is a distance by
    which to separate what overlaps (m). Columns 0 and 1 are changed. impulses (m,): added to. Accelerated
    projected gradient (Nesterov 1983; Mazhar, Heyn, Negrut, Tasora 2015) whose every sum and test is
    independent of the order of the contacts. Contradictory demands (a ball between walls too narrow for it)
    end as a compromise after `max_iterations`. Returns iterations.
    """
    first, second, _ = graph
    contacts, balls = scratch
    coupled = _share_out(count, graph, inverse_masses, scratch)
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            contacts[i, _BEFORE] = 0.0
            contacts[i, _NOW] = max(0.0, contacts[i, DEMAND] * contacts[i, STEP])
            contacts[i, _AHEAD] = contacts[i, _NOW]
    iterations = 1
    momentum = 1.0
    while coupled and iterations < max_iterations:
        _sum_impulses(count, graph, inverse_masses, scratch, np.bool_(True))
        moved, scale = _descend(count, graph, scratch)
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
            if contacts[i, STEP] > 0.0:
                contacts[i, _AHEAD] = contacts[i, _NOW] + gain * (contacts[i, _NOW] - contacts[i, _BEFORE])
    _sum_impulses(count, graph, inverse_masses, scratch, np.bool_(False))
    for i in range(count):
        if contacts[i, STEP] > 0.0:
            impulses[i] += contacts[i, _NOW]
            for side in range(2):
                ball = first[i] if side == 0 else second[i]
                if ball >= 0:  # a ball of several contacts gets its sum once
                    targets[ball, 0] += balls[ball, _COARSE_X] + balls[ball, _FINE_X]
                    targets[ball, 1] += balls[ball, _COARSE_Y] + balls[ball, _FINE_Y]
                    balls[ball, :_VALENCE] = 0.0
    return iterations


@kernel
def _measure_closing(count, graph, velocities, contacts):
    """Write the speed at which each contact closes, m/s, to DEMAND; returns the fastest of either sign."""
    first, second, normals = graph
    fastest = 0.0
    for i in range(count):
        vx = velocities[first[i], 0]
        vy = velocities[first[i], 1]
        if second[i] >= 0:
            vx -= velocities[second[i], 0]
            vy -= velocities[second[i], 1]
        contacts[i, DEMAND] = vx * normals[i, 0] + vy * normals[i, 1]
        fastest = max(fastest, abs(contacts[i, DEMAND]))
    return fastest


@kernel
def solve_joint_impulses(
    count, graph, restitutions, inverse_masses, velocities, impulses, join_resting, scratch
):
    """Resolve `count` simultaneous impacts, in rounds, until no contact closes; returns the rounds.

    A normal (0, 0) leaves a contact out. restitutions (m,): 0 to 1. inverse_masses (n,) 1/kg, 0 does not
    yield. velocities (n, 2 or more) m/s: columns 0 and 1 are changed. impulses (m,) N s: total of each
    contact, written. join_resting: bool, see the module. scratch: `joint_scratch`; its contacts[:, SPEED] is
    left with the closing speeds before the first round, m/s.

    If impacts go on without end (e < 1 between balls in contact), the last of 2 m + SPARE_ROUNDS rounds lets
    every contact stop closing without rebound. That too conserves momentum and cannot raise the energy.
    """
    contacts = scratch.contacts
    limit = 2 * count + SPARE_ROUNDS
    for rounds in range(limit):
        fastest = _measure_closing(count, graph, velocities, contacts)
        closing = 0
        for i in range(count):
            speed = contacts[i, DEMAND]
            if rounds == 0:
                impulses[i] = 0.0
                contacts[i, SPEED] = speed
            contacts[i, STEP] = 0.0
            if speed > CLOSING * fastest:
                closing += 1
                contacts[i, STEP] = 1.0
                contacts[i, DEMAND] = (1.0 + restitutions[i]) * speed
            elif (join_resting or restitutions[i] == 0.0) and speed >= -CLOSING * fastest:
                contacts[i, STEP] = 1.0
            if rounds == limit - 1:
                contacts[i, STEP] = 1.0
                contacts[i, DEMAND] = speed
        if closing == 0:
            return rounds
        solve_complementarity(
            count,
            graph,
            inverse_masses,
            velocities,
            impulses,
            scratch,
            np.int64(MAX_ITERATIONS),  # a bare number would be compiled in, and the kernel twice
        )
    return limit
