"""What a level of grains in a sound field may say."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-0.1, le=0.1)]
Point = tuple[Metre, Metre]


class LevitationContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level.

    nodes: traps, counted along the vertical from the focus, that a grain sits in at the beginning; with rows
    all around (columns, rows) of the lattice. grains: further ones, at rest at places (m).
    """

    nodes: Annotated[
        tuple[Annotated[int, msgspec.Meta(ge=-20, le=20)], ...], msgspec.Meta(max_length=41)
    ] = ()
    lattice: tuple[Annotated[int, msgspec.Meta(ge=0, le=15)], Annotated[int, msgspec.Meta(ge=0, le=15)]] = (
        0,
        0,
    )
    grains: Annotated[tuple[Point, ...], msgspec.Meta(max_length=256)] = ()
    expected: Expectations = ()


DEFAULT = LevitationContent(nodes=(-2, -1, 0, 1, 2))
