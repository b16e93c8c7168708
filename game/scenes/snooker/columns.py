"""The column beside the snooker table. With it the frame is wider, and the table smaller."""

from __future__ import annotations

from game.scenes.shared.tables.beside.column import Column
from game.scenes.shared.tables.boxes import Box
from game.scenes.snooker import layout
from game.scenes.snooker.layout import metres
from game.stage import Frame

WIDTH = 344.0  # design px
COLUMN = Column(
    Box(
        layout.BOARD.top, layout.FRAME.top + metres(4.0),
        layout.FOOT.bottom, layout.FRAME.top + metres(4.0 + WIDTH),
    ),
    metres(76.0), metres(42.0), metres(8.0),
)  # fmt: skip
WIDE_FRAME = layout.FRAME._replace(top=COLUMN.box.right + metres(10.0))


def frame_with(column: bool) -> Frame:
    """The part of the world that is shown."""
    return WIDE_FRAME if column else layout.FRAME
