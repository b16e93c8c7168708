"""What a level of the fireplace may say: wood, damper, wind, and what is expected."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-2.0, le=2.0)]
Length = Annotated[float, msgspec.Meta(ge=0.01, le=1.2)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
MOST_WOOD, MOST_PIECES = 40, 96


class WoodEntry(LevelEntry, frozen=True, kw_only=True):
    """A log or a stick: its middle (m), degrees from level, length and thickness (m), in how many pieces it
    may break; moisture: kg of water for a kg of wood; kelvin: how warm it is.
    """

    at: tuple[Metre, Metre]
    turn: Annotated[float, msgspec.Meta(ge=-180.0, le=180.0)] = 0.0
    length: Length = 0.6
    thick: Annotated[float, msgspec.Meta(ge=0.008, le=0.3)] = 0.1
    pieces: Annotated[int, msgspec.Meta(ge=1, le=12)] = 5
    moisture: Annotated[float, msgspec.Meta(ge=0.0, le=2.0)] = 0.0
    kelvin: Annotated[float, msgspec.Meta(ge=200.0, le=2000.0)] = 293.15


class FireplaceContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. damper: share of the flue that is open. sealed: no air comes in or goes out."""

    wood: Annotated[tuple[WoodEntry, ...], msgspec.Meta(max_length=MOST_WOOD)] = ()
    damper: Share = 1.0
    sealed: bool = False
    expected: Expectations = ()


LOGS = (
    WoodEntry(at=(-0.015, 0.318), turn=9.0, length=0.5, thick=0.085, pieces=6),
    WoodEntry(at=(-0.21, 0.19), turn=0.0, length=0.27, thick=0.08, pieces=3),
    WoodEntry(at=(0.17, 0.205), turn=0.0, length=0.29, thick=0.11, pieces=3),
    WoodEntry(at=(0.05, 0.415), turn=-14.0, length=0.36, thick=0.07, pieces=5),
)
KINDLING = tuple(
    WoodEntry(at=(x, 0.066), turn=turn, length=0.155, thick=0.014, pieces=2)
    for x, turn in (
        (-0.2, 50.0), (-0.14, -52.0), (-0.075, 54.0), (-0.02, -50.0), (0.035, 52.0), (0.09, -54.0),
        (0.15, 50.0), (0.21, -52.0),
    )
)  # fmt: skip
DEFAULT = FireplaceContent(wood=(*LOGS, *KINDLING))
