"""The card: reds, colours and the D; and the picture of a level, for the list of levels."""

from __future__ import annotations

from typing import Any

import pygame

from game.billiards.table.snooker import BAULK, D_RADIUS, MIDDLE, SPOTS, opening_places
from game.billiards.table.table import SNOOKER_LENGTH, SNOOKER_WIDTH
from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import CUE_BALL, FELT_GREEN, FELT_LINE, SNOOKER_COLORS, WOOD_DARK

TO_PEN = 40.0  # lengths of the pen to a metre
BED_LEFT, BED_TOP = 80.0 - 0.5 * TO_PEN * SNOOKER_LENGTH, 44.0 - 0.5 * TO_PEN * SNOOKER_WIDTH
BALL = 2.3  # a ball is drawn larger than it is
HOLE = pygame.Color("#0A0B0C")

CLOSE_UPS = {"snooker": CloseUp(shown_s=3.2, zoom=1.7, across=0.72, down=0.5)}


def draw_snooker(pen: Pen) -> None:
    """The end of the table with pink, reds and black, and a path to them."""
    pen.fill(WOOD_DARK)
    pen.box(-80.0, 8.0, 228.0, 88.0, FELT_GREEN)
    for y in (8.0, 96.0):
        pen.disc(148.0, y, 9.0, HOLE)
    pen.line(((-20.0, 88.0), (50.0, 58.0)), pygame.Color("#D8AE74"), 2.6)
    pen.line(((60.0, 54.0), (84.0, 44.0)), FELT_LINE, 1.0)
    radius = 5.2
    for row in range(4):
        for place in range(row + 1):
            y = 52.0 + (place - 0.5 * row) * 2.0 * radius
            pen.disc(92.0 + row * 1.75 * radius, y, radius, SNOOKER_COLORS[0])
    pen.disc(80.5, 52.0, radius, SNOOKER_COLORS[5])
    pen.disc(138.0, 52.0, radius, SNOOKER_COLORS[6])
    pen.disc(30.0, 28.0, radius, SNOOKER_COLORS[4])
    pen.disc(56.0, 55.6, radius, CUE_BALL)


def color_of(number: int) -> pygame.Color:
    """A ball in a flat colour."""
    return CUE_BALL if number == 0 else SNOOKER_COLORS[0] if number <= 15 else SNOOKER_COLORS[number - 15]


def draw_level(pen: Pen, level: dict[str, Any]) -> None:
    """The table of a level, as its file is read."""
    content = level.get("content", {})
    pen.fill(WOOD_DARK)
    pen.box(BED_LEFT, BED_TOP, TO_PEN * SNOOKER_LENGTH, TO_PEN * SNOOKER_WIDTH, FELT_GREEN)
    for y in (0.0, 0.5 * SNOOKER_LENGTH, SNOOKER_LENGTH):
        for x in (0.0, SNOOKER_WIDTH):
            pen.disc(*_at(x, y), 3.0, HOLE)
    pen.line((_at(0.0, BAULK), _at(SNOOKER_WIDTH, BAULK)), FELT_LINE, 0.6)
    pen.arc(_at(MIDDLE, BAULK), TO_PEN * D_RADIUS, 90.0, 270.0, FELT_LINE, 0.6)
    balls = {ball["number"]: tuple(ball["position"]) for ball in content.get("balls", ())}
    balls |= {number: SPOTS[number] for number in content.get("spotted", ())}
    six = content.get("game") == "six-red"
    for number, (x, y) in (balls or opening_places(6 if six else 15)).items():
        pen.disc(*_at(x, y), BALL, color_of(number))


def _at(x: float, y: float) -> tuple[float, float]:
    """A place of the table, m, in the pen's frame: the table's x runs down."""
    return BED_LEFT + TO_PEN * y, BED_TOP + TO_PEN * x
