"""A phased array, a focus that moves, and the grains that it carries."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.physics.acoustics import grains
from game.physics.acoustics.array import PATTERNS, PhasedArray
from game.physics.acoustics.effects import GRAINS
from game.physics.acoustics.field import PHASE, SX, SY, sample_field
from game.physics.acoustics.grains import Air, Flight, Grain, GrainState, Lead, advance, wave_of
from game.physics.acoustics.paths import figure_path
from game.physics.effects import EffectSet
from game.physics.kernels import elementwise

FREQUENCY = 40_000.0  # Hz, of the usual transducers
PISTON = 4.5e-3  # m, their radius
AIR = Air(1.204, 1.825e-5, 343.2)  # at 20 °C
POLYSTYRENE = Grain(0.6e-3, 29.0, 900.0)  # expanded
LARGEST_GRAIN = 0.25  # of a wave length, radius: beyond that Gor'kov's potential says nothing any more
MOST_GRAINS = 256
MOST_SUBSTEPS = 1_000
TOUCHING = 1.05  # diameters between the middles of grains that lie on each other


@dataclass(frozen=True, slots=True)
class LevitatorSettings:
    """What a step does. ValueError, naming the field, for nonsense.

    effects: of `GRAINS`; substeps of a step; gravity m/s²; speed m/s and acceleration m/s² of the focus;
    pattern: of PATTERNS. "focus": the sound of all meets at a place; "plane": each row sends a plane wave.
    """

    effects: EffectSet = GRAINS.known
    substeps: int = 32
    gravity: float = 9.81
    speed: float = 0.1
    acceleration: float = 1.0
    pattern: str = "focus"

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", GRAINS.checked(self.effects))
        if isinstance(self.substeps, bool) or not 1 <= self.substeps <= MOST_SUBSTEPS:
            raise ValueError(f"substeps = {self.substeps!r}: expected a whole number, 1 to {MOST_SUBSTEPS}")
        if self.pattern not in PATTERNS:
            raise ValueError(f"pattern = {self.pattern!r}: expected one of {', '.join(PATTERNS)}")
        for name, low, high in (("gravity", -1e4, 1e4), ("speed", 0.0, 1e4), ("acceleration", 0.0, 1e6)):
            if not low <= getattr(self, name) <= high:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected {low:g} to {high:g}")


class Levitator:
    """Grains in the field of an array.

    places: (n, 2) m, of grains at rest. figure: of FIGURES, that the focus is led along, ``size`` m half its
    width. ValueError, naming the argument, for nonsense; a grain may not be larger than a quarter wave.
    """

    def __init__(
        self,
        array: PhasedArray,
        places: ArrayLike,
        grain: Grain = POLYSTYRENE,
        figure: str = "circle",
        size: float = 0.02,
        settings: LevitatorSettings | None = None,
    ):
        self.array, self.offsets = array, array.offsets()
        self.settings = settings or LevitatorSettings()
        self.half = float(np.max(np.abs(array.sources[:, SX : SY + 1])))
        self.hand: tuple[float, float] | None = None
        self.set_grain(grain)
        where = np.array(places, dtype=np.float64).reshape(-1, 2)
        if len(where) > MOST_GRAINS or not np.isfinite(where).all():
            raise ValueError(f"places: expected at most {MOST_GRAINS} points of finite numbers")
        self.fields: Floats = np.zeros((grains.FIELDS, len(where)))
        self.fields[:2] = where.T
        self.focus: Floats = np.zeros(4)
        self.set_figure(figure, size)

    # -- what it is made of -------------------------------------------------------------------------

    def set_grain(self, grain: Grain) -> None:
        """Other grains from now on. ValueError unless small, and of numbers above 0."""
        for name, value in zip(grain._fields, grain, strict=True):
            if not 0.0 < value < math.inf:
                raise ValueError(f"{name} = {value!r}: expected a finite number above 0")
        most = LARGEST_GRAIN * AIR.sound / FREQUENCY
        if grain.radius > most:
            raise ValueError(f"radius = {grain.radius:g} m: expected at most a quarter wave, {most:.3g} m")
        self.grain = grain
        self.wave = wave_of(grain, AIR, FREQUENCY, PISTON)

    def set_figure(self, figure: str, size: float) -> None:
        """Lead the focus along another figure, from its beginning."""
        self.path = figure_path(figure, size)
        self.focus[:] = 0.0, 0.0, self.path[0, 0], self.path[0, 1]
        self.aim()

    def add(self, place: tuple[float, float]) -> None:
        """One more grain at rest; ValueError if there are too many, or no place."""
        if self.count >= MOST_GRAINS or not all(map(math.isfinite, place)):
            raise ValueError(f"grain at {place}: expected a finite place, and at most {MOST_GRAINS} grains")
        grain = np.zeros((grains.FIELDS, 1))
        grain[:2, 0] = place
        self.fields = np.concatenate([self.fields, grain], axis=1)

    @property
    def count(self) -> int:
        """Grains."""
        return int(self.fields.shape[1])

    @property
    def positions(self) -> Floats:
        """(n, 2) m, a copy."""
        return self.fields[:2].T.copy()

    @property
    def place(self) -> tuple[float, float]:
        """The focus, m."""
        return float(self.focus[grains.FOCUS_X]), float(self.focus[grains.FOCUS_Y])

    def aim(self) -> None:
        """Give the transducers the phases for the place of the focus, after another pattern was set."""
        turn = self.array.level if self.settings.pattern == "plane" else self.array.focus
        turn(self.wave.number, self.place, self.offsets)

    # -- a step -------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        settings, grain = self.settings, self.grain
        mode = grains.FOLLOWS if self.hand is not None else grains.LED
        if settings.pattern == "plane":
            mode = grains.STANDS
        hand = self.hand or (0.0, 0.0)
        flight = Flight(
            GRAINS.mask(settings.effects), settings.substeps, float(settings.gravity), grain.mass,
            grain.radius,
            6.0 * math.pi * AIR.viscosity * grain.radius / grain.mass,
            2.0 * grain.radius * AIR.density / AIR.viscosity, self.half,
        )  # fmt: skip
        lead = Lead(mode, float(settings.speed), float(settings.acceleration), float(hand[0]), float(hand[1]))
        advance(
            self.fields, self.focus, self.array.sources, self.offsets, self.path, self.wave, flight, lead,
            float(dt),
        )  # fmt: skip

    # -- what is there ------------------------------------------------------------------------------

    def sample(self, places: ArrayLike) -> Floats:
        """(n, 6): p real and imaginary (Pa), |grad p| (Pa/m), U (J), force (N, 2) on a grain at (n, 2) m."""
        where = np.ascontiguousarray(np.array(places, dtype=np.float64).reshape(-1, 2))
        out = np.empty((len(where), 6))
        sample_field(self.array.sources, self.wave, where, out)
        return out

    def held(self) -> NDArray[np.bool_]:
        """(n,) whether each grain is carried: slower against the focus than it would fall in 20 ms, off the
        rows, and on no heap of grains that lie there."""
        speed = elementwise.hypot(*self.fields[grains.VX : grains.VX + 2])
        lies = np.max(np.abs(self.fields[:2]), axis=0) >= self.half - 1.5 * self.grain.radius
        return np.asarray(~self._heaped(lies) & (speed < float(self.focus[1]) + 0.2))

    def _heaped(self, lies: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(n,) grains that lie, and all that touch one of them, from grain to grain."""
        x, y = self.positions.T
        touches = elementwise.hypot(x[:, None] - x, y[:, None] - y) <= TOUCHING * 2.0 * self.grain.radius
        heap = lies
        while np.any(more := np.any(touches[:, heap], axis=1) & ~heap):
            heap = heap | more
        return heap

    def state(self) -> GrainState:
        """All that later steps depend on."""
        return GrainState(self.fields, self.focus, self.array.sources[:, PHASE])

    def restore(self, state: GrainState) -> None:
        """Take over a copy of a state."""
        self.fields = state.fields.copy()
        self.focus[:] = state.focus
        self.array.sources[:, PHASE] = state.phases
