"""Energy in the springs of soft contacts: of each face, by how much it has sunk, eight of them at a time."""

from __future__ import annotations

import numpy as np

from game.compiler.decorator import inner_kernel
from game.physics.kernels.lanes import LANES, choose, load_quads, store
from game.physics.solids import rows
from game.physics.solids.arrays import state
from game.physics.solids.arrays.state import BATCH_GAP, BATCH_POINTS
from game.physics.solids.solvers.abreast import column, levers

STORED = 6  # column of Scratch.works: J, of one body, then of its group


@inner_kernel
def gaps_now(values, at, point, places_a, places_b):
    """`impulses.gap_now` of eight rows. point: its first column; places: DX, DY, DC, DS of a and b."""
    (ax, ay, ca, sa), (bx, by, cb, sb) = places_a, places_b
    cross_a, cross_b, dot_a, dot_b = levers(values, at, point)
    nx, ny = column(values, at, state.ROW_NX), column(values, at, state.ROW_NY)
    gap = column(values, at, point + state.SEP) + (bx - ax) * nx + (by - ay) * ny
    gap = gap + ((cb - 1.0) * (dot_b + column(values, at, state.ROUND_B)) + sb * cross_b)
    return gap - ((ca - 1.0) * (dot_a + column(values, at, state.ROUND_A)) + sa * cross_a)


@inner_kernel
def spring_energies(batches, motion, k, pull):
    """J in the springs of batch k, where they are now, to its gaps. pull: their frequency's square, 1/s²."""
    values, at = batches.values, k * rows.SIZE
    a = load_quads(motion, state.MOTION_WIDTH, batches.ends, 2 * k * LANES, state.DX)
    b = load_quads(motion, state.MOTION_WIDTH, batches.ends, (2 * k + 1) * LANES, state.DX)
    gap1, under1 = gaps_now(values, at, rows.FIRST, a, b), column(values, at, rows.FIRST + state.STIFF_N)
    gap = 0.5 * (gap1 + gaps_now(values, at, rows.SECOND, a, b))
    under = 0.25 * (under1 + column(values, at, rows.SECOND + state.STIFF_N))
    if batches.kinds[k] & rows.SINGLE:
        single = column(values, at, BATCH_POINTS) < 2.0
        gap, under = choose(single, gap1, gap), choose(single, under1, under)
    stiff = 0.5 * choose(column(values, at, state.ROW_HARD) > 0.0, 4.0 * pull, pull)
    store(values, at + BATCH_GAP * LANES, choose(gap < 0.0, stiff * gap * gap / under, 0.0))


@inner_kernel
def measure_springs(bodies, scratch, numbers):
    """Space (J) in the springs at each body, to works, and in all; what they hold beyond it is lost."""
    works, stored, batches, total = scratch.works, bodies.stored, scratch.batches, 0.0
    for i in range(stored.shape[0]):
        works[i, STORED] = 0.0
    for k in range(batches.count[0]):
        spring_energies(batches, scratch.motion, k, numbers.contact_pull)
        for lane in range(batches.filled[k]):
            a, b = (
                np.uint64(batches.ends[k, state.END_A, lane]),
                np.uint64(batches.ends[k, state.END_B, lane]),
            )
            held = batches.values[k, BATCH_GAP, lane]
            moves_a = batches.values[k, state.ROW_IMA, lane] > 0.0
            moves_b = batches.values[k, state.ROW_IMB, lane] > 0.0
            if moves_a:
                works[a, STORED] += 0.5 * held if moves_b else held
            if moves_b:
                works[b, STORED] += 0.5 * held if moves_a else held
    for i in range(stored.shape[0]):
        if bodies.flags[i] & state.ASLEEP:  # its contacts are not looked at
            works[i, STORED] = 0.0
            continue
        stored[i] = min(stored[i], works[i, STORED])
        works[i, STORED] -= stored[i]
        total += works[i, STORED]
    return total
