"""What a level of a pond may say. Places are from its lower left corner, m."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations

Place = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]
Size = Annotated[float, msgspec.Meta(ge=0.5, le=100.0)]
Speed = Annotated[float, msgspec.Meta(ge=-20.0, le=20.0)]
Height = Annotated[float, msgspec.Meta(ge=-1.0, le=1.0)]
MOST_FLOATS = 400


class DropEntry(LevelEntry, frozen=True, kw_only=True):
    """A stone that falls in as the scene begins: the height of its first crest (m). ring: the crest alone."""

    x: Place
    y: Place
    height: Height = 0.05
    ring: bool = False


class FloatEntry(LevelEntry, frozen=True, kw_only=True):
    """A round float: radius and height (m), density beside water's, and how far above its rest it begins."""

    x: Place
    y: Place
    radius: Annotated[float, msgspec.Meta(ge=0.03, le=2.0)] = 0.18
    tall: Annotated[float, msgspec.Meta(ge=0.03, le=2.0)] = 0.2
    density: Annotated[float, msgspec.Meta(ge=0.02, le=4.0)] = 0.5
    lifted: Annotated[float, msgspec.Meta(ge=-2.0, le=2.0)] = 0.0


class BoatEntry(LevelEntry, frozen=True, kw_only=True):
    """A boat and the velocity (m/s) that it keeps by itself; at a bank it turns round."""

    x: Place = 2.0
    y: Place = 4.5
    along: Speed = 0.0
    up: Speed = 0.0


class PondContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. strewn: so many floats in rows all over, besides those that are named."""

    width: Size = 16.0
    height: Size = 9.0
    drops: Annotated[tuple[DropEntry, ...], msgspec.Meta(max_length=64)] = ()
    floats: Annotated[tuple[FloatEntry, ...], msgspec.Meta(max_length=MOST_FLOATS)] = ()
    strewn: Annotated[int, msgspec.Meta(ge=0, le=MOST_FLOATS)] = 0
    boat: BoatEntry | None = None
    expected: Expectations = ()

    @property
    def view(self) -> View:
        """All of it, and a rim of its bank."""
        rim = 0.02 * self.width
        return View(left=-rim, bottom=-rim, right=self.width + rim, top=self.height + rim)


DEFAULT = PondContent(
    drops=(DropEntry(x=10.5, y=5.4),),
    floats=(
        FloatEntry(x=6.0, y=3.0), FloatEntry(x=6.6, y=6.2, radius=0.26), FloatEntry(x=12.8, y=3.4),
        FloatEntry(x=9.0, y=2.2, radius=0.22), FloatEntry(x=13.6, y=6.9, radius=0.3),
    ),
    boat=BoatEntry(x=3.0, y=4.2, along=1.3, up=0.35),
)  # fmt: skip
