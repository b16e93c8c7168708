"""Sweeps over contacts: impulses at two points each, kept not negative in sum, friction within its cone.

Catto 2005, "Iterative Dynamics with Temporal Coherence": what accumulates is clamped, not the single impulse.
The two normal impulses of a manifold are solved together, as a linear complementarity problem of two rows
(Catto 2006), so that neither comes first: a column has no reason to lean. The gap is followed through the
substeps by what both bodies have moved since the step began.
"""

from __future__ import annotations

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.state import (
    APPROACH_0,
    COUPLING,
    CROSS_A,
    CROSS_B,
    DC,
    DOT_A,
    DOT_B,
    DS,
    DX,
    DY,
    END_A,
    END_B,
    END_POINTS,
    JN,
    JT,
    MASS_N,
    MASS_T,
    MOST_0,
    MOST_1,
    RESTITUTION,
    ROUND_A,
    ROUND_B,
    ROW_HARD,
    ROW_IIA,
    ROW_IIB,
    ROW_IMA,
    ROW_IMB,
    ROW_MU,
    ROW_NX,
    ROW_NY,
    ROW_POINT,
    ROW_POINT_WIDTH,
    SEP,
    VX,
    VY,
    W,
)

SECOND = ROW_POINT + ROW_POINT_WIDTH


@inner_kernel
def start_warm(rows, motion):
    """Apply the impulses of the substep before."""
    row, ends = rows.rows, rows.ends
    for c in range(rows.count[0]):
        a, b = ends[c, END_A], ends[c, END_B]
        nx, ny = row[c, ROW_NX], row[c, ROW_NY]
        at = ROW_POINT
        jn, jt = row[c, at + JN], row[c, at + JT]
        turn_a = row[c, at + CROSS_A] * jn - row[c, at + DOT_A] * jt
        turn_b = row[c, at + CROSS_B] * jn - row[c, at + DOT_B] * jt
        if ends[c, END_POINTS] == 2:
            at = SECOND
            n, t = row[c, at + JN], row[c, at + JT]
            turn_a += row[c, at + CROSS_A] * n - row[c, at + DOT_A] * t
            turn_b += row[c, at + CROSS_B] * n - row[c, at + DOT_B] * t
            jn, jt = jn + n, jt + t
        x, y = jn * nx + jt * ny, jn * ny - jt * nx
        motion[a, VX] -= row[c, ROW_IMA] * x
        motion[a, VY] -= row[c, ROW_IMA] * y
        motion[a, W] -= row[c, ROW_IIA] * turn_a
        motion[b, VX] += row[c, ROW_IMB] * x
        motion[b, VY] += row[c, ROW_IMB] * y
        motion[b, W] += row[c, ROW_IIB] * turn_b


@inner_kernel
def gap_now(row, c, at, motion, a, b):
    """Gap (m) of the point at column ``at`` of row c, by what both bodies have moved since the step began."""
    nx, ny = row[c, ROW_NX], row[c, ROW_NY]
    gap = row[c, at + SEP] + (motion[b, DX] - motion[a, DX]) * nx + (motion[b, DY] - motion[a, DY]) * ny
    gap += (motion[b, DC] - 1.0) * (row[c, at + DOT_B] + row[c, ROUND_B]) + motion[b, DS] * row[
        c, at + CROSS_B
    ]
    gap -= (motion[a, DC] - 1.0) * (row[c, at + DOT_A] + row[c, ROUND_A]) + motion[a, DS] * row[
        c, at + CROSS_A
    ]
    return gap


@inner_kernel
def soft_springs(numbers):
    """Springs of soft contacts; see `sweep_contacts`."""
    return (
        (numbers.contact_rate, numbers.contact_mass, numbers.contact_give),
        (numbers.fixed_rate, numbers.fixed_mass, numbers.fixed_give),
        numbers.push,
        1.0 / numbers.h,
    )


@inner_kernel
def point_law(gap, spring, push, over_h):
    """What a point asks for: speed, mass and give. It may close its gap; overlap parts by its spring."""
    if gap > 0.0:
        return gap * over_h, 1.0, 0.0
    rate, mass, give = spring
    return max(rate * gap, -push), mass, give


