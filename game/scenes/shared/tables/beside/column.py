"""The column beside a table: where its rows lie, in the world's metres.

The picture is turned: x runs down and y to the right.
"""

from __future__ import annotations

from typing import NamedTuple

from game.scenes.shared.tables.boxes import Box


class Column(NamedTuple):
    """box: all of it. head: of the heading; pitch: from row to row; edge: beside and between rows, m."""

    box: Box
    head: float
    pitch: float
    edge: float

    @property
    def rows(self) -> int:
        """So many have space."""
        return int((self.box.bottom - self.box.top - self.head - 1.25 * self.edge) / self.pitch)

    def row_box(self, row: int) -> Box:
        """The box of a row, counted from above."""
        top = self.box.top + self.head + row * self.pitch
        return Box(
            top, self.box.left + self.edge, top + self.pitch - 0.5 * self.edge, self.box.right - self.edge
        )

    def row_at(self, x: float, y: float) -> int:
        """The row at a point, -1 for none."""
        return next((row for row in range(self.rows) if self.row_box(row).holds(x, y)), -1)
