"""Heat in a cloth that is written on with saltpetre: one step of all its patches, and of the gas at them.

Cloth that was treated with a flame retardant chars: it needs to be hot before it does anything, most of it
stays as char, and what heat it gives is less than it loses. Where saltpetre is written it takes fire at a
lower temperature, brings its own oxygen, leaves no char and gives more heat: there a front of embers creeps
along. Between the two all numbers go in proportion to the share of saltpetre. With T temperature, C heat
capacity of the dry cloth (which stays that of the whole thread until the mesh falls), f fuel, D = k / C:

    C dT/dt = k lap T + kept q burnt + U (T_gas - T) + eps sigma (T_a^4 - T^4) + match
    df/dt = -R f,   R = r (T >= T_i), or of Fisher's kind R = r (T - T_a) / rise

Of what goes a share leaves as vapour, which burns in the gas, some of it as it leaves a patch that glows;
char stays. The rest burns in the cloth, and a part of its heat stays there. Water keeps a patch at 373.15 K
until it is gone. Everything that leaves a patch enters the cell of gas before it, so that

    cloth + gas + radiated + steam = burnt in the cloth + burnt in the gas + match

to rounding in each step; heat counts from the surroundings. A layer of gas so deep (m) as the flames is
meant.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.cloth import layout
from game.physics.heat.effects import CONVECTION_BIT, RADIATION_BIT, SMOULDERING_BIT
from game.physics.heat.nodes import BOILING, STEAM_HEAT, WATER_HEAT
from game.physics.heat.radiation import STEFAN_BOLTZMANN, cooled_inside
from game.physics.kernels import elementary

IGNITES, FISHER = range(2)
REACTIONS = ("ignition", "fisher")
# of the totals of a cloth: J that its fuel gave, of these J given to the gas, J radiated, J in steam, J from
# a match; kg burnt, kg of vapour, kg of steam; patches that burn, K of the hottest (both of the last step)
MADE, TO_GAS, RADIATED, STEAM, MATCH, BURNT, VAPOUR, STEAM_KG, ALIGHT, HOTTEST = range(10)
TOTALS = 10
BEGUN = 0.25  # of its fuel: then the front is said to be at a patch
SIDES = 2.0  # a cloth has two
SHORT = 1e-2  # b T³ dt up to which four terms of the series give how a patch cools, to 1e-7 of T
ALIKE = 1e-4  # K: what differs less exchanges no heat


class Kind(NamedTuple):
    """One of the two kinds of cloth."""

    ignition: float  # K
    rate: float  # 1/s
    heat: float  # J/kg of what burns in the cloth
    vapour: float  # share of what goes that burns in the gas
    char: float  # share of it that stays
    oxygen: float  # share of the oxygen it needs that it brings


class ClothLaws(NamedTuple):
    """How a cloth takes heat and burns. The two kinds: plain, and written with saltpetre."""

    mask: int
    reaction: int
    conductance: float  # W/K of a square of it
    capacity: float  # J/(m² K)
    dry: float  # kg/m² at first
    kept: float  # share of the heat that stays
    exchange: float  # W/(m² K) of either side with still gas
    stirred: float  # W/(m² K) more at 1 m/s, with the root of the speed
    emissivity: float
    ambient: float  # K
    rise: float  # K, by which Fisher's kind of burning counts


class GasAt(NamedTuple):
    """The gas before a cloth: where its cells are, and what a J in one does."""

    lower_x: float
    lower_y: float
    cell: float  # m
    capacity: float  # J/K of a cell
    volume: float  # m³ of a cell
    fresh: float  # kg/m³ of oxygen in fresh air
    needs: float  # kg of oxygen for a kg that burns
    ignites: float  # K of a patch at which its vapour takes fire as it leaves
    pilot: float  # share of it that burns there
    heat: float  # J/kg of vapour
    soot: float  # kg for a kg of vapour


class Flame(NamedTuple):
    """A match's flame: strength 0 to 1."""

    x: float
    y: float
    radius: float  # m
    kelvin: float
    exchange: float  # W/(m² K) in its middle
    strength: float


