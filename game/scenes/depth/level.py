"""What a level of two overlapping shapes may say."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-3.0, le=3.0)]


class PlacedShape(LevelEntry, frozen=True, kw_only=True):
    """Where a shape is. position: m, of its centroid; turn: °; size: m, half its width; flat: its height is
    so many times that of the shape by name. Which shape it is, the parameters say."""

    position: tuple[Metre, Metre] = (0.0, 0.0)
    turn: Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)] = 0.0
    size: Annotated[float, msgspec.Meta(ge=0.1, le=2.0)] = 1.0
    flat: Annotated[float, msgspec.Meta(ge=0.01, le=10.0)] = 1.0


class DepthContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. moves: whether A moves out from the beginning."""

    a: PlacedShape = PlacedShape()
    b: PlacedShape = PlacedShape()
    moves: bool = False
    expected: Expectations = ()


DEFAULT = DepthContent(
    a=PlacedShape(position=(0.15, 0.3), turn=186.0, size=1.1), b=PlacedShape(position=(-0.1, -0.4), size=1.1)
)
