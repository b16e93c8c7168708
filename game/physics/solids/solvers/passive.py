"""Impacts are passive: in no substep do contacts give bodies more kinetic energy than they take.

Impulses that were known before (warm start) and overlap that is driven apart are guesses of one sweep. Where
many bodies hit each other at once, a relaxing sweep does not take all of it back. Energy then rises. With v
the velocities after the forces and d what all impulses of a substep added, the work is a + b with a = v·M d
and b = d·M d/2. Where it is above a credit c, d is made shorter, to s d with s a + s² b = c; group by group
of bodies that touch. The credit of a substep is m (h g)²/2, which leaves piles the little that their settling
takes. What bounces at the end of a step may give back what its group has lost in the step.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import state
from game.physics.solids.arrays.layout import SUBSTEP
from game.physics.solids.islands import is_moving, root_of, unite
from game.physics.solids.rows import RESTLESS
from game.physics.solids.solvers.motion import cosine_sine

FIRST, SECOND = state.ROW_POINT, state.ROW_POINT + state.ROW_POINT_WIDTH
EXCUSED, HIT = 1, 2  # marks of a body; shifted by two, of its group
FREE, PUSHED = 0, 3  # columns of Scratch.speeds: velocities and spin after the forces, and with the push


@inner_kernel
def is_violent(rows, c, dt):
    """True if the two of a row overlap deeply, or closed or parted fast when the step began."""
    speed = abs(rows.rare[c, state.APPROACH_0])
    if rows.ends[c, state.END_POINTS] == 2:
        speed = max(speed, abs(rows.rare[c, state.APPROACH_1]))
    return rows.rare[c, state.IMPACT] > 0.0 or speed > RESTLESS * dt


@inner_kernel
def excuse(bodies, rows, joints, scratch):
    """Mark bodies that joints or moving key-framed bodies may give energy to."""
    excused, any_moving = scratch.excused, False
    excused[:] = 0
    for k in range(joints.kinds.shape[0]):
        if joints.rows[k, SUBSTEP] >= 0.0:
            excused[joints.bodies[k, 0]] = EXCUSED
            excused[joints.bodies[k, 1]] = EXCUSED
    for i in range(excused.shape[0]):
        any_moving = any_moving or is_moving(bodies, i)
    if any_moving:
        for c in range(rows.count[0]):
            a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
            if is_moving(bodies, a) or is_moving(bodies, b):
                excused[a], excused[b] = EXCUSED, EXCUSED


@inner_kernel
def note_speeds(motion, speeds, at):
    """Keep velocities and spins in three columns of speeds."""
    for i in range(motion.shape[0]):
        speeds[i, at], speeds[i, at + 1], speeds[i, at + 2] = (
            motion[i, state.VX],
            motion[i, state.VY],
            motion[i, state.W],
        )


@inner_kernel
def work_on(bodies, motion, speeds, i):
    """a and b of a body: see the module."""
    m, inertia = 1.0 / bodies.inverse_masses[i], 1.0 / bodies.inverse_inertias[i]
    vx, vy, w = speeds[i, FREE], speeds[i, FREE + 1], speeds[i, FREE + 2]
    x, y, t = motion[i, state.VX] - vx, motion[i, state.VY] - vy, motion[i, state.W] - w
    return m * (vx * x + vy * y) + inertia * w * t, 0.5 * (m * (x * x + y * y) + inertia * t * t)


@inner_kernel
def credit(bodies, scratch, h, i):
    """What contacts may give a body, J."""
    m, x, y = 1.0 / bodies.inverse_masses[i], scratch.accelerations[i, 0], scratch.accelerations[i, 1]
    return 0.5 * m * h * h * (x * x + y * y)


@inner_kernel
def group_by_touch(bodies, rows, scratch, dt):
    """Representatives of bodies that push each other in this substep, marked where one is excused or hit."""
    parents, row = scratch.parents, rows.rows
    for i in range(parents.shape[0]):
        parents[i] = i
    for c in range(rows.count[0]):
        a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
        pushing = row[c, FIRST + state.JN] > 0.0 or (
            rows.ends[c, state.END_POINTS] == 2 and row[c, SECOND + state.JN] > 0.0
        )
        if pushing and bodies.inverse_masses[a] > 0.0 and bodies.inverse_masses[b] > 0.0:
            unite(parents, a, b)
        if is_violent(rows, c, dt):
            scratch.excused[a] |= HIT
            scratch.excused[b] |= HIT
    for i in range(parents.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            scratch.excused[root_of(parents, i)] |= (scratch.excused[i] & (EXCUSED | HIT)) << 2


@inner_kernel
def hold_energy(bodies, rows, scratch, numbers):
    """Shorten what contacts did where it is more than they may."""
    motion, speeds, works, parents = scratch.motion, scratch.speeds, scratch.works, scratch.parents
    total = 0.0
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            a, b = work_on(bodies, motion, speeds, i)
            total += a + b - credit(bodies, scratch, numbers.h, i)
    if not total > 0.0:
        return
    group_by_touch(bodies, rows, scratch, numbers.dt)
    works[:] = 0.0
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            a, b = work_on(bodies, motion, speeds, i)
            r = root_of(parents, i)
            works[r, 0] += a
            works[r, 1] += b
            works[r, 2] += credit(bodies, scratch, numbers.h, i)
    for i in range(motion.shape[0]):
        a, b, c = works[i, 0], works[i, 1], max(works[i, 2], 0.0)
        keep = 1.0
        if a + b > c and b > 0.0 and scratch.excused[i] >> 2 == HIT:
            keep = max(0.0, min(1.0, (math.sqrt(a * a + 4.0 * b * c) - a) / (2.0 * b)))
        works[i, 0] = keep
        scratch.excused[i] &= EXCUSED
    for i in range(motion.shape[0]):
        keep = works[root_of(parents, i), 0]
        if bodies.inverse_masses[i] > 0.0 and keep < 1.0:
            vx, vy, w = speeds[i, FREE], speeds[i, FREE + 1], speeds[i, FREE + 2]
            motion[i, state.VX] = vx + keep * (motion[i, state.VX] - vx)
            motion[i, state.VY] = vy + keep * (motion[i, state.VY] - vy)
            motion[i, state.W] = w + keep * (motion[i, state.W] - w)
    scale_impulses(bodies, rows, works, parents)


@inner_kernel
def scale_impulses(bodies, rows, works, parents):
    """The impulses of groups that were held, likewise."""
    row = rows.rows
    for c in range(rows.count[0]):
        a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
        keep = works[root_of(parents, a if bodies.inverse_masses[a] > 0.0 else b), 0]
        if keep < 1.0:
            for at in (FIRST, SECOND):
                row[c, at + state.JN] *= keep
                row[c, at + state.JT] *= keep


@inner_kernel
def hold_push(bodies, scratch, numbers):
    """No body is driven out of overlap faster than ``push``, however many drive it."""
    motion, speeds = scratch.motion, scratch.speeds
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] == 0.0 or scratch.excused[i]:
            continue
        reach = bodies.reaches[i]
        vx, vy, w = speeds[i, PUSHED], speeds[i, PUSHED + 1], speeds[i, PUSHED + 2]
        pushed = math.sqrt(vx * vx + vy * vy) + abs(w) * reach
        if pushed <= numbers.push:
            continue
        fx, fy = speeds[i, FREE], speeds[i, FREE + 1]
        fastest = math.sqrt(fx * fx + fy * fy) + abs(speeds[i, FREE + 2]) * reach
        after = (
            math.sqrt(motion[i, state.VX] * motion[i, state.VX] + motion[i, state.VY] * motion[i, state.VY])
            + abs(motion[i, state.W]) * reach
        )
        excess = pushed - numbers.push - max(fastest, after)
        if excess > 0.0:
            part = numbers.h * excess / pushed
            motion[i, state.DX] -= part * vx
            motion[i, state.DY] -= part * vy
            motion[i, state.DA] -= part * w
            motion[i, state.DC], motion[i, state.DS] = cosine_sine(motion[i, state.DA])
