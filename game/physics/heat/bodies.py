"""Things of nodes and threads that take heat and burn: checked, stepped, and asked what they gave the gas."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats, Longs
from game.physics.effects import EffectSet
from game.physics.heat import nodes as no
from game.physics.heat.effects import HEAT
from game.physics.heat.nodes import NodeLaws, step_nodes, strongest_coupling

MOST_NODES, MOST_SUBSTEPS = 1_000_000, 1_000
STABLE = 0.5  # of the limit at which neighbours would change places


@dataclass(frozen=True, slots=True)
class Fuel:
    """What burns. ValueError, naming the field, for nonsense.

    ignition K; rate 1/s of its fuel in fresh air; heat J/kg; kept: share of it that stays; vapour: share of
    the fuel that leaves unburnt. fuel_heat J/(kg K). exchange W/(m² K) with the gas where nothing else is
    said; emissivity; ambient K, of gas and surroundings where nothing else is said.
    """

    ignition: float = 570.0
    rate: float = 0.1
    heat: float = 1.6e7
    kept: float = 0.3
    vapour: float = 0.5
    fuel_heat: float = 1500.0
    exchange: float = 25.0
    emissivity: float = 0.9
    ambient: float = 293.15
    effects: EffectSet = HEAT.known

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", HEAT.checked(self.effects))
        bounds = {
            "ignition": (1.0, 1e6), "rate": (0.0, 1e6), "heat": (0.0, 1e10), "kept": (0.0, 1.0),
            "vapour": (0.0, 1.0), "fuel_heat": (0.0, 1e6), "exchange": (0.0, 1e6), "emissivity": (0.0, 1.0),
            "ambient": (0.0, 1e6),
        }  # fmt: skip
        for name, (low, high) in bounds.items():
            if not low <= getattr(self, name) <= high:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected {low:g} to {high:g}")

    def laws(self) -> NodeLaws:
        """For kernels."""
        return NodeLaws(
            HEAT.mask(self.effects), *(float(getattr(self, name)) for name in NodeLaws._fields[1:])
        )


class NodesState(NamedTuple):
    """nodes (ROWS, n): see `nodes`; torn (m,); totals (4,): J radiated, in steam, of fuel; kg of steam."""

    nodes: Floats
    torn: Longs
    totals: Floats


class BurningBodies:
    """Nodes with threads between them.

    links (m, 2); conductances (m,) W/K. temperature K, rest J/K, fuel kg, water kg and area m²: numbers or
    (n,). rest must be above 0. ValueError, naming the argument and the first node that is wrong.
    """

    def __init__(
        self, count: int, links: ArrayLike = (), conductances: ArrayLike = 1.0, *,
        temperature: ArrayLike = 293.15, rest: ArrayLike = 1.0, fuel: ArrayLike = 0.0, water: ArrayLike = 0.0,
        area: ArrayLike = 0.0, made_of: Fuel | None = None,
    ):  # fmt: skip
        if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= MOST_NODES:
            raise ValueError(f"count = {count!r}: expected a whole number, 1 to {MOST_NODES}")
        self.count, self.made_of = count, made_of or Fuel()
        self.links: Longs = np.array(links, dtype=np.int64).reshape(-1, 2)
        if len(self.links) and not (self.links.min() >= 0 and self.links.max() < count):
            raise ValueError(f"links: expected nodes from 0 to {count - 1}")
        if len(self.links) and np.any(self.links[:, 0] == self.links[:, 1]):
            raise ValueError("links: a node cannot be linked to itself")
        self.conductances = _numbers("conductances", conductances, len(self.links), 0.0, 1e12)
        self.torn: Longs = np.zeros(len(self.links), dtype=np.int64)
        self.nodes: Floats = np.zeros((no.ROWS, count))
        for row, name, values, low, high in (
            (no.TEMPERATURE, "temperature", temperature, 1e-9, 1e9), (no.REST, "rest", rest, 1e-12, 1e15),
            (no.FUEL, "fuel", fuel, 0.0, 1e12), (no.WATER, "water", water, 0.0, 1e12),
            (no.AREA, "area", area, 0.0, 1e12),
        ):  # fmt: skip
            self.nodes[row] = _numbers(name, values, count, low, high)
        self.nodes[no.GAS], self.nodes[no.OXYGEN] = self.made_of.ambient, 1.0
        self.nodes[no.AMBIENT], self.nodes[no.EXCHANGE] = self.made_of.ambient, self.made_of.exchange
        self.totals: Floats = np.zeros(4)
        self._sums = np.zeros(count)

    @property
    def temperature(self) -> Floats:
        """(n,) K, not copied."""
        return self.nodes[no.TEMPERATURE]

    @property
    def fuel(self) -> Floats:
        """(n,) kg, not copied."""
        return self.nodes[no.FUEL]

    @property
    def water(self) -> Floats:
        """(n,) kg, not copied."""
        return self.nodes[no.WATER]

    def burning(self) -> NDArray[np.bool_]:
        """(n,) which burn now."""
        return np.asarray((self.temperature >= self.made_of.ignition) & (self.fuel > 0.0))

    def meet_gas(
        self, temperature: ArrayLike, oxygen: ArrayLike = 1.0, exchange: ArrayLike | None = None
    ) -> None:
        """Temperature (K) and oxygen (1: fresh air) of the gas at each node; exchange with it, W/(m² K),
        which grows with its speed (None: as the fuel says). ValueError.
        """
        given = self.made_of.exchange if exchange is None else exchange
        self.nodes[no.EXCHANGE] = _numbers("exchange", given, self.count, 0.0, 1e6)
        self.nodes[no.GAS] = _numbers("gas temperature", temperature, self.count, 0.0, 1e9)
        self.nodes[no.OXYGEN] = _numbers("oxygen", oxygen, self.count, 0.0, 1e3)

    def meet_light(self, temperature: ArrayLike) -> None:
        """Temperature (K) of what each node shines to: a fourth root of a mean of fourth powers.
        ValueError.
        """
        self.nodes[no.AMBIENT] = _numbers("temperature around", temperature, self.count, 0.0, 1e9)

    def take_given(self) -> tuple[Floats, Floats, Floats]:
        """What was given to the gas since the last time, (n,) each: J, kg of vapour, kg burnt; then nothing
        is left.
        """
        rows = self.nodes[[no.GIVEN, no.VAPOUR, no.BURNT]].copy()
        self.nodes[[no.GIVEN, no.VAPOUR, no.BURNT]] = 0.0
        return rows[0], rows[1], rows[2]

    def wet(self, node: int, kilograms: float, kelvin: float = 293.15) -> None:
        """Water of so many K onto a node; both come to one temperature. ValueError."""
        if not 0 <= node < self.count or not 0.0 <= kilograms <= 1e12 or not 0.0 < kelvin <= 373.15:
            raise ValueError(
                f"node {node!r}, kilograms = {kilograms!r}, kelvin = {kelvin!r}: expected one that is "
                "there, from 0, and up to 373.15"
            )
        nodes = self.nodes
        own = (
            nodes[no.REST, node]
            + self.made_of.fuel_heat * nodes[no.FUEL, node]
            + no.WATER_HEAT * nodes[no.WATER, node]
        )
        more = no.WATER_HEAT * kilograms
        nodes[no.TEMPERATURE, node] = (own * nodes[no.TEMPERATURE, node] + more * kelvin) / (own + more)
        nodes[no.WATER, node] += kilograms

    def tear(self, link: int) -> None:
        """No heat goes along a link any more; what it tears off keeps its own. ValueError."""
        if not 0 <= link < len(self.links):
            raise ValueError(f"link {link!r}: there are {len(self.links)}")
        self.torn[link] = 1

    def heat(self) -> float:
        """J in all nodes, from 0 K; of water: as a liquid."""
        laws, n = self.made_of, self.nodes
        return math.fsum(
            (
                (n[no.REST] + laws.fuel_heat * n[no.FUEL] + no.WATER_HEAT * n[no.WATER]) * n[no.TEMPERATURE]
            ).tolist()
        )

    def step(self, dt: float) -> int:
        """Go on by dt (s); how many substeps it took. ValueError unless above 0, or if it takes too many."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        laws = self.made_of.laws()
        arguments = (self.nodes, self.links, self.conductances, self.torn, laws)
        coupling = strongest_coupling(*arguments, float(dt), self._sums)
        substeps = max(1, math.ceil(dt * coupling / STABLE))
        if substeps > MOST_SUBSTEPS:
            raise ValueError(f"dt = {dt:g} s: expected at most {MOST_SUBSTEPS * STABLE / coupling:g} s")
        step_nodes(*arguments, substeps, float(dt), self.totals)
        return substeps

    def state(self) -> NodesState:
        """All that later steps depend on, not copied."""
        return NodesState(self.nodes, self.torn, self.totals)

    def restore(self, state: NodesState) -> None:
        """Take over a copy of a state."""
        self.nodes[:], self.torn[:], self.totals[:] = state.nodes, state.torn, state.totals


def _numbers(name: str, values: ArrayLike, count: int, low: float, high: float) -> Floats:
    """(count,) from a number or an array; ValueError naming the first that is out of range."""
    try:
        found = np.broadcast_to(np.asarray(values, dtype=np.float64), (count,)).copy()
    except ValueError:
        raise ValueError(f"{name}: expected a number or {count} of them") from None
    wrong = np.flatnonzero(~((found >= low) & (found <= high)))
    if len(wrong):
        raise ValueError(f"{name}[{wrong[0]}] = {found[wrong[0]]!r}: expected {low:g} to {high:g}")
    return found
