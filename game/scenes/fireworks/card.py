"""The card: bursts over a lake."""

from __future__ import annotations

import math
import random

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a09": CloseUp(shown_s=9.0, zoom=1.25, across=0.5, down=0.42)}

BURSTS = ((56.0, 36.0, 27.0, "amber", 110), (112.0, 27.0, 20.0, "chalk", 80), (92.0, 58.0, 13.0, "pink", 46))
SHORE = 86.0


def draw_burst(pen: Pen) -> None:
    """Three bursts, stars on their rays, and their light in the water."""
    pen.fill("stage")
    chance = random.Random(9)
    pen.area(
        [
            (0.0, SHORE),
            (0.0, 76.0),
            (30.0, 70.0),
            (62.0, 78.0),
            (100.0, 71.0),
            (134.0, 77.0),
            (160.0, 72.0),
            (160.0, SHORE),
        ],
        "body",
    )
    for x, y, radius, color, count in BURSTS:
        ink = pen.look.color(color)
        pen.line(((x, SHORE), (x, y + 2.0)), pen.look.color("line2"), 0.8, dash=2.0)
        for _ in range(count):
            height, turn = chance.uniform(-1.0, 1.0), chance.uniform(0.0, math.tau)
            across = math.sqrt(1.0 - height * height) * math.cos(turn)
            for share in (1.0, 0.93, 0.85, 0.75):
                spot = (x + radius * share * across, y - radius * share * height + 2.5 * share * share)
                pen.disc(*spot, 0.9 * share, ink.lerp(pen.look.color("stage"), 1.4 * (1.0 - share)))
    pen.line(((0.0, SHORE), (160.0, SHORE)), "line2", 1.0)
    for x, _, radius, color, _ in BURSTS:
        ink = pen.look.color(color).lerp(pen.look.color("stage"), 0.55)
        for i in range(4):
            wide = radius * (0.55 - 0.1 * i) * chance.uniform(0.7, 1.1)
            pen.line(((x - wide, SHORE + 3.5 + 4.0 * i), (x + wide, SHORE + 3.5 + 4.0 * i)), ink, 1.2)
