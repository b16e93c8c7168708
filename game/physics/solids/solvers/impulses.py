"""Sweeps over contacts: impulses at two points each, kept not negative in sum, friction within its cone.

Catto 2005, "Iterative Dynamics with Temporal Coherence": what accumulates is clamped, not the single impulse.
The two normal impulses of a manifold are solved together, as a linear complementarity problem of two rows
(Catto 2006), so that neither comes first: a column has no reason to lean. A face is soft as a whole: it sinks
by what both points carry, and hardly tilts. With softness by each point for itself a column of n unit boxes
buckles like any slender one where n³ g exceeds 0.78 w² (Greenhill 1881), at 30 Hz from 15 boxes on. The gap
is followed through the substeps by what both bodies have moved since the step began.
"""

from __future__ import annotations

import numpy as np

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import state

FIRST = state.ROW_POINT
SECOND = state.ROW_POINT + state.ROW_POINT_WIDTH
OPEN = 1e30  # m/s, of what may close as fast as it will
TILT = 0.25  # how much softer a face is where it tilts than where it sinks evenly


@inner_kernel
def start_warm(rows, motion):
    """Apply the impulses of the substep before, but not those of an impact."""
    row, ends = rows.rows, rows.ends
    for c in range(rows.count[0]):
        a, b = ends[c, state.END_A], ends[c, state.END_B]
        nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
        if rows.rare[c, state.IMPACT] > 0.0:
            row[c, FIRST + state.JN], row[c, FIRST + state.JT] = 0.0, 0.0
            row[c, SECOND + state.JN], row[c, SECOND + state.JT] = 0.0, 0.0
            continue
        at = state.ROW_POINT
        jn, jt = row[c, at + state.JN], row[c, at + state.JT]
        turn_a = row[c, at + state.CROSS_A] * jn - row[c, at + state.DOT_A] * jt
        turn_b = row[c, at + state.CROSS_B] * jn - row[c, at + state.DOT_B] * jt
        if ends[c, state.END_POINTS] == 2:
            at = SECOND
            n, t = row[c, at + state.JN], row[c, at + state.JT]
            turn_a += row[c, at + state.CROSS_A] * n - row[c, at + state.DOT_A] * t
            turn_b += row[c, at + state.CROSS_B] * n - row[c, at + state.DOT_B] * t
            jn, jt = jn + n, jt + t
        x, y = jn * nx + jt * ny, jn * ny - jt * nx
        motion[a, state.VX] -= row[c, state.ROW_IMA] * x
        motion[a, state.VY] -= row[c, state.ROW_IMA] * y
        motion[a, state.W] -= row[c, state.ROW_IIA] * turn_a
        motion[b, state.VX] += row[c, state.ROW_IMB] * x
        motion[b, state.VY] += row[c, state.ROW_IMB] * y
        motion[b, state.W] += row[c, state.ROW_IIB] * turn_b


@inner_kernel
def gap_now(row, c, at, motion, a, b):
    """Gap (m) of the point at column ``at`` of row c, by what both bodies have moved since the step began."""
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    gap = (
        row[c, at + state.SEP]
        + (motion[b, state.DX] - motion[a, state.DX]) * nx
        + (motion[b, state.DY] - motion[a, state.DY]) * ny
    )
    gap += (motion[b, state.DC] - 1.0) * (row[c, at + state.DOT_B] + row[c, state.ROUND_B]) + motion[
        b, state.DS
    ] * row[c, at + state.CROSS_B]
    gap -= (motion[a, state.DC] - 1.0) * (row[c, at + state.DOT_A] + row[c, state.ROUND_A]) + motion[
        a, state.DS
    ] * row[c, at + state.CROSS_A]
    return gap


@inner_kernel
def soft_springs(numbers):
    """Springs of soft contacts; see `sweep_contacts`."""
    return (
        (numbers.contact_rate, numbers.contact_mass, numbers.contact_give / numbers.contact_mass),
        (numbers.fixed_rate, numbers.fixed_mass, numbers.fixed_give / numbers.fixed_mass),
        numbers.push,
        1.0 / numbers.h,
    )


@inner_kernel
def point_law(gap, rate, push, over_h):
    """Speed that a point asks for: it may close its gap; overlap parts at a rate, but no faster than push."""
    return max(gap, 0.0) * over_h + max(rate * min(gap, 0.0), -push)


