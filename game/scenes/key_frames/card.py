"""The card: boxes on a path of key-frames."""

from __future__ import annotations

import math

import pygame

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen, Point

CLOSE_UPS = {"c01": CloseUp(zoom=1.6, across=0.7, down=0.35)}


def draw_key_frames(pen: Pen) -> None:
    pen.fill("stage")
    path = []
    for i in range(61):
        t = 2.0 * math.pi * i / 60.0
        path.append((80.0 - 58.0 * math.cos(t), 42.0 - 24.0 * math.sin(2.0 * t)))
    pen.line([*path, path[1]], "chalk", 1.8)
    for i, strength in ((4, "line"), (8, "line2"), (12, "ghost")):
        pen.line(_box_on_path(path[i], path[i + 1]), strength, 0.9)
    for i in (0, 20, 30, 40, 52):
        pen.disc(*path[i], 3.0, "stage")
        pen.disc(*path[i], 3.0, "accent", ring=1.3)
    corners = _box_on_path(path[16], path[17])
    pygame.draw.polygon(pen.large, pen.look.color("body"), [pen.at(*corner) for corner in corners])
    pen.line(corners, "text1", 1.6)
    pen.disc(*path[16], 2.4, "amber")
    pen.line(((14.0, 90.0), (146.0, 90.0)), "line2", 1.0)
    for x in (14.0, 50.0, 80.0, 104.0, 132.0):
        pen.disc(x, 90.0, 2.2, "accent")
    pen.line(((57.0, 76.0), (57.0, 90.0)), "amber", 1.4)


def _box_on_path(place: Point, ahead: Point) -> list[Point]:
    """Corners of a box that looks along a path, the first one again at the end."""
    angle = math.atan2(ahead[1] - place[1], ahead[0] - place[0])
    cos, sin = math.cos(angle), math.sin(angle)
    sides = ((-10.0, -6.0), (10.0, -6.0), (10.0, 6.0), (-10.0, 6.0), (-10.0, -6.0))
    return [(place[0] + a * cos - b * sin, place[1] + a * sin + b * cos) for a, b in sides]
