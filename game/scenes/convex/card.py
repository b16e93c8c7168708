"""The cards: a walk through Voronoi regions (C10), simplexes (C11)."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {
    "c10": CloseUp(zoom=1.2),
    "c11": CloseUp(level="crystals"),
}


def draw_voronoi_walk(pen: Pen) -> None:
    """Two polygons, a region of each, and the line between their closest features."""
    pen.fill("stage")
    a = ((22.0, 34.0), (46.0, 26.0), (64.0, 44.0), (60.0, 70.0), (34.0, 80.0), (16.0, 60.0))
    b = ((112.0, 20.0), (140.0, 30.0), (146.0, 58.0), (122.0, 78.0), (98.0, 62.0))
    for tail, tip in (
        ((64.0, 44.0), (160.0, -52.0)), ((64.0, 44.0), (170.0, 60.3)), ((60.0, 70.0), (180.0, 88.5)),
        ((60.0, 70.0), (84.0, 132.0)), ((98.0, 62.0), (-22.0, 22.0)), ((98.0, 62.0), (62.0, 116.0)),
        ((112.0, 20.0), (-8.0, -20.0)), ((122.0, 78.0), (84.0, 135.0)),
    ):  # fmt: skip
        pen.line((tail, tip), "line2", 0.7)
    for corners, color in ((a, "text1"), (b, "chalk")):
        pen.line((*corners, corners[0], corners[1]), color, 1.6)
    pen.line(((64.0, 44.0), (60.0, 70.0)), "green", 3.0)
    pen.line(((61.9, 57.0), (98.0, 62.0)), "amber", 1.5)
    pen.disc(61.9, 57.0, 2.8, "amber")
    pen.disc(98.0, 62.0, 2.8, "amber")


def draw_simplexes(pen: Pen) -> None:
    """A Minkowski difference, a few simplexes, and the path from the origin."""
    pen.fill("stage")
    hull = (
        (30.0, 30.0),
        (58.0, 14.0),
        (92.0, 22.0),
        (112.0, 48.0),
        (104.0, 76.0),
        (72.0, 92.0),
        (38.0, 82.0),
    )
    pen.line((*hull, hull[0], hull[1]), "violet", 1.6)
    for corner in hull:
        pen.disc(*corner, 2.0, "violet")
    pen.line(((58.0, 14.0), (104.0, 76.0)), "line2", 1.2)
    pen.line(((92.0, 22.0), (104.0, 76.0)), "ghost", 1.2)
    pen.line(((112.0, 48.0), (104.0, 76.0)), "amber", 2.6)
    for corner in ((112.0, 48.0), (104.0, 76.0)):
        pen.disc(*corner, 3.2, "amber")
    pen.line(((132.0, 70.0), (146.0, 70.0)), "text1", 1.4)
    pen.line(((139.0, 63.0), (139.0, 77.0)), "text1", 1.4)
    pen.arrow((139.0, 70.0), (110.2, 61.8), "green")
