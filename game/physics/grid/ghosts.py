"""Rows and columns of ghosts around padded fields, by what holds at the sides.

A padded field has PAD ghosts before its first and after its last value, each way. Along the axis on which
its first value lies on the side itself (u across left and right) it is *nodal*, else cell-centred.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, kernel
from game.physics.grid import borders
from game.physics.grid.layout import PAD

X, Y = 0, 1  # which component of the velocity a padded field holds


@inner_kernel
def _nodal(edge, inner, far, kind):
    """A ghost behind a value on the side: a wall reflects it odd, a periodic side goes on."""
    if kind == borders.PERIODIC:
        return far
    if kind in (borders.WALL, borders.NO_SLIP):
        return 2.0 * edge - inner
    return edge


@inner_kernel
def _centred(edge, inner, far, kind, along):
    """A ghost behind cell values: even at a slippery wall, such that an inflow has its value on the side."""
    if kind == borders.PERIODIC:
        return far
    if kind == borders.INFLOW:
        return 2.0 * along - inner
    if kind == borders.WALL:
        return inner
    return edge


@inner_kernel
def _sticking(wall, first, second, k):
    """Ghost k behind a wall that the fluid sticks to: the parabola through the wall's own speed along itself
    and the two cells before it goes on. A straight line there would leave drag at the wall an error that does
    not fall with the cell.
    """
    if k == 1:
        return (8.0 * wall + second) / 3.0 - 2.0 * first
    return 8.0 * wall - 9.0 * first + 2.0 * second


@inner_kernel
def _along(given, side, k, count, axis, joined):
    """A side's own velocity along itself at corner k of its count cells: the mean of the two cells there."""
    one, two = k - 1, k
    if joined:
        one, two = (one + count) % count, two % count
    one, two = min(max(one, 0), count - 1), min(max(two, 0), count - 1)
    return 0.5 * (given[side, one, axis] + given[side, two, axis])


@kernel
def fill_velocity_ghosts(padded, axis, edges):
    """Ghosts of u (axis 0) or v (axis 1), padded (rows + 2 PAD, columns + 2 PAD)."""
    rows, columns = padded.shape[0] - 2 * PAD, padded.shape[1] - 2 * PAD
    kinds, given = edges.kinds, edges.velocities
    left, right, bottom, top = (
        kinds[borders.LEFT],
        kinds[borders.RIGHT],
        kinds[borders.BOTTOM],
        kinds[borders.TOP],
    )
    last, node = columns - 1, axis == X
    for j in range(rows):
        row = padded[j + PAD]
        wall_left = (
            0.0 if node else _along(given, borders.LEFT, j, rows - 1, axis, bottom == borders.PERIODIC)
        )
        wall_right = (
            0.0 if node else _along(given, borders.RIGHT, j, rows - 1, axis, bottom == borders.PERIODIC)
        )
        for k in range(1, PAD + 1):
            if node:
                row[PAD - k] = _nodal(row[PAD], row[PAD + k], row[PAD + last - k], left)
                row[PAD + last + k] = _nodal(row[PAD + last], row[PAD + last - k], row[PAD + k], right)
                continue
            one, other = row[PAD + k - 1], row[PAD + last + 1 - k]
            row[PAD - k] = (
                _sticking(wall_left, row[PAD], row[PAD + 1], k) if left == borders.NO_SLIP
                else _centred(row[PAD], one, other, left, wall_left)
            )  # fmt: skip
            row[PAD + last + k] = (
                _sticking(wall_right, row[PAD + last], row[PAD + last - 1], k) if right == borders.NO_SLIP
                else _centred(row[PAD + last], other, one, right, wall_right)
            )  # fmt: skip
    last, node = rows - 1, axis == Y
    for i in range(columns + 2 * PAD):
        wall_low = (
            0.0
            if node
            else _along(given, borders.BOTTOM, i - PAD, columns - 1, axis, left == borders.PERIODIC)
        )
        wall_high = (
            0.0 if node else _along(given, borders.TOP, i - PAD, columns - 1, axis, left == borders.PERIODIC)
        )
        for k in range(1, PAD + 1):
            if node:
                padded[PAD - k, i] = _nodal(
                    padded[PAD, i], padded[PAD + k, i], padded[PAD + last - k, i], bottom
                )
                padded[PAD + last + k, i] = _nodal(
                    padded[PAD + last, i], padded[PAD + last - k, i], padded[PAD + k, i], top
                )
                continue
            one, other = padded[PAD + k - 1, i], padded[PAD + last + 1 - k, i]
            first, final = padded[PAD, i], padded[PAD + last, i]
            padded[PAD - k, i] = (
                _sticking(wall_low, first, padded[PAD + 1, i], k) if bottom == borders.NO_SLIP
                else _centred(first, one, other, bottom, wall_low)
            )  # fmt: skip
            padded[PAD + last + k, i] = (
                _sticking(wall_high, final, padded[PAD + last - 1, i], k) if top == borders.NO_SLIP
                else _centred(final, other, one, top, wall_high)
            )  # fmt: skip


