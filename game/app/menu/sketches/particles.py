"""Drawings of a fountain, a hanging cloth and a jelly."""

from __future__ import annotations

import math
import random
from itertools import pairwise

from game.ui.canvas.pen import Pen, Point

FALL = 23.2  # half the acceleration that gives the envelope
STONE = (88.0, 42.0)
CLOTH = (15, 8)  # cells across and down
JELLY = (9, 5)


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


def draw_cloth(pen: Pen) -> None:
    """A cloth held at two corners, moved by the wind."""
    pen.fill("stage")
    across, down = CLOTH
    knots = [[_knot(i / across, j / down) for i in range(across + 1)] for j in range(down + 1)]
    for row in knots:
        pen.line(row, "text1", 0.7)
    for column in zip(*knots, strict=True):
        pen.line(column, "text1", 0.7)
    for row in knots:
        for knot in row:
            pen.disc(*knot, 1.1, "text1")
    for x, y in (knots[0][0], knots[0][-1]):
        pen.box(x - 3.2, y - 3.2, 6.4, 6.4, "amber")


def _knot(u: float, v: float) -> Point:
    """Where a knot hangs; u across, v down, 0 to 1."""
    sag = 4.0 * u * (1.0 - u)
    wave = 3.0 * math.sin(7.0 * u + 3.0 * v) * v
    return 22.0 + 116.0 * u + 5.0 * v * (0.5 - u) + wave, 16.0 + 60.0 * v + 17.0 * sag * (0.55 + 0.45 * v)


def draw_jelly(pen: Pen) -> None:
    """A block of springs that a ball has just met: pressed below it, bulged beside."""
    pen.fill("stage")
    across, down = JELLY
    knots = [[_pressed(i / across, j / down) for i in range(across + 1)] for j in range(down + 1)]
    for above, below in pairwise(knots):
        for i in range(across):
            pen.line((above[i], below[i + 1]), "ghost", 0.6)
            pen.line((above[i + 1], below[i]), "ghost", 0.6)
    for j, row in enumerate(knots):
        for i, (a, b) in enumerate(pairwise(row)):
            pen.line((a, b), "vermilion" if j < 2 and 2 < i < 6 else "text1", 0.9)
    for column in zip(*knots, strict=True):
        for j, (a, b) in enumerate(pairwise(column)):
            pen.line((a, b), "chalk" if j < 2 and 60.0 < a[0] < 100.0 else "text1", 0.9)
    for row in knots:
        for knot in row:
            pen.disc(*knot, 1.5, "text1")
    for y, tone in ((10.0, "line"), (18.0, "line2")):
        pen.disc(80.0, y, 9.0, tone, ring=0.9)
    pen.disc(80.0, 32.0, 9.5, "body")
    pen.disc(80.0, 32.0, 9.5, "amber", ring=1.6)
    pen.line(((0.0, 95.0), (160.0, 95.0)), "line2", 1.0)


def _pressed(u: float, v: float) -> Point:
    """Where a knot of the pressed block is; u across, v down, 0 to 1."""
    dent = math.exp(-(((u - 0.5) / 0.17) ** 2))
    bulge = 9.0 * math.sin(math.pi * (0.15 + 0.85 * v)) * (2.0 * u - 1.0)
    return 36.0 + 88.0 * u + bulge, 36.0 + 58.0 * v + 9.0 * dent * (1.0 - v) - 3.0 * (1.0 - dent) * (1.0 - v)
