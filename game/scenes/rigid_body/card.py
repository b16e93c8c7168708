"""The card: a hammer of spheres."""

from __future__ import annotations

import pygame

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"c12": CloseUp(zoom=1.7, across=0.25)}


def draw_rigid_body(pen: Pen) -> None:
    """A hammer in its box, and the outline of where it will be when it has turned over."""
    pen.fill("stage")
    for left, middle, right in ((26, 14, 26), (92, 84, 92)):
        pen.line(((18, left), (106, middle), (146, right)), "line2", 0.8)
    for x, top, low in ((18, 26, 92), (106, 14, 84), (146, 26, 92)):
        pen.line(((x, top), (x, low)), "line2", 0.8)
    for k in range(6):
        pen.disc(102.0 + 6.4 * k, 53.0 + 3.4 * k, 5.2, "ghost", ring=0.7)
    for k in range(6):
        _ball_of_body(pen, 40.0 + 6.6 * k, 69.0 - 3.4 * k, 5.4, pygame.Color("#E9E0CF"))
    for k in (-2, 2, -1, 1, 0):
        _ball_of_body(pen, 84.0 + 4.2 * k, 47.0 + 10.8 * k, 11.5, pygame.Color("#5FBAF9"))
    pen.arrow((84.0, 47.0), (132.0, 22.0), "pink")


def _ball_of_body(pen: Pen, x: float, y: float, radius: float, color: pygame.Color) -> None:
    """A sphere: shade, colour, light."""
    pen.disc(x, y, radius, color.lerp(pygame.Color("black"), 0.45))
    pen.disc(x - 0.06 * radius, y - 0.08 * radius, 0.9 * radius, color)
    pen.disc(x - 0.3 * radius, y - 0.36 * radius, 0.28 * radius, color.lerp(pygame.Color("white"), 0.6))
