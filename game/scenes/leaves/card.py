"""The card: leaves over a basket."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a18": CloseUp(shown_s=8.0, zoom=1.3, across=0.6, down=0.45)}


def draw_leaves(pen: Pen) -> None:
    """Five leaves come down a way, a basket below."""
    pen.fill("stage")
    pen.box(0.0, 88.0, 160.0, 16.0, "body")
    pen.area([(98.0, 60.0), (142.0, 60.0), (136.0, 90.0), (104.0, 90.0)], "line2")
    for k in range(7):
        pen.line(((100.0 + 6.6 * k, 60.0), (105.0 + 5.0 * k, 90.0)), "text3", 1.2)
    for x, y, turn, color in (
        (24.0, 70.0, 0.4, "amber"), (46.0, 38.0, 1.2, "vermilion"), (76.0, 22.0, 2.2, "yellow"),
        (104.0, 26.0, 0.2, "amber"), (122.0, 46.0, 2.7, "vermilion"),
    ):  # fmt: skip
        c, s = math.cos(turn), math.sin(turn)
        shape = [
            (
                x + 10.0 * c * math.cos(t) - 5.0 * s * math.sin(t),
                y + 10.0 * s * math.cos(t) + 5.0 * c * math.sin(t),
            )
            for t in [math.tau * i / 20.0 for i in range(20)]
        ]
        pen.area(shape, color)
        pen.line(((x - 13.0 * c, y - 13.0 * s), (x + 9.0 * c, y + 9.0 * s)), "stage", 1.0)
