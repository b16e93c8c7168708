"""A wind and its gusts in a level."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.physics.plates import Gust
from game.worlds.entries.entry import LevelEntry

Metre = Annotated[float, msgspec.Meta(ge=-1000.0, le=1000.0)]
Speed = Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)]  # m/s
Second = Annotated[float, msgspec.Meta(ge=0.0, le=10_000.0)]


class GustEntry(LevelEntry, frozen=True, kw_only=True):
    """A gust: the place of its middle (m), its beginning and its length (s), the velocity of its middle
    (m/s), its size (m). Then the wind at its middle (m/s), and the speed of its turning (m/s).
    """

    place: tuple[Metre, Metre]
    begins: Second = 0.0
    lasts: Annotated[float, msgspec.Meta(ge=0.01, le=1000.0)] = 2.0
    goes: tuple[Speed, Speed] = (0.0, 0.0)
    size: Annotated[float, msgspec.Meta(ge=0.05, le=100.0)] = 1.0
    blows: tuple[Speed, Speed] = (0.0, 0.0)
    turns: Speed = 0.0

    def gust(self) -> Gust:
        """As the physics takes it."""
        return Gust(self.place, self.begins, self.lasts, self.goes, self.size, self.blows, self.turns)


Gusts = Annotated[tuple[GustEntry, ...], msgspec.Meta(max_length=60)]
