"""What a step of gas does."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from game.physics.effects import EffectSet
from game.physics.gas.effects import GAS, USUAL
from game.physics.multigrid import SOLVERS

ADVECTIONS = ("stam-1999", "linear", "cubic", "maccormack", "time-centred")
QUALITIES = ("play", "teach", "film")
_OF_QUALITY = {
    "play": {"turns": 2, "tolerance": 1e-4, "prime": False, "centring": 0.52},
    "teach": {"turns": 5, "tolerance": 1e-6, "prime": False, "centring": 0.52},
    "film": {"turns": 30, "tolerance": 1e-10, "prime": True, "centring": 0.5},
}


@dataclass(frozen=True, slots=True)
class GasSettings:
    """What a step does. ValueError, naming the field, for nonsense; change it by `dataclasses.replace`.

    effects: of `GAS`. advection: of ADVECTIONS. "stam-1999" goes back straight, by the velocity where it ends
    (his order of steps, linear). "linear", "cubic", "maccormack" (Selle et al. 2008, limited) by the midpoint
    rule. "time-centred" is cubic. It takes only a part ``centring`` (q, 0.5 to 1) of the pressure from the
    end of the step, the rest is carried: second order at 0.5. In a step in which gas goes more than 8 cells q
    grows, to 1 at 16 cells: the pressure of before, carried so far along a straight way, would be wrong where
    the gas turns (`report.centring` says what q was). prime: a first projection, thrown away, so that the
    first step knows its pressure. pressure: of SOLVERS, in at most ``turns`` (0: as usual) until no cell
    changes its volume by more than ``tolerance`` in a step. viscosity, and diffusivity of scalars (one
    number, or by field): m²/s. gravity (x, y) m/s²; ambient: K, of what surrounds the gas; smoke_weight: how
    much heavier than air smoke of 1 is; confinement: epsilon of vorticity confinement. slip: the gas slides
    along solids, else it sticks to them. conservative: fields that are named here are carried in flux form,
    and pushed aside by solids: their sums are kept to rounding. carries_fields: if False, a step leaves
    fields where they are; what owns the gas carries them afterwards (`densities.carry_densities`).
    """

    effects: EffectSet = USUAL
    advection: str = "time-centred"
    centring: float = 0.52
    prime: bool = False
    pressure: str = "multigrid"
    turns: int = 2
    tolerance: float = 1e-4
    viscosity: float = 0.0
    diffusivity: float | Mapping[str, float] = 0.0
    gravity: tuple[float, float] = (0.0, -9.81)
    ambient: float = 293.15
    smoke_weight: float = 0.0
    confinement: float = 0.0
    slip: bool = True
    conservative: tuple[str, ...] = field(default=())
    carries_fields: bool = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", GAS.checked(self.effects))
        for name, known in (("advection", ADVECTIONS), ("pressure", SOLVERS)):
            if getattr(self, name) not in known:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected one of {', '.join(known)}")
        if isinstance(self.turns, bool) or not isinstance(self.turns, int) or not 0 <= self.turns <= 100_000:
            raise ValueError(f"turns = {self.turns!r}: expected a whole number, 0 to 100000")
        limits = {
            "centring": (0.5, 1.0), "tolerance": (0.0, 1.0), "viscosity": (0.0, 1e6), "ambient": (1e-3, 1e6),
            "smoke_weight": (-1e6, 1e6), "confinement": (0.0, 1e3),
        }  # fmt: skip
        for name, (low, high) in limits.items():
            if not low <= getattr(self, name) <= high:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected {low:g} to {high:g}")
        if len(self.gravity) != 2 or not all(abs(g) <= 1e6 for g in self.gravity):
            raise ValueError(f"gravity = {self.gravity!r}: expected two numbers, m/s²")
        given = self.diffusivity
        for value in given.values() if isinstance(given, Mapping) else (given,):
            if not 0.0 <= value < math.inf:
                raise ValueError(f"diffusivity = {value!r}: expected a number from 0, m²/s")

    def quality(self, name: str) -> GasSettings:
        """The same at another quality, of QUALITIES: play, teach, film. ValueError for others."""
        if name not in _OF_QUALITY:
            raise ValueError(f"quality = {name!r}: expected one of {', '.join(QUALITIES)}")
        return replace(self, **_OF_QUALITY[name])  # type: ignore[arg-type]
