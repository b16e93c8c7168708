"""How a cloth hangs and moves: its size, its hooks, what it gives way by."""

from __future__ import annotations

from dataclasses import dataclass

from game.physics.cloth.effects import CLOTH
from game.physics.effects import EffectSet


@dataclass(frozen=True, slots=True)
class Hanging:
    """How a cloth moves. ValueError, naming the field, for nonsense.

    width, height m; span: m between the hooks; top: m, how high these are. strength: strain at which a whole
    thread parts. shear, folds: compliance m/N of a mesh's diagonals and of folds. calm 1/s: its own friction.
    floor: m, on which it comes to lie.
    """

    width: float = 1.6
    height: float = 0.9
    span: float = 1.56
    top: float = 1.5
    substeps: int = 8
    gravity: float = 9.81
    strength: float = 1.2
    shear: float = 2.0e-2
    folds: float = 1.0e-3
    calm: float = 0.25
    floor: float = 0.012
    effects: EffectSet = CLOTH.known

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", CLOTH.checked(self.effects))
        ranges = {
            "width": (1e-3, 1e3), "height": (1e-3, 1e3), "span": (0.0, 1e3), "top": (-1e3, 1e3),
            "gravity": (-1e3, 1e3), "strength": (1e-3, 1e3), "shear": (0.0, 1e6), "folds": (0.0, 1e6),
            "calm": (0.0, 1e3), "floor": (-1e3, 1e3),
        }  # fmt: skip
        for name, (low, high) in ranges.items():
            if not low <= getattr(self, name) <= high:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected {low:g} to {high:g}")
        if isinstance(self.substeps, bool) or not 1 <= self.substeps <= 1000:
            raise ValueError(f"substeps = {self.substeps!r}: expected 1 to 1000")
        if self.span > self.width:
            raise ValueError(f"span = {self.span!r}: expected at most the width, {self.width:g} m")
