"""The pressure equation of a grid with its solvers, chosen by name."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.physics.grid.borders import OPEN, PERIODIC
from game.physics.multigrid.conjugate_gradients import factorise, solve_gradients
from game.physics.multigrid.cycle import coarsen_all, make_hierarchy
from game.physics.multigrid.equation import Found, balance, label_regions, make_equation, rounding
from game.physics.multigrid.gauss_seidel import solve_sweeps
from game.physics.multigrid.jacobi import solve_jacobi
from game.physics.multigrid.levels import CLOSED, JOINED, OPEN_END
from game.physics.multigrid.multigrid import solve_cycles, solve_multigrid
from game.physics.multigrid.smoothing import find_plain
from game.physics.multigrid.transfer import invert_diagonal

SOLVERS = ("multigrid", "v-cycles", "conjugate-gradients", "gauss-seidel", "jacobi")
USUAL_TURNS = {"multigrid": 3, "v-cycles": 4, "conjugate-gradients": 40, "gauss-seidel": 20, "jacobi": 40}
LEAST_FACE = 1e-3  # open part of a face below which it counts as closed


@lean_kernel
def _set_faces(e, ax, ay, kinds):
    """Conductances from the open parts of faces and the kinds of the sides."""
    ny, nx = e.b.shape
    for j in range(ny):
        for i in range(nx + 1):
            e.cx[j, i] = ax[j, i] if ax[j, i] >= LEAST_FACE else 0.0
        for side, i in ((0, 0), (1, nx)):
            if kinds[side] == OPEN:
                e.cx[j, i] *= 2.0
            elif kinds[side] != PERIODIC:
                e.cx[j, i] = 0.0
            else:  # the seam is one face
                e.cx[j, i] = min(e.cx[j, 0], e.cx[j, nx])
    for i in range(nx):
        for j in range(ny + 1):
            e.cy[j, i] = ay[j, i] if ay[j, i] >= LEAST_FACE else 0.0
        for side, j in ((2, 0), (3, ny)):
            if kinds[side] == OPEN:
                e.cy[j, i] *= 2.0
            elif kinds[side] != PERIODIC:
                e.cy[j, i] = 0.0
            else:
                e.cy[j, i] = min(e.cy[0, i], e.cy[ny, i])
    invert_diagonal(e.cx, e.cy, e.inverse)
    find_plain(e.cx, e.cy, e.plain)


class PressureSolver:
    """A p = b on ny rows and nx columns: over each cell's faces the sum of c (p - p_neighbour) is b.

    kinds: (4,) of `grid.borders` at left, right, bottom, top: at an "open" side the pressure is 0 on the
    side itself, at a "periodic" one it goes on, at others nothing passes. Write the right side into
    ``equation.b``; the unknown is ``pressure`` (a view, (ny, nx)), where a solve begins from what is there.
    In each connected region that no open side fixes, the mean of b is taken out (``removed``, per region) and
    the mean of the pressure made 0. Nothing is allocated by a solve.
    """

    def __init__(self, nx: int, ny: int, kinds: NDArray[np.int64]):
        ends = tuple({OPEN: OPEN_END, PERIODIC: JOINED}.get(int(kind), CLOSED) for kind in kinds)
        self.kinds = np.array(kinds, dtype=np.int64)
        self.hierarchy = make_hierarchy(nx, ny, ends)  # type: ignore[arg-type]
        self.equation = make_equation(nx, ny, (ends[0] == JOINED, ends[2] == JOINED))
        self.factor, self.room = np.zeros((ny + 2, nx + 2)), np.zeros((ny + 2, nx + 2))
        self.regions, self._coarse, self._factored = 0, False, False
        self.set_faces(np.ones((ny, nx + 1)), np.ones((ny + 1, nx)))

    @property
    def pressure(self) -> Floats:
        """(ny, nx), a view."""
        return self.equation.p[1:-1, 1:-1]

    @property
    def removed(self) -> Floats:
        """(regions,) mean of b that the last solve took out of each region; 0 where an open side is."""
        return self._removed

    def set_faces(self, ax: Floats, ay: Floats) -> None:
        """Open parts of faces, 0 to 1: ax (ny, nx + 1), ay (ny + 1, nx)."""
        _set_faces(self.equation, ax, ay, self.kinds)
        self.regions = label_regions(self.equation)
        self._removed: Floats = np.zeros(self.regions)
        self._coarse = self._factored = False

    def solve(self, method: str = "multigrid", turns: int = 0, goal: float = 0.0) -> Found:
        """Improve the pressure until the largest residual is at most goal, in at most so many turns (0: as
        usual for the method); no further than rounding lets it. ValueError for an unknown
        method, turns below 0 or a goal that is no number.
        """
        if method not in SOLVERS:
            raise ValueError(f"method = {method!r}: expected one of {', '.join(SOLVERS)}")
        if isinstance(turns, bool) or not isinstance(turns, int) or turns < 0:
            raise ValueError(f"turns = {turns!r}: expected a whole number from 0")
        if not 0.0 <= goal < math.inf:
            raise ValueError(f"goal = {goal!r}: expected a number from 0")
        equation, most = self.equation, turns or USUAL_TURNS[method]
        balance(equation, equation.b, self.regions, 0)
        goal = max(goal, rounding(equation))
        self._removed[:] = equation.sums[0, : self.regions]
        if method in ("multigrid", "v-cycles"):
            self._coarsen()
            run = solve_multigrid if method == "multigrid" else solve_cycles
            found = run(equation, self.hierarchy, most, goal)
        elif method == "conjugate-gradients":
            if not self._factored:
                factorise(equation, self.factor)
                self._factored = True
            found = solve_gradients(equation, self.factor, self.room, most, goal)
        elif method == "gauss-seidel":
            found = solve_sweeps(equation, most, goal)
        else:
            found = solve_jacobi(equation, most, goal)
        balance(equation, equation.p, self.regions, 1)
        return Found(*found)

    def _coarsen(self) -> None:
        """The coarser levels, if faces changed."""
        if not self._coarse:
            coarsen_all(self.hierarchy, self.equation.cx, self.equation.cy)
            self._coarse = True
