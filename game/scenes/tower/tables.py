"""Rows of the tables of the tower: a part of it, a storey, a puff of dust, a sound."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats

# of a part: body (GONE: it has become others), kind, storey (from 1), bay or column, breadth and height (m,
# 0 for what has other corners), mass kg, speed that contacts and joints have taken from it lately, m/s
BODY, KIND, STOREY, PLACE, WIDE, TALL, MASS, SHOCK = range(8)
PART_WIDTH = 8
SLAB, COLUMN, RUBBLE, SHARD = range(4)  # rubble is of columns, shards are of floors
# of a storey: time at which its first column was cut, time at which its floor was struck (NOT_YET)
CUT, STRUCK = range(2)
STOREY_WIDTH = 2
# of what falls when nothing carries it any more: time s (NOT_YET before), its speed m/s and way m by then,
# downwards
FREE, FREE_SPEED, FREE_WAY = range(3)
# of a puff: place m, velocity m/s, age and life s, radius m
DX, DY, DVX, DVY, AGE, LIFE, SIZE = range(7)
DUST_WIDTH = 7
GONE, NOT_YET = -1.0, -1.0


def none_of(width: int) -> Floats:
    """An empty table."""
    return np.zeros((0, width))
