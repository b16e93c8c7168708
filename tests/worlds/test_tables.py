"""Tables as NamedTuples of arrays: packed for a state, read again, extended."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from game.arrays import Floats, Longs
from game.worlds.tables import NO_FLOATS, NO_LONGS, extended, packed, unpacked


class Row(NamedTuple):
    body: Longs = NO_LONGS
    struck: Floats = NO_FLOATS


def test_an_empty_table_has_its_columns_and_kinds() -> None:
    assert packed(Row()).shape == (0, 2)
    again = unpacked(Row, packed(Row()))
    assert again.body.dtype == np.int64 and again.struck.dtype == np.float64


def test_rows_come_back_as_they_were() -> None:
    table = extended(Row(), [(2**53 - 1, 0.1), (-1, -1.0)])
    again = unpacked(Row, packed(table))
    assert again.body.tolist() == [2**53 - 1, -1] and again.struck.tolist() == [0.1, -1.0]
    again.struck[0] = 5.0
    assert table.struck[0] == 0.1  # a copy


def test_more_rows_stand_at_the_end_in_the_order_of_columns() -> None:
    table = extended(extended(Row(), [(1, 0.5)]), [(2, 0.25)])
    assert packed(table).tolist() == [[1.0, 0.5], [2.0, 0.25]]
    assert extended(table, []) is table
    with pytest.raises(IndexError):
        extended(table, [(3,)])
