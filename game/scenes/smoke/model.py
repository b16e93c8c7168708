"""A box of gas by the method that is chosen: sources, solids, fire, stirring, what is measured."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.combustion import Flames, GasFuel
from game.physics.combustion.effects import COMBUSTION, EXPANSION
from game.physics.effects import EffectSet
from game.physics.gas import Gas, GasSettings
from game.physics.gas.effects import BUOYANCY, CONFINEMENT, GAS
from game.physics.gas.forces import buoyancy
from game.physics.grid import Border, Borders, Grid
from game.physics.kernels import elementary, elementwise
from game.physics.stable_fluids import PrintedFluid
from game.scenes.smoke import discs
from game.scenes.smoke.discs import DiscObstacles
from game.scenes.smoke.level import MOST_SOLIDS, SmokeContent
from game.scenes.smoke.parameters import DYES, PRINTED, SmokeParameters
from game.stage import Part
from game.worlds.stopwatch import Stopwatch

WIDE, TALL = 2.0, 1.0  # m
FIELDS = ("smoke", "temperature", "fuel", "oxygen", "soot")
SMOKE, WARM, FUEL, OXYGEN, SOOT = range(5)
DYED = (*FIELDS, *DYES)  # fields once a coloured dye is in the gas
ROOM, FRESH, WIND = 293.15, 0.27, 0.8  # K, kg/m³, m/s
GRAVITY = 9.81  # m/s²
BURNS = {
    "ignition": 520.0, "rate": 25.0, "oxygen": 1.3, "heat": 1.6e7, "soot": 0.05, "soot_rate": 2.0,
    "glow": 8e-12, "soot_glow": 2.5e-7, "ambient": ROOM,
}  # fmt: skip
WHIRL = 0.6  # m/s, the fastest of the whirl at the start
HOT_LAYER = 373.15  # K


class SmokeState(NamedTuple):
    """fluid: a GasState, or of a printed paper a PrintedState; solids (n, 5): place, radius m, velocity m/s;
    books (6,) of what burnt.
    """

    fluid: Any
    solids: Floats
    books: Floats


class SmokeModel(Part):
    """time s. gas or printed: whichever method is chosen."""

    def __init__(self, content: SmokeContent, parameters: SmokeParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        self.time, self.watch = 0.0, Stopwatch()
        nx = int(parameters.cells)
        self.grid = Grid(nx, nx // 2, WIDE / nx)
        self.cell = self.grid.cell
        self.obstacles = DiscObstacles()
        self.obstacles.rows = np.array(
            [(*one.at, one.radius, 0.0, 0.0) for one in content.solids], dtype=np.float64
        ).reshape(-1, 5)  # fmt: skip
        self.gas: Gas | None = None
        self.printed: PrintedFluid | None = None
        dyed = any(one.dye in DYES for one in content.sources)
        self._make_fluid(DYED if dyed else FIELDS)
        self.flames = Flames((WARM, FUEL, OXYGEN, SOOT), self.cell, self._burns())
        self._source = np.zeros(self.grid.shape)
        self.scalars[:] = self.fresh()
        self._begin()
        self.take_solids()
        self.given = math.nan  # K m², by hand and sources in the last step
        self.keep_books()
        self.smoke_at_first = self.total(SMOKE)
        self.energy_at_first = self.energy()

    # -- what it is made of -------------------------------------------------------------------------------

    def _make_fluid(self, fields: tuple[str, ...]) -> None:
        """A new fluid, at rest, that carries these fields. Dyes cost time, so only who uses them has them."""
        self.fields, chosen = fields, self.parameters
        if chosen.method in PRINTED:
            self.printed = PrintedFluid(
                self.grid.shape, self.cell, len(fields), chosen.method, chosen.viscosity, self._turns()
            )
        else:
            self.gas = Gas(self.grid, self._borders(), self._settings(), fields, {"oxygen": FRESH})

    def _change_fields(self, fields: tuple[str, ...]) -> None:
        """Go on as before with other fields; those that are new are empty."""
        gas, printed = self.gas, self.printed
        self._make_fluid(fields)
        self.take_solids()
        self.keep_books()
        if gas is not None and self.gas is not None:
            state = gas.state()
            self.gas.restore(state._replace(scalars=_as_wide(state.scalars, len(fields))))
        elif printed is not None and self.printed is not None:
            told = printed.state()
            self.printed.restore(told._replace(fields=_as_wide(told.fields, len(fields))))

    def column(self, ink: str) -> int:
        """Where smoke or a dye stands in the scalars. The first dye brings the fields of all of them."""
        if ink in DYES and self.fields != DYED:
            self._change_fields(DYED)
        return self.fields.index(ink)

    def fresh(self) -> Floats:
        """(fields,) of fresh air."""
        air = np.zeros(len(self.fields))
        air[WARM], air[OXYGEN] = ROOM, FRESH
        return air

    def _borders(self) -> Borders:
        if self.content.sides == "closed":
            return Borders.all("wall")
        if self.content.sides == "wind":
            return Borders(Border("inflow", (WIND, 0.0)), Border("open"), Border("wall"), Border("wall"))
        return Borders(Border("wall"), Border("wall"), Border("wall"), Border("open"))

    def _turns(self) -> int:
        return max(int(self.parameters.turns), 20 if self.parameters.method == "stam-2003" else 1)

    def _settings(self) -> GasSettings:
        chosen = self.parameters
        effects = (self.active & GAS.known).without(BUOYANCY)
        if chosen.confinement == 0.0:
            effects = effects.without(CONFINEMENT)
        return GasSettings(
            effects=effects, advection=chosen.method, pressure=chosen.pressure,
            turns=max(int(chosen.turns), self._fewest()),
            viscosity=chosen.viscosity, confinement=chosen.confinement, ambient=ROOM,
            conservative=self.fields if chosen.flux else (),
        )  # fmt: skip

    def _fewest(self) -> int:
        """V-cycles at least: beside solids a pressure that is carried along lets its errors grow with
        fewer.
        """
        return 6 if self.parameters.method == "time-centred" and len(self.obstacles.rows) else 1

    def _burns(self) -> GasFuel:
        effects = self.active & COMBUSTION.known
        return GasFuel(**BURNS, effects=effects)

    def change(self) -> None:
        """Take over parameters and effects."""
        if self.gas is not None:
            self.gas.settings = self._settings()
        elif self.printed is not None:
            self.printed.viscosity, self.printed.most = float(self.parameters.viscosity), self._turns()
        self.flames.made_of = self._burns()
        self.keep_books()
        self.watch.clear()

    def keep_books(self) -> None:
        """Begin or end the books of the gas, as chosen."""
        if self.gas is not None and (self.gas.ledger is not None) != bool(self.parameters.books):
            self.gas.keep_books(bool(self.parameters.books))

    def change_effects(self, active: EffectSet) -> None:
        """Compute these from now on."""
        self.active = active
        self.change()

    def _begin(self) -> None:
        _x, y = self.grid.centres()
        if self.content.start == "layers":
            self.scalars[..., WARM] = np.where(y > 0.5 * TALL, HOT_LAYER, ROOM)
        if self.content.start == "whirl":
            self.scalars[..., SMOKE] = (y > 0.5 * TALL).astype(np.float64)
            self._set_velocity(_whirl)

    def _set_velocity(self, flow: Any) -> None:
        """A velocity by a function of places."""
        if self.gas is not None:
            self.gas.u[:] = flow(*self.grid.u_places())[0]
            self.gas.v[:] = flow(*self.grid.v_places())[1]
            self.gas.jolt()
        elif self.printed is not None:
            u, v, _ = self.printed.inner
            u[:], v[:] = flow(*self.grid.centres())

    @property
    def scalars(self) -> Floats:
        """(ny, nx, fields), not copied."""
        if self.gas is not None:
            return self.gas.scalars
        assert self.printed is not None
        return self.printed.inner[2]

    def velocity(self) -> Floats:
        """(ny, nx, 2) m/s in the middles of cells."""
        if self.gas is not None:
            return self.gas.velocity()
        assert self.printed is not None
        return np.stack(self.printed.inner[:2], axis=2)

    def pressure(self) -> Floats:
        """(ny, nx) m²/s², over the density of air: of the last step, less its mean."""
        if self.gas is not None:
            found = self.gas.pressure
        else:
            assert self.printed is not None  # its pressure holds for a step, as it is taken from velocities
            found = self.printed.pressure[1:-1, 1:-1] / self.parameters.step_length
        return np.asarray(found - np.mean(found))

    def divergence(self) -> Floats:
        """(ny, nx) 1/s that should not be there: from face to face, as what is carried feels it."""
        if self.gas is not None:
            return self.gas.divergence()
        assert self.printed is not None
        return self.printed.face_divergence()

    def vorticity(self) -> Floats:
        """(ny, nx) 1/s."""
        w, h = self.velocity(), self.cell
        return np.asarray(np.gradient(w[..., 1], h, axis=1) - np.gradient(w[..., 0], h, axis=0))

    # -- solids -------------------------------------------------------------------------------------------

    def take_solids(self) -> None:
        """Let the gas know where the discs are."""
        if self.gas is not None:
            self.gas.settings = self._settings()
            if len(self.obstacles.rows):
                self.gas.set_solids(self.obstacles)
            elif self.gas.solids.present:
                self.gas.set_solids()
            return
        assert self.printed is not None
        x, y = self.grid.centres()
        found = self.obstacles.sample(np.stack([x.ravel(), y.ravel()], axis=1)).distance.reshape(x.shape)
        self.printed.solid[:] = found < 0.0

    def solid_at(self, point: tuple[float, float]) -> int:
        """Number of the disc at a point, or -1."""
        for number, (x, y, radius, _, _) in enumerate(self.obstacles.rows.tolist()):
            if elementary.dist((x, y), point) <= radius:
                return number
        return -1

    def add_solid(self, point: tuple[float, float], radius: float) -> int:
        """A disc more; its number, or -1 if there are too many."""
        if len(self.obstacles.rows) >= MOST_SOLIDS:
            return -1
        self.obstacles.rows = np.concatenate([self.obstacles.rows, [[*point, radius, 0.0, 0.0]]])
        self.take_solids()
        return len(self.obstacles.rows) - 1

    def lead_solid(self, number: int, point: tuple[float, float], dt: float) -> None:
        """Move a disc to a point within a step; it pushes the gas with the velocity that this takes."""
        row = self.obstacles.rows[number]
        row[discs.VX], row[discs.VY] = (point[0] - row[discs.X]) / dt, (point[1] - row[discs.Y]) / dt
        row[discs.X], row[discs.Y] = point
        self.take_solids()

    def rest_solids(self) -> None:
        """What is not led stands still."""
        if len(self.obstacles.rows) and np.any(self.obstacles.rows[:, discs.VX :]):
            self.obstacles.rows[:, discs.VX :] = 0.0
            self.take_solids()

    def clear(self) -> None:
        """Fresh air everywhere, and nothing in it."""
        self.scalars[:] = self.fresh()

    # -- a step -------------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """Sources, fire, then the gas."""
        with self.watch.time("step"):
            self._advance(dt)
        self.time += dt

    def _advance(self, dt: float) -> None:
        cells = self.scalars
        began = self._warmth()
        x, y = self.grid.centres()
        for one in self.content.sources:
            if self.time >= one.seconds:
                continue
            near = (
                elementary.square(x - one.at[0]) + elementary.square(y - one.at[1]) < one.radius * one.radius
            )
            column = self.fields.index(one.dye)
            cells[near, column] = np.maximum(cells[near, column], one.smoke)
            cells[near, WARM] = np.maximum(cells[near, WARM], one.kelvin)
            cells[near, FUEL] = np.maximum(cells[near, FUEL], one.fuel)
            if one.velocity is not None:
                self._blow(near, one.velocity)
        self._note_given(began)
        self._source[:] = 0.0
        if self.printed is not None:  # its cells lie within a ring of ghosts
            own = np.ascontiguousarray(cells)
            self.flames.step(own, dt, self._source)
            cells[:] = own
        else:
            self.flames.step(cells, dt, self._source)
        lift = self.parameters.lift * GRAVITY if BUOYANCY in self.active else 0.0
        force = self.gas.force if self.gas is not None else np.zeros((*cells.shape[:2], 2))
        buoyancy(np.ascontiguousarray(cells), WARM, ROOM, lift, force)
        if self.gas is not None:
            self.gas.expansion[:] = np.clip(self._source, -60.0, 60.0) if EXPANSION in self.active else 0.0
            self.gas.step(dt)
        elif self.printed is not None:
            self.printed.v[1:-1, 1:-1] += dt * force[..., 1]
            self.printed.step(dt)

    def _warmth(self) -> float:
        """K m² in the gas as its books have it; NaN without books."""
        if self.gas is None or self.gas.ledger is None:
            return math.nan
        return float(self.gas.ledger.contents(self.scalars, self.gas.solids.faces)[WARM])

    def _note_given(self, began: float) -> None:
        """What hand and sources have made of the heat since the last step; began: `_warmth` at its end."""
        ledger = self.gas.ledger if self.gas is not None else None
        left = ledger.left if ledger is not None else None
        hand = began - float(left[WARM]) if left is not None else math.nan
        self.given = hand + (self._warmth() - began)

    def _blow(self, near: NDArray[np.bool_], velocity: tuple[float, float]) -> None:
        if self.gas is not None:
            self.gas.u[:, 1:][near], self.gas.v[1:][near] = velocity
        elif self.printed is not None:
            u, v, _ = self.printed.inner
            u[near], v[near] = velocity

    # -- what there is ------------------------------------------------------------------------------------

    def total(self, field: int) -> float:
        """Of a field over the box, times m²."""
        return float(np.sum(self.scalars[..., field])) * (self.cell * self.cell)

    def dye(self, name: str) -> float:
        """m² of a coloured dye over the box."""
        return self.total(self.fields.index(name)) if name in self.fields else 0.0

    def energy(self) -> float:
        """m⁴/s²: half the square of the velocity over the box."""
        return 0.5 * float(np.sum(elementary.square(self.velocity()))) * (self.cell * self.cell)

    def smear(self) -> float:
        """How mixed the smoke is, 0 to 1: by how much the cells that it lies in are not full of it."""
        smoke = np.clip(self.scalars[..., SMOKE], 0.0, 1.0)
        there = float(np.sum(smoke))
        return float(np.sum(smoke * (1.0 - smoke))) / there if there > 1e-9 else 0.0

    def state(self) -> SmokeState:
        """All that later steps depend on."""
        fluid = self.gas.state() if self.gas is not None else self.printed.state() if self.printed else None
        return SmokeState(fluid, self.obstacles.rows, self.flames.books)

    def restore(self, state: SmokeState) -> None:
        """Take over a copy of a state."""
        carried = state.fluid.scalars if self.gas is not None else state.fluid.fields
        fields = DYED if carried.shape[2] == len(DYED) else FIELDS
        if fields != self.fields:
            self._change_fields(fields)
        moved = not np.array_equal(self.obstacles.rows, state.solids)
        self.obstacles.rows = state.solids.copy()
        if moved:
            self.take_solids()
        if self.gas is not None:
            self.gas.restore(state.fluid)
        elif self.printed is not None:
            self.printed.restore(state.fluid)
        self.flames.books[:] = state.books


def _as_wide(cells: Floats, fields: int) -> Floats:
    """(ny, nx, fields): the first of the cells' fields; nothing in those that they do not have."""
    wide = np.zeros((*cells.shape[:2], fields))
    both = min(fields, cells.shape[2])
    wide[..., :both] = cells[..., :both]
    return wide


def _whirl(x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Two whirls side by side in the box: a steady flow without friction."""
    across, upright = np.pi * x / (0.5 * WIDE), np.pi * y / TALL
    return WHIRL * elementwise.sin(across) * elementwise.cos(upright), -WHIRL * elementwise.cos(
        across
    ) * elementwise.sin(upright)
