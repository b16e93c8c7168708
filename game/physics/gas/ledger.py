"""The books of a step of gas: what changed its momentum and the sums of what it carries.

Momentum is summed over the open parts of faces, of those on the sides by half; fields over cells that are not
closed. Both are over the density of air and a metre deep: m³/s, and units of the field times m². Each row is
found for itself: what the side that gives it says, not what is missing. The one row that is not is
``CARRYING``: what the scheme's own way of carrying made or lost beside what went through the sides. Of fields
in flux form it is rounding (4 N eps of the sum of all terms); of others it is the open share of the books.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.gas.conserving import upwind
from game.physics.grid.borders import PERIODIC
from game.physics.grid.layout import PAD
from game.physics.grid.obstacles import SolidFaces

# rows of momentum: lift and other forces in the gas, pressure of solids and of sides, what viscosity drags,
# what sides hold, what flows through them, the scheme's own
FORCES, SOLIDS, SIDES, DRAG, HELD, THROUGH, CARRYING = range(7)
MOMENTUM_ROWS = 7
# rows of fields: sources, through the sides with the gas, and by spreading, the scheme's own
SOURCES, CARRIED_THROUGH, SPREAD_THROUGH, SCHEME = range(4)
FIELD_ROWS = 4
# moments of a step at which sums are taken; LADEN: with what comes before it is carried
START, LADEN, CARRIED, PUSHED, DRAGGED, STOPPED, END = range(7)
_STAGES = 7


class Book(NamedTuple):
    """Of the last step: rows (MOMENTUM_ROWS or FIELD_ROWS, k), the change that they explain (k,), what came
    between the steps (k,), and what is left open (k,): rounding.
    """

    rows: Floats
    change: Floats
    between: Floats
    open: Floats


@lean_kernel
def momentum_of(u, v, ax, ay, area, out):
    """Write sums (2,) of u and v over open parts of faces, times the area of a cell."""
    ny, nx = ay.shape[0] - 1, ax.shape[1] - 1
    total = 0.0
    for j in range(ny):
        row = 0.5 * (ax[j, 0] * u[j, 0] + ax[j, nx] * u[j, nx])
        for i in range(1, nx):
            row += ax[j, i] * u[j, i]
        total += row
    out[0] = area * total
    total = 0.0
    for j in range(ny + 1):
        row = 0.0
        for i in range(nx):
            row += ay[j, i] * v[j, i]
        total += 0.5 * row if j == 0 or j == ny else row
    out[1] = area * total


@lean_kernel
def pressure_on(p, ax, ay, h, solids, sides):
    """Write what pressure does to the gas, m³/s² (2,) each: on solids' outlines (as `loads`, the other way
    round), and at the sides. p: padded by one, with ghosts for gradients.
    """
    ny, nx = ay.shape[0] - 1, ax.shape[1] - 1
    solid_x, solid_y, side_x, side_y = 0.0, 0.0, 0.0, 0.0
    for j in range(ny):
        row_x, row_y = 0.0, 0.0
        for i in range(nx):
            here = p[j + 1, i + 1]
            row_x += here * (ax[j, i + 1] - ax[j, i])
            row_y += here * (ay[j + 1, i] - ay[j, i])
        solid_x += row_x
        solid_y += row_y
        first, last = p[j + 1, 1], p[j + 1, nx]
        side_x += ax[j, 0] * 0.5 * (first + p[j + 1, 0]) - ax[j, nx] * 0.5 * (last + p[j + 1, nx + 1])
    for i in range(nx):
        first, last = p[1, i + 1], p[ny, i + 1]
        side_y += ay[0, i] * 0.5 * (first + p[0, i + 1]) - ay[ny, i] * 0.5 * (last + p[ny + 1, i + 1])
    solids[0], solids[1], sides[0], sides[1] = h * solid_x, h * solid_y, h * side_x, h * side_y


@lean_kernel
def momentum_through(u, v, ax, ay, kinds, h, out):
    """Write the momentum (2,) that comes in through the sides in a second, m³/s²: velocity times flow."""
    ny, nx = ay.shape[0] - 1, ax.shape[1] - 1
    along, up = 0.0, 0.0
    for side in range(2):
        i, inward = side * nx, 1.0 - 2.0 * side
        if kinds[side] == PERIODIC:
            continue
        k = min(i, nx - 1)
        for j in range(ny):
            flow = inward * h * ax[j, i] * u[j, i]
            along += flow * u[j, i]
            up += flow * 0.5 * (v[j, k] + v[j + 1, k])
    for side in range(2):
        j, inward = side * ny, 1.0 - 2.0 * side
        if kinds[2 + side] == PERIODIC:
            continue
        k = min(j, ny - 1)
        for i in range(nx):
            flow = inward * h * ay[j, i] * v[j, i]
            up += flow * v[j, i]
            along += flow * 0.5 * (u[k, i] + u[k, i + 1])
    out[0], out[1] = along, up


@inner_kernel
def _is_closed(ax, ay, j, i):
    return max(max(ax[j, i], ax[j, i + 1]), max(ay[j, i], ay[j + 1, i])) <= 0.0


@lean_kernel
def contents_of(scalars, ax, ay, area, out):
    """Write sums (fields,) over cells that are not closed, times the area of a cell."""
    for k in range(out.size):
        out[k] = 0.0
    for j in range(scalars.shape[0]):
        for i in range(scalars.shape[1]):
            if not _is_closed(ax, ay, j, i):
                for k in range(out.size):
                    out[k] += area * scalars[j, i, k]


@inner_kernel
def _between(a, b, c, d, speed, limited):
    """Value on the side between b and c: as the flux form has it, or that of where the gas comes from."""
    if limited:
        return upwind(a, b, c, d, speed)
    return b if speed >= 0.0 else c


@lean_kernel
def fields_through(padded, u, v, solids, kinds, limited, h, out):
    """Write what comes in through the sides in a second, (fields,); padded: with ghosts."""
    ny, nx, p = solids.ay.shape[0] - 1, solids.ax.shape[1] - 1, PAD
    for k in range(out.size):
        total = 0.0
        for side in range(2):
            i, inward = side * nx, 1.0 - 2.0 * side
            if kinds[side] != PERIODIC:
                for j in range(ny):
                    speed, m, n = solids.ax[j, i] * u[j, i], j + p, i + p
                    value = _between(
                        padded[m, n - 2, k], padded[m, n - 1, k], padded[m, n, k], padded[m, n + 1, k],
                        speed, limited,
                    )  # fmt: skip
                    total += inward * speed * value
            j, inward = side * ny, 1.0 - 2.0 * side
            if kinds[2 + side] != PERIODIC:
                for i in range(nx):
                    speed, m, n = solids.ay[j, i] * v[j, i], j + p, i + p
                    value = _between(
                        padded[m - 2, n, k], padded[m - 1, n, k], padded[m, n, k], padded[m + 1, n, k],
                        speed, limited,
                    )  # fmt: skip
                    total += inward * speed * value
        out[k] = h * total


@lean_kernel
def fields_spread(padded, ax, ay, kinds, out):
    """Write the sums (fields,) of differences to the ghosts over the open sides: what spreads in, over
    D dt.
    """
    ny, nx, p = ay.shape[0] - 1, ax.shape[1] - 1, PAD
    for k in range(out.size):
        total = 0.0
        for side in range(2):
            if kinds[side] != PERIODIC:
                i, ghost = side * (nx - 1), side * (nx + 1) - 1
                for j in range(ny):
                    total += ax[j, side * nx] * (padded[j + p, ghost + p, k] - padded[j + p, i + p, k])
            if kinds[2 + side] != PERIODIC:
                j, ghost = side * (ny - 1), side * (ny + 1) - 1
                for i in range(nx):
                    total += ay[side * ny, i] * (padded[ghost + p, i + p, k] - padded[j + p, i + p, k])
        out[k] = total


class Ledger:
    """Keeps the books of a gas of so many fields; `gas.ledger = Ledger(...)` lets it, None ends it.

    h: m, cell; kinds (4,): of sides. ``momentum``, ``fields``: `Book` of the last step, None before it.
    """

    def __init__(self, h: float, kinds: NDArray[np.int64], fields: int):
        self.h, self.kinds, self.count = float(h), kinds, fields
        self.momentum: Book | None = None
        self.fields: Book | None = None
        self._solids: SolidFaces | None = None
        self._velocity, self._contents = np.zeros((_STAGES, 2)), np.zeros((_STAGES, fields))
        self._rows, self._field_rows = np.zeros((MOMENTUM_ROWS, 2)), np.zeros((FIELD_ROWS, fields))
        self._own = np.zeros(fields, np.bool_)
        self._exact = np.zeros(fields)
        self._two, self._pair, self._many = np.zeros(2), np.zeros(2), np.zeros(fields)

    def forget(self) -> None:
        """The last step was not of this gas: there is no book, and nothing came between the steps."""
        self.momentum = self.fields = None

    def contents(self, scalars: Floats, solids: SolidFaces) -> Floats:
        """Sums (fields,) of fields as they are now, as the books have them."""
        found = np.zeros(self.count)
        contents_of(scalars, solids.ax, solids.ay, self.h * self.h, found)
        return found

    @property
    def left(self) -> Floats | None:
        """Sums (fields,) as the last step left them; None before it."""
        return self._contents[END] if self.fields is not None else None

    # -- what a step tells ------------------------------------------------------------------------------

    def begin(
        self, u: Floats, v: Floats, scalars: Floats, solids: SolidFaces, kept: NDArray[np.bool_]
    ) -> None:
        """A step begins, with these open parts; kept (fields,): which are carried in flux form."""
        self._solids, self._own = solids, ~kept
        self._rows[:], self._field_rows[:] = 0.0, 0.0
        self.see(START, u, v)
        self.see_fields(START, scalars)

    def see(self, stage: int, u: Floats, v: Floats) -> None:
        """Velocities at a moment of the step."""
        assert self._solids is not None
        momentum_of(u, v, self._solids.ax, self._solids.ay, self.h * self.h, self._velocity[stage])

    def see_fields(self, stage: int, scalars: Floats) -> None:
        """Fields (ny, nx, fields) at a moment of the step."""
        assert self._solids is not None
        contents_of(scalars, self._solids.ax, self._solids.ay, self.h * self.h, self._contents[stage])

    def force(self, seconds: float, u: Floats, v: Floats) -> None:
        """Forces m/s² on faces acted so long."""
        assert self._solids is not None
        momentum_of(u, v, self._solids.ax, self._solids.ay, self.h * self.h, self._two)
        self._rows[FORCES] += seconds * self._two

    def press(self, seconds: float, p: Floats) -> None:
        """A pressure, padded, acted so long."""
        assert self._solids is not None
        pressure_on(p, self._solids.ax, self._solids.ay, self.h, self._two, self._pair)
        self._rows[SOLIDS] += seconds * self._two
        self._rows[SIDES] += seconds * self._pair

    def flow(self, seconds: float, u: Floats, v: Floats, padded: Floats) -> None:
        """Velocities and padded fields at the sides, for what is not in flux form."""
        assert self._solids is not None
        momentum_through(u, v, self._solids.ax, self._solids.ay, self.kinds, self.h, self._two)
        self._rows[THROUGH] += seconds * self._two
        fields_through(padded, u, v, self._solids, self.kinds, False, self.h, self._many)
        self._field_rows[CARRIED_THROUGH, self._own] += seconds * self._many[self._own]

    def flux(self, seconds: float, u: Floats, v: Floats, padded: Floats) -> None:
        """The same, as the flux form has it, for what is in flux form."""
        fields_through(padded, u, v, self._solids, self.kinds, True, self.h, self._many)
        self._field_rows[CARRIED_THROUGH, ~self._own] += seconds * self._many[~self._own]

    def spread(self, strength: Floats, padded: Floats) -> None:
        """Fields spread by D dt / h² (fields,)."""
        assert self._solids is not None
        fields_spread(padded, self._solids.ax, self._solids.ay, self.kinds, self._many)
        self._field_rows[SPREAD_THROUGH] += self.h * self.h * strength * self._many

    def source(self, seconds: float, rates: Floats) -> None:
        """Rates (ny, nx, fields) of the fields acted so long."""
        assert self._solids is not None
        contents_of(rates, self._solids.ax, self._solids.ay, self.h * self.h, self._many)
        self._field_rows[SOURCES] += seconds * self._many

    def close(self, u: Floats, v: Floats, scalars: Floats) -> None:
        """The step is done."""
        before = (self._velocity[END].copy(), self._contents[END].copy())
        known = self.momentum is not None
        self.see(END, u, v)
        self.see_fields(END, scalars)
        at, rows = self._velocity, self._rows
        rows[DRAG] = at[DRAGGED] - at[PUSHED]
        rows[HELD] = at[STOPPED] - at[DRAGGED]
        rows[CARRYING] = at[CARRIED] - at[LADEN] - rows[THROUGH]
        change = at[END] - at[START]
        between = at[START] - before[0] if known else np.zeros(2)
        self.momentum = Book(rows.copy(), change, between, change - rows.sum(axis=0))
        held, rows = self._contents, self._field_rows
        rows[SCHEME] = held[CARRIED] - held[LADEN] - rows[SOURCES] - rows[CARRIED_THROUGH]
        change = held[END] - held[START]
        between = held[START] - before[1] if known else np.zeros(self.count)
        self.fields = Book(rows.copy(), change, between, change - rows.sum(axis=0))
