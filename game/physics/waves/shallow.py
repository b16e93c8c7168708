"""Shallow water in a channel or a basin: depth and discharge over a bed, stepped row by row.

The equations of Saint-Venant (1871). Rows and columns are swept in turn, in the other order in every other
step (Strang 1968); how a sweep works is told in `riemann`. Friction at the bed is Manning's (1891), taken at
the end of the step, so that it only slows.
"""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.kernels import elementary
from game.physics.kernels.lanes import LANES
from game.physics.waves.riemann import (
    ACROSS,
    ALONG,
    BED,
    DEPTH,
    DRY,
    GHOSTS,
    MASS,
    PERIODIC,
    ROWS,
    WORKS,
    fastest,
    fill_ghosts,
    padded,
    sweep_row,
)
from game.settings import Number, Option

ENDS = ("wall", "open", "periodic", "flow", "level")
METHODS = ("constant", "linear")
MOST_STEPS = 10_000  # in one `advance`
ENDS_GAVE, RAIN_GAVE = range(2)  # of ``came``


class ShallowSettings(NamedTuple):
    """How shallow water is stepped."""

    gravity: Annotated[float, Number(0.0, 30.0, help="downwards", unit="m/s²")] = 9.81
    method: Annotated[int, Option(METHODS, help="how depth and speed go through a cell")] = 1
    courant: Annotated[float, Number(0.05, 1.0, help="cells that the fastest wave crosses in a step")] = 0.5
    roughness: Annotated[
        float, Number(0.0, 0.2, unit="m^(-1/3) s", help="of the bed: 0.01 glass, 0.03 a river")
    ] = 0.0  # Manning's number
    rain: Annotated[float, Number(0.0, 0.1, unit="m/s", help="that falls everywhere")] = 0.0


class ShallowState(NamedTuple):
    """depth, along, across, bed: (ny, nx) m, m²/s, m; kinds, values: (4,) of the ends.

    came: (2,) through the ends and as rain, in the unit of the volume; clock: (2,) s since the start, steps.
    """

    depth: Floats
    along: Floats
    across: Floats
    bed: Floats
    kinds: Longs
    values: Floats
    came: Floats
    clock: Floats


@kernel
def _sweep_rows(fields, row, work, ends, came, size, ratio, gravity, second):
    """Sweep all rows; fields: depth, along, across, bed, each (ny, nx), or transposed views of them.

    came: what goes through both ends is added; size: of a cell, in the unit of the volume for 1 m of depth.
    """
    depth, along, across, bed = fields
    count = depth.shape[1]
    for j in range(depth.shape[0]):
        for i in range(count):
            row[DEPTH, i + GHOSTS] = depth[j, i]
            row[ALONG, i + GHOSTS] = along[j, i]
            row[ACROSS, i + GHOSTS] = across[j, i]
            row[BED, i + GHOSTS] = bed[j, i]
        fill_ghosts(row, count, ends[0], ends[1], gravity)
        sweep_row(row, work, count, ratio, gravity, second)
        came[ENDS_GAVE] += size * ratio * (work[MASS, GHOSTS] - work[MASS, GHOSTS + count])
        for i in range(count):
            depth[j, i] = row[DEPTH, i + GHOSTS]
            along[j, i] = row[ALONG, i + GHOSTS]
            across[j, i] = row[ACROSS, i + GHOSTS]


@kernel
def _rub(depth, along, across, strength):
    """Friction of the bed; strength: g n² dt, m^(1/3)."""
    for j in range(depth.shape[0]):
        for i in range(depth.shape[1]):
            h = depth[j, i]
            if h > DRY:
                speed = elementary.hypot(along[j, i], across[j, i]) / h
                kept = 1.0 / (1.0 + strength * speed / elementary.pow(h, 4.0 / 3.0))
                along[j, i] *= kept
                across[j, i] *= kept