@inner_kernel
def warm(patches, b, a, joule, laws, totals, area):
    """Heat a patch by J/m²; at 373.15 K its water goes first."""
    capacity = laws.capacity + WATER_HEAT * patches[layout.WATER, b, a]
    if patches[layout.WATER, b, a] > 0.0:
        missing = (BOILING - patches[layout.HOT, b, a]) * capacity
        if joule > missing:
            gone = min(patches[layout.WATER, b, a], (joule - missing) / STEAM_HEAT)
            patches[layout.HOT, b, a] = BOILING
            patches[layout.WATER, b, a] = (
                patches[layout.WATER, b, a] - gone if gone < patches[layout.WATER, b, a] else 0.0
            )
            totals[STEAM] += area * gone * (STEAM_HEAT + WATER_HEAT * (BOILING - laws.ambient))
            totals[STEAM_KG] += area * gone
            joule -= missing + gone * STEAM_HEAT
            capacity = laws.capacity + WATER_HEAT * patches[layout.WATER, b, a]
    patches[layout.HOT, b, a] += joule / capacity


@inner_kernel
def _burn(patches, at, how, oxygen, when, totals):
    """Burn for h (s): what goes to the gas, J/m² and kg/m² of vapour, and kg/m² of oxygen that it takes."""
    b, a = at
    laws, kinds = how
    h, now, area = when
    plain, salted = kinds
    salt = patches[layout.SALT, b, a]
    hot = patches[layout.HOT, b, a]
    rate = plain.rate + salt * (salted.rate - plain.rate)
    if laws.reaction == IGNITES:
        if hot < plain.ignition + salt * (salted.ignition - plain.ignition):
            return 0.0, 0.0, 0.0
    else:
        rate *= max(hot - laws.ambient, 0.0) / laws.rise
    own = plain.oxygen + salt * (salted.oxygen - plain.oxygen)
    gone = patches[layout.FUEL, b, a] * -elementary.expm1(-rate * h * (own + (1.0 - own) * oxygen))
    if gone <= 0.0:
        return 0.0, 0.0, 0.0
    vapour = (plain.vapour + salt * (salted.vapour - plain.vapour)) * gone
    char = (plain.char + salt * (salted.char - plain.char)) * gone
    burnt = max(gone - vapour - char, 0.0)
    before = patches[layout.FUEL, b, a]
    patches[layout.FUEL, b, a] = max(before - gone, 0.0)
    patches[layout.CHAR, b, a] += char
    full = (1.0 - BEGUN) * laws.dry
    if patches[layout.BEGAN, b, a] < 0.0 and patches[layout.FUEL, b, a] <= full:
        share = (before - full) / gone if gone > 0.0 and before > full else 0.0
        patches[layout.BEGAN, b, a] = now + h * share
    joule = burnt * (plain.heat + salt * (salted.heat - plain.heat))
    totals[MADE] += area * joule
    totals[BURNT] += area * burnt
    totals[VAPOUR] += area * vapour
    totals[ALIGHT] += 1.0
    warm(patches, b, a, laws.kept * joule, laws, totals, area)
    return (1.0 - laws.kept) * joule, vapour, (1.0 - own) * burnt


