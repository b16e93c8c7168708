"""The help figure: where the heat of a log goes, and how an ember cools."""

from __future__ import annotations

import pygame

from game.physics.heat import cooled
from game.ui.canvas.pen import Pen

LEFT, RIGHT, LOW, HIGH = 40.0, 276.0, 168.0, 34.0
SECONDS, HOT, ROOM, RATE = 120.0, 1100.0, 300.0, 2e-11


def draw_ember(pen: Pen) -> None:
    """Temperature of an ember over two minutes, by T⁴, and by cooling in proportion from the same start."""
    pen.line(((LEFT, HIGH - 8.0), (LEFT, LOW), (RIGHT, LOW)), "text3", 1.2)

    def place(seconds: float, kelvin: float) -> tuple[float, float]:
        return (
            LEFT + (RIGHT - LEFT) * seconds / SECONDS,
            LOW - (LOW - HIGH) * (kelvin - ROOM) / (HOT - ROOM),
        )

    times = [SECONDS * k / 60.0 for k in range(61)]
    by_law = [cooled(HOT, ROOM, RATE, time) for time in times]
    first = RATE * (HOT**4 - ROOM**4) / (HOT - ROOM)
    linear = [ROOM + (HOT - ROOM) * 2.718281828 ** (-first * time) for time in times]
    pen.line([place(t, k) for t, k in zip(times, linear, strict=True)], "text3", 1.4, dash=4.0)
    pen.line([place(t, k) for t, k in zip(times, by_law, strict=True)], "vermilion", 2.4)
    for time, kelvin in list(zip(times, by_law, strict=True))[::12]:
        share = (kelvin - ROOM) / (HOT - ROOM)
        x, y = place(time, kelvin)
        pen.disc(x, y, 5.0, pygame.Color(255, int(40 + 180 * share), int(20 + 60 * share)))
    pen.words("1100 K", LEFT + 8.0, HIGH - 10.0, "text2", "left")
    pen.words("300 K", LEFT + 8.0, LOW - 10.0, "text2", "left")
    pen.words("in proportion", 196.0, LOW - 16.0, "text3", "left")
    pen.formula(r"\dot{T} = -b (T^4 - T_a^4)", 196.0, 70.0)
    pen.words("2 minutes", RIGHT, LOW + 14.0, "text3", "right")
