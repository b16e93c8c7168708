"""The help figure: two balls exchange what lies along their line of centres."""

from __future__ import annotations

from game.scenes.shared.marks import ahead, between, dot, right_angle
from game.ui.canvas.pen import Pen


def draw_exchange(pen: Pen) -> None:
    """Two equal balls, the second at rest: the parts along the line of centres change owners."""
    alpha, radius = 20.0, 34.0
    along, across = 84.0, 54.0  # parts of the first velocity
    second = (103.0, 120.0)
    first = ahead(second, alpha, 2.0 * radius)
    foot = ahead(first, alpha, along)
    tail = ahead(foot, alpha - 90.0, across)
    given = ahead(second, alpha + 180.0, along)
    pen.line((ahead(second, alpha + 180.0, 104.0), ahead(first, alpha, 112.0)), "text2", 1.1, dash=3.5)
    for center, number in ((first, "1"), (second, "2")):
        pen.disc(*center, radius, pen.veiled("body", 0.2))
        pen.disc(*center, radius, "text1", ring=1.5)
        pen.words(number, center[0] + 9.0, center[1] + 16.0, "text2", size=13, weight="semibold")
    pen.line((foot, tail), "chalk", 1.4, dash=3.0)
    right_angle(pen, foot, alpha + 180.0, color="text2")
    pen.arrow(tail, first, "chalk", 2.2)
    pen.arrow(second, given, "green", 2.2)
    pen.arrow(first, ahead(first, alpha + 90.0, across), "green", 2.2)
    pen.line((second, (second[0] - 92.0, second[1])), "text2", 1.1, dash=3.5)
    pen.arc(second, 66.0, 180.0, 180.0 + alpha, "text1", 1.2)
    dot(pen, ahead(second, alpha, radius), "amber", 3.6)
    pen.formula(r"\alpha", *ahead(second, 180.0 + 0.42 * alpha, 77.0))
    pen.formula(r"\v{v}_1", tail[0] - 20.0, tail[1] + 12.0, "chalk")
    pen.formula("p_{1x}", *ahead(between(first, foot, 0.62), alpha + 90.0, 11.0), "chalk")
    pen.formula("p_{1y}", *ahead(between(foot, tail, 0.5), alpha, 18.0), "chalk")
    pen.formula("p_{2x}' = p_{1x}", given[0] + 58.0, given[1] + 15.0, "green")
    pen.formula("p_{1y}", *ahead(ahead(first, alpha + 90.0, across), 200.0, 18.0), "green")
