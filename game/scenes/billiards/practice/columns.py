"""The column beside the table: what it can show, and where its rows lie, in the world's metres.

The picture is turned: x runs down and y to the right. With the column the frame is wider, and the table
smaller.
"""

from __future__ import annotations

from game.scenes.billiards import layout
from game.scenes.billiards.beside import NONE
from game.scenes.billiards.layout import metres
from game.scenes.shared.tables.boxes import Box
from game.stage import Frame

WIDTH = 344.0  # design px
COLUMN = Box(
    layout.BOARD.top, layout.FRAME.top + metres(4.0),
    layout.FOOT.bottom + metres(16.0), layout.FRAME.top + metres(4.0 + WIDTH),
)  # fmt: skip
WIDE_FRAME = layout.FRAME._replace(top=COLUMN.right + metres(10.0))
HEAD, PITCH = metres(76.0), metres(42.0)
ROWS = int((COLUMN.bottom - COLUMN.top - HEAD - metres(10.0)) / PITCH)


def frame_with(beside: str) -> Frame:
    """The part of the world that is shown."""
    return layout.FRAME if beside == NONE else WIDE_FRAME


def row_box(row: int) -> Box:
    """The box of a row, counted from above."""
    top = COLUMN.top + HEAD + row * PITCH
    return Box(top, COLUMN.left + metres(8.0), top + PITCH - metres(4.0), COLUMN.right - metres(8.0))


def row_at(x: float, y: float) -> int:
    """The row at a point, -1 for none."""
    return next((row for row in range(ROWS) if row_box(row).holds(x, y)), -1)
