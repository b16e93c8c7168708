"""Air in which something burns, in the plane: its gas, its flames, what of both is seen and kept."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.combustion import Flames, GasFuel
from game.physics.effects import EffectSet
from game.physics.gas import Gas, GasSettings, GasState
from game.physics.gas.effects import BUOYANCY
from game.stage import Part
from game.worlds.painting.flames import FlameLook, flame_height, see_gas

Floats = NDArray[np.float64]
FIELDS = ("temperature", "fuel", "oxygen", "soot")  # of the gas, in this order


class AirState(NamedTuple):
    """gas; books (6,) of what burnt; flows (4,): numbers of a scene's own, see its air."""

    gas: GasState
    books: Floats
    flows: Floats


class BurningAir(Part):
    """``gas`` with FIELDS; ``flames`` in it; ``flows`` (4,), what a scene counts beside them. ``lifts``:
    whether warm gas rises, which a scene's own forces see to.

    edge (ny, nx): share that is seen of each cell. ``vapour``: what burns, as GasFuel takes it.
    """

    vapour: ClassVar[Mapping[str, Any]]
    flame_look: ClassVar[FlameLook]

    def __init__(self, gas: Gas, edge: Floats, active: EffectSet, lifts: bool):
        self.gas, self.cell = gas, gas.grid.cell
        self.flames = Flames(range(4), self.cell, GasFuel(**self.vapour, effects=active))
        self.flows: Floats = np.zeros(4)
        self.lifts = lifts
        self._edge = edge
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
        kept = {name: getattr(now, name) for name in ("effects", "turns", "ambient", "conservative")}
        self.gas.settings = GasSettings(**(kept | changes))

    @property
    def temperature(self) -> Floats:
        """(ny, nx) K."""
        return self.gas.field("temperature")

    def veil(self) -> NDArray[np.float32]:
        """(ny, nx, 2) how thick the smoke and how bright the flames are, 0 to 1; good until the next call."""
        cells = self.gas.scalars
        see_gas(self.flame_look, cells[..., 0], cells[..., 3], self._edge, self._veil)
        return self._veil

    def flame_height(self) -> float:
        """m, of the highest gas that is seen to burn."""
        return flame_height(self.flame_look, self.temperature, self.cell)

    def state(self) -> AirState:
        """All that later steps depend on."""
        return AirState(self.gas.state(), self.flames.books, self.flows)

    def restore(self, state: AirState) -> None:
        """Take over a copy of a state."""
        self.gas.restore(state.gas)
        self.flames.books[:], self.flows[:] = state.books, state.flows
