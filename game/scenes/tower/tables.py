"""Tables of the tower: its parts and its storeys, row by row."""

from __future__ import annotations

from typing import NamedTuple

from game.arrays import Floats, Longs
from game.worlds.tables import NO_FLOATS, NO_LONGS

SLAB, COLUMN, RUBBLE, SHARD = range(4)  # rubble is of columns, shards are of floors
GONE, NOT_YET = -1, -1.0


class PartTable(NamedTuple):
    """body: GONE once it has become others; storey: from 1; place: of its bay or column; wide, tall: m;
    mass: kg; shock: m/s that contacts and joints have taken from its speed lately.
    """

    body: Longs = NO_LONGS
    kind: Longs = NO_LONGS
    storey: Longs = NO_LONGS
    place: Longs = NO_LONGS
    wide: Floats = NO_FLOATS
    tall: Floats = NO_FLOATS
    mass: Floats = NO_FLOATS
    shock: Floats = NO_FLOATS


class StoreyTable(NamedTuple):
    """s at which a storey's first column was cut, and at which its floor was struck; NOT_YET."""

    cut: Floats = NO_FLOATS
    struck: Floats = NO_FLOATS
