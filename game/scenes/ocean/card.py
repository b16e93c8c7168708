"""The card and the help figure of the ocean."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a15": CloseUp(shown_s=4.0, zoom=1.7, across=0.5, down=0.5)}


def _boat(pen: Pen, x: float, y: float, k: float, lean: float = 0.0) -> None:
    """Hull and sail over (x, y), so many times as large."""

    def at(u: float, v: float) -> tuple[float, float]:
        return x + k * (u + lean * v), y - k * v

    pen.area((at(-26, 0), at(24, 0), at(30, 9), at(-30, 8)), "body")
    pen.line((at(-30, 8), at(30, 9)), "text2", 1.4)
    pen.area((at(12, 12), at(12, 44), at(-14, 62), at(-27, 14)), "vermilion")
    pen.line((at(13, 8), at(13, 58)), "text2", 1.8)


def _waves(pen: Pen, left: float, right: float, y: float, high: float, long: float, ink: str) -> None:
    count = 48
    points = [
        (left + (right - left) * k / count, y - high * math.sin((right - left) * k / count * math.tau / long))
        for k in range(count + 1)
    ]
    pen.line(points, ink, 2.0)


def draw_boat(pen: Pen) -> None:
    """A boat on waves."""
    pen.fill("stage")
    _boat(pen, 78.0, 78.0, 0.95, 0.08)
    for k, (y, high, long) in enumerate(((76.0, 3.0, 34.0), (84.0, 4.0, 52.0), (94.0, 5.0, 80.0))):
        _waves(pen, 0.0, 160.0, y, high, long, ("ghost", "body", "chalk")[k])


def draw_arms(pen: Pen) -> None:
    """The boat from astern: its weight, the water's lift, and the arm between them."""
    pen.line(((10.0, 130.0), (286.0, 130.0)), "chalk", 1.6)
    lean, x, y = 0.42, 140.0, 122.0

    def at(u: float, v: float) -> tuple[float, float]:
        c, s = math.cos(lean), math.sin(lean)
        return x + u * c + v * s, y - v * c + u * s

    hull = [(-52, 26), (52, 26), (50, 4), (36, -20), (8, -34), (-8, -34), (-36, -20), (-50, 4)]
    pen.area([at(*one) for one in hull], "body")
    pen.line((at(0.0, 26.0), at(0.0, 96.0)), "text2", 2.0)
    pen.line((at(0.0, -34.0), at(0.0, -56.0)), "text2", 5.0)
    middle, lift = at(0.0, -6.0), (x + 25.0, 138.0)
    pen.disc(*middle, 4.0, "amber")
    pen.arrow(middle, (middle[0], middle[1] + 44.0), "amber", 2.0)
    pen.disc(*lift, 4.0, "green")
    pen.arrow(lift, (lift[0], lift[1] - 50.0), "green", 2.0)
    pen.line((middle, (lift[0], middle[1])), "text1", 1.2, dash=3.0)
    pen.formula("G", middle[0] - 16.0, middle[1], "amber")
    pen.formula("B", lift[0] + 16.0, lift[1] + 4.0, "green")
    pen.words("arm", 0.5 * (middle[0] + lift[0]), middle[1] - 12.0, "text1", "center")
    pen.arrow((30.0, 50.0), (86.0, 50.0), "chalk", 2.0)
    pen.words("wind", 58.0, 36.0, "text2", "center")
