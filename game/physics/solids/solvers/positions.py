"""What solvers of positions share: gaps and slides by what bodies have moved, impulses that move places.

Their impulses are per square of the substep while they work: j moves a body by j / m (kg m).
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import state
from game.physics.solids.solvers.impulses import gap_now
from game.physics.solids.solvers.motion import cosine_sine


@inner_kernel
def remember(motion, before):
    """Keep where all bodies are at the beginning of a substep."""
    for i in range(motion.shape[0]):
        for n in range(motion.shape[1]):
            before[i, n] = motion[i, n]


@inner_kernel
def remember_places(motion, before):
    """Where ways begin: impacts have put bodies to where their new velocities would have come from."""
    for i in range(motion.shape[0]):
        for n in (state.DX, state.DY, state.DC, state.DS, state.DA):
            before[i, n] = motion[i, n]


@inner_kernel
def note_gaps(rows, motion, points):
    """Gaps of both points at the beginning of a substep: columns 0 and 1 of points."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            points[c, k] = gap_now(
                rows.rows, c, at, motion, rows.ends[c, state.END_A], rows.ends[c, state.END_B]
            )


@inner_kernel
def clear_impulses(rows):
    """A substep begins without impulses."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, state.END_POINTS]):
            at = state.ROW_POINT + k * state.ROW_POINT_WIDTH
            rows.rows[c, at + state.JN], rows.rows[c, at + state.JT] = 0.0, 0.0


@inner_kernel
def slide_now(row, c, at, a, b, motion, before):
    """How far b's surface has slid over a's since ``before``, m; to first order in turns."""
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    dx = motion[b, state.DX] - before[b, state.DX] - motion[a, state.DX] + before[a, state.DX]
    dy = motion[b, state.DY] - before[b, state.DY] - motion[a, state.DY] + before[a, state.DY]
    slid = dx * ny - dy * nx
    slid -= (motion[b, state.DA] - before[b, state.DA]) * row[c, at + state.DOT_B]
    return slid + (motion[a, state.DA] - before[a, state.DA]) * row[c, at + state.DOT_A]


@inner_kernel
def turn_body(motion, i, angle):
    """Turn a body by an angle, rad."""
    if angle != 0.0:
        motion[i, state.DA] += angle
        motion[i, state.DC], motion[i, state.DS] = cosine_sine(motion[i, state.DA])


@inner_kernel
def shift_point(row, c, at, motion, a, b, jn, jt):
    """Move both bodies of a point by jn along its normal and jt along its tangent, kg m."""
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    x, y = jn * nx + jt * ny, jn * ny - jt * nx
    motion[a, state.DX] -= row[c, state.ROW_IMA] * x
    motion[a, state.DY] -= row[c, state.ROW_IMA] * y
    motion[b, state.DX] += row[c, state.ROW_IMB] * x
    motion[b, state.DY] += row[c, state.ROW_IMB] * y
    turn_body(
        motion, a, -row[c, state.ROW_IIA] * (row[c, at + state.CROSS_A] * jn - row[c, at + state.DOT_A] * jt)
    )
    turn_body(
        motion, b, row[c, state.ROW_IIB] * (row[c, at + state.CROSS_B] * jn - row[c, at + state.DOT_B] * jt)
    )


@inner_kernel
def velocities_from_places(bodies, motion, before, h):
    """What was moved has the velocity of its way; what is led keeps the one that it was given."""
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            motion[i, state.VX] = (motion[i, state.DX] - before[i, state.DX]) / h
            motion[i, state.VY] = (motion[i, state.DY] - before[i, state.DY]) / h
            motion[i, state.W] = (motion[i, state.DA] - before[i, state.DA]) / h
