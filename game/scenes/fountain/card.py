"""The card: drops under their envelope."""

from __future__ import annotations

import math
import random

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen, Point

CLOSE_UPS = {"c04": CloseUp(zoom=1.4, down=0.58)}

FALL = 23.2  # half the acceleration that gives the envelope
STONE = (88.0, 42.0)


def draw_fountain(pen: Pen) -> None:
    """Drops on their parabolas, the lighter the slower, under the envelope; a stone in their way."""
    pen.fill("stage")
    pen.line([(x, 18.0 + (x - 80.0) ** 2 / 88.0) for x in range(0, 161, 4)], "line2", 0.8, dash=2.4)
    slow, fast = pen.look.color("text1"), pen.look.color("chalk").lerp(pen.look.color("stage"), 0.25)
    chance = random.Random(4)
    for _ in range(1500):
        aim = math.radians(90.0 + chance.uniform(-17.0, 17.0))
        t, up = chance.uniform(0.05, 3.6), 84.0 * math.sin(aim)
        x, y = 80.0 + 84.0 * math.cos(aim) * t, 94.0 - up * t + FALL * t * t
        if y < 95.0 and (math.dist((x, y), STONE) > 12.5 and not (y < STONE[1] and abs(x - STONE[0]) < 11.0)):
            pen.disc(x, y, 0.8, slow.lerp(fast, min(1.0, abs(up - 2.0 * FALL * t) / 84.0)))
    pen.disc(*STONE, 11.0, "body")
    pen.disc(*STONE, 11.0, "text1", ring=1.2)
    pen.line([_on_circle(STONE, 11.6, turn) for turn in range(40, 145, 8)], "amber", 2.2)
    pen.line(((0.0, 96.0), (160.0, 96.0)), "line2", 1.0)
    pen.box(76.0, 93.0, 8.0, 6.0, "ghost")


def _on_circle(center: Point, radius: float, degrees: float) -> Point:
    turn = math.radians(degrees)
    return center[0] + radius * math.cos(turn), center[1] + radius * math.sin(turn)
