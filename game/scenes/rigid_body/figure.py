"""The help figure: the sphere of angular momentum."""

from __future__ import annotations

import math
from itertools import pairwise

from game.scenes.shared.marks import dot, spaced
from game.ui.canvas.pen import Pen

INERTIA = (1.0, 2.0, 3.0)  # of the axes 1, 2, 3
CENTER, RADIUS = (148.0, 114.0), 78.0
TURN, TILT = math.radians(-38.0), math.radians(22.0)  # from where the sphere is looked at
Vector = tuple[float, float, float]


def draw_momentum_sphere(pen: Pen) -> None:
    """Where L can go in a free body: curves of equal energy on the sphere of equal length."""
    pen.disc(*CENTER, RADIUS, pen.veiled("body", 0.3))
    for axis, parts in ((0, (0.04, 0.16, 0.35, 0.6)), (2, (0.04, 0.16, 0.35, 0.6, 0.85))):
        for part in parts:  # of the way from an extreme energy to the middle one
            for path in _paths(axis, part):
                _draw_path(pen, path, "text3", 1.1)
    for path in _paths(0, 1.0):
        _draw_path(pen, path, "amber", 1.8)
    pen.disc(*CENTER, RADIUS, "text2", ring=1.3)
    path = _euler_path((0.34, 0.93, 0.16), 0.3, 200)
    _draw_path(pen, path, "vermilion", 1.6)
    tip = _seen(path[0])
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


def _euler_path(start: Vector, step: float, count: int) -> list[Vector]:
    """L in the body when the body turns, step by step, by the spin at the step's beginning.

    L stays in space, so in the body it turns backwards about that spin; its energy can only grow.
    """
    length = math.sqrt(_product(start, start))
    path = [(start[0] / length, start[1] / length, start[2] / length)]
    for _ in range(count):
        x, y, z = path[-1]
        wx, wy, wz = x / INERTIA[0], y / INERTIA[1], z / INERTIA[2]
        spin = math.sqrt(wx * wx + wy * wy + wz * wz)
        along = (x * wx + y * wy + z * wz) / spin**2
        c, s = math.cos(step * spin), math.sin(step * spin) / spin
        across = (y * wz - z * wy, z * wx - x * wz, x * wy - y * wx)
        parts = zip((x, y, z), (wx, wy, wz), across, strict=True)
        x, y, z = (c * q + (1.0 - c) * along * w + s * k for q, w, k in parts)
        path.append((x, y, z))
    return path


def _product(p: Vector, q: Vector) -> float:
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def _paths(axis: int, part: float) -> list[list[Vector]]:
    """Both closed curves round an axis of least or greatest inertia (Poinsot 1834)."""
    middle, end = 1.0 / INERTIA[1], 1.0 / INERTIA[axis]
    level = end + part * (middle - end)  # twice the energy, at length 1
    other = 2 - axis
    wide = (level - end) / (middle - end)  # of the square of L on axis 2, without L on the other one
    slim = (level - end) / (1.0 / INERTIA[other] - end)
    paths: list[list[Vector]] = []
    for sign in (1.0, -1.0):
        path: list[Vector] = []
        for turn in spaced(0.0, 2.0 * math.pi, 121):
            y, z = math.sqrt(wide) * math.cos(turn), math.sqrt(slim) * math.sin(turn)
            point = [0.0, y, 0.0]
            point[axis], point[other] = sign * math.sqrt(max(1.0 - y * y - z * z, 0.0)), z
            path.append((point[0], point[1], point[2]))
        paths.append(path)
    return paths


def _draw_path(pen: Pen, path: list[Vector], color: str, width: float) -> None:
    """The part of a curve that is in front."""
    for p, q in pairwise(path):
        if min(_seen(p)[2], _seen(q)[2]) > 0.05:
            pen.line((_seen(p)[:2], _seen(q)[:2]), color, width)


def _seen(p: Vector) -> Vector:
    """Frame coordinates, and how far in front; axis 2 points up before the sphere is tilted."""
    x, y, z = p[0], -p[2], p[1]
    x, y = x * math.cos(TURN) - y * math.sin(TURN), x * math.sin(TURN) + y * math.cos(TURN)
    depth, z = -y * math.cos(TILT) + z * math.sin(TILT), y * math.sin(TILT) + z * math.cos(TILT)
    return CENTER[0] + RADIUS * x, CENTER[1] - RADIUS * z, depth
