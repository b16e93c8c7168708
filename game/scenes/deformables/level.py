"""What a level of soft bodies may say."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import msgspec
import numpy as np

from game.physics.deformables import Mesh, blob, comb, strip
from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-1e6, le=1e6)]
Length = Annotated[float, msgspec.Meta(ge=1e-6, le=10.0)]
Number = Annotated[int, msgspec.Meta(ge=1, le=200)]
Point = tuple[Metre, Metre]
GOLDEN = math.pi * (3.0 - math.sqrt(5.0))  # rad, from each copy to the next: none lies as its neighbours do
MOST_BODIES = 1_000
WIDTH, HEIGHT = 3.2, 1.8  # m, between the walls, and in view


class Body(LevelEntry, frozen=True, kw_only=True):
    """One mesh, or a field of equal ones.

    shape: "blob" of size[0] across and so many rings; "strip" or "comb" of size (m) and cells (columns,
    rows). place: m, of the middle, or of the lower left one of a field. angle: degrees. copies: columns and
    rows of a field, pitch (m) apart, each copy turned on by the golden angle. velocity: m/s. fixed: which
    vertices stand still. mirrored: it begins turned inside out.
    """

    shape: Literal["blob", "strip", "comb"] = "blob"
    size: tuple[Length, Length] = (0.3, 0.3)
    rings: Annotated[int, msgspec.Meta(ge=1, le=60)] = 4
    cells: tuple[Number, Number] = (4, 4)
    place: Point = (0.0, 0.5)
    angle: Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)] = 0.0
    copies: tuple[Number, Number] = (1, 1)
    pitch: tuple[Metre, Metre] = (0.35, 0.35)
    velocity: Point = (0.0, 0.0)
    fixed: Literal["nothing", "left", "top", "bottom", "all"] = "nothing"
    mirrored: bool = False

    def mesh(self) -> Mesh:
        """The mesh at rest, about the origin."""
        if self.shape == "blob":
            return blob(0.5 * self.size[0], self.rings)
        return (strip if self.shape == "strip" else comb)(*self.size, *self.cells)

    def places(self) -> list[tuple[float, float, float]]:
        """x, y (m) and angle (rad) of each copy."""
        columns, rows = self.copies
        return [
            (
                self.place[0] + self.pitch[0] * (i + 0.25 * (j % 2) * (columns > 1)),
                self.place[1] + self.pitch[1] * j,
                math.radians(self.angle) + GOLDEN * (j * columns + i),
            )
            for j in range(rows)
            for i in range(columns)
        ]

    def is_fixed(self, points: np.ndarray) -> np.ndarray:
        """(n,) which vertices of the mesh at rest stand still."""
        x, y = points.T
        near = 1e-9
        chosen = {
            "left": x < x.min() + near, "top": y > y.max() - near, "bottom": y < y.min() + near,
            "all": np.full(len(x), True),
        }  # fmt: skip
        return np.asarray(chosen.get(self.fixed, np.full(len(x), False)))


class DeformablesContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level."""

    bodies: Annotated[tuple[Body, ...], msgspec.Meta(min_length=1, max_length=64)]
    expected: Expectations = ()

    def check_count(self) -> None:
        """ValueError if there are too many bodies."""
        count = sum(body.copies[0] * body.copies[1] for body in self.bodies)
        if count > MOST_BODIES:
            raise ValueError(f"bodies: {count} of them; at most {MOST_BODIES}")


DEFAULT = DeformablesContent(
    bodies=(
        Body(size=(0.3, 0.3), rings=4, place=(-1.3, 0.2), copies=(8, 3), pitch=(0.35, 0.33)),
        Body(shape="strip", size=(1.4, 0.1), cells=(28, 2), place=(0.0, 1.35)),
    )
)
