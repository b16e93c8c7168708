"""The help figures: a standing wave with its nodes, and how phases make a focus."""

from __future__ import annotations

import math

from game.scenes.shared.marks import dot, span
from game.ui.canvas.pen import Pen


def draw_standing_wave(pen: Pen) -> None:
    """Pressure amplitude along the axis of two rows, the potential, and where grains sit."""
    low, high, wave = 30.0, 182.0, 76.0

    def amplitude(y: float) -> float:
        return math.sin(2.0 * math.pi * (y - 106.0) / wave)

    for x, words in ((78.0, "pressure"), (206.0, "potential")):
        pen.line(((x, low), (x, high)), "text3", 1.0)
        pen.words(words, x, 16.0, "text2")
    for side in (-1.0, 1.0):
        pen.line([(78.0 + side * 44.0 * amplitude(y), 1.0 * y) for y in range(30, 183)], "chalk", 1.8)
    pen.line(
        [(206.0 + 40.0 * (2.0 * amplitude(y) ** 2 - 1.0), 1.0 * y) for y in range(30, 183)], "violet", 1.8
    )
    for k in (-1, 0, 1):
        y = 106.0 + 0.5 * wave * k
        pen.line(((78.0, y), (206.0, y)), "text3", 1.0, dash=3.0)
        dot(pen, (78.0, y), "yellow", 5.0)
        dot(pen, (166.0, y), "yellow", 5.0)
    span(pen, (136.0, 68.0), (136.0, 106.0), "text1")
    pen.formula(r"\lambda / 2", 152.0, 88.0)


def draw_focus(pen: Pen) -> None:
    """Waves of three transducers that arrive together at a place."""
    focus = (168.0, 66.0)
    for x in (60.0, 110.0, 160.0, 210.0):
        pen.box(x - 12.0, 176.0, 24.0, 14.0, "body")
        far = math.dist((x, 176.0), focus)
        pen.line(((x, 176.0), focus), "text3", 1.0, dash=3.0)
        for part in (0.42, 0.62, 0.82):
            heading = math.degrees(math.atan2(176.0 - focus[1], focus[0] - x))
            pen.arc((x, 176.0), part * far, heading - 14.0, heading + 14.0, "chalk", 1.6)
    dot(pen, focus, "amber", 5.0)
    pen.formula(r"\phi_j = -k \abs{\v{r} - \v{r}_j}", 110.0, 26.0)
