"""What a level of leaves in a wind may say."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.entries.gusts import Gusts
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-20.0, le=20.0)]
Kind = Literal["maple", "oak", "birch", "linden", "ash"]


class BedEntry(LevelEntry, frozen=True, kw_only=True):
    """Leaves that lie in a row from left to right (m), or are let go at a height (m); each kind by turns."""

    kinds: Annotated[tuple[Kind, ...], msgspec.Meta(min_length=1, max_length=8)]
    count: Annotated[int, msgspec.Meta(ge=1, le=400)] = 1
    left: Metre
    right: Metre
    height: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 0.0
    spread: Annotated[float, msgspec.Meta(ge=0.0, le=10.0)] = 0.0
    alike: bool = False


class BasketEntry(LevelEntry, frozen=True, kw_only=True):
    """A litter basket: its middle, half its width at the rim, its height, m."""

    x: Metre = 1.55
    half: Annotated[float, msgspec.Meta(ge=0.05, le=3.0)] = 0.4
    height: Annotated[float, msgspec.Meta(ge=0.05, le=3.0)] = 0.62


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the park in view, m."""

    left: Metre = -2.6
    bottom: Metre = -0.36
    right: Metre = 2.8
    top: Metre = 2.6


class LeavesContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. gusts: see `GustEntry`; expected: of readouts."""

    beds: Annotated[tuple[BedEntry, ...], msgspec.Meta(max_length=32)] = ()
    gusts: Gusts = ()
    basket: BasketEntry = BasketEntry()
    view: View = View()
    expected: Expectations = ()


DEFAULT = LeavesContent(
    beds=(BedEntry(kinds=("maple", "oak", "birch", "linden", "ash"), count=60, left=-2.3, right=0.9),)
)
