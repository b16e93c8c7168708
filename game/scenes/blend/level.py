"""What a level of splashes between splashes may say. Places are from the tank's lower left corner, m."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations

Place = Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)]
Size = Annotated[float, msgspec.Meta(ge=0.0, le=10.0)]
Speed = Annotated[float, msgspec.Meta(ge=-20.0, le=20.0)]
Side = Annotated[float, msgspec.Meta(ge=0.1, le=10.0)]
Seconds = Annotated[float, msgspec.Meta(ge=0.05, le=4.0)]
Moment = Annotated[float, msgspec.Meta(ge=0.0, le=4.0)]
MOST_LINKS = 32
GAP = 0.2  # of the tank's height, from one to the next
TANKS = {2: (2, 2), 4: (4, 3)}  # columns and rows of tanks that are shown, by the number of recorded runs


class WaterEntry(LevelEntry, frozen=True, kw_only=True):
    """A box of water between two corners, or a drop about ``low``; speed m/s downwards."""

    low: tuple[Place, Place] = (0.0, 0.0)
    high: tuple[Place, Place] = (0.0, 0.0)
    radius: Size = 0.0
    speed: Speed = 0.0


class RunEntry(LevelEntry, frozen=True, kw_only=True):
    """A run that is recorded. at, width, height: of a wall on the floor; seconds: how long it is."""

    water: Annotated[tuple[WaterEntry, ...], msgspec.Meta(max_length=8)] = ()
    at: Place = 0.8
    width: Size = 0.0
    height: Size = 0.0
    seconds: Seconds = 1.0


class LinkEntry(LevelEntry, frozen=True, kw_only=True):
    """A place of the first run, and one of another that belongs to it: s of each run, and x, y m.

    run: number of the other one, of two always 2.
    """

    run: Annotated[int, msgspec.Meta(ge=2, le=4)] = 2
    first: tuple[Moment, Place, Place]
    other: tuple[Moment, Place, Place]


class BlendContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. tank: width and height; cells: along it, in which runs are computed.

    runs: two, or four: left and right of the lower row, then of the upper one. links: what belongs together.
    """

    tank: tuple[Side, Side] = (1.6, 0.9)
    cells: Annotated[int, msgspec.Meta(ge=16, le=192)] = 80
    runs: Annotated[tuple[RunEntry, ...], msgspec.Meta(min_length=2, max_length=4)] = ()
    links: Annotated[tuple[LinkEntry, ...], msgspec.Meta(max_length=MOST_LINKS)] = ()
    expected: Expectations = ()

    @property
    def view(self) -> View:
        """All tanks."""
        columns, rows = TANKS.get(len(self.runs), (2, 2))
        gap = GAP * self.tank[1]
        return View(
            left=-gap, bottom=-gap, right=columns * (self.tank[0] + gap), top=rows * (self.tank[1] + gap)
        )


POOL = WaterEntry(low=(0.0, 0.0), high=(1.6, 0.25))
DEFAULT = BlendContent(
    runs=(
        RunEntry(water=(POOL, WaterEntry(low=(0.45, 0.55), radius=0.1, speed=1.5))),
        RunEntry(water=(POOL, WaterEntry(low=(1.1, 0.62), radius=0.14, speed=1.5))),
    ),
    links=(
        LinkEntry(first=(0.0, 0.45, 0.55), other=(0.0, 1.1, 0.62)),
        LinkEntry(first=(0.1, 0.45, 0.25), other=(0.11, 1.1, 0.25)),
    ),
)
