"""Rows of contacts for solvers, made in batches: eight pairs that share no moving body, side by side.

Pairs follow each other by colours (`pairs.order_by_colours`), so that neighbours are mostly free of each
other; a batch ends where one is not. What does not share a body can be solved in any order: a sweep over
batches gives what a sweep over rows gives, bit for bit. `copy_rows` is for what goes row by row.

A batch's last lanes, where pairs are too few, repeat its first pair without masses: they change nothing.
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import inner_kernel
from game.physics.kernels.lanes import (
    LANES,
    QUAD,
    any_of,
    choose,
    either,
    gather,
    larger,
    load,
    load_quads,
    root,
    smaller,
    store,
    store_quads,
    zeros,
)
from game.physics.solids.arrays import state
from game.physics.solids.arrays.state import BATCH_GAP, BATCH_MOST, BATCH_POINTS, BATCH_RARE

SIZE = state.BATCH_WIDTH * LANES  # numbers of a batch
# bits of Batches.kinds: it has a row of one point; one whose impulses are no guess; one that is not at rest
SINGLE, CHILLED, VIOLENT = 1, 2, 4
COLD = 30.0  # m/s², what closes faster than that in a step hits, it does not rest
RESTLESS = 10.0  # m/s², what parts or closes faster than that in a step is not at rest
MOST_COUPLING = 0.98  # of two points, as part of their own entries of K
FIRST, SECOND = state.ROW_POINT, state.ROW_POINT + state.ROW_POINT_WIDTH


@inner_kernel
def start_batches(batches):
    """None there yet."""
    batches.count[0], batches.filled[0], batches.kinds[0] = 0, 0, 0
    batches.lately[:] = -1


@inner_kernel(inline="always")
def add_row(bodies, shapes, contacts, p, rows, batches, motion, numbers):
    """Give a pair that has points the next row."""
    # inline: a call with so many arrays would take longer than what is done here; numbers without a sign
    # need no look at whether they count from the end
    i, j = np.uint64(contacts.bodies[p, 0]), np.uint64(contacts.bodies[p, 1])
    a, b = np.uint64(contacts.shapes[p, 0]), np.uint64(contacts.shapes[p, 1])
    k, lately = np.uint64(batches.count[0]), batches.lately
    shared = (lately[i] == k and bodies.inverse_masses[i] > 0.0) or (
        lately[j] == k and bodies.inverse_masses[j] > 0.0
    )
    if shared or batches.filled[k] == LANES:
        finish_batch(frames_of(bodies, motion), contacts.manifolds, batches, limits_of(numbers))
        k = np.uint64(batches.count[0])
    lately[i], lately[j] = k, k
    c, lane = np.uint64(rows.count[0]), np.uint64(batches.filled[k])
    points, values = contacts.marks[p, state.POINTS], batches.values
    rows.count[0] += 1
    batches.filled[k] += 1
    rows.ends[c, state.END_A], rows.ends[c, state.END_B] = i, j
    rows.ends[c, state.END_POINTS], rows.ends[c, state.END_PAIR] = points, p
    batches.rows[k, lane], batches.pairs[k, lane] = c, p
    batches.ends[k, state.END_A, lane], batches.ends[k, state.END_B, lane] = i, j
    values[k, state.ROW_MU, lane] = numbers.friction * math.sqrt(shapes.frictions[a] * shapes.frictions[b])
    values[k, state.ROUND_A, lane], values[k, state.ROUND_B, lane] = -shapes.radii[a], shapes.radii[b]
    values[k, BATCH_RARE + state.RESTITUTION, lane] = max(shapes.restitutions[a], shapes.restitutions[b])
    values[k, BATCH_POINTS, lane] = points
    if points == 1:
        batches.kinds[k] |= SINGLE


@inner_kernel(inline="always")
def frames_of(bodies, motion):
    """Of bodies, what rows are made of: each array is a handful of arguments of a call.

    motion: as `note_places` leaves it.
    """
    return motion, bodies.inverse_masses, bodies.inverse_inertias


@inner_kernel
def note_places(bodies, motion):
    """Velocities and places of all bodies to motion, until a step begins: each in one line of memory."""
    for i in range(motion.shape[0]):
        motion[i, state.VX], motion[i, state.VY] = bodies.velocities[i, 0], bodies.velocities[i, 1]
        motion[i, state.W], motion[i, state.DA] = bodies.spins[i], bodies.angles[i]
        motion[i, state.DX], motion[i, state.DY] = bodies.positions[i, 0], bodies.positions[i, 1]
        motion[i, state.DC], motion[i, state.DS] = bodies.rotations[i, 0], bodies.rotations[i, 1]


@inner_kernel(inline="always")
def limits_of(numbers):
    """Speed of closing (m/s) and rate of parting (1/s) by which contacts count as hits, fastest push, and
    speed (m/s) beyond which they are not at rest.
    """
    return -COLD * numbers.dt, numbers.contact_rate, -numbers.push, RESTLESS * numbers.dt


@inner_kernel
def finish_batch(frames, kept, batches, limits):
    """Numbers of the batch that was being filled, if it has any rows; the next one begins.

    frames, limits: `frames_of`, `limits_of`. kept: manifolds.
    """
    k, values = batches.count[0], batches.values
    if batches.filled[k] == 0:
        return
    for lane in range(batches.filled[k], LANES):
        batches.rows[k, lane], batches.pairs[k, lane] = batches.rows[k, 0], batches.pairs[k, 0]
        for column in (
            state.ROW_MU,
            state.ROUND_A,
            state.ROUND_B,
            BATCH_RARE + state.RESTITUTION,
            BATCH_POINTS,
        ):
            values[k, column, lane] = values[k, column, 0]
        for end in (state.END_A, state.END_B):
            batches.ends[k, end, lane] = batches.ends[k, end, 0]
    write_batch(frames, kept, batches, k, limits)
    for lane in range(batches.filled[k], LANES):
        for column in (state.ROW_IMA, state.ROW_IIA, state.ROW_IMB, state.ROW_IIB):
            values[k, column, lane] = 0.0
    batches.count[0] = k + 1
    if k + 1 < batches.filled.shape[0]:
        batches.filled[k + 1], batches.kinds[k + 1] = 0, 0


@inner_kernel
def copy_rows(rows, batches):
    """What is in batches to rows, for solvers and measures that go row by row."""
    values = batches.values
    for k in range(batches.count[0]):
        for quad in range((state.ROW_WIDTH + QUAD - 1) // QUAD):
            column = min(quad * QUAD, state.ROW_WIDTH - QUAD)
            at = k * SIZE + column * LANES
            four = (
                load(values, at), load(values, at + LANES), load(values, at + 2 * LANES),
                load(values, at + 3 * LANES),
            )  # fmt: skip
            store_quads(rows.rows, state.ROW_WIDTH, batches.rows, k * LANES, column, four)
    copy_rare(rows, batches)
    rows.count[1] = 1


@inner_kernel
def copy_rare(rows, batches):
    """Of `copy_rows`, what is in Rows.rare."""
    rare, values = rows.rare, batches.values
    for k in range(batches.count[0]):
        for lane in range(batches.filled[k]):
            c = np.uint64(batches.rows[k, lane])
            for column in range(state.MOST_0):
                rare[c, column] = values[k, BATCH_RARE + column, lane]
            rare[c, state.MOST_0], rare[c, state.MOST_1] = (
                values[k, BATCH_MOST, lane],
                values[k, BATCH_MOST + 1, lane],
            )


@inner_kernel
def kinds_seen(batches):
    """Bits of all batches."""
    seen = 0
    for k in range(batches.count[0]):
        seen |= batches.kinds[k]
    return seen


@inner_kernel
def write_point(values, at, point, frames, masses, place):
    """Columns of a point from ``point`` on; its gap and the speed at which that opens.

    frames: cosines and sines of a and b, from a to b, normal, velocity of b against a, spins of a and b.
    masses: inverse masses together, inverse inertias of a and b. place: in the frames of a and of b, gap
    when found, impulses.
    """
    ca, sa, cb, sb, dx, dy, nx, ny, vx, vy, wa, wb = frames
    both, iia, iib = masses
    px, py, qx, qy, found, jn, jt = place
    ax, ay = ca * px - sa * py, sa * px + ca * py
    bx, by = dx + cb * qx - sb * qy, dy + sb * qx + cb * qy
    gap = found + (bx - ax) * nx + (by - ay) * ny
    mx, my = 0.5 * (ax + bx), 0.5 * (ay + by)
    ex, ey = mx - dx, my - dy
    cross_a, cross_b = mx * ny - my * nx, ex * ny - ey * nx
    open_half = 0.5 * larger(gap, 0.0)  # what is still apart will meet surface to surface
    dot_a, dot_b = mx * nx + my * ny - open_half, ex * nx + ey * ny + open_half
    at = at + point * LANES
    store(values, at + state.CROSS_A * LANES, cross_a)
    store(values, at + state.CROSS_B * LANES, cross_b)
    store(values, at + state.DOT_A * LANES, dot_a)
    store(values, at + state.DOT_B * LANES, dot_b)
    store(values, at + state.SEP * LANES, gap)
    store(values, at + state.STIFF_N * LANES, both + iia * cross_a * cross_a + iib * cross_b * cross_b)
    store(values, at + state.MASS_T * LANES, 1.0 / (both + iia * dot_a * dot_a + iib * dot_b * dot_b))
    store(values, at + state.JN * LANES, jn)
    store(values, at + state.JT * LANES, jt)
    return gap, vx * nx + vy * ny + wb * cross_b - wa * cross_a


@inner_kernel(inline="always")
def write_batch(frames, kept, batches, k, limits):
    """What solvers read of the pairs of batch k."""
    motion, inverse_masses, inverse_inertias = frames
    values, ends, pairs = batches.values, batches.ends, batches.pairs
    at, one, a, b = k * SIZE, k * LANES, 2 * k * LANES, (2 * k + 1) * LANES
    lx, ly, pax, pay = load_quads(kept, state.MANIFOLD_WIDTH, pairs, one, 0)
    pbx, pby, found1, jn1 = load_quads(kept, state.MANIFOLD_WIDTH, pairs, one, 4)
    jt1, qax, qay, qbx = load_quads(kept, state.MANIFOLD_WIDTH, pairs, one, 8)
    qby, found2, jn2, jt2 = load_quads(kept, state.MANIFOLD_WIDTH, pairs, one, 12)
    vxa, vya, wa, xa = load_quads(motion, state.MOTION_WIDTH, ends, a, state.VX)
    vxb, vyb, wb, xb = load_quads(motion, state.MOTION_WIDTH, ends, b, state.VX)
    ya, ca, sa, _ = load_quads(motion, state.MOTION_WIDTH, ends, a, state.DY)
    yb, cb, sb, _ = load_quads(motion, state.MOTION_WIDTH, ends, b, state.DY)
    nx, ny = ca * lx - sa * ly, sa * lx + ca * ly
    dx, dy, vx, vy = xb - xa, yb - ya, vxb - vxa, vyb - vya
    ima, imb = gather(inverse_masses, 1, ends, a, 0), gather(inverse_masses, 1, ends, b, 0)
    iia, iib = gather(inverse_inertias, 1, ends, a, 0), gather(inverse_inertias, 1, ends, b, 0)
    store(values, at + state.ROW_NX * LANES, nx)
    store(values, at + state.ROW_NY * LANES, ny)
    store(values, at + state.ROW_HARD * LANES, choose(either(ima <= 0.0, imb <= 0.0), 1.0, zeros()))
    store(values, at + state.ROW_IMA * LANES, ima)
    store(values, at + state.ROW_IMB * LANES, imb)
    store(values, at + state.ROW_IIA * LANES, iia)
    store(values, at + state.ROW_IIB * LANES, iib)
    given, masses = (ca, sa, cb, sb, dx, dy, nx, ny, vx, vy, wa, wb), (ima + imb, iia, iib)
    gap1, opens1 = write_point(values, at, FIRST, given, masses, (pax, pay, pbx, pby, found1, jn1, jt1))
    gap2, opens2 = write_point(values, at, SECOND, given, masses, (qax, qay, qbx, qby, found2, jn2, jt2))
    fastest, deepest = smaller(zeros(), opens1), smaller(zeros(), gap1)
    most2, lowest2 = smaller(fastest, opens2), smaller(deepest, gap2)
    stir = larger(opens1, -opens1)
    stir2 = larger(stir, larger(opens2, -opens2))
    if batches.kinds[k] & SINGLE:
        single = load(values, at + BATCH_POINTS * LANES) < 2.0
        most2, lowest2 = choose(single, fastest, most2), choose(single, deepest, lowest2)
        stir2 = choose(single, stir, stir2)
        clear_second(values, at, single)
    cold = either(most2 < limits[0], limits[1] * lowest2 < limits[2])
    store(values, at + (BATCH_RARE + state.APPROACH_0) * LANES, opens1)
    store(values, at + (BATCH_RARE + state.APPROACH_1) * LANES, opens2)
    store(values, at + (BATCH_RARE + state.IMPACT) * LANES, choose(cold, 1.0, zeros()))
    couple(values, at, ima + imb, iia, iib)
    for point in range(2):
        sep = at + (FIRST + state.SEP + point * state.ROW_POINT_WIDTH) * LANES
        store(values, at + (BATCH_GAP + point) * LANES, load(values, sep))
        store(values, at + (BATCH_MOST + point) * LANES, zeros())
    if any_of(cold):
        batches.kinds[k] |= CHILLED
    if any_of(either(cold, stir2 > limits[3])):
        batches.kinds[k] |= VIOLENT


@inner_kernel
def clear_second(values, at, single):
    """Make the second points of rows that have none such as change nothing."""
    for column in (
        state.CROSS_A,
        state.CROSS_B,
        state.DOT_A,
        state.DOT_B,
        state.SEP,
        state.MASS_T,
        state.JN,
        state.JT,
    ):
        place = at + (SECOND + column) * LANES
        store(values, place, choose(single, zeros(), load(values, place)))
    place = at + (SECOND + state.STIFF_N) * LANES
    store(values, place, choose(single, 1.0, load(values, place)))


@inner_kernel
def couple(values, at, both, iia, iib):
    """Entry of K of both points. both: inverse masses together."""
    first, second = at + FIRST * LANES, at + SECOND * LANES
    crosses = iia * load(values, first + state.CROSS_A * LANES) * load(values, second + state.CROSS_A * LANES)
    crosses = crosses + iib * load(values, first + state.CROSS_B * LANES) * load(
        values, second + state.CROSS_B * LANES
    )
    k1, k2 = load(values, first + state.STIFF_N * LANES), load(values, second + state.STIFF_N * LANES)
    # two points that nearly coincide would make K singular: a little less coupling, the same solution
    most = MOST_COUPLING * root(k1 * k2)
    store(values, at + state.COUPLING * LANES, smaller(most, larger(-most, both + crosses)))
