"""What solvers of positions share: gaps and slides by what bodies have moved, impulses that move places.

Their impulses are per square of the substep while they work: j moves a body by j / m (kg m).
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel
from game.physics.solids.solvers.impulses import gap_now
from game.physics.solids.solvers.motion import cosine_sine
from game.physics.solids.state import (
    CROSS_A,
    CROSS_B,
    DA,
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
    ROW_IIA,
    ROW_IIB,
    ROW_IMA,
    ROW_IMB,
    ROW_NX,
    ROW_NY,
    ROW_POINT,
    ROW_POINT_WIDTH,
    VX,
    VY,
    W,
)


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
        for n in (DX, DY, DC, DS, DA):
            before[i, n] = motion[i, n]


@inner_kernel
def note_gaps(rows, motion, points):
    """Gaps of both points at the beginning of a substep: columns 0 and 1 of points."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, END_POINTS]):
            at = ROW_POINT + k * ROW_POINT_WIDTH
            points[c, k] = gap_now(rows.rows, c, at, motion, rows.ends[c, END_A], rows.ends[c, END_B])


@inner_kernel
def clear_impulses(rows):
    """A substep begins without impulses."""
    for c in range(rows.count[0]):
        for k in range(rows.ends[c, END_POINTS]):
            at = ROW_POINT + k * ROW_POINT_WIDTH
            rows.rows[c, at + JN], rows.rows[c, at + JT] = 0.0, 0.0


@inner_kernel
def slide_now(row, c, at, a, b, motion, before):
    """How far b's surface has slid over a's since ``before``, m; to first order in turns."""
    nx, ny = row[c, ROW_NX], row[c, ROW_NY]
    dx = motion[b, DX] - before[b, DX] - motion[a, DX] + before[a, DX]
    dy = motion[b, DY] - before[b, DY] - motion[a, DY] + before[a, DY]
    slid = dx * ny - dy * nx
    slid -= (motion[b, DA] - before[b, DA]) * row[c, at + DOT_B]
    return slid + (motion[a, DA] - before[a, DA]) * row[c, at + DOT_A]


@inner_kernel
def turn_body(motion, i, angle):
    """Turn a body by an angle, rad."""
    if angle != 0.0:
        motion[i, DA] += angle
        motion[i, DC], motion[i, DS] = cosine_sine(motion[i, DA])


@inner_kernel
def shift_point(row, c, at, motion, a, b, jn, jt):
    """Move both bodies of a point by jn along its normal and jt along its tangent, kg m."""
    nx, ny = row[c, ROW_NX], row[c, ROW_NY]
    x, y = jn * nx + jt * ny, jn * ny - jt * nx
    motion[a, DX] -= row[c, ROW_IMA] * x
    motion[a, DY] -= row[c, ROW_IMA] * y
    motion[b, DX] += row[c, ROW_IMB] * x
    motion[b, DY] += row[c, ROW_IMB] * y
    turn_body(motion, a, -row[c, ROW_IIA] * (row[c, at + CROSS_A] * jn - row[c, at + DOT_A] * jt))
    turn_body(motion, b, row[c, ROW_IIB] * (row[c, at + CROSS_B] * jn - row[c, at + DOT_B] * jt))


@inner_kernel
def velocities_from_places(bodies, motion, before, h):
    """What was moved has the velocity of its way; what is led keeps the one that it was given."""
    for i in range(motion.shape[0]):
        if bodies.inverse_masses[i] > 0.0:
            motion[i, VX] = (motion[i, DX] - before[i, DX]) / h
            motion[i, VY] = (motion[i, DY] - before[i, DY]) / h
            motion[i, W] = (motion[i, DA] - before[i, DA]) / h