@inner_kernel
def unless_open(gap, pressing, law):
    """A sweep without push begins no contact that is open: one that hits does so in the next substep."""
    return OPEN if gap > 0.0 and pressing <= 0.0 else law


@inner_kernel
def solve_two(k11, k12, k22, r1, r2):
    """j1, j2 >= 0 with K j + r >= 0 and complementary: K = (k11, k12; k12, k22), positive definite."""
    j1, j2 = k12 * r2 - k22 * r1, k12 * r1 - k11 * r2
    if j1 >= 0.0 and j2 >= 0.0:
        under = 1.0 / (k11 * k22 - k12 * k12)
        return j1 * under, j2 * under
    if r1 <= 0.0 and r2 * k11 >= k12 * r1:
        return -r1 / k11, 0.0
    if r2 <= 0.0 and r1 * k22 >= k12 * r2:
        return 0.0, -r2 / k22
    return 0.0, 0.0


@inner_kernel
def closing(row, c, at, gone, turns, speeds, law):
    """Speed that the point at column ``at`` must lose, as its law asks for, and its gap.

    gone: m, what both bodies have moved along the normal. turns: cosines less 1, and sines, of a and b.
    speeds: along the normal, spins of a and b. law: rate, push and 1/h of `point_law`, and whether it pushes.
    """
    cross_a, cross_b, dot_a, dot_b = levers(row, c, at)
    gap = gone + row[c, at + state.SEP] + turns[2] * dot_b + turns[3] * cross_b
    gap = gap - turns[0] * dot_a - turns[1] * cross_a
    asked = point_law(gap, law[0], law[1], law[2])
    if not law[3]:
        asked = unless_open(gap, row[c, at + state.JN], asked)
    return speeds[0] + speeds[2] * cross_b - speeds[1] * cross_a + asked, gap


@inner_kernel
def rub(row, c, at, pressing, slide):
    """Friction of the point at column ``at``, within the cone of what presses; by how much it has changed."""
    before, most = row[c, at + state.JT], row[c, state.ROW_MU] * pressing
    j = max(-most, min(most, before - row[c, at + state.MASS_T] * slide))
    row[c, at + state.JT] = j
    return j - before


@inner_kernel
def press_two(row, c, v1, v2, gap, give):
    """Normal impulses of both points together; by how much they have changed. give: of the spring."""
    k1, k2, k12 = row[c, FIRST + state.STIFF_N], row[c, SECOND + state.STIFF_N], row[c, state.COUPLING]
    n1, n2 = row[c, FIRST + state.JN], row[c, SECOND + state.JN]
    soft = 0.25 * give * (k1 + k2) if gap <= 0.0 else 0.0
    tilt = TILT * soft
    j1, j2 = solve_two(
        k1 + soft + tilt, k12 + soft - tilt, k2 + soft + tilt,
        v1 - k1 * n1 - k12 * n2, v2 - k12 * n1 - k2 * n2,
    )  # fmt: skip
    row[c, FIRST + state.JN], row[c, SECOND + state.JN] = j1, j2
    return j1 - n1, j2 - n2


