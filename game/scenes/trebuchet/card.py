"""The card and the help figure of the trebuchet."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"trebuchet": CloseUp(shown_s=0.4, zoom=5.0, across=0.1, down=0.83)}


def _machine(pen: Pen, x: float, y: float, k: float) -> tuple[float, float]:
    """Arm, weight and sling about an axle at (x, y), so many times as large; where the stone is."""
    stone = (x + 16.0 * k, y - 50.0 * k)
    for foot in (-17.0, 17.0):
        pen.line(((x + foot * k, y + 34.0 * k), (x, y)), "text3", 4.0 * k)
    pen.line(((x + 4.0 * k, y + 10.0 * k), (x - 12.0 * k, y - 34.0 * k)), "body", 4.0 * k)
    pen.line(((x - 12.0 * k, y - 34.0 * k), stone), "chalk", 1.4)
    pen.box(x - 3.0 * k, y + 12.0 * k, 14.0 * k, 14.0 * k, "text2")
    pen.disc(*stone, 3.5 * k, "amber")
    return stone


def draw_machine(pen: Pen) -> None:
    """The stone on its way to a wall."""
    pen.fill("stage")
    pen.box(0.0, 90.0, 160.0, 4.0, "ghost")
    _machine(pen, 40.0, 56.0, 1.0)
    for row in range(5):
        for k in range(2):
            pen.box(124.0 + 11.0 * k + 3.0 * (row % 2), 82.0 - 8.0 * row, 10.0, 7.0, "body")


def draw_levers(pen: Pen) -> None:
    """Arm and sling as the stone leaves; weight, fall, speed and angle beside them."""
    pen.line(((0.0, 176.0), (296.0, 176.0)), "line2", 1.4)
    x, y = _machine(pen, 110.0, 124.0, 1.5)
    pen.line(((160.0, 92.0), (160.0, 152.0)), "text2", 1.0, dash=3.0)
    pen.formula("h", 172.0, 124.0, "text1")
    pen.formula("M", 116.0, 152.0, "stage")
    pen.formula("m", x - 14.0, y - 14.0, "text1")
    pen.line(((x, y), (x + 96.0, y)), "text2", 1.0, dash=3.0)
    pen.arrow((x, y), (x + 84.0, y - 24.0), "chalk", 2.0)
    pen.formula(r"\v{v}", x + 96.0, y - 24.0, "text1")
    pen.formula(r"\theta", x + 56.0, y - 7.0, "text1")
    pen.words("sling", 72.0, 62.0, "text2", "center")
