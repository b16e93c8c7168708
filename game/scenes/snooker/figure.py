"""The help figure: the table, its spots and values, and what snookered means."""

from __future__ import annotations

from game.billiards.table.snooker import BAULK, COLOURS, D_RADIUS, MIDDLE, SPOTS, opening_places, value_of
from game.billiards.table.table import SNOOKER_LENGTH, SNOOKER_WIDTH
from game.ui.canvas.pen import Pen

LEFT, TOP, TO_PEN = 20.0, 26.0, 72.0
RADIUS = 3.4
COLOR = ("yellow", "green", "amber", "chalk", "vermilion", "text1")


def draw_table_of_values(pen: Pen) -> None:
    """The D, the six spots with the values of their colours, the triangle of reds."""

    def at(x: float, y: float) -> tuple[float, float]:
        return LEFT + TO_PEN * y, TOP + TO_PEN * x

    right, bottom = at(SNOOKER_WIDTH, SNOOKER_LENGTH)[0], at(SNOOKER_WIDTH, 0.0)[1]
    pen.line(((LEFT, TOP), (right, TOP), (right, bottom), (LEFT, bottom), (LEFT, TOP)), "text1", 2.0)
    pen.line((at(0.0, BAULK), at(SNOOKER_WIDTH, BAULK)), "text2", 1.2)
    pen.arc(at(MIDDLE, BAULK), TO_PEN * D_RADIUS, 90.0, 270.0, "text2", 1.2)
    for number, place in opening_places().items():
        if number not in COLOURS:
            pen.disc(*at(*place), 1.9, "vermilion")
    for colour, name in zip(COLOURS, COLOR, strict=True):
        x, y = at(*SPOTS[colour])
        pen.disc(x, y, RADIUS, name)
        pen.words(str(value_of(colour)), x - 9.0, y, "text1", "center")
    pen.words("baulk", *at(SNOOKER_WIDTH + 0.16, 0.37), "text2", "center")
    pen.words("reds: 1 each", *at(SNOOKER_WIDTH + 0.16, 2.9), "text2", "center")
