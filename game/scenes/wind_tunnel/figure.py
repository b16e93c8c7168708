"""The help figures: the wind past a shape with its forces, and the box whose momentum is booked."""

from __future__ import annotations

import math

from game.physics.tunnel import shape_named
from game.scenes.shared.marks import dot
from game.ui.canvas.pen import Pen


def _shape(pen: Pen, name: str, at: tuple[float, float], size: float, attack: float) -> None:
    placed = shape_named(name).placed(attack, (0.0, 0.0)).tolist()
    corners = [(at[0] + size * x, at[1] - size * y) for x, y in placed]
    pen.area(corners, "body")
    pen.line([*corners, corners[0]], "text1", 1.6)


def draw_forces(pen: Pen) -> None:
    """An aerofoil at an angle of attack, with drag along the wind, lift across it, and its moment."""
    middle = (134.0, 112.0)
    for y in (52.0, 84.0, 116.0, 148.0):
        pen.arrow((10.0, y), (44.0, y), "accent", 1.6)
    pen.words("U", 26.0, 36.0, "accent")
    _shape(pen, "aerofoil", middle, 130.0, math.radians(18.0))
    pen.line(((40.0, 112.0), middle), "text3", 1.0, dash=3.0)
    pen.arc(middle, 64.0, 162.0, 180.0, "amber", 2.0)
    pen.formula(r"\alpha", 58.0, 100.0, "amber")
    pen.arrow(middle, (middle[0], 30.0), "green", 2.4)
    pen.formula("C_L", middle[0] + 22.0, 36.0, "green")
    pen.arrow(middle, (238.0, middle[1]), "vermilion", 2.4)
    pen.formula("C_D", 244.0, 96.0, "vermilion")
    pen.arc(middle, 40.0, 200.0, 320.0, "violet", 2.2)
    end = (middle[0] + 40.0 * math.cos(math.radians(200.0)), middle[1] - 40.0 * math.sin(math.radians(200.0)))
    dot(pen, end, "violet", 3.4)
    pen.formula("C_M", 134.0, 172.0, "violet")
    dot(pen, middle, "amber", 3.4)


def draw_box(pen: Pen) -> None:
    """What flows in and out of a box, and the pressure on its sides, give the force on what is inside."""
    left, right, top, low = 70.0, 226.0, 40.0, 168.0
    pen.line(((left, top), (right, top), (right, low), (left, low), (left, top)), "amber", 1.8, dash=5.0)
    _shape(pen, "disc", (134.0, 104.0), 46.0, 0.0)
    for y in (58.0, 88.0, 120.0, 150.0):
        pen.arrow((28.0, y), (62.0, y), "accent", 1.6)
    for y, long in ((52.0, 38.0), (80.0, 22.0), (104.0, 10.0), (128.0, 22.0), (156.0, 38.0)):
        pen.arrow((234.0, y), (238.0 + long, y), "accent", 1.6)
    pen.arrow((134.0, 104.0), (190.0, 104.0), "vermilion", 2.4)
    pen.formula(r"F = - \dot{P} - \int (\v{u} u_n + p \v{n} - \tau)", 148.0, 192.0)
    pen.words("what is held changes by what crosses the sides", 148.0, 18.0, "text2")