@inner_kernel
def sweep_contacts(rows, motion, springs, pushing, noting):
    """One sweep: normal impulses, then friction.

    springs: rate, mass and softness of overlap between two that move, and against what cannot; fastest push
    (m/s); 1/h. pushing: overlap drives bodies apart, else it is left. noting: largest impulses are noted.
    """
    row, ends, rare = rows.rows, rows.ends, rows.rare
    for c in range(rows.count[0]):
        a, b = np.uint64(ends[c, state.END_A]), np.uint64(ends[c, state.END_B])
        nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
        iia, iib, wa, wb = (
            row[c, state.ROW_IIA],
            row[c, state.ROW_IIB],
            motion[a, state.W],
            motion[b, state.W],
        )
        x, y = motion[b, state.VX] - motion[a, state.VX], motion[b, state.VY] - motion[a, state.VY]
        speeds, ut = (x * nx + y * ny, wa, wb), x * ny - y * nx
        gone = (motion[b, state.DX] - motion[a, state.DX]) * nx + (
            motion[b, state.DY] - motion[a, state.DY]
        ) * ny
        turns = motion[a, state.DC] - 1.0, motion[a, state.DS], motion[b, state.DC] - 1.0, motion[b, state.DS]
        gone += turns[2] * row[c, state.ROUND_B] - turns[0] * row[c, state.ROUND_A]
        spring = (0.0, 1.0, 0.0)
        if pushing:
            spring = springs[1] if row[c, state.ROW_HARD] > 0.0 else springs[0]
        law = (spring[0], springs[2], springs[3], pushing)
        v1, gap = closing(row, c, FIRST, gone, turns, speeds, law)
        ca1, cb1, da1, db1 = levers(row, c, FIRST)
        if ends[c, state.END_POINTS] == 1:
            k1, n1 = row[c, FIRST + state.STIFF_N], row[c, FIRST + state.JN]
            j1 = max((k1 * n1 - v1) / (k1 + (k1 * spring[2] if gap <= 0.0 else 0.0)), 0.0)
            row[c, FIRST + state.JN] = j1
            jn = j1 - n1
            wa, wb = wa - iia * ca1 * jn, wb + iib * cb1 * jn
            jt = rub(row, c, FIRST, j1, ut - wb * db1 + wa * da1)
            wa, wb = wa + iia * da1 * jt, wb - iib * db1 * jt
        else:
            ca2, cb2, da2, db2 = levers(row, c, SECOND)
            v2, gap2 = closing(row, c, SECOND, gone, turns, speeds, law)
            n1, n2 = press_two(row, c, v1, v2, min(gap, gap2), spring[2])
            jn = n1 + n2
            wa, wb = wa - iia * (ca1 * n1 + ca2 * n2), wb + iib * (cb1 * n1 + cb2 * n2)
            jt = rub(row, c, FIRST, row[c, FIRST + state.JN], ut - wb * db1 + wa * da1)
            ut += (row[c, state.ROW_IMA] + row[c, state.ROW_IMB]) * jt
            wa, wb = wa + iia * da1 * jt, wb - iib * db1 * jt
            j = rub(row, c, SECOND, row[c, SECOND + state.JN], ut - wb * db2 + wa * da2)
            jt += j
            wa, wb = wa + iia * da2 * j, wb - iib * db2 * j
        if noting:
            note_most(row, rare, c, ends[c, state.END_POINTS])
        x, y = jn * nx + jt * ny, jn * ny - jt * nx
        motion[a, state.VX] -= row[c, state.ROW_IMA] * x
        motion[a, state.VY] -= row[c, state.ROW_IMA] * y
        motion[a, state.W] = wa
        motion[b, state.VX] += row[c, state.ROW_IMB] * x
        motion[b, state.VY] += row[c, state.ROW_IMB] * y
        motion[b, state.W] = wb


@inner_kernel
def levers(row, c, at):
    """r x n and r . n of the point at column ``at``: crosses of a and b, dots of a and b."""
    return (
        row[c, at + state.CROSS_A],
        row[c, at + state.CROSS_B],
        row[c, at + state.DOT_A],
        row[c, at + state.DOT_B],
    )


@inner_kernel
def note_most(row, rare, c, points):
    """The largest normal impulse of each point so far."""
    rare[c, state.MOST_0] = max(rare[c, state.MOST_0], row[c, FIRST + state.JN])
    if points == 2:
        rare[c, state.MOST_1] = max(rare[c, state.MOST_1], row[c, SECOND + state.JN])


@inner_kernel
def gap_speed(row, c, at, motion, a, b):
    """Speed at which the gap of one point of a row opens, m/s."""
    vx, vy = motion[b, state.VX] - motion[a, state.VX], motion[b, state.VY] - motion[a, state.VY]
    speed = vx * row[c, state.ROW_NX] + vy * row[c, state.ROW_NY]
    return (
        speed
        + motion[b, state.W] * row[c, at + state.CROSS_B]
        - motion[a, state.W] * row[c, at + state.CROSS_A]
    )


@inner_kernel
def push_point(row, c, at, motion, a, b, jn, jt):
    """Impulses along normal and tangent (N s) at one point of a row."""
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    x, y = jn * nx + jt * ny, jn * ny - jt * nx
    motion[a, state.VX] -= row[c, state.ROW_IMA] * x
    motion[a, state.VY] -= row[c, state.ROW_IMA] * y
    motion[a, state.W] -= row[c, state.ROW_IIA] * (
        row[c, at + state.CROSS_A] * jn - row[c, at + state.DOT_A] * jt
    )
    motion[b, state.VX] += row[c, state.ROW_IMB] * x
    motion[b, state.VY] += row[c, state.ROW_IMB] * y
    motion[b, state.W] += row[c, state.ROW_IIB] * (
        row[c, at + state.CROSS_B] * jn - row[c, at + state.DOT_B] * jt
    )