@inner_kernel
def solve_two(k11, k12, k22, r1, r2):
    """j1, j2 >= 0 with K j + r >= 0 and complementary: K = (k11, k12; k12, k22), positive definite."""
    under = k11 * k22 - k12 * k12
    j1, j2 = k12 * r2 - k22 * r1, k12 * r1 - k11 * r2
    if j1 >= 0.0 and j2 >= 0.0:
        return j1 / under, j2 / under
    j1 = -r1 / k11
    if j1 >= 0.0 and k12 * j1 + r2 >= 0.0:
        return j1, 0.0
    j2 = -r2 / k22
    if j2 >= 0.0 and k12 * j2 + r1 >= 0.0:
        return 0.0, j2
    return 0.0, 0.0


@inner_kernel
def sweep_contacts(rows, motion, springs, pushing):
    """One sweep: normal impulses, then friction.

    springs: rate, mass and give of overlap between two that move, and against what cannot; fastest push
    (m/s); 1/h. pushing: overlap drives bodies apart, else it is left.
    """
    row, ends, rare = rows.rows, rows.ends, rows.rare
    moving, fixed, push, over_h = springs
    for c in range(rows.count[0]):
        a, b = ends[c, END_A], ends[c, END_B]
        nx, ny = row[c, ROW_NX], row[c, ROW_NY]
        ima, iia, imb, iib = row[c, ROW_IMA], row[c, ROW_IIA], row[c, ROW_IMB], row[c, ROW_IIB]
        wa, wb = motion[a, W], motion[b, W]
        vx, vy = motion[b, VX] - motion[a, VX], motion[b, VY] - motion[a, VY]
        un, ut = vx * nx + vy * ny, vx * ny - vy * nx
        spring = (0.0, 1.0, 0.0)
        if pushing:
            spring = fixed if row[c, ROW_HARD] > 0.0 else moving
        gap = gap_now(row, c, ROW_POINT, motion, a, b)
        bias, mass, give = point_law(gap, spring, push, over_h)
        ca1, cb1, m1, n1 = (
            row[c, ROW_POINT + CROSS_A],
            row[c, ROW_POINT + CROSS_B],
            row[c, ROW_POINT + MASS_N],
            row[c, ROW_POINT + JN],
        )
        v1 = un + wb * cb1 - wa * ca1 + bias
        if ends[c, END_POINTS] == 1:
            j = max(n1 - m1 * mass * v1 - give * n1, 0.0)
            row[c, ROW_POINT + JN] = j
            rare[c, MOST_0] = max(rare[c, MOST_0], j)
            jn = j - n1
            wa, wb = wa - iia * ca1 * jn, wb + iib * cb1 * jn
            da, db, n1 = row[c, ROW_POINT + DOT_A], row[c, ROW_POINT + DOT_B], row[c, ROW_POINT + JT]
            most = row[c, ROW_MU] * j
            j = max(-most, min(most, n1 - row[c, ROW_POINT + MASS_T] * (ut - wb * db + wa * da)))
            row[c, ROW_POINT + JT] = j
            jt = j - n1
            wa, wb = wa + iia * da * jt, wb - iib * db * jt
        else:
            ca2, cb2, m2, n2 = (
                row[c, SECOND + CROSS_A],
                row[c, SECOND + CROSS_B],
                row[c, SECOND + MASS_N],
                row[c, SECOND + JN],
            )
            k1, k2 = 1.0 / m1, 1.0 / m2
            soft1 = k1 * give / mass
            gap = gap_now(row, c, SECOND, motion, a, b)
            bias, mass, give = point_law(gap, spring, push, over_h)
            soft2 = k2 * give / mass
            v2 = un + wb * cb2 - wa * ca2 + bias
            k12 = row[c, COUPLING]
            j1, j2 = solve_two(k1 + soft1, k12, k2 + soft2, v1 - k1 * n1 - k12 * n2, v2 - k12 * n1 - k2 * n2)
            row[c, ROW_POINT + JN], row[c, SECOND + JN] = j1, j2
            rare[c, MOST_0], rare[c, MOST_1] = max(rare[c, MOST_0], j1), max(rare[c, MOST_1], j2)
            n1, n2 = j1 - n1, j2 - n2
            jn = n1 + n2
            wa, wb = wa - iia * (ca1 * n1 + ca2 * n2), wb + iib * (cb1 * n1 + cb2 * n2)
            da, db, n1 = row[c, ROW_POINT + DOT_A], row[c, ROW_POINT + DOT_B], row[c, ROW_POINT + JT]
            most = row[c, ROW_MU] * j1
            j = max(-most, min(most, n1 - row[c, ROW_POINT + MASS_T] * (ut - wb * db + wa * da)))
            row[c, ROW_POINT + JT] = j
            jt = j - n1
            ut += (ima + imb) * jt
            wa, wb = wa + iia * da * jt, wb - iib * db * jt
            da, db, n2 = row[c, SECOND + DOT_A], row[c, SECOND + DOT_B], row[c, SECOND + JT]
            most = row[c, ROW_MU] * j2
            j = max(-most, min(most, n2 - row[c, SECOND + MASS_T] * (ut - wb * db + wa * da)))
            row[c, SECOND + JT] = j
            jt += j - n2
            wa, wb = wa + iia * da * (j - n2), wb - iib * db * (j - n2)
        x, y = jn * nx + jt * ny, jn * ny - jt * nx
        motion[a, VX] -= ima * x
        motion[a, VY] -= ima * y
        motion[a, W] = wa
        motion[b, VX] += imb * x
        motion[b, VY] += imb * y
        motion[b, W] = wb


