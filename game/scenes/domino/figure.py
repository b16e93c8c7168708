"""The help figure: a train of dominoes that lean on each other."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen

FLOOR, HEIGHT, THICK, GAP = 168.0, 112.0, 18.0, 40.0  # design px


def draw_leaning(pen: Pen) -> None:
    """The front at 14 degrees, all behind it as the equation has them, one still upright."""
    pitch = GAP + THICK
    angles, edges = [math.radians(14.0)], [212.0]
    for _ in range(3):
        ahead = angles[-1]
        angles.append(ahead + math.asin((pitch * math.cos(ahead) - THICK) / HEIGHT))
        edges.append(edges[-1] - pitch)
    pen.line(((0.0, FLOOR), (296.0, FLOOR)), "line2", 1.4)
    for k in range(3, -1, -1):
        pen.area(_corners(edges[k], angles[k]), "amber" if k == 0 else "ghost")
    pen.area(_corners(edges[0] + pitch, 0.0), "body")
    foot, top = _corners(edges[1], angles[1])[1:3]
    pen.disc(*top, 3.0, "vermilion")
    pen.disc(*foot, 3.0, "text1")
    pen.line(((foot[0], foot[1]), (foot[0], foot[1] - 84.0)), "text2", 1.0, dash=3.0)
    pen.formula(r"\theta", foot[0] + 15.0, foot[1] - 80.0, "text1")
    pen.formula("d", edges[0] + pitch - 0.5 * THICK, FLOOR + 14.0, "text1")
    pen.formula("s", edges[0] + 0.5 * GAP, FLOOR + 14.0, "text1")
    pen.formula("h", edges[0] + pitch + 14.0, FLOOR - 0.5 * HEIGHT, "text1")
    pen.words("struck", edges[0] + pitch - 40.0, FLOOR - HEIGHT - 14.0, "text2", "center")


def _corners(edge: float, angle: float) -> list[tuple[float, float]]:
    """Corners of a domino that turns about its lower right edge: both feet, right and left top."""
    c, s = math.cos(angle), math.sin(angle)
    own = ((-THICK, 0.0), (0.0, 0.0), (0.0, HEIGHT), (-THICK, HEIGHT))
    return [(edge + c * x + s * y, FLOOR + s * x - c * y) for x, y in own]
