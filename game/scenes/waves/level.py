"""What a level of water in a channel may say. Places are from the middle of the channel, m."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry, Metre, Point, View
from game.worlds.expectations import Expectations

Depth = Annotated[float, msgspec.Meta(ge=0.0, le=1000.0)]
Size = Annotated[float, msgspec.Meta(ge=0.001, le=1000.0)]
Discharge = Annotated[float, msgspec.Meta(ge=-1000.0, le=1000.0)]
End = Literal["wall", "open", "flow", "level"]


class WaterEntry(LevelEntry, frozen=True, kw_only=True):
    """Water between two places, up to a level, with a discharge (m²/s) to the right; the last one counts."""

    left: Metre = -1e5
    right: Metre = 1e5
    level: Metre = 1.0
    flow: Discharge = 0.0


class HumpEntry(LevelEntry, frozen=True, kw_only=True):
    """A rounded hump of water on the level: a Gaussian of a height and a width (standard deviation), m."""

    at: Metre = 0.0
    height: Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)] = 0.1
    width: Size = 1.0


class DamEntry(LevelEntry, frozen=True, kw_only=True):
    """A dam in the middle, over a flat bed, that breaks as the scene begins: depths on its sides."""

    left: Size = 1.0
    right: Depth = 0.0


class BowlEntry(LevelEntry, frozen=True, kw_only=True):
    """A parabolic trough and water that swings in it, see `game.physics.waves.Bowl`."""

    depth: Size = 1.0
    half: Size = 6.0
    swing: Metre = 1.5


class WavesContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. bed: points (x, z) of which the bed goes in lines; flows, levels of both ends.

    A dam or a bowl takes the place of bed and water. airy: the same water with waves of any length is drawn
    beside it; for a flat bed between walls, from rest.
    """

    bed: Annotated[tuple[Point, ...], msgspec.Meta(max_length=2000)] = ()
    water: Annotated[tuple[WaterEntry, ...], msgspec.Meta(max_length=64)] = ()
    hump: HumpEntry | None = None
    dam: DamEntry | None = None
    bowl: BowlEntry | None = None
    airy: bool = False
    ends: tuple[End, End] = ("wall", "wall")
    values: tuple[Discharge, Discharge] = (0.0, 0.0)
    expected: Expectations = ()
    view: View = View(left=-20.0, bottom=-0.5, right=20.0, top=2.5)

    @property
    def stretch(self) -> float:
        """How many times as large heights are drawn as lengths, so that the view is half as high as wide."""
        return max(
            1.0,
            float(
                int(0.5 * (self.view.right - self.view.left) / max(self.view.top - self.view.bottom, 1e-6))
            ),
        )


DEFAULT = WavesContent(dam=DamEntry())
