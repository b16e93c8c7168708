"""What holds at the four sides of a grid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.physics.grid.layout import Grid

KINDS = ("wall", "no-slip", "open", "inflow", "periodic")
WALL, NO_SLIP, OPEN, INFLOW, PERIODIC = range(5)
SIDES = ("left", "right", "bottom", "top")
LEFT, RIGHT, BOTTOM, TOP = range(4)


@dataclass(frozen=True, eq=False)
class Border:
    """One side.

    kind: "wall" (nothing passes, it slips), "no-slip" (a wall that the fluid sticks to: velocity is the
    wall's own along itself, as of a lid), "open" (pressure 0: fluid leaves and comes in freely), "inflow"
    (the velocity is given), "periodic" (joined to the opposite side, which must be too). velocity: (2,) m/s,
    or (n, 2) for the n cells along the side, from left or from below. scalars: values, by the name of a
    field, of what flows in, or that a wall keeps (a hot wall). A field that is not named has its
    surroundings' value in inflow and open sides, and does not pass walls.
    """

    kind: str = "wall"
    velocity: ArrayLike = (0.0, 0.0)
    scalars: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ValueError(f"kind = {self.kind!r}: expected one of {', '.join(KINDS)}")
        if not np.isfinite(np.asarray(self.velocity, dtype=np.float64)).all():
            raise ValueError("velocity: expected finite numbers, m/s")
        for name, value in self.scalars.items():
            if not np.isfinite(value):
                raise ValueError(f"scalars: {name} = {value!r}: expected a finite number")


@dataclass(frozen=True, eq=False)
class Borders:
    """All sides. ValueError if only one of two opposite sides is periodic."""

    left: Border = Border()
    right: Border = Border()
    bottom: Border = Border()
    top: Border = Border()

    def __post_init__(self) -> None:
        for one, other in ((self.left, self.right), (self.bottom, self.top)):
            if (one.kind == "periodic") != (other.kind == "periodic"):
                raise ValueError("kind: a side is periodic only together with the opposite one")

    @classmethod
    def all(cls, kind: str) -> Borders:
        """The same on every side."""
        return cls(*(Border(kind) for _ in SIDES))

    @property
    def sides(self) -> tuple[Border, Border, Border, Border]:
        """In the order of SIDES."""
        return self.left, self.right, self.bottom, self.top


class Edges(NamedTuple):
    """The same for kernels."""

    kinds: NDArray[np.int64]  # (4,) in the order of SIDES
    velocities: Floats  # (4, most cells of a side, 2) m/s


def edges_of(borders: Borders, grid: Grid) -> Edges:
    """For kernels; ValueError if a velocity is not (2,) or one for each cell of the side."""
    kinds = np.array([KINDS.index(side.kind) for side in borders.sides], dtype=np.int64)
    velocities = np.zeros((4, max(grid.nx, grid.ny), 2))
    for number, (name, side) in enumerate(zip(SIDES, borders.sides, strict=True)):
        count = grid.ny if number in (LEFT, RIGHT) else grid.nx
        given = np.asarray(side.velocity, dtype=np.float64)
        if given.shape not in ((2,), (count, 2)):
            raise ValueError(f"{name}: velocity has the shape {given.shape}: expected (2,) or ({count}, 2)")
        velocities[number, :count] = given
    return Edges(kinds, velocities)
