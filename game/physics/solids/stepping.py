"""A step of solids: what comes before the solver, and what after it.

begin_step: pairs if a body may have left its boxes; manifolds; rows; velocities
fill_rows: for solvers that do not take rows in batches
a solver of `SOLVERS`: all substeps
finish_step: impulses kept, places, contacts that began, joints that broke
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.solids.arrays import layout, state
from game.physics.solids.arrays.state import BATCH_MOST, BATCH_POINTS, BATCH_RARE
from game.physics.solids.boxes import has_outgrown, make_boxes, make_room
from game.physics.solids.contacts import fetch_manifold, update_contacts
from game.physics.solids.effects import CONTACTS_BIT, CONTINUOUS_BIT, SLEEP_BIT
from game.physics.solids.islands import mark_touched, send_to_sleep, wake_islands
from game.physics.solids.joints.lines import joint_load
from game.physics.solids.pairs import carry_over, find_pairs, order_by_colours
from game.physics.solids.rows import FIRST, SECOND, copy_rows
from game.physics.solids.solvers.governor import hold_step
from game.physics.solids.solvers.motion import start_motion
from game.physics.solids.sweep import stop_fast_bodies

BEGUN, SNAPPED, WRONG, STOPPED = range(4)  # of Scratch.events
NOTHING_WRONG = -1
RUNAWAY = 1e7  # m/s, rad/s, ten times what a body can be given: only a solver that fails makes that


@lean_kernel
def renew_pairs(bodies, shapes, pool, contacts, spare, excluded, scratch, numbers):
    """Pairs anew, whatever moved; returns how many there are: if more than there is space for, none is
    changed.
    """
    make_room(bodies, numbers)
    make_boxes(bodies, shapes, pool, numbers)
    found = find_pairs(bodies, shapes, excluded, scratch)
    if found <= contacts.shapes.shape[0]:
        carry_over(contacts, spare, scratch.pair_keys, found, shapes)
        order_by_colours(bodies, contacts, scratch)
    return found


@lean_kernel
def begin_step(bodies, shapes, pool, contacts, rows, joints, scratch, numbers):
    """Rows and velocities; False, with nothing done, if pairs have to be found first."""
    wake_islands(bodies, contacts, joints, scratch)
    if numbers.mask & CONTACTS_BIT:
        if has_outgrown(bodies, numbers):
            return False
        update_contacts(bodies, shapes, pool, contacts, rows, scratch, numbers)
    else:
        rows.count[0], scratch.batches.count[0] = 0, 0
    start_motion(bodies, scratch, numbers)
    return True


@lean_kernel
def fill_rows(rows, scratch):
    """All rows, for solvers that go row by row: not of `begin_step`, where most do without its code."""
    copy_rows(rows, scratch.batches)


@inner_kernel
def place_bodies(bodies, scratch):
    """Places and velocities of what moves; the first body that is not finite or runs away, or
    NOTHING_WRONG.
    """
    motion, wrong = scratch.motion, NOTHING_WRONG
    for i in range(bodies.flags.shape[0]):
        if not bodies.flags[i] & (state.DYNAMIC | state.KEY_FRAMED) or bodies.flags[i] & state.ASLEEP:
            continue
        bodies.positions[i, 0] += motion[i, state.DX]
        bodies.positions[i, 1] += motion[i, state.DY]
        if motion[i, state.DA] != 0.0:
            bodies.angles[i] += motion[i, state.DA]
            bodies.rotations[i, 0] = elementary.cos(bodies.angles[i])
            bodies.rotations[i, 1] = elementary.sin(bodies.angles[i])
        bodies.velocities[i, 0], bodies.velocities[i, 1] = motion[i, state.VX], motion[i, state.VY]
        bodies.spins[i] = motion[i, state.W]
        total = bodies.positions[i, 0] + bodies.positions[i, 1] + bodies.angles[i]
        fastest = max(abs(motion[i, state.VX]), abs(motion[i, state.VY]), abs(motion[i, state.W]))
        if not (math.isfinite(total + fastest) and fastest <= RUNAWAY) and wrong == NOTHING_WRONG:
            wrong = i
    return wrong


@inner_kernel
def first_touch(rows, batches, k, lane, most, latest):
    """When (s, from the step's beginning) the first of the points that pressed closes its gap.

    That may be in the substep after the step: what would close there is slowed down already. most: largest
    impulses of both points.
    """
    earliest, values, c = latest, batches.values, np.uint64(batches.rows[k, lane])
    for n in range(2):
        speed = -values[k, BATCH_RARE + state.APPROACH_0 + n, lane]
        at = FIRST + n * state.ROW_POINT_WIDTH + state.SEP
        gap = rows.rows[c, at] if rows.count[1] else values[k, at, lane]  # a solver may leave some overlap
        if most[n] > 0.0:
            earliest = min(earliest, gap / speed if speed > 0.0 and gap > 0.0 else 0.0)
    return earliest


@inner_kernel
def note_beginning(bodies, contacts, rows, scratch, k, lane, most, latest):
    """Write down a contact that began in this step, before latest (s): this lane of batch k.

    most: largest impulses of both points (0 of one that there is not).
    """
    number = scratch.events[BEGUN]
    scratch.events[BEGUN] += 1
    if number >= scratch.begun.shape[0]:
        return
    batches, values = scratch.batches, scratch.batches.values
    pair, a, b = (
        batches.pairs[k, lane],
        batches.ends[k, state.END_A, lane],
        batches.ends[k, state.END_B, lane],
    )
    scratch.begun[number, 0], scratch.begun[number, 1] = contacts.shapes[pair, 0], contacts.shapes[pair, 1]
    second = most[1] > most[0]
    at, x, y = SECOND if second else FIRST, values[k, state.ROW_NX, lane], values[k, state.ROW_NY, lane]
    # of the lever: r = (r . n) n + (r x n) (ny, -nx)
    dot, cross = values[k, at + state.DOT_A, lane], values[k, at + state.CROSS_A, lane]
    scratch.begun_places[number, 0] = bodies.positions[a, 0] + dot * x + cross * y
    scratch.begun_places[number, 1] = bodies.positions[a, 1] + dot * y - cross * x
    scratch.begun_places[number, 2] = most[0] + most[1]
    approach = state.APPROACH_1 if second else state.APPROACH_0
    scratch.begun_places[number, 3] = -values[k, BATCH_RARE + approach, lane]
    first = first_touch(rows, batches, k, lane, most, latest)
    scratch.begun_places[number, 4] = first - max(bodies.late[a], bodies.late[b])


@inner_kernel
def impulses_of(rows, batches, c, k, lane):
    """Of row c, which is this lane of batch k: JN and JT of both points, MOST_0, MOST_1."""
    row, rare, values = rows.rows, rows.rare, batches.values
    if rows.count[1]:
        return (
            row[c, FIRST + state.JN],
            row[c, FIRST + state.JT],
            row[c, SECOND + state.JN],
            row[c, SECOND + state.JT],
            rare[c, state.MOST_0],
            rare[c, state.MOST_1],
        )
    return (
        values[k, FIRST + state.JN, lane],
        values[k, FIRST + state.JT, lane],
        values[k, SECOND + state.JN, lane],
        values[k, SECOND + state.JT, lane],
        values[k, BATCH_MOST, lane],
        values[k, BATCH_MOST + 1, lane],
    )


@inner_kernel
def keep_impulses(bodies, contacts, rows, scratch, numbers):
    """Impulses back to the manifolds; which contacts began. Called while bodies are where the step began."""
    batches, kept, marks = scratch.batches, contacts.manifolds, contacts.marks
    last = batches.count[0] - 1
    for k in range(last + 1):
        for lane in range(batches.filled[k]):
            fetch_manifold(kept, batches.pairs[min(k + 1, last), lane], 2)
            c, pair = np.uint64(batches.rows[k, lane]), np.uint64(batches.pairs[k, lane])
            n1, t1, n2, t2, most1, most2 = impulses_of(rows, batches, c, k, lane)
            kept[pair, state.FIRST_POINT + state.NORMAL_IMPULSE] = n1
            kept[pair, state.FIRST_POINT + state.TANGENT_IMPULSE] = t1
            if batches.values[k, BATCH_POINTS, lane] == 2.0:
                kept[pair, state.FIRST_POINT + state.POINT_WIDTH + state.NORMAL_IMPULSE] = n2
                kept[pair, state.FIRST_POINT + state.POINT_WIDTH + state.TANGENT_IMPULSE] = t2
            else:
                most2 = 0.0
            touching = 1 if most1 + most2 > 0.0 else 0
            if marks[pair, state.TOUCHING] == touching:
                continue
            marks[pair, state.TOUCHING] = touching
            if touching:
                note_beginning(
                    bodies, contacts, rows, scratch, k, lane, (most1, most2), numbers.dt + numbers.h
                )


@inner_kernel
def break_joints(joints, scratch, numbers):
    """Mark joints that carried more than their breaking load in the last substep."""
    for k in range(joints.kinds.shape[0]):
        joints.flags[k] &= ~layout.JUST_BROKEN
        if (
            joints.kinds[k] == layout.NO_JOINT
            or joints.flags[k] & layout.BROKEN
            or joints.rows[k, layout.SUBSTEP] < 0.0
        ):
            continue
        force, torque = joint_load(joints, k)
        most = (
            numbers.h * joints.parameters[k, layout.BREAK_FORCE],
            numbers.h * joints.parameters[k, layout.BREAK_TORQUE],
        )
        if force > most[0] or torque > most[1]:
            joints.flags[k] |= layout.BROKEN | layout.JUST_BROKEN
            scratch.events[SNAPPED] += 1


@lean_kernel
def finish_step(bodies, shapes, pool, contacts, rows, joints, scratch, numbers):
    """After the solver: impulses, events, places, sleep. scratch.events is written."""
    scratch.events[BEGUN], scratch.events[SNAPPED], scratch.events[STOPPED] = 0, 0, 0
    keep_impulses(bodies, contacts, rows, scratch, numbers)
    break_joints(joints, scratch, numbers)
    if mark_touched(bodies, contacts, rows):
        wake_islands(bodies, contacts, joints, scratch)
    if numbers.mask & CONTINUOUS_BIT and numbers.mask & CONTACTS_BIT:
        scratch.events[STOPPED] = stop_fast_bodies(bodies, shapes, pool, contacts, scratch, numbers)
    if numbers.passive:
        hold_step(bodies, contacts, scratch, numbers)
    scratch.events[WRONG] = place_bodies(bodies, scratch)
    if numbers.mask & SLEEP_BIT:
        send_to_sleep(bodies, rows, contacts, joints, scratch, numbers)
