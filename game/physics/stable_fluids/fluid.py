"""A box of fluid moved as the two papers say: checked, stepped, measured."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.stable_fluids.printed import (
    ACROSS,
    ALONG,
    PLAIN,
    carry_fields,
    carry_velocity,
    fill_ghosts,
    relax,
    take_gradient,
    write_divergence,
)

PAPERS = ("stam-1999", "stam-2003")
SWEEPS = 20  # of the second paper's program
AT_ONCE, MOST_SWEEPS = 20, 4_000  # of the first paper's systems, which are solved to the end
SOLVED = 1e-7  # of the largest value: a change that is small enough


class PrintedState(NamedTuple):
    """u, v (ny + 2, nx + 2) m/s; fields (ny + 2, nx + 2, k); pressure (ny + 2, nx + 2) m²/s."""

    u: Floats
    v: Floats
    fields: Floats
    pressure: Floats


class PrintedFluid:
    """Fluid in a box of (ny, nx) cells of ``cell`` m with so many carried fields.

    paper: of PAPERS. viscosity m²/s. solid (ny, nx): cells in which nothing moves. ValueError for nonsense.
    sweeps: of Gauss and Seidel in the last step, all systems together.
    """

    def __init__(
        self, shape: tuple[int, int], cell: float, fields: int = 1, paper: str = "stam-1999",
        viscosity: float = 0.0, sweeps: int = SWEEPS,
    ):  # fmt: skip
        ny, nx = shape
        if not (4 <= ny <= 4096 and 4 <= nx <= 4096):
            raise ValueError(f"shape = {shape!r}: expected 4 to 4096 cells each way")
        if not 0.0 < cell < math.inf:
            raise ValueError(f"cell = {cell!r}: expected a finite number above 0 m")
        if paper not in PAPERS:
            raise ValueError(f"paper = {paper!r}: expected one of {', '.join(PAPERS)}")
        if not 0.0 <= viscosity < math.inf:
            raise ValueError(f"viscosity = {viscosity!r}: expected a finite number from 0 m²/s")
        if isinstance(sweeps, bool) or not 1 <= sweeps <= MOST_SWEEPS:
            raise ValueError(f"sweeps = {sweeps!r}: expected 1 to {MOST_SWEEPS}")
        if not 0 <= fields <= 16:
            raise ValueError(f"fields = {fields!r}: expected 0 to 16")
        self.cell, self.paper, self.viscosity, self.most = float(cell), paper, float(viscosity), int(sweeps)
        size = (ny + 2, nx + 2)
        self.u, self.v, self.pressure = np.zeros(size), np.zeros(size), np.zeros(size)
        self.fields, self._next = np.zeros((*size, fields)), np.zeros((*size, fields))
        self._a, self._b, self._right = np.zeros(size), np.zeros(size), np.zeros(size)
        self.solid: NDArray[np.bool_] = np.zeros(shape, dtype=bool)
        self.sweeps = 0

    @property
    def inner(self) -> tuple[Floats, Floats, Floats]:
        """u, v and fields without ghosts, not copied."""
        return self.u[1:-1, 1:-1], self.v[1:-1, 1:-1], self.fields[1:-1, 1:-1]

    def _solve(self, x: Floats, right: Floats, number: float, share: float, kind: int) -> None:
        """By 20 sweeps, or to the end."""
        if self.paper == "stam-2003":
            relax(x, right, number, share, kind, self.most, 1.0)
            self.sweeps += self.most
            return
        done, over = (
            0,
            2.0 / (1.0 + math.pi / max(self.solid.shape)),
        )  # the best for a square without viscosity
        while done < MOST_SWEEPS:
            change = relax(x, right, number, share, kind, AT_ONCE, over)
            done += AT_ONCE
            if change <= SOLVED * float(np.max(np.abs(x))) + 1e-300:
                break
        self.sweeps += done

    def _diffuse(self, dt: float) -> None:
        number = self.viscosity * dt / (self.cell * self.cell)
        if number == 0.0:
            return
        for field, kind in ((self.u, ACROSS), (self.v, ALONG)):
            np.copyto(self._right, field)
            self._solve(field, self._right, number, 1.0 + 4.0 * number, kind)

    def _project(self) -> None:
        if self.solid.any():
            self.u[1:-1, 1:-1][self.solid], self.v[1:-1, 1:-1][self.solid] = 0.0, 0.0
        write_divergence(self.u, self.v, self.cell, self._right)
        self._right *= -(self.cell * self.cell)
        self.pressure[:] = 0.0
        fill_ghosts(self._right, PLAIN)
        self._solve(self.pressure, self._right, 1.0, 4.0, PLAIN)
        take_gradient(self.u, self.v, self.pressure, self.cell)

    def _carry(self, dt: float, stages: int) -> None:
        carry_velocity(self.u, self.v, dt / self.cell, stages, self._a, self._b)
        self.u, self._a, self.v, self._b = self._a, self.u, self._b, self.v

    def step(self, dt: float) -> None:
        """Go on by dt (s), after forces were added to u and v. ValueError unless it is above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        self.sweeps = 0
        fill_ghosts(self.u, ACROSS)
        fill_ghosts(self.v, ALONG)
        stages = 2 if self.paper == "stam-1999" else 1
        if self.paper == "stam-1999":
            self._carry(dt, stages)
            self._diffuse(dt)
            self._project()
        else:
            self._diffuse(dt)
            self._project()
            self._carry(dt, stages)
            self._project()
        if self.fields.shape[2]:
            carry_fields(self.fields, self.u, self.v, dt / self.cell, stages, self._next)
            self.fields, self._next = self._next, self.fields

    def divergence(self) -> Floats:
        """(ny, nx) 1/s, by central differences over two cells, as the papers measure it."""
        write_divergence(self.u, self.v, self.cell, self._right)
        return self._right[1:-1, 1:-1].copy()

    def face_divergence(self) -> Floats:
        """(ny, nx) 1/s from cell to cell, with velocities on faces as means: what a field that it carries
        feels.
        """
        u, v = self.u[1:-1, 1:-1], self.v[1:-1, 1:-1]
        across, along = np.zeros((u.shape[0], u.shape[1] + 1)), np.zeros((u.shape[0] + 1, u.shape[1]))
        across[:, 1:-1], along[1:-1] = 0.5 * (u[:, 1:] + u[:, :-1]), 0.5 * (v[1:] + v[:-1])
        return np.asarray((np.diff(across, axis=1) + np.diff(along, axis=0)) / self.cell)

    def state(self) -> PrintedState:
        """All that later steps depend on, not copied."""
        return PrintedState(self.u, self.v, self.fields, self.pressure)

    def restore(self, state: PrintedState) -> None:
        """Take over a copy of a state."""
        for mine, given in zip(self.state(), state, strict=True):
            mine[:] = given
