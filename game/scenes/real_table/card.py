"""The card: a track of dots, and a computed path that leaves it."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import CUE_BALL, FELT, FELT_LINE, FELT_WARM, WOOD_DARK

CLOSE_UPS = {"real-table": CloseUp(shown_s=4.0, zoom=1.6, across=0.24, down=0.5)}
CORNERS = ((34.0, 74.0), (92.0, 21.0), (138.0, 58.0), (106.0, 84.0), (62.0, 50.0))


def draw_real_table(pen: Pen) -> None:
    pen.fill("stage")
    pen.box(10.0, 10.0, 140.0, 84.0, WOOD_DARK)
    pen.box(15.0, 15.0, 130.0, 74.0, FELT)
    for k in range(len(CORNERS) - 1):
        (x0, y0), (x1, y1) = CORNERS[k], CORNERS[k + 1]
        for dot in range(9):
            pen.disc(x0 + (x1 - x0) * dot / 9.0, y0 + (y1 - y0) * dot / 9.0, 1.3, FELT_WARM)
    off = [(x + 0.8 * k * k, y + 0.5 * k * k) for k, (x, y) in enumerate(CORNERS)]
    pen.line(off, FELT_LINE, 1.1)
    pen.disc(*CORNERS[0], 5.0, CUE_BALL)
