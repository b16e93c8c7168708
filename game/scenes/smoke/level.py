"""What a level of smoke may say: sources, solids, sides, how it is stirred at first."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-0.5, le=2.5)]
Radius = Annotated[float, msgspec.Meta(ge=0.01, le=0.6)]
Speed = Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)]
MOST_SOLIDS = 12


class SourceEntry(LevelEntry, frozen=True, kw_only=True):
    """A place (m) and its radius (m) that is kept: smoke (0 to 1), K, fuel kg/m³, velocity m/s, for so many
    s. dye: what the smoke is, grey or coloured.
    """

    at: tuple[Metre, Metre]
    radius: Radius = 0.05
    smoke: Annotated[float, msgspec.Meta(ge=0.0, le=10.0)] = 1.0
    dye: Literal["smoke", "blue", "pink", "yellow"] = "smoke"
    kelvin: Annotated[float, msgspec.Meta(ge=1.0, le=1e6)] = 293.15
    fuel: Annotated[float, msgspec.Meta(ge=0.0, le=10.0)] = 0.0
    velocity: tuple[Speed, Speed] | None = None
    seconds: Annotated[float, msgspec.Meta(ge=0.0, le=1e6)] = 1e6


class SolidEntry(LevelEntry, frozen=True, kw_only=True):
    """A disc (m)."""

    at: tuple[Metre, Metre]
    radius: Radius = 0.1


class SmokeContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. sides: "closed", "open" above, or "wind" through from the left.

    start: "still"; "whirl": one whirl that fills the box, a steady flow; "layers": hot gas above cold.
    """

    sources: Annotated[tuple[SourceEntry, ...], msgspec.Meta(max_length=12)] = ()
    solids: Annotated[tuple[SolidEntry, ...], msgspec.Meta(max_length=MOST_SOLIDS)] = ()
    sides: Literal["closed", "open", "wind"] = "open"
    start: Literal["still", "whirl", "layers"] = "still"
    expected: Expectations = ()


DEFAULT = SmokeContent(
    sources=(SourceEntry(at=(0.7, 0.06), radius=0.045, kelvin=430.0),),
    solids=(SolidEntry(at=(0.78, 0.5), radius=0.1),),
)
