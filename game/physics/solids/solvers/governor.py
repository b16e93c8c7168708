"""A step is passive: the energy of what has no source does not rise in it.

Two things could raise the energy of motion and of height. Overlap that is driven apart lifts what lies on it.
Friction, bounces and sweeps that are cut short leave a little more motion than there was. The springs of soft
contacts hold what sinking has paid into them: of what a step loses, each takes in no more than its energy k
s²/2 at overlap s, and gives it back for lifting only. Where energy has risen beyond that, each group of
bodies that touch takes back its lifting by overlap. Then it is lowered by a little, then slowed down:
velocities shrink against those of the group as one rigid body, or against rest where it touches what is
fixed. To scale all of them alike keeps momentum, and keeps every contact: a speed of closing that is 0 stays
0.

Not held are groups that have a source: joints, key-framed bodies that move, wind, and pairs that overlap by
no motion of their own (marked GIVEN): born so, or put so. Those part as fast as they are told.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import state
from game.physics.solids.islands import root_of, unite
from game.physics.solids.rows import FIRST, SECOND
from game.physics.solids.solvers.motion import cosine_sine
from game.physics.solids.solvers.passive import EXCUSED
from game.physics.solids.solvers.springs import STORED, measure_springs

NEXT_TO_NOTHING = 1e-6  # of the energy m (h g)²/2 that gravity gives in a substep: below that it is rounding
LOWERED = 0.02  # of the slop: how far a group is lowered at most, before it is slowed down
GAIN, LIFT, HEIGHT, FORCE, NOISE, MOTION = range(6)  # columns of Scratch.works, J; N; then STORED
# columns of Scratch.drifts: kg, kg m, kg m, N s, N s, N m s, kg m², and whether it touches what is fixed
MASS, CENTRE_X, CENTRE_Y, PUSH_X, PUSH_Y, TURN, INERTIA, HELD = range(8)


@inner_kernel
def start_going(going):
    """Nothing has gone anywhere yet."""
    going[:] = 0.0


@inner_kernel
def note_going(motion, going):
    """Add the velocities that bodies go on with when overlap has been driven apart."""
    for i in range(motion.shape[0]):
        going[i, 0] += motion[i, state.VX]
        going[i, 1] += motion[i, state.VY]
        going[i, 2] += motion[i, state.W]


@inner_kernel
def pushed(scratch, h, i):
    """What overlap alone has moved body i since the step began: the way less that of its own velocities."""
    motion, going = scratch.motion, scratch.going
    return (
        motion[i, state.DX] - h * going[i, 0],
        motion[i, state.DY] - h * going[i, 1],
        motion[i, state.DA] - h * going[i, 2],
    )


@inner_kernel
def mass_of(bodies, i):
    """Mass (kg) and inertia (kg m²) of a dynamic body."""
    return 1.0 / bodies.inverse_masses[i], 1.0 / bodies.inverse_inertias[i]


@inner_kernel
def raised(bodies, pulls, i, x, y, turn):
    """Work against the forces on body i of moving it by x, y (m) and turning it (rad), J."""
    m, inertia = mass_of(bodies, i)
    return -m * (pulls[i, 0] * x + pulls[i, 1] * y) - inertia * pulls[i, 2] * turn


@inner_kernel
def gain_of(bodies, scratch, i):
    """By how much a body's energy of motion has risen in the step beyond the work of its forces, J."""
    motion = scratch.motion
    m, inertia = mass_of(bodies, i)
    x, y, w = bodies.velocities[i, 0], bodies.velocities[i, 1], bodies.spins[i]
    motions = (motion[i, state.VX] - x) * (motion[i, state.VX] + x) + (motion[i, state.VY] - y) * (
        motion[i, state.VY] + y
    )
    turns = (motion[i, state.W] - w) * (motion[i, state.W] + w)
    height = raised(
        bodies, scratch.accelerations, i, motion[i, state.DX], motion[i, state.DY], motion[i, state.DA]
    )
    return 0.5 * (m * motions + inertia * turns) + height


@inner_kernel
def noise_of(bodies, scratch, h, i):
    """What is no rise, J."""
    m, x, y = 1.0 / bodies.inverse_masses[i], scratch.accelerations[i, 0], scratch.accelerations[i, 1]
    return NEXT_TO_NOTHING * 0.5 * m * h * h * (x * x + y * y)


@inner_kernel
def pull_of(scratch, i):
    """Size of what forces accelerate a body by, m/s²."""
    x, y = scratch.accelerations[i, 0], scratch.accelerations[i, 1]
    return math.sqrt(x * x + y * y)


