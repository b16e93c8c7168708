"""Measures of the yard in which the cloth hangs, and rows of what flies and sounds."""

from __future__ import annotations

# m: the box of gas; the cloth; hooks; the table at the right with the box of matches on it
HALF, TALL = 1.6, 2.0
WIDTH, HEIGHT, SPAN, TOP = 1.6, 0.9, 1.597, 1.6
TABLE, TABLE_FROM, TABLE_TO = 0.4, 0.98, 1.52
BOX, BOX_HIGH = (1.08, 1.22), 0.045  # m: from, to; how high it lies on the table
DEEP = 0.06  # m: how deep the layer of gas is that the cloth hangs in
ROOM = 293.15  # K
