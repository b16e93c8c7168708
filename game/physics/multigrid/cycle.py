"""A V-cycle over all levels, in one kernel (Brandt 1977; Trottenberg, Oosterlee and Schueller 2001)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, kernel
from game.physics.multigrid.levels import JOINED, Axis, axis_tables, levels_of
from game.physics.multigrid.smoothing import FACTORS, begin, find_plain, relax, residual, wrap_ghosts
from game.physics.multigrid.transfer import invert_diagonal, prolong, restrict
from game.physics.multigrid.walls import (
    choose_cells,
    coarsen_x,
    coarsen_y,
    list_irregular,
    prolong_irregular,
    restrict_irregular,
)

LAST_PAIRS = 8  # of sweeps on the coarsest level, which has at most two by two cells


class Places(NamedTuple):
    """Sizes of the levels, and where each begins in the arrays: (levels,) each."""

    rows: Longs
    columns: Longs
    padded: Longs  # in p, q, r
    cells: Longs  # in b, inverse, norm
    x: Longs  # in cx
    y: Longs  # in cy
    row: Longs  # in plain


class Hierarchy(NamedTuple):
    """All levels, finest first; each array holds those of all levels one after the other."""

    at: Places
    p: Floats
    q: Floats
    r: Floats
    b: Floats
    inverse: Floats
    norm: Floats
    cx: Floats
    cy: Floats
    x: Axis
    y: Axis
    row: Floats  # space for a row
    plain: Longs  # (rows of all levels, 2) of each row, a run of cells whose faces all conduct 1
    stands: Longs  # as the cells: whether a coarse cell stands for it
    ways: Longs  # of irregular cells, from where each level's cells begin
    listed: Longs
    irregular: Longs  # (levels,) how many
    joined: NDArray[np.bool_]  # (2,) whether x, y are periodic


def make_hierarchy(nx: int, ny: int, ends: tuple[int, int, int, int]) -> Hierarchy:
    """For ny rows and nx columns; ends (of levels.py) at left, right, bottom, top."""
    count = levels_of(nx, ny)
    columns, x = axis_tables(nx, count, ends[:2])
    rows, y = axis_tables(ny, count, ends[2:])
    wide, high = np.array(columns), np.array(rows)
    sizes = [(high + 2) * (wide + 2), high * wide, high * (wide + 1), (high + 1) * wide, high]
    starts = [np.concatenate([[0], np.cumsum(size)[:-1]]).astype(np.int64) for size in sizes]
    totals = [int(np.sum(size)) for size in sizes]
    return Hierarchy(
        Places(high.astype(np.int64), wide.astype(np.int64), *starts),
        np.zeros(totals[0]), np.zeros(totals[0]), np.zeros(totals[0]),
        np.zeros(totals[1]), np.zeros(totals[1]), np.zeros(totals[1]),
        np.zeros(totals[2]), np.zeros(totals[3]), x, y, np.zeros(nx + 2),
        np.zeros((totals[4], 2), np.int64),
        np.zeros(totals[1], np.int64), np.zeros(totals[1], np.int64), np.zeros(totals[1], np.int64),
        np.zeros(count, np.int64),
        np.array([ends[0] == JOINED, ends[2] == JOINED]),
    )  # fmt: skip


@kernel(inline="always")
def padded(array, at, level):
    """A level of p, q or r, (ny + 2, nx + 2)."""
    ny, nx, start = at.rows[level] + 2, at.columns[level] + 2, at.padded[level]
    return array[start : start + ny * nx].reshape(ny, nx)


@kernel(inline="always")
def cells(array, at, level):
    """A level of b, inverse or norm, (ny, nx)."""
    ny, nx, start = at.rows[level], at.columns[level], at.cells[level]
    return array[start : start + ny * nx].reshape(ny, nx)


@kernel(inline="always")
def faces_x(array, at, level):
    """A level of cx (ny, nx + 1)."""
    ny, nx, start = at.rows[level], at.columns[level] + 1, at.x[level]
    return array[start : start + ny * nx].reshape(ny, nx)


@kernel(inline="always")
def faces_y(array, at, level):
    """A level of cy (ny + 1, nx)."""
    ny, nx, start = at.rows[level] + 1, at.columns[level], at.y[level]
    return array[start : start + ny * nx].reshape(ny, nx)


@kernel(inline="always")
def plain_rows(h, level):
    """A level of plain (ny, 2)."""
    start = h.at.row[level]
    return h.plain[start : start + h.at.rows[level]]


@kernel(inline="always")
def up_tables(axis, level, fine):
    """near, far, share, even of a level with so many fine cells."""
    at = axis.fine_at[level]
    return axis.near[at : at + fine], axis.far[at : at + fine], axis.share[at : at + fine], axis.even[level]


@kernel(inline="always")
def down_tables(axis, level, coarse):
    """members, gather, even of a level with so many coarse cells."""
    at = axis.coarse_at[level]
    return axis.members[at : at + coarse], axis.gather[at : at + coarse], axis.even[level]


@kernel
def coarsen_all(h, cx, cy):
    """Conductances, diagonals and weights of all levels from the finest's cx and cy."""
    h.cx[: cx.size] = cx.reshape(-1)
    h.cy[: cy.size] = cy.reshape(-1)
    invert_diagonal(faces_x(h.cx, h.at, 0), faces_y(h.cy, h.at, 0), cells(h.inverse, h.at, 0))
    for level in range(h.at.rows.size - 1):
        ny, nx = h.at.rows[level + 1], h.at.columns[level + 1]
        mx, my = down_tables(h.x, level, nx)[0], down_tables(h.y, level, ny)[0]
        cx, cy, inverse = (
            faces_x(h.cx, h.at, level),
            faces_y(h.cy, h.at, level),
            cells(h.inverse, h.at, level),
        )
        stands = cells(h.stands, h.at, level)
        choose_cells(stands, inverse, cx, cy, mx, my)
        at = h.x.face_at[level]
        coarsen_x(cx, faces_x(h.cx, h.at, level + 1), stands, h.x.mid[at:], h.x.ratio[at:], my)
        at = h.y.face_at[level]
        coarsen_y(cy, faces_y(h.cy, h.at, level + 1), stands, h.y.mid[at:], h.y.ratio[at:], mx)
        invert_diagonal(
            faces_x(h.cx, h.at, level + 1), faces_y(h.cy, h.at, level + 1), cells(h.inverse, h.at, level + 1)
        )
        x, y = up_tables(h.x, level, h.at.columns[level]), up_tables(h.y, level, h.at.rows[level])
        at = h.at.cells[level]
        h.irregular[level] = list_irregular(
            cells(h.norm, h.at, level), h.ways[at:], h.listed[at:], stands, inverse, cx, cy, x, y
        )
    for level in range(h.at.rows.size):
        find_plain(faces_x(h.cx, h.at, level), faces_y(h.cy, h.at, level), plain_rows(h, level))


