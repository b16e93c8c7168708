"""The card: a wave of dominoes and a ball."""

from __future__ import annotations

import colorsys
import math

import pygame

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a01": CloseUp(shown_s=0.5, zoom=3.2, across=0.13, down=0.36)}

FLOOR, HEIGHT, THICK, PITCH = 82.0, 40.0, 6.0, 15.0
COUNT, FRONT = 10, 4


def draw_dominoes(pen: Pen) -> None:
    """Ten dominoes in the colours of the path, half of them fallen, and the ball that they reach."""
    pen.fill("stage")
    pen.box(0.0, FLOOR, 160.0, 5.0, "ghost")
    angle = math.radians(8.0)
    angles = [0.0] * COUNT
    for k in range(FRONT, -1, -1):
        angles[k] = angle
        lean = (PITCH * math.cos(angle) - THICK) / HEIGHT
        angle += math.asin(min(lean, 1.0))
    for k in range(COUNT):
        x, c, s = 12.0 + PITCH * k, math.cos(angles[k]), math.sin(angles[k])
        r, g, b = colorsys.hsv_to_rgb(0.8 * k / COUNT, 0.6, 0.85)
        own = ((-THICK, 0.0), (0.0, 0.0), (0.0, HEIGHT), (-THICK, HEIGHT))
        pen.area(
            [(x + c * px + s * py, FLOOR + s * px - c * py) for px, py in own],
            pygame.Color(int(255 * r), int(255 * g), int(255 * b)),
        )
    pen.line(((0.0, FLOOR), (160.0, FLOOR)), "line2", 1.0)
