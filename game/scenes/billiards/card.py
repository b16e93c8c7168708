"""The card: a cue behind its ball; and the picture of a level, for the list of levels."""

from __future__ import annotations

from typing import Any

import pygame

from game.billiards.table.rack import (
    BALL_RADIUS,
    EIGHT_BALL_ORDER,
    FOOT_SPOT,
    HEAD_SPOT,
    NINE_BALL_ORDER,
    TEN_BALL_ORDER,
)
from game.billiards.table.table import BED_LENGTH, BED_WIDTH
from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM, WOOD_DARK

TO_PEN = 56.0  # lengths of the pen to a metre
BED_LEFT, BED_TOP = 80.0 - 0.5 * TO_PEN * BED_LENGTH, 43.2 - 0.5 * TO_PEN * BED_WIDTH
BALL = 3.2  # a ball is drawn twice as large as it is, to be told from others
HOLE = pygame.Color("#0A0B0C")
ROWS = {"nine-ball": (1, 2, 3, 2, 1), "ten-ball": (1, 2, 3, 4)}  # of a rack; others have a triangle

CLOSE_UPS = {"billiards": CloseUp(shown_s=4.1, zoom=2.2, across=0.7, down=0.48)}


def draw_billiards(pen: Pen) -> None:
    """A cut into the corner: cue, aim, ghost ball, the paths after it."""
    pen.fill(WOOD_DARK)
    pen.box(-80.0, 7.0, 226.0, 90.0, FELT.lerp(pygame.Color("black"), 0.3))
    pen.box(-80.0, 10.0, 223.0, 84.0, FELT)
    for x, y in ((148.0, 10.0), (148.0, 94.0), (70.0, 5.0), (70.0, 99.0)):
        pen.disc(x, y, 8.5, HOLE)
    pen.line(((-60.0, 97.0), (36.0, 62.0)), pygame.Color("#D8AE74"), 2.6)
    pen.line(((36.0, 62.0), (39.0, 60.9)), pygame.Color("#3E8FD0"), 2.6)
    pen.line(((48.0, 57.6), (96.0, 40.0)), FELT_LINE, 1.0)
    pen.line(((104.5, 36.0), (142.0, 14.0)), FELT_COOL, 1.3, dash=3.0)
    pen.line(((96.0, 40.0), (108.0, 66.0), (124.0, 92.0), (100.0, 76.0)), FELT_LINE, 1.0, dash=3.0)
    pen.disc(96.0, 40.0, 6.2, FELT_LINE, ring=1.0)
    pen.ball(48.0, 57.6, 6.2, 0)
    pen.ball(106.6, 33.6, 6.2, 11)
    pen.ball(70.0, 26.0, 6.2, 8)
    pen.ball(24.0, 30.0, 6.2, 2)
    pen.ball(66.0, 80.0, 6.2, 14)


def draw_level(pen: Pen, level: dict[str, Any]) -> None:
    """The table of a level, as its file is read: balls where they lie, racked if none is placed, the goal."""
    content = level.get("content", {})
    pen.fill(WOOD_DARK)
    pen.box(BED_LEFT, BED_TOP, TO_PEN * BED_LENGTH, TO_PEN * BED_WIDTH, FELT)
    middles = [(x, y) for y in (0.0, 0.5 * BED_LENGTH, BED_LENGTH) for x in (0.0, BED_WIDTH)]
    if "pockets" not in level.get("effects", {}).get("off", ()):
        for x, y in middles:
            pen.disc(*_at(x, y), 4.2, HOLE)
    for stars, goal in enumerate((content.get("goal", {}), *content.get("more", ()))):
        for zone in goal.get("zones", ()):
            pen.disc(*_at(zone["x"], zone["y"]), TO_PEN * zone["radius"], FELT_WARM, ring=0.9)
        for pot in goal.get("pots", ()) if not stars else ():
            if pot.get("pocket") is not None:
                pen.disc(*_at(*middles[pot["pocket"]]), 4.8, FELT_WARM, ring=1.3)
    balls = [(ball["number"], *ball["position"]) for ball in content.get("balls", ())]
    for number, x, y in balls or _racked(content.get("game", "eight-ball")):
        pen.ball(*_at(x, y), BALL, number)


def _at(x: float, y: float) -> tuple[float, float]:
    """A place of the table, m, in the pen's frame: the table's x runs down."""
    return BED_LEFT + TO_PEN * y, BED_TOP + TO_PEN * x


def _racked(game: str) -> list[tuple[int, float, float]]:
    """Number and place, m, of the balls before a break, spread as far as they are enlarged."""
    game = game.removeprefix("ghost-")
    order = {"nine-ball": NINE_BALL_ORDER, "ten-ball": TEN_BALL_ORDER}.get(game, EIGHT_BALL_ORDER)
    pitch, numbers = BALL / TO_PEN * 2.0, iter(order)
    placed = [(0, 0.5 * BED_WIDTH, HEAD_SPOT * BED_LENGTH)]
    for row, count in enumerate(ROWS.get(game, (1, 2, 3, 4, 5))):
        for place in range(count):
            x = 0.5 * BED_WIDTH + (place - 0.5 * (count - 1)) * pitch
            placed.append((next(numbers), x, FOOT_SPOT * BED_LENGTH + 0.87 * row * pitch - 2.0 * BALL_RADIUS))
    return placed
