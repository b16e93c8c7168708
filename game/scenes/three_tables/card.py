"""The card: one stroke on three tables."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import CUE_BALL, FELT, FELT_WARM, WOOD_DARK

CLOSE_UPS = {"three-tables": CloseUp(shown_s=5.0, zoom=1.5, across=0.55, down=0.58)}


def draw_three_tables(pen: Pen) -> None:
    pen.fill("stage")
    for left, top in ((10.0, 10.0), (84.0, 10.0), (47.0, 56.0)):
        pen.box(left, top, 66.0, 38.0, WOOD_DARK)
        pen.box(left + 3.0, top + 3.0, 60.0, 32.0, FELT)
        pen.line(
            ((left + 12, top + 27), (left + 50, top + 14), (left + 40, top + 3)), FELT_WARM, 0.9, dash=2.0
        )
        pen.disc(left + 12, top + 27, 2.4, CUE_BALL)
