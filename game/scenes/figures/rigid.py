"""Rigid bodies: the ways of the angular momentum in the body, the impulse in its friction cone."""

from __future__ import annotations

import math
from itertools import pairwise

from game.scenes.figures.marks import ahead, between, dot, right_angle, spaced, span
from game.ui.canvas.pen import Pen

# -- momentum sphere ----------------------------------------------------------------------------------

INERTIA = (1.0, 2.0, 3.0)  # of the axes 1, 2, 3
CENTER, RADIUS = (148.0, 114.0), 78.0
TURN, TILT = math.radians(-38.0), math.radians(22.0)  # from where the sphere is looked at

Vector = tuple[float, float, float]


def draw_momentum_sphere(pen: Pen) -> None:
    """Where L can go in a free body: curves of equal energy on the sphere of equal length."""
    pen.disc(*CENTER, RADIUS, pen.veiled("body", 0.3))
    for axis, parts in ((0, (0.04, 0.16, 0.35, 0.6)), (2, (0.04, 0.16, 0.35, 0.6, 0.85))):
        for part in parts:  # of the way from an extreme energy to the middle one
            for way in _ways(axis, part):
                _draw_way(pen, way, "text3", 1.1)
    for way in _ways(0, 1.0):
        _draw_way(pen, way, "amber", 1.8)
    pen.disc(*CENTER, RADIUS, "text2", ring=1.3)
    way = _euler_way((0.34, 0.93, 0.16), 0.3, 200)
    _draw_way(pen, way, "vermilion", 1.6)
    tip = _seen(way[0])
    pen.arrow(CENTER, tip[:2], "green", 2.2)
    dot(pen, CENTER, "green", 2.6)
    for i, name in enumerate("123"):
        start, end, beyond = (
            _seen((r * (i == 0), r * (i == 1), r * (i == 2)))[:2] for r in (1.0, 1.3, 1.46 + 0.12 * (i == 2))
        )
        pen.arrow(start, end, "text1", 1.4)
        pen.formula(name, *beyond)
    pen.words("explicit Euler", 204.0, 46.0, "vermilion", align="left")
    pen.formula(r"E = \frac{L^2}{2 I_2}", 54.0, 52.0, "amber")
    pen.formula(r"\v{L}", tip[0] + 10.0, tip[1] + 26.0, "green")


def _euler_way(start: Vector, step: float, count: int) -> list[Vector]:
    """L in the body when the body turns, step by step, by the spin at the step's beginning.

    L stays in space, so in the body it turns backwards about that spin; its energy can only grow.
    """
    length = math.sqrt(_product(start, start))
    way = [(start[0] / length, start[1] / length, start[2] / length)]
    for _ in range(count):
        x, y, z = way[-1]
        wx, wy, wz = x / INERTIA[0], y / INERTIA[1], z / INERTIA[2]
        spin = math.sqrt(wx * wx + wy * wy + wz * wz)
        along = (x * wx + y * wy + z * wz) / spin**2
        c, s = math.cos(step * spin), math.sin(step * spin) / spin
        across = (y * wz - z * wy, z * wx - x * wz, x * wy - y * wx)
        parts = zip((x, y, z), (wx, wy, wz), across, strict=True)
        x, y, z = (c * q + (1.0 - c) * along * w + s * k for q, w, k in parts)
        way.append((x, y, z))
    return way


def _product(p: Vector, q: Vector) -> float:
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def _ways(axis: int, part: float) -> list[list[Vector]]:
    """Both closed curves round an axis of least or greatest inertia (Poinsot 1834)."""
    middle, end = 1.0 / INERTIA[1], 1.0 / INERTIA[axis]
    level = end + part * (middle - end)  # twice the energy, at length 1
    other = 2 - axis
    wide = (level - end) / (middle - end)  # of the square of L on axis 2, without L on the other one
    slim = (level - end) / (1.0 / INERTIA[other] - end)
    ways: list[list[Vector]] = []
    for sign in (1.0, -1.0):
        way: list[Vector] = []
        for turn in spaced(0.0, 2.0 * math.pi, 121):
            y, z = math.sqrt(wide) * math.cos(turn), math.sqrt(slim) * math.sin(turn)
            point = [0.0, y, 0.0]
            point[axis], point[other] = sign * math.sqrt(max(1.0 - y * y - z * z, 0.0)), z
            way.append((point[0], point[1], point[2]))
        ways.append(way)
    return ways


def _draw_way(pen: Pen, way: list[Vector], color: str, width: float) -> None:
    """The part of a curve that is in front."""
    for p, q in pairwise(way):
        if min(_seen(p)[2], _seen(q)[2]) > 0.05:
            pen.line((_seen(p)[:2], _seen(q)[:2]), color, width)


def _seen(p: Vector) -> Vector:
    """Frame coordinates, and how far in front; axis 2 points up before the sphere is tilted."""
    x, y, z = p[0], -p[2], p[1]
    x, y = x * math.cos(TURN) - y * math.sin(TURN), x * math.sin(TURN) + y * math.cos(TURN)
    depth, z = -y * math.cos(TILT) + z * math.sin(TILT), y * math.sin(TILT) + z * math.cos(TILT)
    return CENTER[0] + RADIUS * x, CENTER[1] - RADIUS * z, depth


# -- contact ------------------------------------------------------------------------------------------


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
