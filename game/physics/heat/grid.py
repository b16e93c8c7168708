"""A plate of cells through which heat flows, by a scheme that one chooses."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.heat.conduction import alternating_step, explicit_step, flow_into, implicit_step, join_cells
from game.physics.heat.enthalpy import Phases, add_flow, join_phases, temperatures_of

SCHEMES = ("explicit", "crank-nicolson", "alternating")
BEYOND = ("refuse", "switch")
EDGES = ("left", "right", "lower", "upper")
LEAST_CELLS, MOST_CELLS = 4, 2**24
MOST_ITERATIONS = 400
DAMPED = 2  # steps of backward Euler after a jump: Crank-Nicolson alone would let it ring (Rannacher 1984)
HOTTEST = 1e9  # K


def checked_grid(name: str, values: ArrayLike, least: float, most: float) -> Floats:
    """Numbers (ny, nx) from least to most as an array of one's own; ValueError, naming the first that is
    not.
    """
    grid = np.array(values, dtype=np.float64, ndmin=2)
    if grid.ndim != 2 or not LEAST_CELLS <= grid.size <= MOST_CELLS:
        raise ValueError(
            f"{name}: expected (rows, columns) of {LEAST_CELLS} to {MOST_CELLS} cells, not {grid.shape}"
        )
    wrong = np.argwhere(~((grid >= least) & (grid <= most)))
    if len(wrong):
        j, i = wrong[0].tolist()
        raise ValueError(f"{name}[{j}, {i}] = {grid[j, i]!r}: expected {least:g} to {most:g}")
    return grid


def _positive(name: str, value: float) -> float:
    if not 0.0 < value < math.inf:
        raise ValueError(f"{name} = {value!r}: expected a finite number above 0")
    return float(value)


class HeatState(NamedTuple):
    """temperature (ny, nx) K, or of `MeltingGrid` heat J/m³; came: J/m (a metre of depth) through the
    edges.
    """

    values: Floats
    came: Floats  # (1,)


class MeltingState(NamedTuple):
    """values, came: as of `HeatState`; open_x (ny, nx + 1), open_y (ny + 1, nx): 0 for faces that are cut."""

    values: Floats
    came: Floats
    open_x: Floats
    open_y: Floats


class _Plate:
    """Cells of one size with edges that are insulated or held at a temperature."""

    def __init__(self, values: Floats, cell: float, held: dict[str, float]):
        self.cell = _positive("cell", cell)
        self.values = values
        self.came = np.zeros(1)
        self.held, self.is_held = np.zeros(8), np.zeros(4)
        for edge, temperature in held.items():
            if edge not in EDGES:
                raise ValueError(f"held: {edge!r}: expected {', '.join(EDGES)}")
            if not 0.0 <= temperature <= HOTTEST:
                raise ValueError(f"held: {edge} = {temperature!r}: expected 0 to {HOTTEST:g} K")
            self.held[EDGES.index(edge)], self.is_held[EDGES.index(edge)] = temperature, 1.0
        ny, nx = values.shape
        self.gx, self.gy = np.zeros((ny, nx + 1)), np.zeros((ny + 1, nx))
        self.flow = np.zeros((ny, nx))

    def _step(self, dt: float) -> float:
        return _positive("dt", dt)


class HeatGrid(_Plate):
    """Temperatures (ny, nx) K of cells of ``cell`` m.

    conductivity W/(m K) and capacity J/(m³ K): a number or (ny, nx). held: temperatures (K) of edges by name;
    the others are insulated. scheme: of SCHEMES. beyond: what an explicit step longer than its limit does:
    "refuse" (ValueError), or "switch" to alternating directions, which `used` tells. ValueError, naming the
    argument.
    """

    def __init__(
        self, temperature: ArrayLike, cell: float, conductivity: ArrayLike = 1.0, capacity: ArrayLike = 1.0,
        held: dict[str, float] | None = None, scheme: str = "alternating", beyond: str = "refuse",
    ):  # fmt: skip
        super().__init__(checked_grid("temperature", temperature, 0.0, HOTTEST), cell, held or {})
        for name, value, known in (("scheme", scheme, SCHEMES), ("beyond", beyond, BEYOND)):
            if value not in known:
                raise ValueError(f"{name} = {value!r}: expected one of {', '.join(known)}")
        self.scheme = self.used = scheme
        self.beyond, self.fresh, self.iterations = beyond, 0, 0
        shape = self.values.shape
        self.capacity = checked_grid(
            "capacity", np.broadcast_to(np.asarray(capacity, float), shape), 1e-12, 1e15
        )
        self._work, self._lines = np.zeros((4, *shape)), np.zeros((3, max(shape)))
        self.set_conductivity(conductivity)

    @property
    def temperature(self) -> Floats:
        """(ny, nx) K, not copied."""
        return self.values

    def set_conductivity(self, conductivity: ArrayLike) -> None:
        """Other W/(m K) from now on, a number or (ny, nx). ValueError."""
        shape = self.values.shape
        self.conductivity = checked_grid(
            "conductivity", np.broadcast_to(np.asarray(conductivity, float), shape), 0.0, 1e12
        )
        join_cells(self.conductivity, self.cell, self.is_held, self.gx, self.gy)
        gains = self.gx[:, :-1] + self.gx[:, 1:] + self.gy[:-1] + self.gy[1:]
        worst = float(np.max(gains / self.capacity))
        self.explicit_limit = 1.0 / worst if worst > 0.0 else math.inf
        self.fresh = DAMPED

    def state(self) -> HeatState:
        """All that later steps depend on, not copied."""
        return HeatState(self.values, self.came)

    def restore(self, state: HeatState) -> None:
        """Take over a copy of a state."""
        self.values[:], self.came[:] = state.values, state.came

    def jump(self) -> None:
        """Say that temperatures were changed by hand: the next two steps of Crank-Nicolson are damped."""
        self.fresh = DAMPED

    def heat(self) -> float:
        """J in a metre of depth, from 0 K."""
        return math.fsum((self.capacity * self.values).ravel().tolist()) * (self.cell * self.cell)

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is above 0, or if it is beyond the explicit limit and
        refused.
        """
        h = self._step(dt)
        self.used = self.scheme
        # a grid of equal cells in the plane: cell² C / 4 k; a tenth of a rounding is no reason to refuse
        if self.scheme == "explicit" and h > self.explicit_limit * (1.0 + 1e-12):
            if self.beyond == "refuse":
                raise ValueError(
                    f"dt = {h:g} s: an explicit step is stable up to {self.explicit_limit:g} s here"
                )
            self.used = "alternating"
        arguments = (self.values, self.capacity, self.gx, self.gy, self.held, h)
        if self.used == "explicit":
            came = explicit_step(*arguments, self.flow)
        elif self.used == "alternating":
            came = alternating_step(*arguments, self.flow, self._lines)
        else:
            theta = 1.0 if self.fresh > 0 else 0.5
            self.fresh = max(self.fresh - 1, 0)
            came, self.iterations = implicit_step(*arguments, theta, MOST_ITERATIONS, self._work)
        self.came[0] += came * (self.cell * self.cell)


