"""The help figure: a front that takes floor after floor with it."""

from __future__ import annotations

from game.ui.canvas.pen import Pen

# left edge, heights of floors, how many of them fall
TOWERS = ((36.0, (170.0, 130.0, 90.0, 62.0, 48.0), 2), (160.0, (170.0, 130.0, 84.0, 72.0, 60.0), 3))


def draw_front(pen: Pen) -> None:
    """Before and after a floor is struck: mass M at v, floor m at rest, then both together."""
    for x, heights, moving in TOWERS:
        pen.line(((x - 20.0, 190.0), (x + 102.0, 190.0)), "line2", 1.4)
        for k, y in enumerate(heights):
            falls = k >= 5 - moving
            pen.box(x, y, 82.0, 8.0, "amber" if falls else "body")
            if not falls:
                for place in (x + 3.0, x + 38.0, x + 73.0):
                    pen.box(place, y + 8.0, 6.0, 32.0 if k else 12.0, "ghost")
    pen.arrow((77.0, 24.0), (77.0, 44.0), "vermilion")
    pen.arrow((201.0, 38.0), (201.0, 56.0), "vermilion")
    pen.formula("M", 130.0, 56.0, "text1")
    pen.formula("m", 130.0, 92.0, "text1")
    pen.formula("M + m", 269.0, 72.0, "text1")
