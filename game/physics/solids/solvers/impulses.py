"""Sweeps over contacts: impulses at two points each, kept not negative in sum, friction within its cone.

Catto 2005, "Iterative Dynamics with Temporal Coherence": what accumulates is clamped, not the single impulse.
The gap is followed through the substeps by what both bodies have moved since the manifold was found.
"""

from __future__ import annotations

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.state import (
    APPROACH_0,
    DC,
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
    RAX,
    RAY,
    RBX,
    RBY,
    RESTITUTION,
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


@inner_kernel
def start_warm(rows, motion):
    """Apply the impulses of the substep before."""
    row, ends = rows.rows, rows.ends
    for c in range(rows.count[0]):
        a, b = ends[c, END_A], ends[c, END_B]
        nx, ny = row[c, ROW_NX], row[c, ROW_NY]
        px, py, la, lb = 0.0, 0.0, 0.0, 0.0
        for k in range(ends[c, END_POINTS]):
            at = ROW_POINT + k * ROW_POINT_WIDTH
            jn, jt = row[c, at + JN], row[c, at + JT]
            x, y = jn * nx + jt * ny, jn * ny - jt * nx
            px, py = px + x, py + y
            la += row[c, at + RAX] * y - row[c, at + RAY] * x
            lb += row[c, at + RBX] * y - row[c, at + RBY] * x
        motion[a, VX] -= row[c, ROW_IMA] * px
        motion[a, VY] -= row[c, ROW_IMA] * py
        motion[a, W] -= row[c, ROW_IIA] * la
        motion[b, VX] += row[c, ROW_IMB] * px
        motion[b, VY] += row[c, ROW_IMB] * py
        motion[b, W] += row[c, ROW_IIB] * lb


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
def sweep_contacts(rows, motion, springs, pushing):
    """One sweep: normal impulses, then friction.

    springs: rate, mass and give of overlap between two that move, and against what cannot; fastest push (m/s);
    1/h. pushing: overlap drives bodies apart, else it is left.
    """
    row, ends, rare = rows.rows, rows.ends, rows.rare
    moving, fixed, push, over_h = springs
    for c in range(rows.count[0]):
        a, b, points = ends[c, END_A], ends[c, END_B], ends[c, END_POINTS]
        nx, ny = row[c, ROW_NX], row[c, ROW_NY]
        ima, iia, imb, iib = row[c, ROW_IMA], row[c, ROW_IIA], row[c, ROW_IMB], row[c, ROW_IIB]
        vax, vay, wa = motion[a, VX], motion[a, VY], motion[a, W]
        vbx, vby, wb = motion[b, VX], motion[b, VY], motion[b, W]
        dx, dy = motion[b, DX] - motion[a, DX], motion[b, DY] - motion[a, DY]
        ca, sa, cb, sb = motion[a, DC], motion[a, DS], motion[b, DC], motion[b, DS]
        rate, mass, give = 0.0, 1.0, 0.0
        if pushing:
            rate, mass, give = fixed if row[c, ROW_HARD] > 0.0 else moving
        for k in range(points):
            at = ROW_POINT + k * ROW_POINT_WIDTH
            rax, ray, rbx, rby = row[c, at + RAX], row[c, at + RAY], row[c, at + RBX], row[c, at + RBY]
            mx = dx + (cb * rbx - sb * rby) - (ca * rax - sa * ray)
            my = dy + (sb * rbx + cb * rby) - (sa * rax + ca * ray)
            gap = row[c, at + SEP] + mx * nx + my * ny
            vn = (vbx - wb * rby - vax + wa * ray) * nx + (vby + wb * rbx - vay - wa * rax) * ny
            before = row[c, at + JN]
            if gap > 0.0:
                j = before - row[c, at + MASS_N] * (vn + gap * over_h)
            else:
                bias = max(rate * gap, -push)
                j = before - row[c, at + MASS_N] * mass * (vn + bias) - give * before
            j = max(j, 0.0)
            row[c, at + JN] = j
            rare[c, MOST_0 + k] = max(rare[c, MOST_0 + k], j)
            x, y = (j - before) * nx, (j - before) * ny
            vax, vay, wa = vax - ima * x, vay - ima * y, wa - iia * (rax * y - ray * x)
            vbx, vby, wb = vbx + imb * x, vby + imb * y, wb + iib * (rbx * y - rby * x)
        for k in range(points):
            at = ROW_POINT + k * ROW_POINT_WIDTH
            rax, ray, rbx, rby = row[c, at + RAX], row[c, at + RAY], row[c, at + RBX], row[c, at + RBY]
            vt = (vbx - wb * rby - vax + wa * ray) * ny - (vby + wb * rbx - vay - wa * rax) * nx
            before = row[c, at + JT]
            most = row[c, ROW_MU] * row[c, at + JN]
            j = max(-most, min(most, before - row[c, at + MASS_T] * vt))
            row[c, at + JT] = j
            x, y = (j - before) * ny, (before - j) * nx
            vax, vay, wa = vax - ima * x, vay - ima * y, wa - iia * (rax * y - ray * x)
            vbx, vby, wb = vbx + imb * x, vby + imb * y, wb + iib * (rbx * y - rby * x)
        motion[a, VX], motion[a, VY], motion[a, W] = vax, vay, wa
        motion[b, VX], motion[b, VY], motion[b, W] = vbx, vby, wb


@inner_kernel
def bounce_contacts(rows, motion, numbers):
    """At the end of a step: what came in fast and was stopped leaves by its restitution."""
    row, ends, rare = rows.rows, rows.ends, rows.rare
    for c in range(rows.count[0]):
        e = rare[c, RESTITUTION]
        if e == 0.0:
            continue
        a, b = ends[c, END_A], ends[c, END_B]
        nx, ny = row[c, ROW_NX], row[c, ROW_NY]
        ima, iia, imb, iib = row[c, ROW_IMA], row[c, ROW_IIA], row[c, ROW_IMB], row[c, ROW_IIB]
        for k in range(ends[c, END_POINTS]):
            if rare[c, APPROACH_0 + k] > -numbers.bounce or rare[c, MOST_0 + k] == 0.0:
                continue
            at = ROW_POINT + k * ROW_POINT_WIDTH
            rax, ray, rbx, rby = row[c, at + RAX], row[c, at + RAY], row[c, at + RBX], row[c, at + RBY]
            vn = (motion[b, VX] - motion[b, W] * rby - motion[a, VX] + motion[a, W] * ray) * nx
            vn += (motion[b, VY] + motion[b, W] * rbx - motion[a, VY] - motion[a, W] * rax) * ny
            before = row[c, at + JN]
            j = max(before - row[c, at + MASS_N] * (vn + e * rare[c, APPROACH_0 + k]), 0.0)
            row[c, at + JN] = j
            rare[c, MOST_0 + k] = max(rare[c, MOST_0 + k], j)
            x, y = (j - before) * nx, (j - before) * ny
            motion[a, VX] -= ima * x
            motion[a, VY] -= ima * y
            motion[a, W] -= iia * (rax * y - ray * x)
            motion[b, VX] += imb * x
            motion[b, VY] += imb * y
            motion[b, W] += iib * (rbx * y - rby * x)
