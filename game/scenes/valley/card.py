"""The card and the help figure of the valley."""

from __future__ import annotations

import numpy as np

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"valley": CloseUp(shown_s=0.6, zoom=1.6, across=0.45, down=0.5)}


def draw_dam(pen: Pen) -> None:
    """Water behind a broken dam, and a rocket that comes."""
    pen.fill("stage")
    pen.box(0.0, 40.0, 64.0, 48.0, "chalk")
    for k in range(9):
        pen.box(64.0 + 9.0 * k, 58.0 + 3.2 * k, 9.0, 30.0 - 3.2 * k, "chalk")
    for k in range(4):
        pen.box(64.0, 34.0 + 6.0 * k, 7.0 + 2.0 * k, 5.4, "body")
    pen.box(64.0, 76.0, 26.0, 12.0, "body")
    for x, y in ((96.0, 62.0), (110.0, 72.0), (88.0, 66.0)):
        pen.box(x, y, 7.0, 6.0, "text2")
    pen.box(0.0, 88.0, 160.0, 4.0, "ghost")
    pen.line(((148.0, 16.0), (112.0, 38.0)), "text1", 3.0)
    pen.line(((159.0, 9.0), (148.0, 16.0)), "amber", 3.0)


def draw_theory(pen: Pen) -> None:
    """Ritter's surface, and where the film has the front at the same moment."""
    pen.line(((0.0, 170.0), (296.0, 170.0)), "line2", 1.4)
    share = np.linspace(-1.0, 2.0, 40)
    depth = 110.0 * ((2.0 - share) / 3.0) ** 2
    surface = [(0.0, 60.0), *zip((120.0 + 70.0 * share).tolist(), (170.0 - depth).tolist(), strict=True)]
    pen.line(surface, "chalk", 2.0)
    pen.line(((120.0, 40.0), (120.0, 170.0)), "text2", 1.2, dash=4.0)
    pen.line(((190.0, 140.0), (190.0, 170.0)), "amber", 2.0, dash=4.0)
    pen.words("filmed", 190.0, 132.0, "text2", "center")
    pen.words("Ritter", 262.0, 152.0, "text2", "center")
    pen.formula("h", 14.0, 112.0, "text1")
    pen.formula(r"2 c t", 196.0, 186.0, "text1")
