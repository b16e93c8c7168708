"""The help figure: two bodies at a contact, with normal, levers, impulse and the cone of friction."""

from __future__ import annotations

from game.scenes.shared.marks import ahead, dot, outline
from game.ui.canvas.pen import Pen


def draw_contact(pen: Pen) -> None:
    """A tilted box stands on a corner; what the ground gives lies within the cone of friction."""
    ground, tilt = 156.0, 24.0
    pen.box(16.0, ground, 264.0, 24.0, "body")
    pen.line(((16.0, ground), (280.0, ground)), "text2", 1.4)
    foot = (148.0, ground)
    right, left = ahead(foot, tilt, 88.0), ahead(foot, tilt + 90.0, 66.0)
    top = (right[0] + left[0] - foot[0], right[1] + left[1] - foot[1])
    outline(pen, (foot, right, top, left), "chalk")
    centre = (0.5 * (foot[0] + top[0]), 0.5 * (foot[1] + top[1]))
    cone, length = 31.0, 92.0
    pen.area((foot, ahead(foot, 90.0 - cone, length), ahead(foot, 90.0 + cone, length)), "green", 0.22)
    for side in (-cone, cone):
        pen.line((foot, ahead(foot, 90.0 + side, length)), "green", 1.2, dash=4.0)
    pen.line((foot, centre), "text2", 1.4, dash=4.0)
    dot(pen, centre, "text1", 3.2)
    dot(pen, foot, "amber", 4.0)
    pen.arrow(foot, ahead(foot, 90.0, 74.0), "text1", 1.6)
    pen.arrow(foot, ahead(foot, 106.0, 62.0), "amber", 2.4)
    pen.arrow(foot, ahead(foot, 180.0, 44.0), "text1", 1.6)
    pen.formula(r"\v{n}", foot[0] + 9.0, ground - 82.0)
    pen.formula(r"\v{t}", foot[0] - 50.0, ground - 12.0)
    pen.formula(r"\v{j}", *ahead(ahead(foot, 106.0, 62.0), 150.0, 14.0), "amber")
    pen.formula(r"\v{r}_a", centre[0] + 6.0, 0.5 * (centre[1] + foot[1]) + 14.0, "text2")
    pen.formula(r"\mu", *ahead(foot, 90.0 + cone + 8.0, 70.0), "green")
    pen.words("cone of friction", 88.0, 58.0, "green")
    pen.formula(r"\abs{j_t} \le \mu j_n", 228.0, 136.0, "text2")
