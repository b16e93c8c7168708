"""What a level of liquid may say. Places are from the lower left corner of the tank, m."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations

Place = Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)]
Size = Annotated[float, msgspec.Meta(ge=0.005, le=100.0)]
Speed = Annotated[float, msgspec.Meta(ge=-50.0, le=50.0)]
Weight = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]
Turn = Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)]
Side = Literal["left", "right", "bottom", "top"]
MOST_ENTRIES = 64


class WaterEntry(LevelEntry, frozen=True, kw_only=True):
    """A box of water between two corners, with a speed, m/s; ``radius``: a drop about ``low`` instead, m."""

    low: tuple[Place, Place] = (0.0, 0.0)
    high: tuple[Place, Place] = (0.0, 0.0)
    radius: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    speed: tuple[Speed, Speed] = (0.0, 0.0)


class SolidEntry(LevelEntry, frozen=True, kw_only=True):
    """A box, or a ball where ``radius`` is given; density beside water's, 0: it stays where it is."""

    at: tuple[Place, Place]
    size: tuple[Size, Size] = (0.1, 0.1)
    radius: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 0.0
    angle: Turn = 0.0
    density: Weight = 0.5


class TapEntry(LevelEntry, frozen=True, kw_only=True):
    """A mouth so wide across the flow of a speed, m/s."""

    at: tuple[Place, Place]
    width: Size = 0.05
    speed: tuple[Speed, Speed] = (0.0, -1.0)


class DrainEntry(LevelEntry, frozen=True, kw_only=True):
    """A disc in which water vanishes."""

    at: tuple[Place, Place]
    radius: Size = 0.05


class LiquidContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. tank: width and height; open: sides through which water leaves."""

    tank: tuple[Size, Size] = (2.0, 1.125)
    open: Annotated[tuple[Side, ...], msgspec.Meta(max_length=4)] = ()
    water: Annotated[tuple[WaterEntry, ...], msgspec.Meta(max_length=MOST_ENTRIES)] = ()
    solids: Annotated[tuple[SolidEntry, ...], msgspec.Meta(max_length=MOST_ENTRIES)] = ()
    taps: Annotated[tuple[TapEntry, ...], msgspec.Meta(max_length=MOST_ENTRIES)] = ()
    drains: Annotated[tuple[DrainEntry, ...], msgspec.Meta(max_length=MOST_ENTRIES)] = ()
    expected: Expectations = ()

    @property
    def view(self) -> View:
        """The tank, with a margin."""
        edge = 0.06 * self.tank[1]
        return View(left=-edge, bottom=-edge, right=self.tank[0] + edge, top=self.tank[1] + 0.5 * edge)


DEFAULT = LiquidContent(
    water=(WaterEntry(high=(0.6, 0.8)),),
    solids=(
        SolidEntry(at=(1.35, 0.07), size=(0.14, 0.14), density=0.4),
        SolidEntry(at=(1.65, 0.09), radius=0.09),
    ),
)
