"""The card: a plate that flutters and one that tumbles, by flashes."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"falling-plates": CloseUp(shown_s=6.0, zoom=1.0, across=0.4, down=0.5)}


def draw_fall(pen: Pen) -> None:
    """Poses along two ways."""
    pen.fill("stage")
    for k in range(22):
        t = k / 21.0
        swing = math.sin(t * 9.5)
        blade(
            pen, 44.0 + 24.0 * swing, 8.0 + 84.0 * t - 5.0 * abs(swing), 0.9 * math.cos(t * 9.5), "chalk", t
        )
        blade(pen, 92.0 + 54.0 * t, 10.0 + 80.0 * t, 13.0 * t, "amber", t)


def blade(pen: Pen, x: float, y: float, angle: float, color: str, strength: float) -> None:
    """One pose, the later the stronger."""
    ink = pen.look.color("stage").lerp(pen.look.color(color), 0.25 + 0.75 * strength)
    dx, dy = 10.0 * math.cos(angle), -10.0 * math.sin(angle)
    pen.line(((x - dx, y - dy), (x + dx, y + dy)), ink, 2.2)