@inner_kernel
def _smooth(h, level, factor, back):
    """One sweep from p to q, or back."""
    source, goal = (h.q, h.p) if back else (h.p, h.q)
    field = padded(source, h.at, level)
    wrap_ghosts(field, h.joined[0], h.joined[1])
    relax(
        field, padded(goal, h.at, level), cells(h.b, h.at, level), faces_x(h.cx, h.at, level), faces_y(h.cy,
        h.at, level), cells(h.inverse, h.at, level), plain_rows(h, level), factor,
    )  # fmt: skip


@inner_kernel
def _down(h, level):
    """Smooth, and pass the residual on to the next level."""
    begin(padded(h.q, h.at, level), cells(h.b, h.at, level), cells(h.inverse, h.at, level), FACTORS[0])
    for k in range(1, 3):
        _smooth(h, level, FACTORS[k], k == 1)
    q, r, norm = padded(h.q, h.at, level), padded(h.r, h.at, level), cells(h.norm, h.at, level)
    wrap_ghosts(q, h.joined[0], h.joined[1])
    residual(
        q, r, cells(h.b, h.at, level), faces_x(h.cx, h.at, level), faces_y(h.cy, h.at, level),
        plain_rows(h, level),
    )  # fmt: skip
    at, count = h.at.cells[level], h.irregular[level]
    coarse = cells(h.b, h.at, level + 1)
    if count > 0:
        _keep_regular(r, norm, padded(h.p, h.at, level))
    wrap_ghosts(r, h.joined[0], h.joined[1])
    x = down_tables(h.x, level, h.at.columns[level + 1])
    y = down_tables(h.y, level, h.at.rows[level + 1])
    restrict(r, h.row, coarse, x, y)
    if count > 0:
        x, y = up_tables(h.x, level, h.at.columns[level]), up_tables(h.y, level, h.at.rows[level])
        whole = padded(h.p, h.at, level)
        restrict_irregular(whole, coarse, h.ways[at : at + count], h.listed[at : at + count], x, y)


@inner_kernel
def _keep_regular(r, norm, whole):
    """Copy r (padded by one) to whole, and keep of it only what is regular."""
    for j in range(norm.shape[0]):
        for i in range(norm.shape[1]):
            whole[j + 1, i + 1] = r[j + 1, i + 1]
            r[j + 1, i + 1] *= norm[j, i]


@inner_kernel
def _up(h, level):
    """Add the coarser level's correction, and smooth."""
    coarse, fine = padded(h.p, h.at, level + 1), padded(h.q, h.at, level)
    wrap_ghosts(coarse, h.joined[0], h.joined[1])
    x, y = up_tables(h.x, level, h.at.columns[level]), up_tables(h.y, level, h.at.rows[level])
    prolong(coarse, h.row, fine, cells(h.norm, h.at, level), x, y)
    at, count = h.at.cells[level], h.irregular[level]
    if count > 0:
        prolong_irregular(coarse, fine, h.ways[at : at + count], h.listed[at : at + count], x, y)
    for k in range(3):
        _smooth(h, level, FACTORS[2 - k], k != 1)


@inner_kernel
def v_cycle(h):
    """The finest p from 0, for the finest b."""
    last = h.at.rows.size - 1
    for level in range(last):
        _down(h, level)
    padded(h.p, h.at, last)[:] = 0.0
    for k in range(2 * LAST_PAIRS):
        _smooth(h, last, 1.0 if k % 2 == 0 else 0.5, k % 2 == 1)
    for level in range(last - 1, -1, -1):
        _up(h, level)
