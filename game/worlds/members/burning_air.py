"""Air in which something burns, in the plane: its gas, its flames, what of both is seen and kept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point, Singles
from game.physics.combustion import Flames, GasFuel
from game.physics.effects import EffectSet
from game.physics.gas import Gas, GasSettings, GasState
from game.physics.gas.effects import BUOYANCY
from game.physics.gas.forces import buoyancy
from game.physics.kernels import elementary
from game.worlds.painting.flames import flame_height
from game.worlds.painting.glowing import GlowLook, see_glowing
from game.worlds.world import Member

GRAVITY = 9.81  # m/s²
FIELDS = ("temperature", "fuel", "oxygen", "soot")  # of the gas, in this order
FRESH = 0.27  # kg/m³ of oxygen in air of a room
KEPT = ("effects", "turns", "ambient", "conservative", "carries_fields")  # of settings that change


class AirState(NamedTuple):
    """gas; books (6,) of what burnt; flows (counts,): numbers of a scene's own, see its air."""

    gas: GasState
    books: Floats
    flows: Floats


def faded(shape: tuple[int, int], sides: float, top: float = 0.0) -> Floats:
    """(ny, nx) 1 within, falling to 0 over such shares of the width and of the height: no edge is seen."""
    ny, nx = shape
    across = np.minimum(np.arange(nx), np.arange(nx)[::-1]) / (sides * nx)
    above = np.arange(ny)[::-1] / (top * ny) if top else np.ones(ny)
    return np.clip(across, 0.0, 1.0) * np.clip(above, 0.0, 1.0)[:, None]


class BurningAir(Member):
    """``gas`` with FIELDS; ``flames`` in it; ``flows`` (counts,), what a scene counts beside them.
    ``lifts``: whether warm gas rises, which a scene's own forces see to.

    edge (ny, nx): share that is seen of each cell. ``vapour``: what burns, as GasFuel takes it.
    """

    vapour: ClassVar[Mapping[str, Any]]
    flame_look: ClassVar[GlowLook]
    counts: ClassVar[int] = 4

    def __init__(self, gas: Gas, edge: Floats, active: EffectSet, lifts: bool):
        self.gas, self.cell = gas, gas.grid.cell
        self.flames = Flames(range(4), self.cell, GasFuel(**self.vapour, effects=active))
        self.flows: Floats = np.zeros(self.counts)
        self.lifts = lifts
        self.edge = edge
        self._veil = np.zeros((*gas.grid.shape, 2), np.float32)

    def set_cycles(self, cycles: int) -> None:
        """So many V-cycles in a step."""
        self._change(turns=cycles)

    def set_effects(self, active: EffectSet, gas_effects: EffectSet) -> None:
        """Compute these from now on."""
        self.flames.made_of = GasFuel(**self.vapour, effects=active)
        self.lifts = BUOYANCY in gas_effects
        self._change(effects=gas_effects.without(BUOYANCY))

    def _change(self, **changes: object) -> None:
        now = self.gas.settings
        kept = {name: getattr(now, name) for name in KEPT}
        self.gas.settings = GasSettings(**(kept | changes))

    # -- what comes in ----------------------------------------------------------------------------------

    def blow(self, place: Point, velocity: Point, reach: float) -> None:
        """Push the gas about a place (m) by a velocity (m/s), less and less up to ``reach`` m from it."""
        grid = self.gas.grid
        for field, (x, y), part in (
            (self.gas.u, grid.u_places(), velocity[0]), (self.gas.v, grid.v_places(), velocity[1]),
        ):  # fmt: skip
            away = (elementary.square(x - place[0]) + elementary.square(y - place[1])) / (reach * reach)
            field += part * elementary.square(np.clip(1.0 - away, 0.0, None))
        self.gas.jolt()

    def slow(self, along: float, upward: float) -> None:
        """Add a force that lets whirls die down at rates 1/s: in space they fall apart, in the plane not."""
        self.gas.force[..., 0] -= 0.5 * along * (self.gas.u[:, 1:] + self.gas.u[:, :-1])
        self.gas.force[..., 1] -= 0.5 * upward * (self.gas.v[1:] + self.gas.v[:-1])

    def near(self, place: Point, reach: float) -> Any:
        """(ny, nx) which cells are nearer to a place (m) than that, m."""
        x, y = self.gas.grid.centres()
        return elementary.square(x - place[0]) + elementary.square(y - place[1]) < reach * reach

    def rise(self) -> None:
        """Write the upward force of warm gas, if it is to rise."""
        if self.lifts:
            buoyancy(self.gas.scalars, 0, self.vapour["ambient"], GRAVITY, self.gas.force)

    # -- what there is ------------------------------------------------------------------------------------

    def velocities(self) -> tuple[Floats, Floats]:
        """(ny, nx) m/s along and upwards, in the middles of cells."""
        u, v = self.gas.u, self.gas.v
        return 0.5 * (u[:, 1:] + u[:, :-1]), 0.5 * (v[1:] + v[:-1])

    def cells_at(self, points: Floats) -> tuple[Longs, Longs]:
        """Rows and columns of the cells at points (..., 2) m; the nearest ones outside."""
        (ny, nx), (left, low) = self.gas.grid.shape, self.gas.grid.lower
        i = np.clip(((points[..., 0] - left) / self.cell).astype(np.int64), 0, nx - 1)
        return np.clip(((points[..., 1] - low) / self.cell).astype(np.int64), 0, ny - 1), i

    def wind_at(self, points: Floats) -> Floats:
        """Velocity (..., 2) m/s at points (..., 2) m."""
        (j, i), u, v = self.cells_at(points), self.gas.u, self.gas.v
        return np.stack([0.5 * (u[j, i] + u[j, i + 1]), 0.5 * (v[j, i] + v[j + 1, i])], axis=-1)

    @property
    def temperature(self) -> Floats:
        """(ny, nx) K."""
        return self.gas.field("temperature")

    def veil(self) -> Singles:
        """(ny, nx, 2) how thick the smoke and how bright the flames are, 0 to 1; good until the next call."""
        cells = self.gas.scalars
        see_glowing(self.flame_look, cells[..., 0], cells[..., 3], self.edge, self._veil)
        return self._veil

    def flame_height(self) -> float:
        """m, of the highest gas that is seen to burn."""
        return flame_height(self.flame_look, self.temperature, self.cell)

    def state(self) -> tuple[Any, ...]:
        return (AirState(self.gas.state(), self.flames.books, self.flows),)

    def restore(self, fields: Iterator[Any]) -> None:
        state: AirState = next(fields)
        self.gas.restore(state.gas)
        self.flames.books[:], self.flows[:] = state.books, state.flows
