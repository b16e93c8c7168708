"""How linked particles are to be moved: a frozen record, each number checked where it comes in."""

from __future__ import annotations

import math
from dataclasses import dataclass

from game.physics.constraints.effects import AREAS, CONTACTS, DAMPING, LINKED, LINKS
from game.physics.constraints.links import MODELS
from game.physics.constraints.schemes import SCHEMES
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY, GROUND

SOLVERS = ("gauss-seidel", "direct")
LARGEST = 1e6  # m, m/s
MOST_TURNS = 10_000  # substeps of a step, sweeps of a substep


@dataclass(frozen=True, slots=True)
class Settings:
    """What a step does. ValueError, naming the field, for nonsense; change it by `dataclasses.replace`.

    effects: of `LINKED`. model: of MODELS. scheme: of SCHEMES. solver: of SOLVERS. substeps of a step and
    iterations (sweeps over all links) of a substep: whole. gravity: m/s² downwards. damping: k_d, N s/m.
    floor: m. left, right: m, of walls beside the ground; GROUND switches all three. body_distance: m, least
    distance between particles of different bodies, which are what links and outlines hold together, torn or
    not; 0: bodies pass through each other; CONTACTS switches it. relaxation: above 0, below 2; 1 is plain
    Gauss-Seidel. speed_limit: m/s, or infinity; it slows each particle by itself, so momentum is lost where
    it is met. stretch_limit: strain at which a link tears. restitution: of contacts of listed pairs.
    """

    effects: EffectSet = GRAVITY | GROUND | LINKS | DAMPING
    model: str = "pbd"
    scheme: str = "euler"
    solver: str = "gauss-seidel"
    substeps: int = 1
    iterations: int = 20
    gravity: float = 9.81
    damping: float = 0.0
    floor: float = -LARGEST
    left: float = -LARGEST
    right: float = LARGEST
    body_distance: float = 0.0
    relaxation: float = 1.0
    speed_limit: float = math.inf
    stretch_limit: float = 1.0
    restitution: float = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", LINKED.checked(self.effects))
        for name, options in (("model", MODELS), ("scheme", SCHEMES), ("solver", SOLVERS)):
            if getattr(self, name) not in options:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected one of {', '.join(options)}")
        for name in ("substeps", "iterations"):
            turns = getattr(self, name)
            if isinstance(turns, bool) or not isinstance(turns, int) or not 1 <= turns <= MOST_TURNS:
                raise ValueError(f"{name} = {turns!r}: expected a whole number, 1 to {MOST_TURNS}")
        limits = {
            "gravity": (-1e4, 1e4),
            "damping": (0.0, 1e9),
            "floor": (-LARGEST, LARGEST),
            "left": (-LARGEST, self.right),
            "right": (-LARGEST, LARGEST),
            "body_distance": (0.0, LARGEST),
            "relaxation": (1e-9, 2.0 - 1e-9),
            "speed_limit": (1e-9, math.inf),
            "stretch_limit": (0.0, 1e9),
            "restitution": (0.0, 1.0),
        }
        for name, (least, most) in limits.items():
            value = getattr(self, name)
            if not least <= value <= most:
                raise ValueError(f"{name} = {value!r}: expected {least:g} to {most:g}")


def effects_for(areas: bool, contacts: bool) -> EffectSet:
    """The usual effects, and those of outlines and of contacts if there are any."""
    effects = Settings().effects
    effects = effects.with_(AREAS) if areas else effects
    return effects.with_(CONTACTS) if contacts else effects
