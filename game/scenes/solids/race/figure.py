"""The help figure: a column as rows of contacts, each of which changes what its neighbours were told."""

from __future__ import annotations

from game.scenes.shared.marks import dot, outline
from game.ui.canvas.pen import Pen


def draw_loop_of_impulses(pen: Pen) -> None:
    """Four boxes on the ground, the impulses of their contacts growing downwards."""
    ground, size, x = 186.0, 38.0, 96.0
    pen.box(30.0, ground, 132.0, 12.0, "body")
    pen.line(((30.0, ground), (162.0, ground)), "text2", 1.4)
    for k in range(4):
        top = ground - size * (k + 1)
        outline(
            pen,
            ((x - 26.0, top + 1.0), (x + 26.0, top + 1.0), (x + 26.0, top + size), (x - 26.0, top + size)),
            "chalk",
        )  # fmt: skip
        y, length = ground - size * k, 9.0 * (4 - k)
        pen.arrow((x, y), (x, y - length), "amber", 2.2)
        dot(pen, (x, y), "amber", 3.2)
        pen.formula(rf"\lambda_{k + 1}", x + 42.0, y - 2.0, "amber")
    for k in range(3):
        y = ground - size * (k + 0.5)
        pen.arrow((184.0, y + 14.0), (184.0, y - 16.0), "text1", 1.6)
    pen.words("a sweep goes", 240.0, 92.0, "text2")
    pen.words("from row to row", 240.0, 110.0, "text2")
    pen.words("each undoes a part", 240.0, 140.0, "text3")
    pen.words("of the one before", 240.0, 156.0, "text3")
