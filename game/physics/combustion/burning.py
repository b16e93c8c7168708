"""Fuel, oxygen, temperature and soot in the cells of a gas: one step of burning, radiating, expanding.

Where the gas is at least at its ignition temperature, what can burn does so at a rate: of m = min(fuel,
oxygen / s), s the oxygen that a kilogram of fuel needs, the share 1 - exp(-rate dt). It is exact for the
reactant of which there is less, so neither falls below nothing however long the step. The heat goes into the
cell's capacity (J/(m³ K), the same everywhere: of a gas at constant pressure density times temperature is).
Soot burns off at a rate of its own; by its temperature and oxygen too if the size of its balls is given
(`soot`). Hot gas radiates as T⁴, exactly, in proportion to the soot in it and to what glows of itself. A cell
whose temperature rises from T to T' wants (T' - T) / (T dt) more space in a second: a source of the
divergence, for the gas to be projected to.

Cells (ny, nx, fields): the carried scalars of a gas; columns (4,) says where temperature (K), fuel, oxygen
and soot (kg/m³) are among them.
"""

from __future__ import annotations

from typing import NamedTuple

from game.compiler.decorator import lean_kernel
from game.physics.combustion.effects import EXPANSION_BIT, FLAMES_BIT, RADIATION_BIT, SOOT_LOSS_BIT
from game.physics.combustion.soot import soot_rate_of
from game.physics.heat.radiation import cooled_inside
from game.physics.kernels import elementary

TEMPERATURE, FUEL, OXYGEN, SOOT = range(4)  # of ``columns``
# of the sums of a step, each for a cell of volume 1: fuel burnt, oxygen used (kg/m³), heat of burning, heat
# radiated (J/m³), soot made, soot burnt off (kg/m³), the largest rate of heat (W/m³), cells that burn
BURNT, USED, RELEASED, RADIATED, SOOT_MADE, SOOT_GONE, FIERCEST, ALIGHT = range(8)
SUMS = 8


class FlameLaws(NamedTuple):
    """How a gas burns, and what a step computes."""

    mask: int
    ignition: float  # K
    rate: float  # 1/s
    oxygen: float  # kg that a kg of fuel needs
    heat: float  # J/kg of fuel
    capacity: float  # J/(m³ K)
    soot: float  # kg that a kg of fuel makes
    soot_rate: float  # 1/s at which soot burns off in flames
    soot_size: float  # m, diameter of soot that burns off by temperature and oxygen; 0: at soot_rate alone
    glow: float  # 1/(K³ s): b of gas without soot
    soot_glow: float  # m³/(kg K³ s): b for a kg of soot in a m³
    ambient: float  # K


@lean_kernel
def burn_cells(cells, columns, laws, dt, source, sums):
    """Go on by dt (s); source (ny, nx) 1/s is added to; sums (SUMS,) are written."""
    t, f, o, s = columns[0], columns[1], columns[2], columns[3]
    share = -elementary.expm1(-laws.rate * dt)
    soot_share = -elementary.expm1(-laws.soot_rate * dt)
    for k in range(SUMS):
        sums[k] = 0.0
    for j in range(cells.shape[0]):
        for i in range(cells.shape[1]):
            before = cells[j, i, t]
            warm, fuel, oxygen, soot = before, cells[j, i, f], cells[j, i, o], cells[j, i, s]
            if laws.mask & FLAMES_BIT and warm >= laws.ignition and fuel > 0.0 and oxygen > 0.0:
                burnt = min(fuel, oxygen / laws.oxygen) * share
                used, made = min(laws.oxygen * burnt, oxygen), laws.soot * burnt
                cells[j, i, f], cells[j, i, o] = fuel - burnt, oxygen - used
                soot += made
                warm += laws.heat * burnt / laws.capacity
                sums[BURNT] += burnt
                sums[USED] += used
                sums[RELEASED] += laws.heat * burnt
                sums[SOOT_MADE] += made
                sums[FIERCEST] = max(sums[FIERCEST], laws.heat * burnt / dt)
                sums[ALIGHT] += 1.0
            if laws.mask & SOOT_LOSS_BIT and soot > 0.0 and warm >= laws.ignition and cells[j, i, o] > 0.0:
                gone = soot * soot_share
                if laws.soot_size > 0.0:
                    rate = laws.soot_rate + soot_rate_of(warm, cells[j, i, o], laws.soot_size)
                    gone = -soot * elementary.expm1(-rate * dt)
                soot -= gone
                sums[SOOT_GONE] += gone
            cells[j, i, s] = soot
            if laws.mask & RADIATION_BIT and warm != laws.ambient:
                rate = laws.glow + laws.soot_glow * max(soot, 0.0)
                cooler = cooled_inside(warm, laws.ambient, rate, dt)
                sums[RADIATED] += laws.capacity * (warm - cooler)
                warm = cooler
            cells[j, i, t] = warm
            if laws.mask & EXPANSION_BIT:
                source[j, i] += (warm - before) / (before * dt)
