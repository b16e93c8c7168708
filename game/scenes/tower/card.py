"""The card: a tower whose upper floors have begun to fall."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a08": CloseUp(shown_s=2.2, zoom=1.6, across=0.5, down=0.55)}

PUFFS = ((44.0, 50.0, 9.0), (37.0, 46.0, 6.0), (116.0, 50.0, 9.0), (123.0, 45.0, 6.0), (50.0, 55.0, 6.0))


def draw_tower(pen: Pen) -> None:
    """Floors at even heights below, close upon each other above, dust at both sides between them."""
    pen.fill("stage")
    pen.box(0.0, 88.0, 160.0, 12.0, "ghost")
    heights = [76.0, 64.0, 52.0, 47.0, 42.5, 38.0]
    for x, y, r in (
        (44.0, 50.0, 9.0),
        (37.0, 46.0, 6.0),
        (116.0, 50.0, 9.0),
        (123.0, 45.0, 6.0),
        (50.0, 55.0, 6.0),
    ):
        pen.disc(x, y, r, "line2")
    for k in range(3):
        for x in (58.0, 73.0, 87.0, 102.0):
            pen.box(x - 1.5, heights[k], 3.0, 12.0, "text2")
    for k, y in enumerate(heights):
        pen.box(54.0, y, 52.0, 3.0, "text1" if k < 3 else "amber")