@lean_kernel
def conduct(patches, whole, laws, numbers, totals):
    """Heat flows along the threads for h (s), explicitly. numbers: h s, m of a patch. whole (ny, nx): meshes;
    what is lost conducts nothing.
    """
    h, size = numbers
    rows, columns = patches.shape[1], patches.shape[2]
    part = laws.conductance * h / (size * size)
    for b in range(rows):
        for a in range(columns):
            patches[layout.FLOW, b, a] = 0.0
    for b in range(rows):
        for a in range(columns):
            if whole[b // layout.PER, a // layout.PER] <= 0.0:
                continue
            here = patches[layout.HOT, b, a]
            if a + 1 < columns and whole[b // layout.PER, (a + 1) // layout.PER] > 0.0:
                flow = part * (patches[layout.HOT, b, a + 1] - here)
                patches[layout.FLOW, b, a] += flow
                patches[layout.FLOW, b, a + 1] -= flow
            if b + 1 < rows and whole[(b + 1) // layout.PER, a // layout.PER] > 0.0:
                flow = part * (patches[layout.HOT, b + 1, a] - here)
                patches[layout.FLOW, b, a] += flow
                patches[layout.FLOW, b + 1, a] -= flow
    for b in range(rows):
        for a in range(columns):
            if patches[layout.WATER, b, a] > 0.0:
                warm(patches, b, a, patches[layout.FLOW, b, a], laws, totals, size * size)
            else:
                patches[layout.HOT, b, a] += patches[layout.FLOW, b, a] / laws.capacity


@inner_kernel
def place_of(nodes, b, a):
    """Where the middle of a patch is, m, in the picture's plane."""
    j, i = b // layout.PER, a // layout.PER
    down, right = (b - layout.PER * j + 0.5) / layout.PER, (a - layout.PER * i + 0.5) / layout.PER
    upper = (1.0 - right) * nodes[layout.X, j, i] + right * nodes[layout.X, j, i + 1]
    lower = (1.0 - right) * nodes[layout.X, j + 1, i] + right * nodes[layout.X, j + 1, i + 1]
    x = (1.0 - down) * upper + down * lower
    upper = (1.0 - right) * nodes[layout.Y, j, i] + right * nodes[layout.Y, j, i + 1]
    lower = (1.0 - right) * nodes[layout.Y, j + 1, i] + right * nodes[layout.Y, j + 1, i + 1]
    return x, (1.0 - down) * upper + down * lower


@inner_kernel
def _light(patches, nodes, at, laws, flame, when, totals):
    """What a match does to a patch in h (s), as a backward step: however hot, never beyond its flame."""
    b, a = at
    h, _, area = when
    x, y = place_of(nodes, b, a)
    dx, dy = (x - flame.x) / flame.radius, (y - flame.y) / flame.radius
    away = dx * dx + dy * dy
    if away >= 9.0 or patches[layout.HOT, b, a] >= flame.kelvin:
        return
    capacity = laws.capacity + WATER_HEAT * patches[layout.WATER, b, a]
    share = flame.strength * flame.exchange * elementary.exp(-away) * h / capacity
    joule = capacity * (flame.kelvin - patches[layout.HOT, b, a]) * share / (1.0 + share)
    totals[MATCH] += joule * area
    warm(patches, b, a, joule, laws, totals, area)


@inner_kernel
def _give(patches, at, how, air, cell, when, totals):
    """Burn, and let what leaves be in a cell of the gas; vapour that leaves what glows begins to burn."""
    b, a = at
    j, i = cell
    cells, gas = air
    area = when[2]
    fresh = min(max(cells[j, i, 2] / gas.fresh, 0.0), 1.0)
    joule, vapour, used = _burn(patches, at, how, fresh, when, totals)
    if joule + vapour <= 0.0:
        return
    if patches[layout.HOT, b, a] >= gas.ignites:
        lit = min(gas.pilot * vapour, max(cells[j, i, 2], 0.0) * gas.volume / (area * gas.needs))
        vapour -= lit
        used += lit
        joule += lit * gas.heat
        totals[MADE] += lit * gas.heat * area
        cells[j, i, 3] += gas.soot * lit * area / gas.volume
    cells[j, i, 0] += joule * area / gas.capacity
    totals[TO_GAS] += joule * area
    cells[j, i, 1] += vapour * area / gas.volume
    cells[j, i, 2] = max(cells[j, i, 2] - gas.needs * used * area / gas.volume, 0.0)


@lean_kernel
def meet_and_burn(cloth, air, how, flame, clock, totals):
    """Gas, match, burning, radiation of all patches for h (s), then what they give is in the gas.

    cloth: patches, meshes that are whole, nodes. air: cells (gy, gx, 4) K, kg/m³ of vapour, of oxygen, of
    soot; wind (gy, gx) m/s, how fast the gas is at the cloth; `GasAt`. how: `ClothLaws`, both `Kind`s. A
    mesh meets the cell before its middle. clock: h, s at its beginning, m of a patch. totals (TOTALS,) are
    added to. Heat goes between gas and cloth as in a backward step, which keeps their sum.
    """
    patches, whole, nodes = cloth
    cells, wind, gas = air
    laws, kinds = how
    h, now, size = clock
    when = (h, now, size * size)
    area, gy, gx = size * size, cells.shape[0], cells.shape[1]
    totals[ALIGHT], totals[HOTTEST] = 0.0, laws.ambient
    reach = 3.0 * flame.radius + 2.0 * layout.PER * size
    fourth = laws.ambient * laws.ambient * laws.ambient * laws.ambient
    burns = laws.mask & SMOULDERING_BIT
    coldest = min(kinds[0].ignition, kinds[1].ignition) if laws.reaction == IGNITES else laws.ambient
    for row in range(whole.shape[0]):
        for column in range(whole.shape[1]):
            if whole[row, column] <= 0.0:
                continue
            x = nodes[layout.X, row, column] + nodes[layout.X, row, column + 1]
            x = 0.25 * (x + nodes[layout.X, row + 1, column] + nodes[layout.X, row + 1, column + 1])
            y = nodes[layout.Y, row, column] + nodes[layout.Y, row, column + 1]
            y = 0.25 * (y + nodes[layout.Y, row + 1, column] + nodes[layout.Y, row + 1, column + 1])
            i = min(max(int((x - gas.lower_x) / gas.cell), 0), gx - 1)
            j = min(max(int((y - gas.lower_y) / gas.cell), 0), gy - 1)
            strong = SIDES * (laws.exchange + laws.stirred * math.sqrt(wind[j, i]))
            near = flame.strength > 0.0 and abs(x - flame.x) < reach and abs(y - flame.y) < reach
            for b in range(layout.PER * row, layout.PER * row + layout.PER):
                for a in range(layout.PER * column, layout.PER * column + layout.PER):
                    difference = cells[j, i, 0] - patches[layout.HOT, b, a]
                    if laws.mask & CONVECTION_BIT and abs(difference) > ALIKE:
                        capacity = laws.capacity + WATER_HEAT * patches[layout.WATER, b, a]
                        part = strong * h
                        joule = difference * part / (1.0 + part * (1.0 / capacity + area / gas.capacity))
                        cells[j, i, 0] -= joule * area / gas.capacity
                        totals[TO_GAS] -= joule * area
                        if patches[layout.WATER, b, a] > 0.0:
                            warm(patches, b, a, joule, laws, totals, area)
                        else:
                            patches[layout.HOT, b, a] += joule / capacity
                    if near:
                        _light(patches, nodes, (b, a), laws, flame, when, totals)
                    if burns and patches[layout.HOT, b, a] >= coldest and patches[layout.FUEL, b, a] > 0.0:
                        _give(patches, (b, a), how, (cells, gas), (j, i), when, totals)
                    hot = patches[layout.HOT, b, a]
                    if laws.mask & RADIATION_BIT and abs(hot - laws.ambient) > ALIKE:
                        capacity = laws.capacity + WATER_HEAT * patches[layout.WATER, b, a]
                        rate = SIDES * laws.emissivity * STEFAN_BOLTZMANN / capacity
                        top = max(hot, laws.ambient)
                        if rate * h * top * top * top < SHORT:
                            f = rate * (hot * hot * hot * hot - fourth)
                            slope, bend = 4.0 * rate * hot * hot * hot, 12.0 * rate * hot * hot
                            third = f * slope * slope + f * f * bend
                            cold = hot - h * (f - h * (0.5 * f * slope - h * third / 6.0))
                        else:
                            cold = cooled_inside(hot, laws.ambient, rate, h)
                        totals[RADIATED] += area * capacity * (hot - cold)
                        patches[layout.HOT, b, a] = cold
                    totals[HOTTEST] = max(totals[HOTTEST], patches[layout.HOT, b, a])


@lean_kernel
def heat_in(patches, laws, size):
    """J above the surroundings in all patches."""
    total = 0.0
    for b in range(patches.shape[1]):
        for a in range(patches.shape[2]):
            capacity = laws.capacity + WATER_HEAT * patches[layout.WATER, b, a]
            total += capacity * (patches[layout.HOT, b, a] - laws.ambient)
    return total * size * size


@lean_kernel
def pour_on(patches, whole, nodes, jet, laws):
    """Water from a jet (x, y, radius m, kg/m² in its middle) at the temperature of the surroundings; kg."""
    x0, y0, radius, most, area = jet
    total = 0.0
    for b in range(patches.shape[1]):
        for a in range(patches.shape[2]):
            if whole[b // layout.PER, a // layout.PER] <= 0.0:
                continue
            x, y = place_of(nodes, b, a)
            dx, dy = (x - x0) / radius, (y - y0) / radius
            if dx * dx + dy * dy >= 1.0:
                continue
            more = most * (1.0 - dx * dx - dy * dy)
            capacity = laws.capacity + WATER_HEAT * patches[layout.WATER, b, a]
            excess = capacity * (patches[layout.HOT, b, a] - laws.ambient)
            patches[layout.HOT, b, a] = laws.ambient + excess / (capacity + WATER_HEAT * more)
            patches[layout.WATER, b, a] += more
            total += more * area
    return total
