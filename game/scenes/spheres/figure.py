"""The help figure: the cone of friction."""

from __future__ import annotations

import math

from game.scenes.shared.marks import ahead, between, dot, right_angle, span
from game.ui.canvas.pen import Pen


def draw_friction_cone(pen: Pen) -> None:
    """The impulse that the second of two spheres gets: within the cone it sticks."""
    friction, along, across = 0.45, 100.0, 26.0  # coefficient; parts of the impulse, px
    normal, contact = 30.0, (116.0, 128.0)
    balls = ((ahead(contact, normal, -64.0), 64.0), (ahead(contact, normal, 150.0), 150.0))
    for center, radius in balls:
        pen.disc(*center, radius, pen.veiled("body", 0.2))
    half = math.degrees(math.atan(friction))
    edges = [ahead(contact, normal + sign * half, 1.24 * along) for sign in (-1.0, 1.0)]
    pen.area((contact, *edges), "amber", 0.82)
    for edge in edges:
        pen.line((contact, edge), "amber", 1.2)
    for center, radius in balls:
        pen.disc(*center, radius, "text1", ring=1.5)
    foot, end = ahead(contact, normal, along), ahead(contact, normal, 1.58 * along)
    tip, border = ahead(foot, normal + 90.0, across), ahead(foot, normal - 90.0, friction * along)
    pen.line((balls[0][0], contact), "text2", 1.3)
    pen.arrow(contact, end, "text1", 1.4)
    span(pen, foot, border, "text1", bar=3.0)
    pen.arrow(contact, foot, "amber", 2.4)
    pen.arrow(foot, tip, "amber", 2.4)
    pen.arrow(contact, tip, "green", 2.4)
    right_angle(pen, foot, normal + 90.0, color="text1")
    pen.arrow(contact, ahead(contact, normal - 90.0, 62.0), "chalk", 2.2)
    dot(pen, balls[0][0], "text1", 2.8)
    dot(pen, contact, "amber", 4.2)
    pen.formula(r"\v{r}_a", *ahead(between(balls[0][0], contact, 0.45), normal + 90.0, 12.0))
    pen.formula("u_t", *ahead(contact, normal - 92.0, 77.0), "chalk")
    pen.formula(r"\v{n}", *ahead(end, normal - 90.0, 12.0))
    pen.formula("j", *ahead(between(contact, foot, 0.66), normal - 90.0, 10.0), "amber")
    pen.formula("j_t", *ahead(between(foot, tip, 0.6), normal, 13.0), "amber")
    pen.formula(r"\mu j", *ahead(between(foot, border, 0.55), normal, 15.0))
