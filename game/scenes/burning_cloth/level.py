"""What a level of the burning cloth may say: words, dabs of a brush, water, wind, what is expected."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.scenes.burning_cloth.letters import MOST, unknown_in
from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-1.0, le=3.0)]
MOST_DABS = 900


class HotEntry(LevelEntry, frozen=True, kw_only=True):
    """A place of the cloth (m from its upper left corner) that is hot at first."""

    at: tuple[Metre, Metre]
    radius: Annotated[float, msgspec.Meta(ge=0.001, le=2.0)] = 0.04
    kelvin: Annotated[float, msgspec.Meta(ge=200.0, le=3000.0)] = 1100.0


class BurningClothContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. words: written instead of what is chosen; dabs: of a brush, (right, down) m from
    the cloth's upper left corner; washed: dabs that take the saltpetre away again; wet: kg/m² of water all
    over; hot: places that are hot at first.
    """

    words: Annotated[str, msgspec.Meta(max_length=MOST)] | None = None
    dabs: Annotated[tuple[tuple[Metre, Metre], ...], msgspec.Meta(max_length=MOST_DABS)] = ()
    washed: Annotated[tuple[tuple[Metre, Metre], ...], msgspec.Meta(max_length=MOST_DABS)] = ()
    wet: Annotated[float, msgspec.Meta(ge=0.0, le=10.0)] = 0.0
    hot: Annotated[tuple[HotEntry, ...], msgspec.Meta(max_length=8)] = ()
    expected: Expectations = ()

    def __post_init__(self) -> None:
        sign = unknown_in(self.words or "")
        if sign:
            raise ValueError(f"words: {sign!r} cannot be written; there are A to Z, 0 to 9, a space and ♥")


DEFAULT = BurningClothContent()
