"""What a cloth is made of, checked."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from game.physics.cloth.charring import REACTIONS, ClothLaws, Kind
from game.physics.cloth.speeds import creeping_speed
from game.physics.effects import EffectSet
from game.physics.heat.effects import HEAT
from game.physics.heat.exact import fisher_speed

PLAIN = Kind(ignition=640.0, rate=0.22, heat=2.0e6, vapour=0.3, char=0.55, oxygen=0.2)
BARE = Kind(ignition=560.0, rate=0.6, heat=5.0e6, vapour=0.5, char=0.1, oxygen=0.2)
SALTED = Kind(ignition=500.0, rate=0.62, heat=6.0e6, vapour=0.5, char=0.0, oxygen=0.85)
_RANGES = {
    "dry": (1e-6, 1e3), "capacity": (1e-3, 1e9), "diffusivity": (1e-12, 1e3), "kept": (0.0, 1.0),
    "exchange": (0.0, 1e6), "stirred": (0.0, 1e6), "emissivity": (0.0, 1.0), "ambient": (1.0, 1e4),
    "retardant": (0.0, 1.0),
}  # fmt: skip
_OF_KIND = {
    "ignition": (1.0, 1e6), "rate": (0.0, 1e6), "heat": (0.0, 1e10), "vapour": (0.0, 1.0),
    "char": (0.0, 1.0), "oxygen": (0.0, 1.0),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Fabric:
    """A cloth, as `ClothLaws` has it. ValueError, naming the field, for nonsense.

    dry kg/m²; capacity J/(m² K); diffusivity m²/s of heat along it; kept: share of the heat of what burns in
    it that stays; exchange, stirred W/(m² K) with the gas; retardant: 1 as treated, 0 bare cotton; reaction:
    of REACTIONS.
    """

    dry: float = 0.25
    capacity: float = 350.0
    diffusivity: float = 2.0e-4
    kept: float = 0.7
    exchange: float = 9.0
    stirred: float = 6.0
    emissivity: float = 0.85
    ambient: float = 293.15
    retardant: float = 1.0
    reaction: str = "ignition"
    treated: Kind = PLAIN
    bare: Kind = BARE
    salted: Kind = SALTED
    effects: EffectSet = field(default_factory=lambda: HEAT.known)

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", HEAT.checked(self.effects))
        for name, (low, high) in _RANGES.items():
            if not low <= getattr(self, name) <= high:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected {low:g} to {high:g}")
        if self.reaction not in REACTIONS:
            raise ValueError(f"reaction = {self.reaction!r}: expected one of {', '.join(REACTIONS)}")
        for kind in ("treated", "bare", "salted"):
            of = getattr(self, kind)
            for name, (low, high) in _OF_KIND.items():
                if not low <= getattr(of, name) <= high:
                    raise ValueError(f"{kind}.{name} = {getattr(of, name)!r}: expected {low:g} to {high:g}")
            if of.vapour + of.char > 1.0:
                raise ValueError(f"{kind}: vapour and char are more than what goes")

    @property
    def rise(self) -> float:
        """K by which the heat of all its fuel warms cloth that is written on, if nothing is lost."""
        burnt = 1.0 - self.salted.vapour - self.salted.char
        return max(self.kept * burnt * self.salted.heat * self.dry / self.capacity, 1e-9)

    def plain(self) -> Kind:
        """The cloth that nothing is written on, between bare and treated."""
        share = self.retardant
        return Kind(*(a + share * (b - a) for a, b in zip(self.bare, self.treated, strict=True)))

    def kinds(self) -> tuple[Kind, Kind]:
        """Plain and written on, for kernels."""
        return self.plain(), Kind(*map(float, self.salted))

    def laws(self) -> ClothLaws:
        """For kernels."""
        return ClothLaws(
            HEAT.mask(self.effects), REACTIONS.index(self.reaction), self.diffusivity * self.capacity,
            float(self.capacity), float(self.dry), float(self.kept), float(self.exchange),
            float(self.stirred), float(self.emissivity), float(self.ambient), float(self.rise),
        )  # fmt: skip

    def loss(self) -> float:
        """1/s at which a cloth that just takes fire cools, by radiation and still air, if it were linear."""
        hot, cold = self.salted.ignition, self.ambient
        radiated = self.emissivity * 5.670374419e-8 * (hot + cold) * (hot * hot + cold * cold)
        return 2.0 * (radiated + self.exchange) / self.capacity

    def front_speed(self, lossless: bool = False) -> float:
        """m/s of a straight front of embers in cloth that is written on, by its own law; 0: it goes out.

        Exact without losses; with them they are taken as linear, as they are at the ignition temperature.
        """
        loss = 0.0 if lossless else self.loss()
        if self.reaction == "fisher":
            return fisher_speed(self.diffusivity, max(self.salted.rate - loss, 1e-300))
        ignition = (self.salted.ignition - self.ambient) / self.rise
        if not 0.0 < ignition < 1.0:
            return 0.0 if ignition >= 1.0 else math.inf
        return creeping_speed(self.diffusivity, self.salted.rate, ignition, loss)

    def fisher_speed(self) -> float:
        """m/s: 2 sqrt(D r), of Fisher, Kolmogorov, Petrovsky and Piskunov (1937)."""
        return fisher_speed(self.diffusivity, self.salted.rate)