@inner_kernel
def rise(bodies, scratch, h):
    """By how much the energy of all bodies has risen, and what is rounding of that, J."""
    total, noise = 0.0, 0.0
    for i in range(scratch.motion.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            total += gain_of(bodies, scratch, i)
            noise += noise_of(bodies, scratch, h, i)
    return total, noise


@inner_kernel
def group_by_contact(bodies, contacts, scratch):
    """Representatives of bodies that touched in this step; drifts tell which touch what is fixed.

    Groups with a source are marked as excused.
    """
    parents, drifts, excused, batches = scratch.parents, scratch.drifts, scratch.excused, scratch.batches
    drifts[:] = 0.0
    for i in range(parents.shape[0]):
        parents[i] = i
    for k in range(batches.count[0]):
        for lane in range(batches.filled[k]):
            a, b, pair = (
                batches.ends[k, state.END_A, lane],
                batches.ends[k, state.END_B, lane],
                batches.pairs[k, lane],
            )
            # of a second point that there is not, the gap is 0
            deepest = min(
                batches.values[k, FIRST + state.SEP, lane], batches.values[k, SECOND + state.SEP, lane]
            )
            if not (contacts.marks[pair, state.TOUCHING] or deepest < 0.0):
                continue
            moves_a, moves_b = bodies.inverse_masses[a] > 0.0, bodies.inverse_masses[b] > 0.0
            if moves_a and moves_b:
                unite(parents, a, b)
            else:
                drifts[a if moves_a else b, HELD] = 1.0
            if contacts.marks[pair, state.GIVEN]:
                excused[a], excused[b] = EXCUSED, EXCUSED
    for i in range(parents.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            r = root_of(parents, i)
            drifts[r, HELD] = max(drifts[r, HELD], drifts[i, HELD])
            if scratch.air[i, 0] != 0.0 or scratch.air[i, 1] != 0.0:
                excused[i] |= EXCUSED
            excused[r] |= (excused[i] & EXCUSED) << 2


@inner_kernel
def drift_of(drifts, r):
    """Velocity (m/s), centre (m) and spin (rad/s) of a group as one rigid body; 0 of one that is held."""
    if drifts[r, HELD] > 0.0:
        return 0.0, 0.0, 0.0, 0.0, 0.0
    x, y = drifts[r, CENTRE_X] / drifts[r, MASS], drifts[r, CENTRE_Y] / drifts[r, MASS]
    vx, vy = drifts[r, PUSH_X] / drifts[r, MASS], drifts[r, PUSH_Y] / drifts[r, MASS]
    turn = drifts[r, TURN] - (x * drifts[r, PUSH_Y] - y * drifts[r, PUSH_X])
    inertia = drifts[r, INERTIA] - drifts[r, MASS] * (x * x + y * y)
    return vx, vy, x, y, turn / inertia


@inner_kernel
def along(bodies, drifts, r, i):
    """Velocity and spin that body i has as a part of group r as one rigid body."""
    vx, vy, x, y, w = drift_of(drifts, r)
    return vx - w * (bodies.positions[i, 1] - y), vy + w * (bodies.positions[i, 0] - x), w


@inner_kernel
def sum_groups(bodies, scratch, h):
    """Fill works and drifts of the groups."""
    motion, pulls = scratch.motion, scratch.accelerations
    works, drifts, parents = scratch.works, scratch.drifts, scratch.parents
    works[:] = 0.0
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] == 0.0:
            continue
        r = root_of(parents, i)
        m, inertia = mass_of(bodies, i)
        works[r, GAIN] += gain_of(bodies, scratch, i)
        works[r, NOISE] += noise_of(bodies, scratch, h, i)
        x, y, turn = pushed(scratch, h, i)
        works[r, LIFT] += raised(bodies, pulls, i, x, y, turn)
        works[r, STORED] += bodies.stored[i]
        works[r, FORCE] += m * pull_of(scratch, i)
        works[r, HEIGHT] += raised(
            bodies, pulls, i, motion[i, state.DX], motion[i, state.DY], motion[i, state.DA]
        )
        x, y = bodies.positions[i, 0], bodies.positions[i, 1]
        px, py = m * motion[i, state.VX], m * motion[i, state.VY]
        drifts[r, MASS] += m
        drifts[r, CENTRE_X] += m * x
        drifts[r, CENTRE_Y] += m * y
        drifts[r, PUSH_X] += px
        drifts[r, PUSH_Y] += py
        drifts[r, TURN] += x * py - y * px + inertia * motion[i, state.W]
        drifts[r, INERTIA] += m * (x * x + y * y) + inertia
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            r = root_of(parents, i)
            m, inertia = mass_of(bodies, i)
            vx, vy, w = along(bodies, drifts, r, i)
            vx, vy, w = motion[i, state.VX] - vx, motion[i, state.VY] - vy, motion[i, state.W] - w
            works[r, MOTION] += 0.5 * (m * (vx * vx + vy * vy) + inertia * w * w)


@inner_kernel
def what_to_take_back(works, r, most):
    """What makes a group passive: the part of its lifting that is taken back; how far it is lowered (m, at
    most ``most``). The factors of its motion, and, where even that is not enough, of its ways.
    """
    gain, lift, motion = works[r, GAIN], works[r, LIFT], works[r, MOTION]
    back = min(1.0, gain / lift) if lift > 0.0 else 0.0
    gain -= back * lift
    height, force = works[r, HEIGHT] - back * lift, works[r, FORCE]
    down = max(0.0, min(gain, height, most * force)) / force if force > 0.0 else 0.0
    gain -= down * force
    height -= down * force
    keep = math.sqrt(max(0.0, 1.0 - gain / motion)) if gain > 0.0 and motion > 0.0 else 1.0
    gain -= motion
    stay = max(0.0, 1.0 - gain / height) if gain > 0.0 and height > 0.0 else 1.0
    return back, down, keep, stay


@inner_kernel
def give_back(bodies, scratch):
    """Springs pay for what they lift, as far as they can and as far as motion lost has not paid for it."""
    works, parents, stored = scratch.works, scratch.parents, bodies.stored
    for r in range(stored.shape[0]):
        paid = min(works[r, STORED], works[r, HEIGHT], works[r, GAIN])
        if parents[r] != r or paid <= 0.0 or scratch.excused[r] >> 2:
            works[r, STORED] = 1.0
            continue
        works[r, GAIN] -= paid
        works[r, LIFT] -= paid
        works[r, HEIGHT] -= paid
        works[r, STORED] = 1.0 - paid / works[r, STORED]  # from here on: the part that is left
    for i in range(stored.shape[0]):
        stored[i] *= works[root_of(parents, i), STORED]


@inner_kernel
def weigh_sleepers(bodies, scratch, numbers):
    """Gravity of what slept when the step began: not that has moved it, but what touched it."""
    for i in range(bodies.flags.shape[0]):
        if bodies.flags[i] & state.DYNAMIC and scratch.air[i, 2] == 0.0:
            scratch.accelerations[i, 0] = bodies.gravity_scales[i] * numbers.gravity_x
            scratch.accelerations[i, 1] = bodies.gravity_scales[i] * numbers.gravity_y


@inner_kernel
def hold_step(bodies, contacts, scratch, numbers):
    """Take back what the energy of groups that have no source has risen in this step.

    Contacts are read in their batches.
    """
    weigh_sleepers(bodies, scratch, numbers)
    risen, noise = rise(bodies, scratch, numbers.h)
    if abs(risen) <= noise:
        return
    room = measure_springs(bodies, scratch, numbers)
    if risen < 0.0:
        part = min(1.0, -risen / room) if room > 0.0 else 0.0
        for i in range(bodies.stored.shape[0]):
            bodies.stored[i] += part * scratch.works[i, STORED]
        return
    motion, works, parents = scratch.motion, scratch.works, scratch.parents
    group_by_contact(bodies, contacts, scratch)
    sum_groups(bodies, scratch, numbers.h)
    give_back(bodies, scratch)
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] == 0.0:
            continue
        r = root_of(parents, i)
        if works[r, GAIN] <= works[r, NOISE] or scratch.excused[r] >> 2:
            continue
        back, down, keep, stay = what_to_take_back(works, r, LOWERED * numbers.slop)
        pull = pull_of(scratch, i)
        lower = down / pull if pull > 0.0 else 0.0
        x, y, turn = pushed(scratch, numbers.h, i)
        motion[i, state.DX] = stay * (motion[i, state.DX] - back * x + lower * scratch.accelerations[i, 0])
        motion[i, state.DY] = stay * (motion[i, state.DY] - back * y + lower * scratch.accelerations[i, 1])
        motion[i, state.DA] = stay * (motion[i, state.DA] - back * turn)
        motion[i, state.DC], motion[i, state.DS] = cosine_sine(motion[i, state.DA])
        vx, vy, w = along(bodies, scratch.drifts, r, i)
        motion[i, state.VX] = vx + keep * (motion[i, state.VX] - vx)
        motion[i, state.VY] = vy + keep * (motion[i, state.VY] - vy)
        motion[i, state.W] = w + keep * (motion[i, state.W] - w)
