"""What a level of falling plates may say."""

from __future__ import annotations

import math
from typing import Annotated

import msgspec

from game.physics.kernels import elementary
from game.physics.plates import Plate
from game.worlds.entries.entry import LevelEntry
from game.worlds.entries.gusts import Gusts
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)]
Radian = Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)]
Ratio = Annotated[float, msgspec.Meta(ge=-20.0, le=20.0)]


class PlateEntry(LevelEntry, frozen=True, kw_only=True):
    """A plate: where it is let go (m), tilt (rad), velocity (m/s), spin (rad/s), and its law (see `Plate`).

    count: how many, each ``step`` farther and its inertia ``times`` as much.
    """

    at: tuple[Metre, Metre]
    tilt: Radian = 0.2
    velocity: tuple[Ratio, Ratio] = (0.0, 0.0)
    spin: Annotated[float, msgspec.Meta(ge=-1e5, le=1e5)] = 0.0
    half_chord: Annotated[float, msgspec.Meta(ge=0.002, le=0.2)] = 0.03
    inertia: Annotated[float, msgspec.Meta(ge=0.001, le=1000.0)] = 1.1
    thickness: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] = 1.0 / 14.0
    glide: Ratio = 1.2
    turn: Ratio = math.pi
    drag: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 1.4
    drag_turn: Ratio = 1.0
    torque: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.2
    torque_2: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.2
    curl: Annotated[float, msgspec.Meta(ge=-1.2, le=1.2)] = 0.0
    bend_hz: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    balance: Annotated[float, msgspec.Meta(ge=-0.8, le=0.8)] = 0.0
    count: Annotated[int, msgspec.Meta(ge=1, le=64)] = 1
    step: tuple[Metre, Metre] = (0.0, 0.0)
    times: Annotated[float, msgspec.Meta(ge=0.1, le=10.0)] = 1.0

    def plate(self, number: int = 0) -> Plate:
        """The plate ``number`` of the row, as the physics takes it."""
        inertia = self.inertia * elementary.pow(self.times, float(number))
        return Plate(
            self.half_chord, inertia, self.thickness, self.turn, self.glide,
            self.drag, self.drag_turn, self.torque, self.torque_2, self.curl, self.bend_hz,
            balance=self.balance,
        )  # fmt: skip


class PlatesContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. walls: segments (x, y, x, y) m that nothing passes; gusts: see `GustEntry`."""

    plates: Annotated[tuple[PlateEntry, ...], msgspec.Meta(max_length=64)] = ()
    walls: Annotated[tuple[tuple[Metre, Metre, Metre, Metre], ...], msgspec.Meta(max_length=32)] = ()
    gusts: Gusts = ()
    expected: Expectations = ()


DEFAULT = PlatesContent(
    plates=tuple(
        PlateEntry(at=(-0.77 + 0.22 * k, 0.5), inertia=inertia)
        for k, inertia in enumerate((0.4, 0.8, 1.1, 1.3, 1.4, 2.0, 3.2, 5.0))
    )
)
