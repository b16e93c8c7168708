"""Heat in things made of nodes and threads: cloth, logs, sticks. One step of all nodes.

A node has a temperature, a dry rest that does not burn (J/K), fuel and water (kg). In a step heat flows along
threads that are not torn, comes from the gas at the node, and leaves by radiation as T⁴ (exactly). Water
keeps a node at 373.15 K until it is gone. A node at its ignition temperature burns fuel at a rate, as fast as
there is oxygen: a share of the heat stays, the rest goes to the gas, and a share of the fuel leaves unburnt,
as vapour. What leaves (steam, vapour, smoke) takes its own heat along, so that

    sum (C + c fuel + c_w water) T + burnt Q + taken from gas = the same before + given to gas + radiated +
    steam.

Heat is explicit along threads, in substeps short enough that no node overshoots its neighbours, and exact
towards the gas.
"""

from __future__ import annotations

from typing import NamedTuple

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.heat.effects import CONDUCTION_BIT, CONVECTION_BIT, RADIATION_BIT, SMOULDERING_BIT
from game.physics.heat.radiation import STEFAN_BOLTZMANN, cooled_inside
from game.physics.kernels import elementary

# rows of nodes (ROWS, n): K, J/K of what does not burn, kg, kg, m² that meets the gas and shines; K and share
# of oxygen of the gas at it (1: as in fresh air); K of what it shines to; what a step has given the gas: J,
# kg of vapour, kg burnt; and a buffer
TEMPERATURE, REST, FUEL, WATER, AREA, GAS, OXYGEN, EXCHANGE, AMBIENT, GIVEN, VAPOUR, BURNT, FLOW = range(13)
ROWS = 13
BOILING, WATER_HEAT, STEAM_HEAT = 373.15, 4186.0, 2.257e6  # K, J/(kg K), J/kg
# of the totals of a step: J radiated, J that steam took along, J of fuel that burnt, kg of steam
RADIATED, STEAM, OF_FUEL, STEAM_KG = range(4)


class NodeLaws(NamedTuple):
    """What nodes are made of, and what a step computes."""

    mask: int
    ignition: float  # K
    rate: float  # 1/s, share of its fuel that a node burns in fresh air
    heat: float  # J/kg of burning fuel
    kept: float  # share of it that stays in the node
    vapour: float  # share of the fuel that leaves unburnt
    fuel_heat: float  # J/(kg K) of fuel
    emissivity: float


@inner_kernel
def _capacity(nodes, i, laws):
    """J/K of a node with what is in it."""
    return nodes[REST, i] + laws.fuel_heat * nodes[FUEL, i] + WATER_HEAT * nodes[WATER, i]


@inner_kernel
def warm(nodes, i, joule, laws, totals):
    """Heat a node; at 373.15 K its water goes first."""
    capacity = _capacity(nodes, i, laws)
    if nodes[WATER, i] > 0.0:
        missing = (BOILING - nodes[TEMPERATURE, i]) * capacity  # below 0 of a hot one that was wetted
        if joule > missing:
            gone = min(nodes[WATER, i], (joule - missing) / STEAM_HEAT)
            nodes[TEMPERATURE, i] = BOILING
            nodes[WATER, i] = nodes[WATER, i] - gone if gone < nodes[WATER, i] else 0.0
            totals[STEAM] += gone * (STEAM_HEAT + WATER_HEAT * BOILING)
            totals[STEAM_KG] += gone
            joule -= missing + gone * STEAM_HEAT
            capacity = _capacity(nodes, i, laws)
    nodes[TEMPERATURE, i] += joule / capacity


@inner_kernel
def _burn(nodes, i, h, laws, totals):
    """Burn for h (s)."""
    share = laws.rate * h * max(nodes[OXYGEN, i], 0.0)
    gone = nodes[FUEL, i] * -elementary.expm1(-share)
    if gone <= 0.0:
        return
    vapour = laws.vapour * gone
    burnt = gone - vapour
    own = gone * laws.fuel_heat * nodes[TEMPERATURE, i]  # the heat that it has leaves with it
    nodes[FUEL, i] = max(nodes[FUEL, i] - gone, 0.0)
    nodes[VAPOUR, i] += vapour
    nodes[BURNT, i] += burnt
    totals[OF_FUEL] += burnt * laws.heat
    nodes[GIVEN, i] += own + (1.0 - laws.kept) * burnt * laws.heat
    warm(nodes, i, laws.kept * burnt * laws.heat, laws, totals)


@lean_kernel
def step_nodes(nodes, links, conductances, torn, laws, substeps, dt, totals):
    """Go on by dt (s) in equal substeps. links (m, 2), conductances (m,) W/K, torn (m,); totals (4,) are
    added to.
    """
    count, h = nodes.shape[1], dt / substeps
    for _ in range(substeps):
        if laws.mask & CONDUCTION_BIT:
            for i in range(count):
                nodes[FLOW, i] = 0.0
            for k in range(links.shape[0]):
                if torn[k]:
                    continue
                a, b = links[k, 0], links[k, 1]
                flow = conductances[k] * (nodes[TEMPERATURE, b] - nodes[TEMPERATURE, a])
                nodes[FLOW, a] += flow
                nodes[FLOW, b] -= flow
            for i in range(count):
                if nodes[FLOW, i] != 0.0:
                    warm(nodes, i, nodes[FLOW, i] * h, laws, totals)
        for i in range(count):
            if laws.mask & CONVECTION_BIT:
                capacity = _capacity(nodes, i, laws)
                part = -elementary.expm1(-nodes[EXCHANGE, i] * nodes[AREA, i] * h / capacity)
                joule = capacity * part * (nodes[GAS, i] - nodes[TEMPERATURE, i])
                nodes[GIVEN, i] -= joule
                warm(nodes, i, joule, laws, totals)
            if laws.mask & SMOULDERING_BIT and nodes[TEMPERATURE, i] >= laws.ignition:
                _burn(nodes, i, h, laws, totals)
            if laws.mask & RADIATION_BIT:
                capacity, hot = _capacity(nodes, i, laws), nodes[TEMPERATURE, i]
                rate = laws.emissivity * STEFAN_BOLTZMANN * nodes[AREA, i] / capacity
                joule = capacity * (cooled_inside(hot, nodes[AMBIENT, i], rate, h) - hot)
                totals[RADIATED] -= joule
                warm(nodes, i, joule, laws, totals)  # what shines on it dries it first


@lean_kernel
def strongest_coupling(nodes, links, conductances, torn, laws, dt, sums):
    """The largest rate (1/s) at which a node may follow its neighbours within a step of dt (s): the sum of
    conductances over the heat capacity that is left once its water is gone and its fuel has burnt so long.

    sums (n,) is a buffer.
    """
    for i in range(sums.shape[0]):
        sums[i] = 0.0
    for k in range(links.shape[0]):
        if not torn[k]:
            sums[links[k, 0]] += conductances[k]
            sums[links[k, 1]] += conductances[k]
    worst = 0.0
    for i in range(sums.shape[0]):
        left = nodes[FUEL, i] * elementary.exp(-laws.rate * dt * max(nodes[OXYGEN, i], 0.0))
        worst = max(worst, sums[i] / (nodes[REST, i] + laws.fuel_heat * left))
    return worst
