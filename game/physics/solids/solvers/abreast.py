"""Contacts abreast: rows that share no moving body, eight in a batch, swept in one go.

Rows follow each other by colours (`pairs.order_by_colours`), so that neighbours are mostly free of each
other; a batch ends where one is not. What does not share a body can go in any order. So the result is that of
`impulses.start_warm` and `impulses.sweep_contacts`, bit for bit, in a fourth of the time. Impulses live here
while a solver runs; `put_back` gives them to the rows, `take_impulses` fetches them again.

A batch's last lanes, where rows are too few, repeat its first row without masses: they change nothing.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.kernels.lanes import (
    LANES,
    all_of,
    any_of,
    choose,
    either,
    larger,
    load,
    load_quads,
    smaller,
    store,
    store_quads,
)
from game.physics.solids import rows as r
from game.physics.solids.arrays import state
from game.physics.solids.arrays.state import BATCH_GAP, BATCH_MOST, BATCH_POINTS, BATCH_RARE
from game.physics.solids.solvers.impulses import OPEN, TILT


@inner_kernel
def put_back(rows, batches):
    """Impulses to their rows, and the largest that there were."""
    row, rare, values = rows.rows, rows.rare, batches.values
    for k in range(batches.count[0]):
        for lane in range(batches.filled[k]):
            c = batches.rows[k, lane]
            row[c, r.FIRST + state.JN] = values[k, r.FIRST + state.JN, lane]
            row[c, r.FIRST + state.JT] = values[k, r.FIRST + state.JT, lane]
            rare[c, state.MOST_0] = values[k, BATCH_MOST, lane]
            if rows.ends[c, state.END_POINTS] == 2:
                row[c, r.SECOND + state.JN] = values[k, r.SECOND + state.JN, lane]
                row[c, r.SECOND + state.JT] = values[k, r.SECOND + state.JT, lane]
                rare[c, state.MOST_1] = values[k, BATCH_MOST + 1, lane]


@inner_kernel
def take_impulses(rows, batches):
    """Impulses of the rows and the largest, where something else has changed them."""
    row, values = rows.rows, batches.values
    for k in range(batches.count[0]):
        for lane in range(batches.filled[k]):
            c = batches.rows[k, lane]
            values[k, r.FIRST + state.JN, lane], values[k, r.FIRST + state.JT, lane] = (
                row[c, r.FIRST + state.JN],
                row[c, r.FIRST + state.JT],
            )
            values[k, BATCH_MOST, lane] = rows.rare[c, state.MOST_0]
            if rows.ends[c, state.END_POINTS] == 2:
                values[k, r.SECOND + state.JN, lane] = row[c, r.SECOND + state.JN]
                values[k, r.SECOND + state.JT, lane] = row[c, r.SECOND + state.JT]
                values[k, BATCH_MOST + 1, lane] = rows.rare[c, state.MOST_1]


@inner_kernel
def column(values, at, number):
    """A column of the batch that begins at ``at``."""
    return load(values, at + number * LANES)


@inner_kernel
def levers(values, at, point):
    """See `impulses.levers`; point: its first column."""
    return (
        column(values, at, point + state.CROSS_A), column(values, at, point + state.CROSS_B),
        column(values, at, point + state.DOT_A), column(values, at, point + state.DOT_B),
    )  # fmt: skip


@inner_kernel
def warm_batches(batches, motion):
    """`impulses.start_warm`."""
    values, ends = batches.values, batches.ends
    for k in range(batches.count[0]):
        at, end = k * r.SIZE, 2 * k * LANES
        if batches.kinds[k] & r.CHILLED:
            cold = column(values, at, BATCH_RARE + state.IMPACT) > 0.0
            for number in (r.FIRST + state.JN, r.FIRST + state.JT, r.SECOND + state.JN, r.SECOND + state.JT):
                store(values, at + number * LANES, choose(cold, 0.0, column(values, at, number)))
        nx, ny = column(values, at, state.ROW_NX), column(values, at, state.ROW_NY)
        jn, jt = column(values, at, r.FIRST + state.JN), column(values, at, r.FIRST + state.JT)
        cross_a, cross_b, dot_a, dot_b = levers(values, at, r.FIRST)
        turn_a, turn_b = cross_a * jn - dot_a * jt, cross_b * jn - dot_b * jt
        n, t = column(values, at, r.SECOND + state.JN), column(values, at, r.SECOND + state.JT)
        cross_a, cross_b, dot_a, dot_b = levers(values, at, r.SECOND)
        turn_a, turn_b = turn_a + (cross_a * n - dot_a * t), turn_b + (cross_b * n - dot_b * t)
        jn, jt = jn + n, jt + t
        x, y = jn * nx + jt * ny, jn * ny - jt * nx
        vx, vy, w, far = load_quads(motion, state.MOTION_WIDTH, ends, end, state.VX)
        m = column(values, at, state.ROW_IMA)
        vx, vy, w = vx - m * x, vy - m * y, w - column(values, at, state.ROW_IIA) * turn_a
        store_quads(motion, state.MOTION_WIDTH, ends, end, state.VX, (vx, vy, w, far))
        vx, vy, w, far = load_quads(motion, state.MOTION_WIDTH, ends, end + LANES, state.VX)
        m = column(values, at, state.ROW_IMB)
        vx, vy, w = vx + m * x, vy + m * y, w + column(values, at, state.ROW_IIB) * turn_b
        store_quads(motion, state.MOTION_WIDTH, ends, end + LANES, state.VX, (vx, vy, w, far))


@inner_kernel
def solve_pairs(k11, k12, k22, r1, r2):
    """`impulses.solve_two`."""
    j1, j2 = k12 * r2 - k22 * r1, k12 * r1 - k11 * r2
    both = (j1 >= 0.0) & (j2 >= 0.0)
    under = 1.0 / (k11 * k22 - k12 * k12)
    j1, j2 = j1 * under, j2 * under
    if not all_of(both):
        j1, j2 = choose(both, j1, 0.0), choose(both, j2, 0.0)
        first = (r1 <= 0.0) & (r2 * k11 >= k12 * r1)
        second = (r2 <= 0.0) & (r1 * k22 >= k12 * r2)
        if any_of(either(first, second)):
            other1, other2 = choose(first, -r1 / k11, 0.0), choose(second, -r2 / k22, 0.0)
            j1, j2 = choose(both, j1, other1), choose(both, j2, choose(first, 0.0, other2))
    return j1, j2


@inner_kernel
def measure(values, at, a, b, ends, motion):
    """Gaps of both points now, by what bodies have moved since the step began (`impulses.closing`).

    a, b: where their numbers begin in ends.
    """
    ax, ay, ac, sa = load_quads(motion, state.MOTION_WIDTH, ends, a, state.VX + 3)
    bx, by, bc, sb = load_quads(motion, state.MOTION_WIDTH, ends, b, state.VX + 3)
    ta, tb = ac - 1.0, bc - 1.0
    gone = (bx - ax) * column(values, at, state.ROW_NX) + (by - ay) * column(values, at, state.ROW_NY)
    gone = gone + (tb * column(values, at, state.ROUND_B) - ta * column(values, at, state.ROUND_A))
    cross_a, cross_b, dot_a, dot_b = levers(values, at, r.FIRST)
    one = (
        gone + column(values, at, r.FIRST + state.SEP) + tb * dot_b + sb * cross_b - ta * dot_a - sa * cross_a
    )
    cross_a, cross_b, dot_a, dot_b = levers(values, at, r.SECOND)
    two = (
        gone
        + column(values, at, r.SECOND + state.SEP)
        + tb * dot_b
        + sb * cross_b
        - ta * dot_a
        - sa * cross_a
    )
    store(values, at + BATCH_GAP * LANES, one)
    store(values, at + (BATCH_GAP + 1) * LANES, two)
    return one, two


@inner_kernel
def rub(values, at, point, mu, pressing, slide):
    """`impulses.rub`."""
    before, most = column(values, at, point + state.JT), mu * pressing
    j = larger(-most, smaller(most, before - column(values, at, point + state.MASS_T) * slide))
    store(values, at + (point + state.JT) * LANES, j)
    return j - before


@inner_kernel
def unless_open(values, at, point, gap, law):
    """`impulses.unless_open`."""
    return choose((gap > 0.0) & (column(values, at, point + state.JN) <= 0.0), OPEN, law)


@inner_kernel
def gaps_of(values, at, a, b, ends, motion, measuring):
    """Gaps of both points, measured again where bodies were moved."""
    if measuring:
        return measure(values, at, a, b, ends, motion)
    return column(values, at, BATCH_GAP), column(values, at, BATCH_GAP + 1)


@inner_kernel
def soften(values, at, gap1, gap2, stiff, springs):
    """Speeds at which springs push both points out; k11, k12, k22 of both with the springs' give; k of one
    alone.

    stiff: k11, k12, k22 of rigid contacts.
    """
    k1, k12, k2 = stiff
    hard = column(values, at, state.ROW_HARD) > 0.0
    rate, give = choose(hard, springs[1][0], springs[0][0]), choose(hard, springs[1][2], springs[0][2])
    push1 = larger(rate * smaller(gap1, 0.0), -springs[2])
    push2 = larger(rate * smaller(gap2, 0.0), -springs[2])
    soft = choose(smaller(gap1, gap2) <= 0.0, 0.25 * give * (k1 + k2), 0.0)
    tilt = TILT * soft
    alone = k1 + choose(gap1 <= 0.0, k1 * give, 0.0)
    return push1, push2, (k1 + soft + tilt, k12 + soft - tilt, k2 + soft + tilt), alone


@inner_kernel
def press(values, at, gaps, speeds, arms, springs, pushing, singles):
    """Normal impulses of both points, stored; what they are in all, and what they turn a and b by.

    speeds: along the normal, spins of a and b. arms: levers of both points. singles: some have one point.
    """
    gap1, gap2 = gaps
    un, wa, wb = speeds
    ca1, cb1, ca2, cb2 = arms[0][0], arms[0][1], arms[1][0], arms[1][1]
    law1, law2 = larger(gap1, 0.0) * springs[3], larger(gap2, 0.0) * springs[3]
    k1, k2 = column(values, at, r.FIRST + state.STIFF_N), column(values, at, r.SECOND + state.STIFF_N)
    k12 = column(values, at, state.COUPLING)
    matrix, alone = (k1, k12, k2), k1
    if pushing:
        push1, push2, matrix, alone = soften(values, at, gap1, gap2, matrix, springs)
        law1, law2 = law1 + push1, law2 + push2
    else:
        law1 = unless_open(values, at, r.FIRST, gap1, law1)
        law2 = unless_open(values, at, r.SECOND, gap2, law2)
    v1, v2 = un + wb * cb1 - wa * ca1 + law1, un + wb * cb2 - wa * ca2 + law2
    n1, n2 = column(values, at, r.FIRST + state.JN), column(values, at, r.SECOND + state.JN)
    r1, r2 = v1 - k1 * n1 - k12 * n2, v2 - k12 * n1 - k2 * n2
    j1, j2 = solve_pairs(matrix[0], matrix[1], matrix[2], r1, r2)
    iia, iib = column(values, at, state.ROW_IIA), column(values, at, state.ROW_IIB)
    d1, d2 = j1 - n1, j2 - n2
    jn, turn_a, turn_b = d1 + d2, iia * (ca1 * d1 + ca2 * d2), iib * (cb1 * d1 + cb2 * d2)
    if singles:
        single = column(values, at, BATCH_POINTS) < 2.0
        only = larger((k1 * n1 - v1) / alone, 0.0)
        j1, j2 = choose(single, only, j1), choose(single, 0.0, j2)
        jn = choose(single, only - n1, jn)
        turn_a, turn_b = choose(single, iia * ca1 * jn, turn_a), choose(single, iib * cb1 * jn, turn_b)
    store(values, at + (r.FIRST + state.JN) * LANES, j1)
    store(values, at + (r.SECOND + state.JN) * LANES, j2)
    return j1, j2, jn, turn_a, turn_b


@inner_kernel
def note_most(values, at, j1, j2):
    """Keep the largest normal impulses of both points."""
    store(values, at + BATCH_MOST * LANES, larger(column(values, at, BATCH_MOST), j1))
    store(values, at + (BATCH_MOST + 1) * LANES, larger(column(values, at, BATCH_MOST + 1), j2))


@inner_kernel
def sweep_batches(batches, motion, springs, pushing, measuring):
    """`impulses.sweep_contacts`. measuring: bodies were moved; a sweep that does not push notes the largest
    impulses.
    """
    values, ends = batches.values, batches.ends
    for k in range(batches.count[0]):
        at, a, b = k * r.SIZE, 2 * k * LANES, (2 * k + 1) * LANES
        gaps = gaps_of(values, at, a, b, ends, motion, measuring)
        nx, ny = column(values, at, state.ROW_NX), column(values, at, state.ROW_NY)
        ax, ay, wa, far_a = load_quads(motion, state.MOTION_WIDTH, ends, a, state.VX)
        bx, by, wb, far_b = load_quads(motion, state.MOTION_WIDTH, ends, b, state.VX)
        x, y = bx - ax, by - ay
        un, ut = x * nx + y * ny, x * ny - y * nx
        arms = levers(values, at, r.FIRST), levers(values, at, r.SECOND)
        da1, db1, da2, db2 = arms[0][2], arms[0][3], arms[1][2], arms[1][3]
        singles = batches.kinds[k] & r.SINGLE != 0
        speeds = un, wa, wb
        j1, j2, jn, turn_a, turn_b = press(values, at, gaps, speeds, arms, springs, pushing, singles)
        wa, wb = wa - turn_a, wb + turn_b
        mu = column(values, at, state.ROW_MU)
        ima, imb = column(values, at, state.ROW_IMA), column(values, at, state.ROW_IMB)
        iia, iib = column(values, at, state.ROW_IIA), column(values, at, state.ROW_IIB)
        jt = rub(values, at, r.FIRST, mu, j1, ut - wb * db1 + wa * da1)
        ut = ut + (ima + imb) * jt
        wa, wb = wa + iia * da1 * jt, wb - iib * db1 * jt
        j = rub(values, at, r.SECOND, mu, j2, ut - wb * db2 + wa * da2)
        jt = jt + j
        wa, wb = wa + iia * da2 * j, wb - iib * db2 * j
        if not pushing:
            note_most(values, at, j1, j2)
        x, y = jn * nx + jt * ny, jn * ny - jt * nx
        store_quads(motion, state.MOTION_WIDTH, ends, a, state.VX, (ax - ima * x, ay - ima * y, wa, far_a))
        store_quads(motion, state.MOTION_WIDTH, ends, b, state.VX, (bx + imb * x, by + imb * y, wb, far_b))