@inner_kernel
def _fill_cell(padded, j, i, from_j, from_i, kind, held, values):
    """One ghost cell: the value that the side holds, else that of the cell it mirrors or goes on in."""
    for f in range(padded.shape[2]):
        if kind != borders.PERIODIC and held[f]:
            if kind in (borders.WALL, borders.NO_SLIP):
                padded[j, i, f] = 2.0 * values[f] - padded[from_j, from_i, f]
            else:
                padded[j, i, f] = values[f]
        else:
            padded[j, i, f] = padded[from_j, from_i, f]


@kernel
def fill_scalar_ghosts(padded, kinds, held, values):
    """Ghosts of scalars, padded (ny + 2 PAD, nx + 2 PAD, fields).

    held (4, fields) bool: whether the side holds the value (4, fields): beyond an inflow or open side it is
    that value, behind a wall such that the wall itself has it. Not held, a wall lets nothing pass.
    """
    ny, nx = padded.shape[0] - 2 * PAD, padded.shape[1] - 2 * PAD
    low, high = PAD, PAD + nx - 1
    for j in range(PAD, PAD + ny):
        for k in range(1, PAD + 1):
            left, right = kinds[borders.LEFT], kinds[borders.RIGHT]
            _fill_cell(
                padded,
                j,
                low - k,
                j,
                high + 1 - k if left == borders.PERIODIC else low + k - 1,
                left,
                held[borders.LEFT],
                values[borders.LEFT],
            )
            _fill_cell(
                padded, j, high + k, j, low + k - 1 if right == borders.PERIODIC else high + 1 - k, right,
                held[borders.RIGHT], values[borders.RIGHT],
            )  # fmt: skip
    low, high = PAD, PAD + ny - 1
    for i in range(padded.shape[1]):
        for k in range(1, PAD + 1):
            bottom, top = kinds[borders.BOTTOM], kinds[borders.TOP]
            _fill_cell(
                padded, low - k, i, high + 1 - k if bottom == borders.PERIODIC else low + k - 1, i, bottom,
                held[borders.BOTTOM], values[borders.BOTTOM],
            )  # fmt: skip
            _fill_cell(
                padded,
                high + k,
                i,
                low + k - 1 if top == borders.PERIODIC else high + 1 - k,
                i,
                top,
                held[borders.TOP],
                values[borders.TOP],
            )


@kernel
def set_side_velocities(u, v, edges):
    """Give the faces on the sides what holds there: walls 0, inflow its velocity, periodic one value."""
    ny, nx = v.shape[0] - 1, u.shape[1] - 1
    kinds, given = edges.kinds, edges.velocities
    for side, i in ((borders.LEFT, 0), (borders.RIGHT, nx)):
        for j in range(ny):
            if kinds[side] == borders.INFLOW:
                u[j, i] = given[side, j, X]
            elif kinds[side] == borders.PERIODIC:
                u[j, nx] = u[j, 0]
            elif kinds[side] != borders.OPEN:
                u[j, i] = 0.0
    for side, j in ((borders.BOTTOM, 0), (borders.TOP, ny)):
        for i in range(nx):
            if kinds[side] == borders.INFLOW:
                v[j, i] = given[side, i, Y]
            elif kinds[side] == borders.PERIODIC:
                v[ny, i] = v[0, i]
            elif kinds[side] != borders.OPEN:
                v[j, i] = 0.0
