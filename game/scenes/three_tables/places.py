"""Where the three tables are in the picture's world: one in each quarter, the last is for the chart."""

from __future__ import annotations

WIDTH, LENGTH = 1.27, 2.54  # m, of the bed
ACROSS, ALONG = 1.68, 2.98  # m from one table to the next
LECTURE, STEPPED, EXACT = range(3)
ORIGINS = ((0.0, 0.0), (0.0, ALONG), (ACROSS, 0.0))  # lecture, stepped, exact


def table_at(x: float, y: float) -> int:
    """Which table a point of the world belongs to; the chart's quarter counts as the exact one's."""
    if x < ACROSS - 0.26:
        return LECTURE if y < ALONG - 0.24 else STEPPED
    return EXACT