class ShallowWater:
    """Water of ``depth`` (ny, nx) m over a ``bed`` of square cells. One row is a channel."""

    def __init__(
        self,
        depth: ArrayLike,
        bed: ArrayLike,
        cell: float,
        settings: ShallowSettings | None = None,
        ends: tuple[str, str, str, str] = ("wall", "wall", "wall", "wall"),
        values: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0),
    ):
        """cell: m; ends: at the left, right, bottom and top. ValueError for nonsense.

        values: discharge to the right or upwards (m²/s) of an end with a "flow", height (m) of a "level".
        """
        self.depth: Floats = np.array(depth, dtype=np.float64, ndmin=2)
        self.bed: Floats = np.array(bed, dtype=np.float64, ndmin=2)
        if self.depth.ndim != 2 or self.depth.size == 0 or self.bed.shape != self.depth.shape:
            raise ValueError(
                f"depth and bed: expected two tables alike, not {self.depth.shape}, {self.bed.shape}"
            )
        if not (np.isfinite(self.depth).all() and np.isfinite(self.bed).all() and (self.depth >= 0.0).all()):
            raise ValueError("depth and bed: expected finite numbers, depths at least 0")
        if not 0.0 < cell < math.inf:
            raise ValueError(f"cell = {cell!r}: expected a length above 0 m")
        for first, last in (ends[:2], ends[2:]):
            if not {first, last} <= set(ENDS) or (first == "periodic") != (last == "periodic"):
                raise ValueError(f"ends = {ends!r}: expected {', '.join(ENDS)}, periodic in pairs")
        self.cell = float(cell)
        self._size = self.cell if len(self.depth) == 1 else self.cell * self.cell
        self.values: Floats = np.array(values, dtype=np.float64)
        if self.values.shape != (4,) or not np.isfinite(self.values).all():
            raise ValueError(f"values = {values!r}: expected 4 finite numbers")
        self.settings = settings or ShallowSettings()
        self.along: Floats = np.zeros_like(self.depth)
        self.across: Floats = np.zeros_like(self.depth)
        self.came: Floats = np.zeros(2)
        self.clock: Floats = np.zeros(2)
        self.kinds: Longs = np.array([ENDS.index(end) for end in ends], dtype=np.int64)
        width = padded(max(self.depth.shape))
        self._row, self._work = np.zeros((ROWS, width)), np.zeros((WORKS, width))
        self._lanes = np.zeros(LANES)

    def set_end(self, number: int, kind: str, value: float) -> None:
        """What is at an end from now on: 0 left, 1 right, 2 bottom, 3 top. ValueError for what is none."""
        if kind not in ENDS or (kind == "periodic") != (self.kinds[number ^ 1] == PERIODIC):
            raise ValueError(f"kind = {kind!r}: expected {', '.join(ENDS)}, periodic in pairs")
        self.kinds[number] = ENDS.index(kind)
        self.values[number] = value

    @property
    def time(self) -> float:
        """s since the start."""
        return float(self.clock[0])

    def fastest(self) -> float:
        """m/s, of the waves."""
        return float(fastest(self.depth, self.along, self.across, self.settings.gravity, self._lanes))

    def longest_step(self) -> float:
        """s of the step at the Courant number; inf if nothing is wet."""
        speed = self.fastest()
        return self.settings.courant * self.cell / speed if speed > 0.0 else math.inf

    def step(self, dt: float) -> None:
        """One step of dt (s); ValueError for one in which a wave crosses more than a cell."""
        self._step(dt, self.fastest())

    def _step(self, dt: float, speed: float) -> None:
        if not 0.0 <= dt * speed <= self.cell * (1.0 + 1e-12):
            raise ValueError(
                f"dt = {dt!r}: a wave of {speed:.4g} m/s would cross more than a cell of {self.cell:g} m"
            )
        settings, ratio = self.settings, dt / self.cell
        if settings.rain > 0.0:
            self.depth += settings.rain * dt
            self.came[RAIN_GAVE] += settings.rain * dt * self.depth.size * self._size
        second = settings.method == METHODS.index("linear")
        rows = (self.depth, self.along, self.across, self.bed)
        columns = (self.depth.T, self.across.T, self.along.T, self.bed.T)
        sweeps = [
            (rows, (self.kinds[:2], self.values[:2])),
            (columns, (self.kinds[2:], self.values[2:])),
        ]
        if self.depth.shape[0] == 1:
            sweeps = sweeps[:1]
        elif int(self.clock[1]) % 2:
            sweeps.reverse()
        for fields, ends in sweeps:
            _sweep_rows(
                fields, self._row, self._work, ends, self.came, self._size, ratio, settings.gravity, second
            )
        if settings.roughness > 0.0:
            strength = settings.gravity * elementary.square(settings.roughness) * dt
            _rub(self.depth, self.along, self.across, strength)
        self.clock[0] += dt
        self.clock[1] += 1.0

    def advance(self, duration: float) -> int:
        """Go on by a duration (s) in equal steps, again and again at the Courant number; how many were made.

        RuntimeError if there would be more than ``MOST_STEPS``.
        """
        left, made = duration, 0
        while left > 0.0:
            speed = self.fastest()
            parts = max(1.0, math.ceil(left * speed / (self.settings.courant * self.cell) - 1e-9))
            if made + parts > MOST_STEPS:
                raise RuntimeError(f"shallow water: more than {MOST_STEPS} steps in {duration:g} s")
            dt = left / parts
            self._step(dt, speed)
            left, made = left - dt if parts > 1.0 else 0.0, made + 1
        return made

    # -- what is there ------------------------------------------------------------------------------

    def velocity(self) -> tuple[Floats, Floats]:
        """Speeds along and across (ny, nx), m/s; 0 where it is dry."""
        wet = self.depth > DRY
        safe = np.where(wet, self.depth, 1.0)
        return np.where(wet, self.along / safe, 0.0), np.where(wet, self.across / safe, 0.0)

    def volume(self) -> float:
        """m³; of a channel m², for each metre of width."""
        return float(np.sum(self.depth)) * self._size

    def energy(self) -> float:
        """Of motion and of height above z = 0, J at a density of 1 kg/m³; of a channel for 1 m of width."""
        u, v = self.velocity()
        motion = 0.5 * self.depth * (u * u + v * v)
        height = self.settings.gravity * self.depth * (self.bed + 0.5 * self.depth)
        return float(np.sum(motion + height)) * self._size

    def state(self) -> ShallowState:
        """All that later steps depend on."""
        return ShallowState(
            self.depth, self.along, self.across, self.bed, self.kinds, self.values, self.came, self.clock
        )

    def restore(self, state: ShallowState) -> None:
        """Take over a copy of a state."""
        for field, saved in zip(self.state(), state, strict=True):
            field[...] = saved
