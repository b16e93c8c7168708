"""The card: balls on a path, and the beats below."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import CUE_BALL, FELT, FELT_LINE

CLOSE_UPS = {"p22": CloseUp(shown_s=3.1, zoom=1.3, across=0.5, down=0.55)}


def draw_beat(pen: Pen) -> None:
    pen.fill("stage")
    pen.box(10.0, 8.0, 140.0, 54.0, FELT)
    path = ((24.0, 50.0), (62.0, 24.0), (98.0, 46.0), (132.0, 20.0))
    pen.line(path, FELT_LINE, 1.0, dash=2.5)
    pen.disc(*path[0], 4.0, CUE_BALL)
    for number, place in zip((1, 3, 2), path[1:], strict=True):
        pen.ball(*place, 4.0, number)
    pen.line(((14.0, 76.0), (146.0, 76.0)), "line", 1.2)
    for x in (24.0, 62.0, 98.0, 132.0):
        pen.disc(x, 76.0, 2.6, "amber")
