"""How a gas burns, checked, and the books of what burnt."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.combustion import burning
from game.physics.combustion.burning import FlameLaws, burn_cells
from game.physics.combustion.effects import COMBUSTION
from game.physics.effects import EffectSet

BOOKS = (
    burning.BURNT,
    burning.USED,
    burning.RELEASED,
    burning.RADIATED,
    burning.SOOT_MADE,
    burning.SOOT_GONE,
)
LEAST_TEMPERATURE = 1e-6  # K


@dataclass(frozen=True, slots=True)
class GasFuel:
    """A gas that burns. ValueError, naming the field, for nonsense.

    ignition K; rate 1/s; oxygen kg for a kg of fuel; heat J/kg; capacity of the gas J/(m³ K); soot: kg of it
    from a kg of fuel; soot_rate 1/s at which it burns off where gas may burn. soot_size m: diameter of its
    balls, which lose mass by temperature and oxygen as well (see `soot`), or 0. glow 1/(K³ s) of clear gas,
    soot_glow m³/(kg K³ s) of soot: b of dT/dt = -b (T⁴ - Ta⁴); ambient K.
    """

    ignition: float = 600.0
    rate: float = 30.0
    oxygen: float = 3.5
    heat: float = 4.5e7
    capacity: float = 1212.0
    soot: float = 0.02
    soot_rate: float = 0.0
    soot_size: float = 0.0
    glow: float = 2e-11
    soot_glow: float = 1e-8
    ambient: float = 293.15
    effects: EffectSet = COMBUSTION.known

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", COMBUSTION.checked(self.effects))
        above = ("oxygen", "capacity")
        for name in FlameLaws._fields[1:]:
            value = getattr(self, name)
            if not (0.0 <= value < 1e15 and (value > 0.0 or name not in above)):
                raise ValueError(
                    f"{name} = {value!r}: expected a number {'above' if name in above else 'from'} 0"
                )
        if self.soot > 1.0:
            raise ValueError(f"soot = {self.soot!r}: expected at most 1 kg of a kg of fuel")

    def laws(self) -> FlameLaws:
        """For kernels."""
        return FlameLaws(
            COMBUSTION.mask(self.effects), *(float(getattr(self, name)) for name in FlameLaws._fields[1:])
        )


class Books(NamedTuple):
    """What burning has done so far, a metre deep: kg, kg, J, J, kg, kg."""

    burnt: float
    used: float
    released: float
    radiated: float
    soot_made: float
    soot_gone: float


class Flames:
    """Burns in the cells (ny, nx, fields) of a gas.

    columns: where temperature, fuel, oxygen and soot are among the fields; cell m. ValueError for nonsense.
    books (6,): see `Books`; power W/m and alight (cells) of the last step.
    """

    def __init__(self, columns: Sequence[int], cell: float, made_of: GasFuel | None = None):
        self.columns = np.array(columns, dtype=np.int64)
        if self.columns.shape != (4,) or len(set(columns)) != 4 or min(columns) < 0:
            raise ValueError(f"columns = {columns!r}: expected four different ones, from 0")
        if not 0.0 < cell < math.inf:
            raise ValueError(f"cell = {cell!r}: expected a finite number above 0")
        self.cell, self.made_of = float(cell), made_of or GasFuel()
        self.sums, self.books = np.zeros(burning.SUMS), np.zeros(len(BOOKS))
        self.power = 0.0

    @property
    def alight(self) -> int:
        """Cells that burnt in the last step."""
        return int(self.sums[burning.ALIGHT])

    @property
    def fiercest(self) -> float:
        """W/m³ in the cell that burnt most in the last step."""
        return float(self.sums[burning.FIERCEST])

    def step(self, cells: Floats, dt: float, source: Floats) -> None:
        """Burn for dt (s); source (ny, nx) 1/s: what expands is added. ValueError for a bad dt or shape."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        if cells.ndim != 3 or source.shape != cells.shape[:2] or cells.shape[2] <= int(self.columns.max()):
            raise ValueError(f"cells {cells.shape}, source {source.shape}: they do not belong together")
        burn_cells(cells, self.columns, self.made_of.laws(), float(dt), source, self.sums)
        self.books += self.sums[list(BOOKS)] * (self.cell * self.cell)
        self.power = float(self.sums[burning.RELEASED]) * (self.cell * self.cell) / dt

    def books_now(self) -> Books:
        """As numbers."""
        return Books(*self.books.tolist())

    def contents(self, cells: Floats) -> tuple[float, float, float, float]:
        """J above the ambient, kg of fuel, of oxygen, of soot in all cells, a metre deep."""
        volume, rows = self.cell * self.cell, self.columns.tolist()
        sums = [float(np.sum(cells[..., k])) * volume for k in rows]
        warmth = sums[burning.TEMPERATURE] - self.made_of.ambient * volume * cells.shape[0] * cells.shape[1]
        return self.made_of.capacity * warmth, sums[burning.FUEL], sums[burning.OXYGEN], sums[burning.SOOT]

    def pressure_ratio(self, cells: Floats) -> float:
        """Of a vessel that was shut at the ambient temperature: the mean temperature over it (ideal gas)."""
        return float(np.mean(cells[..., int(self.columns[burning.TEMPERATURE])])) / self.made_of.ambient


def checked_cells(cells: Floats, columns: Sequence[int]) -> None:
    """ValueError, naming field and cell, for a temperature at or below 0 K or an amount that is not
    finite.
    """
    names = ("temperature", "fuel", "oxygen", "soot")
    for name, k, least in zip(names, columns, (LEAST_TEMPERATURE, 0.0, 0.0, 0.0), strict=True):
        wrong = np.argwhere(~((cells[..., k] >= least) & (cells[..., k] < 1e300)))
        if len(wrong):
            j, i = wrong[0].tolist()
            raise ValueError(
                f"{name}[{j}, {i}] = {cells[j, i, k]!r}: expected a finite number, at least {least:g}"
            )
