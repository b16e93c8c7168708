"""The card: three balls and a way round the table; and the picture of a level, for the list of levels."""

from __future__ import annotations

from typing import Any

from game.billiards.table.carom import starting_position
from game.billiards.table.table import CAROM_LENGTH, CAROM_WIDTH
from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import CAROM_COLORS, FELT_BLUE, FELT_LINE, FELT_WARM, WOOD_DARK

TO_PEN = 50.0  # lengths of the pen to a metre
BED_LEFT, BED_TOP = 80.0 - 0.5 * TO_PEN * CAROM_LENGTH, 44.0 - 0.5 * TO_PEN * CAROM_WIDTH
BALL = 3.4  # a ball is drawn twice as large as it is

CLOSE_UPS = {"carom": CloseUp(shown_s=3.0, zoom=1.5, across=0.35, down=0.5)}


def draw_carom(pen: Pen) -> None:
    """A way over three cushions."""
    pen.fill(WOOD_DARK)
    pen.box(7.0, 9.0, 146.0, 86.0, FELT_BLUE)
    for k in range(1, 8):
        for y in (5.0, 99.0):
            pen.disc(7.0 + 146.0 * k / 8.0, y, 1.1, FELT_LINE)
    pen.line(
        ((26.0, 78.0), (78.0, 44.0), (112.0, 13.0), (149.0, 46.0), (116.0, 91.0), (60.0, 63.0)),
        FELT_WARM,
        1.4,
    )
    for (x, y), color in zip(((26.0, 78.0), (54.0, 60.0), (84.0, 38.0)), CAROM_COLORS, strict=True):
        pen.disc(x, y, 5.4, color)


def draw_level(pen: Pen, level: dict[str, Any]) -> None:
    """The table of a level, as its file is read."""
    content = level.get("content", {})
    pen.fill(WOOD_DARK)
    pen.box(BED_LEFT, BED_TOP, TO_PEN * CAROM_LENGTH, TO_PEN * CAROM_WIDTH, FELT_BLUE)
    start = starting_position(0).tolist()
    for name, place, color in zip(("white", "yellow", "red"), start, CAROM_COLORS, strict=True):
        x, y = content.get(name, place)
        pen.disc(BED_LEFT + TO_PEN * y, BED_TOP + TO_PEN * x, BALL, color)
