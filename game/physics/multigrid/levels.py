"""Levels of coarser grids, and how values pass between them: the tables, made once for a size.

Along each axis two cells become one, and of an odd count the last three, so that any size will do. Widths
differ by less than a factor of two, and all tables are computed from the true places of the centres.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.multigrid.transfer import FAR, NEAR

CLOSED, OPEN_END, JOINED = range(3)  # how an axis ends: no flow, pressure 0 on the side, periodic


class Axis(NamedTuple):
    """Tables of one axis, those of all levels one after the other.

    From a fine cell i to coarse ones: near (n,), far (n,) their places (-1 and the count are ghosts) and the
    weights share (n, 2). From coarse cell I: members (m, 3) the first, last and middle fine cell, gather (m,
    5) the weights of the first, last, the ones before and behind, and the middle one. mid (m + 1,) the fine
    face that lies in a coarse face, ratio (m + 1,) the fine distance across it over the coarse one. even
    (levels, 2): the first and the last (not included) of a run of coarse cells, each made of two fine ones, 2
    I and 2 I + 1. They have the weights 3/4 and 1/4 of equal widths.
    """

    near: Longs
    far: Longs
    share: Floats
    members: Longs
    gather: Floats
    mid: Longs
    ratio: Floats
    fine_at: Longs  # (levels,) where a level's fine rows begin
    coarse_at: Longs  # (levels,) where its coarse rows begin
    face_at: Longs  # (levels,)
    even: Longs  # (levels, 2)


def _merged(count: int) -> list[list[int]]:
    """Which cells become one."""
    if count == 1:
        return [[0]]
    groups = [[2 * k, 2 * k + 1] for k in range(count // 2)]
    if count % 2:
        groups[-1].append(count - 1)
    return groups


def _centres(widths: Floats) -> Floats:
    return np.asarray(np.cumsum(widths) - 0.5 * widths)


def _up_table(widths: Floats, groups: list[list[int]], ends: tuple[int, int]):
    """near, far, share of each fine cell."""
    x, length = _centres(widths), float(np.sum(widths))
    coarse = np.array([np.sum(widths[group]) for group in groups])
    big, count = _centres(coarse), len(groups)
    near, far, share = [], [], []
    for k, group in enumerate(groups):
        for i in group:
            other = k - 1 if x[i] < big[k] else k + 1
            end = ends[0] if other < 0 else ends[1]
            if x[i] == big[k]:
                row = (k, k, 1.0, 0.0)
            elif 0 <= other < count or end == JOINED:
                place = big[other % count] + length * (other // count)
                weight = float(abs(x[i] - place) / abs(big[k] - place))
                row = (k, other, weight, 1.0 - weight)
            else:
                side = 0.0 if other < 0 else length
                row = (k, k, 1.0 if end == CLOSED else float(abs(x[i] - side) / abs(big[k] - side)), 0.0)
            near.append(row[0])
            far.append(row[1])
            share.append(row[2:])
    return np.array(near), np.array(far), np.array(share)


def _down_table(groups: list[list[int]], near: Longs, far: Longs, share: Floats):
    """members, gather of each coarse cell: the transpose."""
    count, fine = len(groups), len(near)
    members, gather = np.zeros((count, 3), np.int64), np.zeros((count, 5))
    for k, group in enumerate(groups):
        first, last = group[0], group[-1]
        members[k] = first, last, group[len(group) // 2]
        gather[k, 0] = share[first, 0]
        gather[k, 1] = share[last, 0] if last != first else 0.0
        gather[k, 4] = share[group[1], 0] if len(group) == 3 else 0.0
        before, behind = first - 1, last + 1
        if far[before % fine] == k + count * (before < 0) and far[before % fine] != near[before % fine]:
            gather[k, 2] = share[before % fine, 1]
        if far[behind % fine] == k - count * (behind >= fine) and far[behind % fine] != near[behind % fine]:
            gather[k, 3] = share[behind % fine, 1]
    return members, gather


def _even_run(members: Longs, gather: Floats) -> tuple[int, int]:
    """The longest run of coarse cells with the weights of equal widths: `Axis.even`."""
    k = np.arange(len(members))
    pairs = (members[:, 0] == 2 * k) & (members[:, 1] == 2 * k + 1)
    even = pairs & (gather == (NEAR, NEAR, FAR, FAR, 0.0)).all(axis=1)
    odd = np.flatnonzero(~np.concatenate([[False], even, [False]])) - 1  # with one at either end
    longest = int(np.argmax(np.diff(odd)))
    return int(odd[longest]) + 1, int(odd[longest + 1])


def _link_table(widths: Floats, groups: list[list[int]], ends: tuple[int, int]) -> tuple[Longs, Floats]:
    """mid and ratio of each coarse face."""
    coarse = np.array([np.sum(widths[group]) for group in groups])
    fine_gaps, gaps = _gaps(widths, ends), _gaps(coarse, ends)
    mid = np.array([group[0] for group in groups] + [len(widths)])
    return mid, fine_gaps[mid] / gaps


def _gaps(widths: Floats, ends: tuple[int, int]) -> Floats:
    """The distance of the centres at both sides of each face; from the side to the centre at open ends."""
    inner = 0.5 * (widths[:-1] + widths[1:])
    if ends[0] == JOINED:
        seam = 0.5 * (widths[0] + widths[-1])
        return np.concatenate([[seam], inner, [seam]])
    return np.concatenate([[0.5 * widths[0]], inner, [0.5 * widths[-1]]])


def axis_tables(count: int, levels: int, ends: tuple[int, int]) -> tuple[list[int], Axis]:
    """Cells of each level, and the tables, for so many levels; ends: how the axis ends, both ways."""
    widths, sizes = np.ones(count), [count]
    rows: list[tuple] = []
    starts, even = np.zeros((3, levels), np.int64), np.zeros((levels, 2), np.int64)
    for level in range(levels - 1):
        groups = _merged(len(widths))
        near, far, share = _up_table(widths, groups, ends)
        members, gather = _down_table(groups, near, far, share)
        mid, ratio = _link_table(widths, groups, ends)
        even[level] = _even_run(members, gather)
        rows.append((near, far, share, members, gather, mid, ratio))
        widths = np.array([np.sum(widths[group]) for group in groups])
        sizes.append(len(widths))
        starts[:, level + 1] = starts[:, level] + (sizes[-2], sizes[-1], sizes[-1] + 1)
    shapes = ((0,), (0,), (0, 2), (0, 3), (0, 5), (0,), (0,))
    tables = [np.concatenate([row[k] for row in rows]) if rows else np.zeros(shapes[k]) for k in range(7)]
    near, far, members, mid = (np.ascontiguousarray(tables[k], dtype=np.int64) for k in (0, 1, 3, 5))
    share, gather, ratio = (np.ascontiguousarray(tables[k], dtype=np.float64) for k in (2, 4, 6))
    at = [row.copy() for row in starts]
    return sizes, Axis(near, far, share, members, gather, mid, ratio, at[0], at[1], at[2], even)


def levels_of(nx: int, ny: int) -> int:
    """How many levels until no side has more than two cells."""
    count = 1
    while max(nx, ny) > 2:
        nx, ny, count = max(1, nx // 2), max(1, ny // 2), count + 1
    return count
