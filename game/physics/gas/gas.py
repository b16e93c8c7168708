"""A gas on a grid: velocity, pressure, and what it carries along."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.gas.arrays import LAST, SETTLED, TIME, GasState, make_room, make_state
from game.physics.gas.effects import VISCOSITY
from game.physics.gas.ledger import Ledger
from game.physics.gas.loads import Load, loads_on
from game.physics.gas.settings import GasSettings
from game.physics.gas.solids import GasSolids
from game.physics.gas.stepping import Step, advance
from game.physics.grid import Borders, Grid, edges_of
from game.physics.grid.borders import INFLOW, OPEN
from game.physics.grid.obstacles import Sampled
from game.physics.kernels import elementary
from game.physics.kernels.finite import finite_doubles
from game.physics.multigrid import Found, PressureSolver

FIELDS = ("smoke", "temperature", "fuel", "oxygen", "soot")
AIR_OXYGEN = 0.23  # mass fraction in air
MOST_FIELDS = 16


class Report(NamedTuple):
    """What the last step did about the pressure."""

    turns: int
    before: float  # largest change of a cell's volume in the step, before the projection, and left after it
    after: float
    centring: float  # q that the step used
    squeezed: float  # largest rate (1/s) at which a closed region had to be squeezed for its sources


class Gas:
    """Gas on a staggered grid, with fields that it carries, solids in it, and sources between steps.

    >>> gas = Gas(Grid(128, 64, 1 / 64), Borders(left=Border("inflow", (1.0, 0.0)), right=Border("open")))
    >>> gas.field("smoke")[28:36, :4] = 1.0
    >>> gas.step(1 / 60)

    grid: `Grid`; borders: `Borders` (walls all around if not given; a wind is an "inflow" side and an "open"
    one opposite); fields: names of the scalars carried along, by default FIELDS; ambient: what the
    surroundings have of them (0 if not named; temperature settings.ambient K, oxygen 0.23): the gas begins
    with it, and it comes in through open sides. ValueError, naming the argument, for nonsense.

    Arrays, all C-contiguous float64, which stay the same objects; write into them between steps:

    - ``u`` (ny, nx + 1), ``v`` (ny + 1, nx) m/s on faces; ``scalars`` (ny, nx, fields), interleaved;
      ``field(name)`` a view (ny, nx) of one. ``pressure`` (ny, nx) m²/s²: over the density of air.
    - Sources, which stay until they are changed: ``expansion`` (ny, nx) 1/s, volume that a cell produces for
      each volume (less its mean over a closed region: ``report.squeezed``); ``force`` (ny, nx, 2) m/s²;
      ``rates`` (ny, nx, fields) change of the scalars, per s (heat as K/s into "temperature").
    - ``faces`` (`SolidFaces`): open parts ``ax``, ``ay`` of faces, ``volume`` of cells, ``body`` ids.

    Solids: `set_solids(surface, ...)`; each answers ``sample(points)`` as those of `physics.surfaces` do.
    With moving=True they are sampled again before every step, and push the gas with their true velocity.
    `loads()` is the force on them.

    A step: everything is carried (with `rates`), diffuses, forces push, viscosity drags, the pressure makes
    the flow free of divergence but for `expansion`. After an explosion or any jump by hand call `jolt()`: the
    next step is then fully implicit in the pressure. ``report`` tells what the solver did. After a step with
    a number that is not finite `step` raises ValueError, naming array and index. Velocity and scalars are
    then what they were before the step.
    """

    def __init__(
        self,
        grid: Grid,
        borders: Borders | None = None,
        settings: GasSettings | None = None,
        fields: tuple[str, ...] = FIELDS,
        ambient: Mapping[str, float] | None = None,
    ):
        self.grid, self.settings, self.fields = grid, settings or GasSettings(), tuple(fields)
        if len(set(self.fields)) != len(self.fields) or not 1 <= len(self.fields) <= MOST_FIELDS:
            raise ValueError(f"fields = {fields!r}: expected 1 to {MOST_FIELDS} different names")
        self._index = {name: k for k, name in enumerate(self.fields)}
        usual = {"temperature": self.settings.ambient, "oxygen": AIR_OXYGEN}
        given = {name: value for name, value in usual.items() if name in self._index} | dict(ambient or {})
        self.ambient: Floats = np.zeros(len(self.fields))
        for name, value in given.items():
            self.ambient[self.column(name)] = value
        if not np.isfinite(self.ambient).all():
            raise ValueError("ambient: expected finite numbers")
        self._borders = borders or Borders()
        self.edges = edges_of(self._borders, grid)
        self.solver = PressureSolver(grid.nx, grid.ny, self.edges.kinds)
        self._state = make_state(grid, len(self.fields), self.solver.equation.p)
        self._room = make_room(grid, len(self.fields))
        ny, nx = grid.shape
        self.expansion: Floats = np.zeros((ny, nx))
        self.force: Floats = np.zeros((ny, nx, 2))
        self.rates: Floats = np.zeros((ny, nx, len(self.fields)))
        self._held = np.zeros((4, len(self.fields)), np.bool_)
        self._values: Floats = np.zeros((4, len(self.fields)))
        self._hold_scalars()
        self.solids = GasSolids(grid)
        self.scalars[:] = self.ambient
        self.report = Report(0, 0.0, 0.0, 1.0, 0.0)
        self.ledger: Ledger | None = None

    # -- what it is ---------------------------------------------------------------------------------

    @property
    def u(self) -> Floats:
        """(ny, nx + 1) m/s along x, on faces."""
        return self._state.u

    @property
    def v(self) -> Floats:
        """(ny + 1, nx) m/s along y, on faces."""
        return self._state.v

    @property
    def scalars(self) -> Floats:
        """(ny, nx, fields), interleaved."""
        return self._state.scalars

    @property
    def pressure(self) -> Floats:
        """(ny, nx) m²/s², over the density of air; a view."""
        return self.solver.pressure

    @property
    def faces(self):
        """`SolidFaces`: open parts of faces and cells, velocity of the solid."""
        return self.solids.faces

    @property
    def time(self) -> float:
        """s that have been simulated."""
        return float(self._state.clock[TIME])

    def column(self, name: str) -> int:
        """Where a field stands in `scalars`; ValueError for an unknown name."""
        if name not in self._index:
            raise ValueError(f"field {name!r}: expected one of {', '.join(self.fields)}")
        return self._index[name]

    def field(self, name: str) -> Floats:
        """(ny, nx), a view into `scalars`."""
        return self.scalars[:, :, self.column(name)]

    # -- what holds at its sides and in it ----------------------------------------------------------

    @property
    def borders(self) -> Borders:
        """What holds at the sides."""
        return self._borders

    def set_borders(self, borders: Borders) -> None:
        """Other velocities or values at the sides, as of a wind that changes. ValueError for other kinds of
        sides, which need another gas.
        """
        edges = edges_of(borders, self.grid)
        if not np.array_equal(edges.kinds, self.edges.kinds):
            raise ValueError("borders: the kinds of the sides cannot change")
        self._borders = borders
        self.edges.velocities[:] = edges.velocities
        self._hold_scalars()

    def _hold_scalars(self) -> None:
        for number, side in enumerate(self._borders.sides):
            flows = self.edges.kinds[number] in (OPEN, INFLOW)
            self._held[number] = flows
            self._values[number] = self.ambient
            for name, value in side.scalars.items():
                self._held[number, self.column(name)] = True
                self._values[number, self.column(name)] = value

    def set_solids(self, *surfaces: Sampled, moving: bool = False) -> None:
        """Solids in the gas from now on, none for none; moving: sampled again before each step."""
        self.solids.set(surfaces, moving)
        self._take_faces()
        self.jolt()

    def set_open_parts(self, ax: ArrayLike, ay: ArrayLike) -> None:
        """Solids at rest by the open parts of faces, ax (ny, nx + 1), ay (ny + 1, nx), 0 to 1."""
        self.solids.set_parts(np.asarray(ax, dtype=np.float64), np.asarray(ay, dtype=np.float64))
        self._take_faces()
        self.jolt()

    def _take_faces(self) -> None:
        faces = self.solids.faces
        kept = np.array([name in self.settings.conservative for name in self.fields])
        self.solids.move_scalars(self._state, self.ambient, kept)
        self.solver.set_faces(faces.ax, faces.ay)
        self._state.solid_x[:], self._state.solid_y[:] = faces.ax, faces.ay

    def jolt(self) -> None:
        """The next step does not rely on pressure and velocity of the last one."""
        self._state.clock[SETTLED] = 0.0

    # -- a step -------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0, or if the gas comes to numbers that
        are not finite.
        """
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        state, clock = self._state, self._state.clock
        moved = self.solids.follow(dt)
        if moved:
            self._take_faces()
        if abs(dt - clock[LAST]) > 1e-9 * dt or moved:
            clock[SETTLED] = 0.0
        np.copyto(self._room.kept, state.scalars)
        step = Step(
            self.grid.cell, float(dt), self.settings, self.edges, self._held, self._values, self.fields,
            self.ambient, self.ledger,
        )  # fmt: skip
        sources = (self.expansion, self.force, self.rates)
        found, q = advance(state, self._room, self.solver, self.solids, sources, step)
        clock[TIME] += dt
        clock[LAST], clock[SETTLED] = dt, 1.0
        self._tell(found, q, dt)
        self._check()

    def _tell(self, found: Found, q: float, dt: float) -> None:
        scale = q * elementary.square(dt / self.grid.cell)
        removed = self.solver.removed
        squeezed = float(np.max(np.abs(removed), initial=0.0)) * scale / dt
        self.report = Report(int(found.turns), found.before * scale, found.after * scale, q, squeezed)

    def _check(self) -> None:
        """ValueError, after going back, if a number is not finite."""
        for name in ("u", "v", "pressure", "scalars"):
            array = getattr(self._state, name)
            if not finite_doubles(array.reshape(-1).view(np.uint64)):
                index = tuple(int(k) for k in np.argwhere(~np.isfinite(array))[0])
                self._go_back()
                raise ValueError(f"{name}{list(index)} is not finite after the step to {self.time:.6g} s")

    def _go_back(self) -> None:
        """The fields as they were before the step; what it knew of the pressure is given up."""
        state = self._state
        for goal, source in ((state.u, state.before_u), (state.v, state.before_v)):
            np.copyto(goal, source)
        np.copyto(state.scalars, self._room.kept)
        for array in (state.pressure, state.force_u, state.force_v):
            array[:] = 0.0
        self.jolt()

    @staticmethod
    def _copy(source: GasState, goal: GasState) -> None:
        for one, other in zip(source, goal, strict=True):
            np.copyto(other, one)

    # -- what is there ------------------------------------------------------------------------------

    def velocity(self) -> Floats:
        """(ny, nx, 2) m/s at centres, a new array."""
        u, v = self.u, self.v
        return np.stack([0.5 * (u[:, 1:] + u[:, :-1]), 0.5 * (v[1:] + v[:-1])], axis=2)

    def sample(self, points: ArrayLike, time: float = 0.0) -> Floats:
        """(n, 2) m/s at points (n, 2) m, linear between faces; as at the sides beyond them. A wind field."""
        places = np.asarray(points, dtype=np.float64).reshape(-1, 2)
        if not np.isfinite(places).all():
            raise ValueError("points: expected finite points (n, 2)")
        x = (places[:, 0] - self.grid.lower[0]) / self.grid.cell
        y = (places[:, 1] - self.grid.lower[1]) / self.grid.cell
        return np.stack([_between(self.u, x, y - 0.5), _between(self.v, x - 0.5, y)], axis=1)

    def vorticity(self) -> Floats:
        """(ny + 1, nx + 1) 1/s at nodes; 0 on the sides."""
        found = np.zeros((self.grid.ny + 1, self.grid.nx + 1))
        rise = self.v[1:-1, 1:] - self.v[1:-1, :-1]
        found[1:-1, 1:-1] = (rise - (self.u[1:, 1:-1] - self.u[:-1, 1:-1])) / self.grid.cell
        return found

    def divergence(self) -> Floats:
        """(ny, nx) 1/s, of gas and solid together, less what `expansion` asks; 0 in closed cells."""
        f, u, v = self.solids.faces, self.u, self.v
        across, up = f.u + f.ax * (u - f.u), f.v + f.ay * (v - f.v)
        found = (across[:, 1:] - across[:, :-1] + up[1:] - up[:-1]) / self.grid.cell - self.expansion
        return np.asarray(np.where(self.solver.equation.inverse > 0.0, found, 0.0))

    def energy(self) -> float:
        """Kinetic, m⁴/s²: half the square of the velocity over the open part of faces, over the density."""
        f, h = self.solids.faces, self.grid.cell
        square_u, square_v = f.ax * (self.u * self.u), f.ay * (self.v * self.v)
        total = np.sum(square_u[:, 1:] + square_u[:, :-1]) + np.sum(square_v[1:] + square_v[:-1])
        return 0.25 * h * h * float(total)

    def total(self, name: str) -> float:
        """A field over the cells that are not closed, times their area, m²."""
        open_cells = self.solver.equation.inverse > 0.0
        return float(np.sum(self.field(name)[open_cells])) * (self.grid.cell * self.grid.cell)

    def loads(self, point: tuple[float, float] = (0.0, 0.0), density: float = 1.2) -> list[Load]:
        """Force (N/m) on each body and torque (N) about a point (m), by a gas of a density (kg/m³).

        Pressure on the outline, and, where the gas sticks (settings.slip False), drag along closed faces.
        """
        if not 0.0 < density < math.inf or not all(map(math.isfinite, point)):
            raise ValueError(
                f"density = {density!r}, point = {point!r}: expected a number above 0, and a place"
            )
        h, lower, chosen = self.grid.cell, self.grid.lower, self.settings
        places = np.array([lower[0] + 0.5 * h, lower[1] + 0.5 * h, float(point[0]), float(point[1])])
        drags = not chosen.slip and VISCOSITY in chosen.effects
        numbers = np.array([h, chosen.viscosity if drags else 0.0])
        found = loads_on(self._state.pressure, self.u, self.v, self.solids.faces, places, numbers)
        return [
            Load(load.body, (density * load.force[0], density * load.force[1]), density * load.torque)
            for load in found
        ]

    def keep_books(self, kept: bool = True) -> None:
        """Write down from now on what changes momentum and fields (``ledger``), or no more."""
        self.ledger = Ledger(self.grid.cell, self.edges.kinds, len(self.fields)) if kept else None

    def state(self) -> GasState:
        """All that later steps depend on: views, not copies."""
        return self._state

    def restore(self, state: GasState) -> None:
        """Take over a copy of a state of a gas of the same size; solids must be where they were then."""
        changed = not (
            np.array_equal(state.solid_x, self._state.solid_x)
            and np.array_equal(state.solid_y, self._state.solid_y)
        )
        self._copy(state, self._state)
        if self.ledger is not None:
            self.ledger.forget()
        if changed:
            self.solids.restore(state.solid_x, state.solid_y)
            self.solver.set_faces(state.solid_x, state.solid_y)


def _between(field: Floats, x: Floats, y: Floats) -> Floats:
    """Bilinear values at x, y counted in points, as at the rim beyond it."""
    rows, columns = field.shape
    x, y = np.clip(x, 0.0, columns - 1.0), np.clip(y, 0.0, rows - 1.0)
    i, j = np.minimum(x.astype(int), columns - 2), np.minimum(y.astype(int), rows - 2)
    f, g = x - i, y - j
    low = (1.0 - f) * field[j, i] + f * field[j, i + 1]
    high = (1.0 - f) * field[j + 1, i] + f * field[j + 1, i + 1]
    return np.asarray((1.0 - g) * low + g * high)
