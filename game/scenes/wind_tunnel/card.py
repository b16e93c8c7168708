"""The card: an aerofoil in streaks of smoke."""

from __future__ import annotations

import math

from game.physics.tunnel import shape_named
from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"wind-tunnel": CloseUp(shown_s=6.0, zoom=1.5, across=0.33, down=0.32)}


def draw_tunnel(pen: Pen) -> None:
    """Streak lines that part at a nose and swing behind."""
    pen.fill("stage")
    middle = (64.0, 52.0)
    for k in range(11):
        y = 6.0 + 9.2 * k
        line = []
        for step in range(81):
            x = 2.0 * step
            far = (x - middle[0]) / 30.0
            bulge = 12.0 * math.exp(-far * far) * (1.0 if y < middle[1] else -1.0)
            bulge *= math.exp(-(((y - middle[1]) / 30.0) ** 2))
            swing = 0.0
            if x > middle[0] + 16.0:
                swing = 5.0 * math.exp(-(((y - middle[1]) / 16.0) ** 2)) * math.sin((x - middle[0]) / 7.0)
            line.append((x, y - bulge + swing))
        pen.line(line, "text3" if k % 2 else "chalk", 1.2)
    placed = shape_named("aerofoil").placed(math.radians(14.0), (0.0, 0.0)).tolist()
    corners = [(middle[0] + 50.0 * x, middle[1] - 50.0 * y) for x, y in placed]
    pen.area(corners, "body")
    pen.line([*corners, corners[0]], "text1", 1.5)
    pen.arrow(middle, (middle[0], 18.0), "green", 2.2)
    pen.arrow(middle, (94.0, middle[1]), "vermilion", 2.2)
