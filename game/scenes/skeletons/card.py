"""The cards: a skeleton (C02), an arm that reaches (C03)."""

from __future__ import annotations

import math
from itertools import pairwise

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen, Point

CLOSE_UPS = {
    "c02": CloseUp(zoom=1.7, down=0.3),
    "c03": CloseUp(zoom=2.4, across=0.2, down=0.27),
}


def draw_skeleton(pen: Pen) -> None:
    pen.fill("stage")
    pen.line(((0.0, 96.0), (160.0, 96.0)), "line", 1.0)
    limbs = (
        ((80.0, 32.0), (80.0, 60.0)), ((86.0, 33.0), (104.0, 42.0)), ((104.0, 42.0), (114.0, 22.0)),
        ((74.0, 33.0), (60.0, 48.0)), ((60.0, 48.0), (52.0, 64.0)), ((84.0, 60.0), (90.0, 78.0)),
        ((90.0, 78.0), (90.0, 94.0)), ((76.0, 60.0), (70.0, 78.0)), ((70.0, 78.0), (68.0, 94.0)),
    )  # fmt: skip
    for a, b in limbs:
        for width, color in ((13.0, "chalk"), (11.0, "body")):
            if color == "chalk":
                pen.disc(*a, 0.5 * width, color)
                pen.disc(*b, 0.5 * width, color)
                pen.line((a, b), color, width)
    pen.disc(80.0, 18.0, 10.5, "chalk")
    for a, b in limbs:
        pen.disc(*a, 5.4, "body")
        pen.disc(*b, 5.4, "body")
        pen.line((a, b), "body", 10.8)
    pen.disc(80.0, 18.0, 9.4, "body")
    for a, b in (*limbs, ((80.0, 28.0), (80.0, 14.0))):
        _bone(pen, a, b, "amber" if b == (114.0, 22.0) else "text1")


def _bone(pen: Pen, a: Point, b: Point, color: str) -> None:
    dx, dy = b[0] - a[0], b[1] - a[1]
    x, y = a[0] + 0.2 * dx, a[1] + 0.2 * dy
    length = math.sqrt(dx * dx + dy * dy)
    side = 2.4 / length
    corners = (a, (x - side * dy, y + side * dx), b, (x + side * dy, y - side * dx), a)
    pen.line(corners, color, 0.9)
    pen.disc(*a, 1.5, color)
    pen.disc(*b, 1.5, color)


def draw_reaching(pen: Pen) -> None:
    pen.fill("stage")
    root, target = (34.0, 84.0), (118.0, 30.0)
    arms = (
        ("chalk", ((34.0, 84.0), (24.0, 50.0), (52.0, 28.0), (87.0, 20.0), (118.0, 30.0))),
        ("violet", ((34.0, 84.0), (58.0, 58.0), (94.0, 66.0), (122.0, 60.0), (118.0, 30.0))),
        ("text1", ((34.0, 84.0), (46.0, 50.0), (76.0, 42.0), (96.0, 54.0), (118.0, 30.0))),
    )
    for color, joints in arms:
        if color == "text1":
            for a, b in pairwise(joints):
                _bone(pen, a, b, color)
        else:
            pen.line(joints, color, 1.4, dash=2.6)
    pen.disc(*root, 3.4, "text1")
    pen.disc(*target, 8.0, "amber", ring=1.6)
    pen.disc(*target, 2.6, "amber")
