"""The column beside the pool table. With it the frame is wider, and the table smaller."""

from __future__ import annotations

from game.scenes.billiards import layout
from game.scenes.billiards.beside import NONE
from game.scenes.billiards.layout import metres
from game.scenes.shared.tables.beside.column import Column
from game.scenes.shared.tables.boxes import Box
from game.stage import Frame

WIDTH = 344.0  # design px
COLUMN = Column(
    Box(
        layout.BOARD.top, layout.FRAME.top + metres(4.0),
        layout.FOOT.bottom + metres(16.0), layout.FRAME.top + metres(4.0 + WIDTH),
    ),
    metres(76.0), metres(42.0), metres(8.0),
)  # fmt: skip
WIDE_FRAME = layout.FRAME._replace(top=COLUMN.box.right + metres(10.0))
ROWS = COLUMN.rows


def frame_with(beside: str) -> Frame:
    """The part of the world that is shown."""
    return layout.FRAME if beside == NONE else WIDE_FRAME
