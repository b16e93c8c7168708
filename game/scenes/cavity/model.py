"""The gas in a cavity, the clock that steps it, and specks that drift with it."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.gas import Gas, GasSettings, GasState
from game.physics.grid import Border, Borders, Grid
from game.physics.kernels import elementary, elementwise
from game.scenes.cavity.level import CavityContent
from game.scenes.cavity.parameters import CavityParameters
from game.stage import Part

PRANDTL = 0.71
SPECKS = 900
MOST_STEPS = 8  # of the gas in a step of the stage; it lags behind the clock rather than the window
WARM = 0.5  # K above or below the mean of the hot and the cold wall, where 1 K is what they differ by
MEAN = 300.0  # K


class CavityState(NamedTuple):
    """gas; specks: (n, 2) m; clock: (2,) s not yet stepped, largest change of u in the last step over dt."""

    gas: GasState
    specks: Floats
    clock: Floats


class CavityModel(Part):
    """A square of 1 m of gas."""

    def __init__(self, content: CavityContent, parameters: CavityParameters, active: EffectSet, seed: int):
        self.content, self.parameters, self.active = content, parameters, active
        self.heated = parameters.flow == "heated"
        n = int(parameters.cells)
        self.gas = Gas(Grid(n, n, 1.0 / n), self._borders(), self._settings(), ("temperature",))
        self.specks: Floats = np.random.default_rng(seed).random((SPECKS, 2))
        self.clock: Floats = np.zeros(2)

    # -- what it is made of -------------------------------------------------------------------------

    def _borders(self) -> Borders:
        if not self.heated:
            lid = Border("no-slip", (self.parameters.lid, 0.0))
            return Borders(Border("no-slip"), Border("no-slip"), Border("no-slip"), lid)
        hot = Border("no-slip", scalars={"temperature": MEAN + WARM})
        cold = Border("no-slip", scalars={"temperature": MEAN - WARM})
        return Borders(hot, cold, Border("no-slip"), Border("no-slip"))

    def _settings(self) -> GasSettings:
        """Viscosity and gravity that make the numbers asked for, in a box of 1 m."""
        chosen = self.parameters
        viscosity = 1.0 / chosen.number
        gravity, spread = 0.0, 0.0
        if self.heated:
            # the speed that buoyancy reaches, sqrt(g beta dT L), is 1 m/s: nu = sqrt(Pr / Ra)
            viscosity = math.sqrt(PRANDTL / chosen.rayleigh)
            gravity, spread = -MEAN, viscosity / PRANDTL
        return GasSettings(
            effects=self.active, advection=chosen.advection, centring=chosen.centring,
            pressure=chosen.pressure, turns=int(chosen.turns), tolerance=1e-6, viscosity=viscosity,
            diffusivity=spread, gravity=(0.0, gravity), ambient=MEAN,
        )  # fmt: skip

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        if name == "lid":
            self.gas.set_borders(self._borders())
        else:
            self.gas.settings = self._settings()

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.gas.settings = self._settings()

    # -- a step -------------------------------------------------------------------------------------

    @property
    def step_length(self) -> float:
        """s of a step of the gas: the lid, or 1 m/s, moves so many cells in it."""
        fastest = max(abs(float(self.parameters.lid)), 0.05) if not self.heated else 1.0
        return float(self.parameters.courant) * self.gas.grid.cell / fastest

    def advance(self, dt: float) -> None:
        """As many steps of the gas as the clock asks for; specks go on in between."""
        self.clock[0] += dt
        length = self.step_length
        for _ in range(MOST_STEPS):
            if self.clock[0] < 0.5 * length:
                break
            before = self.gas.u.copy()
            self.gas.step(length)
            self.clock[0] -= length
            self.clock[1] = float(np.max(np.abs(self.gas.u - before))) / length
        self.clock[0] = min(self.clock[0], length)
        half = self.specks + 0.5 * dt * self.gas.sample(self.specks)
        self.specks += dt * self.gas.sample(half)
        np.clip(self.specks, 0.0, 1.0, out=self.specks)

    def stir(self, place: tuple[float, float], along: tuple[float, float]) -> None:
        """Push the gas near a place (m) by a velocity (m/s)."""
        for number, field in enumerate((self.gas.u, self.gas.v)):
            x, y = self.gas.grid.u_places() if number == 0 else self.gas.grid.v_places()
            near = elementwise.exp(
                -(elementary.square(x - place[0]) + elementary.square(y - place[1])) / 0.004
            )
            field += near * (along[number] - field)
        self.gas.jolt()

    # -- what is there ------------------------------------------------------------------------------

    def profiles(self) -> tuple[Floats, Floats, Floats, Floats]:
        """y and u on the vertical centre line, x and v on the horizontal one, with the walls' own."""
        n, gas = self.gas.grid.nx, self.gas
        middle = (np.arange(n) + 0.5) / n
        u = 0.5 * (gas.u[:, n // 2] + gas.u[:, (n + 1) // 2])
        v = 0.5 * (gas.v[n // 2] + gas.v[(n + 1) // 2])
        lid = 0.0 if self.heated else float(self.parameters.lid)
        places = np.concatenate([[0.0], middle, [1.0]])
        return places, np.concatenate([[0.0], u, [lid]]), places, np.concatenate([[0.0], v, [0.0]])

    def extremes(self) -> tuple[float, float, float]:
        """Least u, most v and least v on the centre lines, over the speed of the lid: peaks of parabolas."""
        _, u, _, v = self.profiles()
        scale = 1.0 if self.heated or self.parameters.lid == 0.0 else abs(float(self.parameters.lid))
        inner_u, inner_v = u[1:-1], v[1:-1]
        return -_peak(-inner_u) / scale, _peak(inner_v) / scale, -_peak(-inner_v) / scale

    def nusselt(self) -> float:
        """Heat through the hot wall over what a gas at rest would conduct, by the wall's own slope."""
        warm = self.gas.field("temperature") - MEAN
        n = self.gas.grid.nx
        slope = (
            (8.0 * WARM - 9.0 * warm[:, 0] + warm[:, 1]) / 3.0 * n
        )  # a parabola through wall and two cells
        return float(np.mean(slope))

    def state(self) -> CavityState:
        """All that later steps depend on."""
        return CavityState(self.gas.state(), self.specks, self.clock)

    def restore(self, state: CavityState) -> None:
        """Take over a copy of a state."""
        self.gas.restore(state.gas)
        self.specks, self.clock = state.specks.copy(), state.clock.copy()


def _peak(values: Floats) -> float:
    """The largest value, of the parabola through the largest and its neighbours."""
    k = int(np.argmax(values))
    if not 0 < k < len(values) - 1:
        return float(values[k])
    left, here, right = values[k - 1 : k + 2].tolist()
    bend = left - 2.0 * here + right
    return here - elementary.square(right - left) / (8.0 * bend) if bend < 0.0 else here
