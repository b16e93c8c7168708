"""Tables of things (dominoes, balls, sparks) as NamedTuples of arrays of one length, read by name.

    class Row(NamedTuple):
        body: Longs = NO_LONGS
        struck: Floats = NO_FLOATS

The defaults are the empty table, and say of what kind each column is. A state holds a table as one array
(n, columns) of float64: see `packed` and `unpacked`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, TypeVar

import numpy as np

from game.arrays import Floats, Longs

NO_LONGS: Longs = np.zeros(0, dtype=np.int64)
NO_FLOATS: Floats = np.zeros(0)
Table = TypeVar("Table", bound=tuple[Any, ...])


def packed(table: tuple[Any, ...]) -> Floats:
    """A table's rows (n, columns). Whole numbers stay exact up to 2**53."""
    rows = np.empty((len(table[0]), len(table)))
    for k, column in enumerate(table):  # quicker than to stack them, in each step
        rows[:, k] = column
    return rows


def unpacked(kind: type[Table], rows: Floats) -> Table:
    """The table of a kind whose rows (n, columns) `packed` gave; a copy."""
    defaults = kind()
    return kind(*(rows[:, k].astype(column.dtype) for k, column in enumerate(defaults)))


def extended(table: Table, rows: Iterable[tuple[float, ...]]) -> Table:
    """A table with more rows at its end, each in the order of the columns."""
    more = list(rows)
    if not more:
        return table
    added = unpacked(type(table), np.array(more, dtype=np.float64))
    return type(table)(*(np.concatenate(pair) for pair in zip(table, added, strict=True)))
