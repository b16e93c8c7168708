"""What a level of the tower may say: its floors and columns, what is cut first, what is expected."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-1e4, le=1e4)]
MOST_STOREYS, MOST_BAYS = 40, 8


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre = -34.0
    bottom: Metre = -4.0
    right: Metre = 34.0
    top: Metre = 46.0


class TowerContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level of the tower: an empty frame of floors upon columns.

    storeys, bays: how many; storey: m from floor to floor, bay: m from column to column; slab: m, thickness
    of a floor, column: m, breadth. first: storey whose columns are cut first, from the ground, 1 the lowest.
    fired_at: s after the beginning; None: it waits for a hand. seed: of how things break.
    """

    storeys: Annotated[int, msgspec.Meta(ge=2, le=MOST_STOREYS)] = 13
    bays: Annotated[int, msgspec.Meta(ge=1, le=MOST_BAYS)] = 3
    storey: Annotated[float, msgspec.Meta(ge=1.0, le=20.0)] = 3.0
    bay: Annotated[float, msgspec.Meta(ge=1.0, le=20.0)] = 5.0
    slab: Annotated[float, msgspec.Meta(ge=0.1, le=1.0)] = 0.4
    column: Annotated[float, msgspec.Meta(ge=0.1, le=1.0)] = 0.5
    first: Annotated[int, msgspec.Meta(ge=1, le=MOST_STOREYS)] = 12
    fired_at: Annotated[float, msgspec.Meta(ge=0.0, le=1e4)] | None = None
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**31)] = 8
    expected: Expectations = ()
    view: View = View()