class MeltingGrid(_Plate):
    """Cells of a material that melts and boils, as heat (ny, nx) J/m³. An explicit step is cut into as many
    as are stable, up to ``most_substeps``; beyond that it is refused by a ValueError. A piece can be cut off
    (`cut`): it keeps its heat, and no more goes to or fro.
    """

    def __init__(
        self, temperature: ArrayLike, cell: float, material: Phases, held: dict[str, float] | None = None,
        most_substeps: int = 10_000,
    ):  # fmt: skip
        for name, value in material._asdict().items():
            if not 0.0 < value < 1e15:
                raise ValueError(f"{name} = {value!r}: expected a number above 0")
        if not material.melting < material.boiling:
            raise ValueError("melting: expected below boiling")
        start = checked_grid("temperature", temperature, 0.0, HOTTEST)
        self.material, self.most_substeps = material, most_substeps
        super().__init__(heat_at(start, material), cell, held or {})
        self.temperature, self.molten, self.boiled = (np.zeros_like(start) for _ in range(3))
        self.open_x, self.open_y = np.ones_like(self.gx), np.ones_like(self.gy)
        most_k = max(material.solid_k, material.liquid_k, material.gas_k)
        least_c = min(material.solid, material.liquid, material.gas)
        faces = 8.0 if np.any(self.is_held) else 4.0
        self.explicit_limit = (self.cell * self.cell) * least_c / (faces * most_k)
        self.look()

    def look(self) -> None:
        """Bring temperature and shares of phases up to date with the heat."""
        temperatures_of(self.values, self.material, self.temperature, self.molten, self.boiled)

    def heat(self) -> float:
        """J in a metre of depth, from 0 K as a solid."""
        return math.fsum(self.values.ravel().tolist()) * (self.cell * self.cell)

    def deposit(self, joule: ArrayLike) -> None:
        """Add heat (ny, nx) J to cells of a metre of depth. ValueError for what is not finite or below 0
        K.
        """
        added = np.asarray(joule, dtype=np.float64) / (self.cell * self.cell)
        if not np.isfinite(added).all() or np.min(self.values + added) < 0.0:
            raise ValueError("joule: expected finite numbers that leave no cell below 0 K")
        self.values += added
        self.look()

    def cut(self, piece: ArrayLike) -> None:
        """Cut off the cells (ny, nx) that are True from all others, even if they are half molten. ValueError
        for another shape.
        """
        off = np.asarray(piece)
        if off.shape != self.values.shape or off.dtype != np.bool_:
            raise ValueError(f"piece: expected {self.values.shape} of True and False")
        self.open_x[:, 1:-1][off[:, 1:] != off[:, :-1]] = 0.0
        self.open_y[1:-1][off[1:] != off[:-1]] = 0.0

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless above 0 and short enough."""
        count = max(1, math.ceil(self._step(dt) / self.explicit_limit - 1e-9))
        if count > self.most_substeps:
            raise ValueError(
                f"dt = {dt:g} s: expected at most {self.most_substeps * self.explicit_limit:g} s"
            )
        h, part = dt / count, 1.0 / (self.cell * self.cell)
        for _ in range(count):
            join_phases(self.molten, self.boiled, self.material, part, self.is_held, self.gx, self.gy)
            np.multiply(self.gx, self.open_x, out=self.gx)
            np.multiply(self.gy, self.open_y, out=self.gy)
            came = flow_into(self.temperature, self.gx, self.gy, self.held, self.flow)
            add_flow(self.values, self.flow, h)
            self.look()
            self.came[0] += came * h * (self.cell * self.cell)

    def front_across(self, row: int = 0) -> float:
        """How far the molten part reaches along a row, m, by the shares of its cells."""
        return float(np.sum(self.molten[row])) * self.cell

    def state(self) -> MeltingState:
        """All that later steps depend on, not copied."""
        return MeltingState(self.values, self.came, self.open_x, self.open_y)

    def restore(self, state: MeltingState) -> None:
        """Take over a copy of a state."""
        self.values[:], self.came[:] = state.values, state.came
        self.open_x[:], self.open_y[:] = state.open_x, state.open_y
        self.look()


def heat_at(temperature: Floats, material: Phases) -> Floats:
    """Heat J/m³ of temperatures K; exactly at a plateau: before the change of phase."""
    m = material
    warm = np.minimum(temperature, m.melting) * m.solid
    warm += np.where(temperature > m.melting, m.melting_heat, 0.0)
    warm += np.clip(temperature - m.melting, 0.0, m.boiling - m.melting) * m.liquid
    warm += np.where(temperature > m.boiling, m.boiling_heat, 0.0)
    return np.ascontiguousarray(warm + np.maximum(temperature - m.boiling, 0.0) * m.gas)
