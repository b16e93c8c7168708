"""Contact and shock propagation: Guendelman, Bridson, Fedkiw 2003, "Nonconvex Rigid Bodies with Stacking".

Order of integration (section 4): collisions, with restitution, of those that would meet by the velocities
that they have. Then forces into velocities. Then contacts (section 6), which have no restitution. Then
places. So a block on a slope starts, slides and stops without hopping, and falling bodies do not bounce off
their own weight. Contacts: sweeps of impulses, each by itself and with friction (section 5), restitution -0.9
at first and 0 at last, so that what presses most is slowed gently. Shock propagation (section 7): bodies in
levels by how many contacts away from what cannot move they stand. Level after level is swept once more, the
level below as if it could not move. What still overlaps is pushed apart in the same order, in places only.
Joints are held within the sweeps of contacts.

Where we differ: the two points of a manifold are pushed together, so that columns do not lean to one side.
Contacts come from manifolds in the place of distance fields (convex parts stand for what is not convex). A
level is the least number of contacts from the ground, in the place of trial falls of single bodies.

What it cannot do: shock propagation hides weight from what is below. So a heavy box on a seesaw's end, or a
plank that should tip by what stands on it, is held too well. Nothing is remembered from step to step.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.arrays import state
from game.physics.solids.joints.direct import solve_joints
from game.physics.solids.joints.geometric import steady_turns
from game.physics.solids.joints.lines import prepare_joints, start_joints_warm
from game.physics.solids.solvers.impulses import gap_now, solve_two
from game.physics.solids.solvers.motion import accelerate, move
from game.physics.solids.solvers.positions import clear_impulses, turn_body

COLLISION_SWEEPS, CONTACT_SWEEPS, SHOCK_SWEEPS, PUSHING_SWEEPS = 5, 10, 4, 2
NO_LEVEL = 1 << 30
PART = 0.5  # of an overlap beyond the slop, that a substep takes away


@inner_kernel
def find_levels(bodies, rows, motion, levels, near):
    """Levels (n,): 0 for what cannot move, else one more than the lowest that is touched."""
    for i in range(levels.shape[0]):
        levels[i] = NO_LEVEL if bodies.flags[i] & state.DYNAMIC else 0
    found = True
    while found:
        found = False
        for c in range(rows.count[0]):
            a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
            if abs(levels[a] - levels[b]) <= 1:
                continue
            for k in range(rows.ends[c, state.END_POINTS]):
                at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
                if gap_now(rows.rows, c, at, motion, a, b) < near:
                    levels[a] = min(levels[a], levels[b] + 1)
                    levels[b] = min(levels[b], levels[a] + 1)
                    found = True


@inner_kernel
def point_speeds(row, c, at, motion, a, b):
    """Speeds of b against a at a point, along normal and tangent."""
    vx, vy = motion[b, state.VX] - motion[a, state.VX], motion[b, state.VY] - motion[a, state.VY]
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    vn = (
        vx * nx
        + vy * ny
        + motion[b, state.W] * row[c, at + state.CROSS_B]
        - motion[a, state.W] * row[c, at + state.CROSS_A]
    )
    vt = (
        vx * ny
        - vy * nx
        - motion[b, state.W] * row[c, at + state.DOT_B]
        + motion[a, state.W] * row[c, at + state.DOT_A]
    )
    return vn, vt


@inner_kernel
def coupled(row, c, at, masses):
    """K of a point: normal, tangent, and between both, for these inverse masses and inertias."""
    ima, iia, imb, iib = masses
    ca, cb, da, db = (
        row[c, at + state.CROSS_A],
        row[c, at + state.CROSS_B],
        row[c, at + state.DOT_A],
        row[c, at + state.DOT_B],
    )
    knn = ima + imb + iia * ca * ca + iib * cb * cb
    ktt = ima + imb + iia * da * da + iib * db * db
    return knn, ktt, -iia * ca * da - iib * cb * db


@inner_kernel
def strike(row, c, at, motion, a, b, wanted, masses):
    """One impulse after which the point parts at the speed wanted, sticking if within the cone."""
    vn, vt = point_speeds(row, c, at, motion, a, b)
    if vn >= wanted:
        return 0.0
    knn, ktt, knt = coupled(row, c, at, masses)
    under = knn * ktt - knt * knt
    dn, dt = wanted - vn, -vt
    jn, jt = (ktt * dn - knt * dt) / under, (knn * dt - knt * dn) / under
    mu = row[c, state.ROW_MU]
    if jn < 0.0 or abs(jt) > mu * jn:
        side = -1.0 if vt > 0.0 else 1.0
        slope = knn + side * mu * knt
        jn = dn / slope if slope > 0.05 * knn else dn / knn
        jt = side * mu * jn if slope > 0.05 * knn else 0.0
        if abs(vt) < abs(ktt * jt + knt * jn):  # it would slide back: no more than stops it
            jt = side * min(mu * jn, abs(vt) / ktt)
    push(row, c, at, motion, a, b, (jn, jt), masses)
    return jn


@inner_kernel
def masses_of(row, c):
    """Inverse masses and inertias of a row."""
    return row[c, state.ROW_IMA], row[c, state.ROW_IIA], row[c, state.ROW_IMB], row[c, state.ROW_IIB]


@inner_kernel
def collide(rows, motion, numbers):
    """Impacts with restitution, of what would overlap by the velocities that there are."""
    row, ends, rare = rows.rows, rows.ends, rows.rare
    for _sweep in range(COLLISION_SWEEPS):
        for c in range(rows.count[0]):
            a, b = ends[c, state.END_A], ends[c, state.END_B]
            for k in range(ends[c, state.END_POINTS]):
                at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
                vn, _ = point_speeds(row, c, at, motion, a, b)
                if vn >= 0.0 or gap_now(row, c, at, motion, a, b) + numbers.h * vn > 0.0:
                    continue
                e = rare[c, state.RESTITUTION] if -vn > numbers.bounce else 0.0
                strike(row, c, at, motion, a, b, -e * vn, masses_of(row, c))


@inner_kernel
def push(row, c, at, motion, a, b, j, masses):
    """Impulses j = (normal, tangent) at a point."""
    ima, iia, imb, iib = masses
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    x, y = j[0] * nx + j[1] * ny, j[0] * ny - j[1] * nx
    motion[a, state.VX] -= ima * x
    motion[a, state.VY] -= ima * y
    motion[a, state.W] -= iia * (row[c, at + state.CROSS_A] * j[0] - row[c, at + state.DOT_A] * j[1])
    motion[b, state.VX] += imb * x
    motion[b, state.VY] += imb * y
    motion[b, state.W] += iib * (row[c, at + state.CROSS_B] * j[0] - row[c, at + state.DOT_B] * j[1])
    row[c, at + state.JN] += j[0]
    row[c, at + state.JT] += j[1]


@inner_kernel
def asked(row, c, at, motion, a, b, keep, h):
    """By how much a point closes faster than it may; ``keep`` of that is left to later sweeps."""
    vn, _ = point_speeds(row, c, at, motion, a, b)
    over = vn + max(0.0, gap_now(row, c, at, motion, a, b)) / h
    return (1.0 - keep) * over if over < 0.0 else over


@inner_kernel
def rub(row, c, at, motion, a, b, masses):
    """Friction at a point: all of the substep so far within the cone of all that pressed so far."""
    _, vt = point_speeds(row, c, at, motion, a, b)
    _, ktt, _ = coupled(row, c, at, masses)
    most, before = row[c, state.ROW_MU] * row[c, at + state.JN], row[c, at + state.JT]
    push(row, c, at, motion, a, b, (0.0, max(-most, min(most, before - vt / ktt)) - before), masses)


@inner_kernel
def touch(rows, motion, c, masses, keep, h):
    """Contacts of one row, without restitution: normals of both points together, then friction of each."""
    row, a, b = rows.rows, rows.ends[c, state.END_A], rows.ends[c, state.END_B]
    at, second = state.ROW_POINT, state.ROW_POINT + state.ROW_POINT_WIDTH
    knn, _, _ = coupled(row, c, at, masses)
    v1 = asked(row, c, at, motion, a, b, keep, h)
    if rows.ends[c, state.END_POINTS] == 1:
        if v1 < 0.0:
            vn, _ = point_speeds(row, c, at, motion, a, b)
            strike(row, c, at, motion, a, b, vn - v1, masses)
    else:
        v2 = asked(row, c, second, motion, a, b, keep, h)
        other, _, _ = coupled(row, c, second, masses)
        ima, iia, imb, iib = masses
        between = ima + imb + iia * row[c, at + state.CROSS_A] * row[c, second + state.CROSS_A]
        between += iib * row[c, at + state.CROSS_B] * row[c, second + state.CROSS_B]
        between = min(between, 0.98 * math.sqrt(knn * other))
        j1, j2 = solve_two(knn, between, other, v1, v2)
        push(row, c, at, motion, a, b, (j1, 0.0), masses)
        push(row, c, second, motion, a, b, (j2, 0.0), masses)
        rub(row, c, at, motion, a, b, masses)
        rub(row, c, second, motion, a, b, masses)


@inner_kernel
def heaviest_below(rows, c, levels):
    """Masses of a row with the lower level as if it could not move."""
    ima, iia, imb, iib = masses_of(rows.rows, c)
    a, b = levels[rows.ends[c, state.END_A]], levels[rows.ends[c, state.END_B]]
    if a < b:
        return 0.0, 0.0, imb, iib
    if b < a:
        return ima, iia, 0.0, 0.0
    return ima, iia, imb, iib


@inner_kernel
def propagate(rows, motion, levels, highest, h):
    """Level after level upward, each upon one that does not move any more."""
    for level in range(1, highest + 1):
        for _ in range(SHOCK_SWEEPS):
            for c in range(rows.count[0]):
                if max(levels[rows.ends[c, state.END_A]], levels[rows.ends[c, state.END_B]]) == level:
                    touch(rows, motion, c, heaviest_below(rows, c, levels), 0.0, h)


@inner_kernel
def push_apart(rows, motion, levels, highest, numbers):
    """Overlap beyond the slop is taken out of places, level after level; velocities do not learn of it."""
    row, ends = rows.rows, rows.ends
    for level in range(1, highest + 1):
        for _sweep in range(PUSHING_SWEEPS):
            for c in range(rows.count[0]):
                a, b = ends[c, state.END_A], ends[c, state.END_B]
                if max(levels[a], levels[b]) != level:
                    continue
                masses = heaviest_below(rows, c, levels)
                for k in range(ends[c, state.END_POINTS]):
                    at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
                    over = -gap_now(row, c, at, motion, a, b) - numbers.slop
                    if over > 0.0:
                        knn, _, _ = coupled(row, c, at, masses)
                        shift(
                            row, c, at, motion, a, b, min(PART * over, numbers.h * numbers.push) / knn, masses
                        )


@inner_kernel
def shift(row, c, at, motion, a, b, j, masses):
    """Move both bodies of a point apart along its normal by j (kg m)."""
    ima, iia, imb, iib = masses
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    motion[a, state.DX] -= ima * j * nx
    motion[a, state.DY] -= ima * j * ny
    motion[b, state.DX] += imb * j * nx
    motion[b, state.DY] += imb * j * ny
    turn_body(motion, a, -iia * row[c, at + state.CROSS_A] * j)
    turn_body(motion, b, iib * row[c, at + state.CROSS_B] * j)


@inner_kernel
def note_impulses(rows):
    """What each point carried in this substep, at its most."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            j = rows.rows[c, state.ROW_POINT + k * state.ROW_POINT_WIDTH + state.JN]
            rows.rare[c, state.MOST_0 + k] = max(rows.rare[c, state.MOST_0 + k], j)