@inner_kernel
def bounce_contacts(rows, motion, numbers):
    """At the end of a step: what came in fast and was stopped leaves by its restitution, with friction."""
    row, ends, rare = rows.rows, rows.ends, rows.rare
    for c in range(rows.count[0]):
        e = rare[c, RESTITUTION]
        if e == 0.0:
            continue
        a, b = ends[c, END_A], ends[c, END_B]
        nx, ny = row[c, ROW_NX], row[c, ROW_NY]
        for k in range(ends[c, END_POINTS]):
            if rare[c, APPROACH_0 + k] > -numbers.bounce or rare[c, MOST_0 + k] == 0.0:
                continue
            at = ROW_POINT + k * ROW_POINT_WIDTH
            vx, vy = motion[b, VX] - motion[a, VX], motion[b, VY] - motion[a, VY]
            vn = vx * nx + vy * ny + motion[b, W] * row[c, at + CROSS_B] - motion[a, W] * row[c, at + CROSS_A]
            before = row[c, at + JN]
            jn = max(before - row[c, at + MASS_N] * (vn + e * rare[c, APPROACH_0 + k]), 0.0)
            row[c, at + JN] = jn
            rare[c, MOST_0 + k] = max(rare[c, MOST_0 + k], jn)
            push_point(row, c, at, motion, a, b, jn - before, 0.0)
            vx, vy = motion[b, VX] - motion[a, VX], motion[b, VY] - motion[a, VY]
            vt = vx * ny - vy * nx - motion[b, W] * row[c, at + DOT_B] + motion[a, W] * row[c, at + DOT_A]
            before, most = row[c, at + JT], row[c, ROW_MU] * jn
            jt = max(-most, min(most, before - row[c, at + MASS_T] * vt))
            row[c, at + JT] = jt
            push_point(row, c, at, motion, a, b, 0.0, jt - before)


@inner_kernel
def push_point(row, c, at, motion, a, b, jn, jt):
    """Impulses along normal and tangent (N s) at one point of a row."""
    nx, ny = row[c, ROW_NX], row[c, ROW_NY]
    x, y = jn * nx + jt * ny, jn * ny - jt * nx
    motion[a, VX] -= row[c, ROW_IMA] * x
    motion[a, VY] -= row[c, ROW_IMA] * y
    motion[a, W] -= row[c, ROW_IIA] * (row[c, at + CROSS_A] * jn - row[c, at + DOT_A] * jt)
    motion[b, VX] += row[c, ROW_IMB] * x
    motion[b, VY] += row[c, ROW_IMB] * y
    motion[b, W] += row[c, ROW_IIB] * (row[c, at + CROSS_B] * jn - row[c, at + DOT_B] * jt)