@inner_kernel
def highest_level(levels):
    """Of those that stand on something."""
    highest = 0
    for i in range(levels.shape[0]):
        if levels[i] < NO_LEVEL:
            highest = max(highest, levels[i])
    return highest


@lean_kernel
def solve_shock_propagation(bodies, contacts, rows, joints, scratch, numbers):
    """All substeps of one step. See the package."""
    motion, h, levels = scratch.motion, numbers.h, scratch.parents
    hard = (0.2 / h, 1.0, 0.0)
    prepare_joints(bodies, joints, hard, numbers)
    for _ in range(numbers.substeps):
        clear_impulses(rows)
        collide(rows, motion, numbers)
        accelerate(scratch, numbers)
        start_joints_warm(joints, motion)
        steady_turns(bodies, joints, scratch, h)
        for n in range(CONTACT_SWEEPS * numbers.iterations):
            if n % 5 == 0:
                solve_joints(joints, scratch.plan, motion, True)
            keep = max(0.0, 0.9 - n / (CONTACT_SWEEPS * numbers.iterations - 1))
            for c in range(rows.count[0]):
                touch(rows, motion, c, masses_of(rows.rows, c), keep, h)
        find_levels(bodies, rows, motion, levels, numbers.slop)
        propagate(rows, motion, levels, highest_level(levels), h)
        move(motion, h)
        push_apart(rows, motion, levels, highest_level(levels), numbers)
        note_impulses(rows)
