"""The help figures: two passes over one table, and the depth that neighbours agree on."""

from __future__ import annotations

from game.scenes.shared.marks import dot, outline
from game.ui.canvas.pen import Pen

CORNERS = ((78.0, 150.0), (196.0, 128.0), (118.0, 44.0))
VERTICES = ((128.0, 98.0), (58.0, 70.0), (222.0, 58.0), (238.0, 150.0), (160.0, 60.0))


def _grid(pen: Pen, size: float = 52.0) -> None:
    for k in range(6):
        pen.line(((20.0 + size * k, 14.0), (20.0 + size * k, 170.0)), "line2", 1.0)
    for k in range(4):
        pen.line(((20.0, 14.0 + size * k), (280.0, 14.0 + size * k)), "line2", 1.0)


def draw_two_passes(pen: Pen) -> None:
    """A triangle, the cells of its box, and the vertices that are tested, inside and not."""
    pen.area(((72.0, 14.0), (228.0, 14.0), (228.0, 170.0), (72.0, 170.0)), "chalk", 0.75)
    _grid(pen)
    outline(pen, CORNERS, "text1", 1.8, "green")
    for k, place in enumerate(VERTICES):
        tested = 72.0 < place[0] < 228.0
        dot(pen, place, "vermilion" if k == 0 else ("text1" if tested else "text3"), 4.5)
    pen.formula(r"\beta_1, \beta_2, \beta_3 \ge 0", 150.0, 192.0)


def draw_slots(pen: Pen) -> None:
    """Cells whose vertices hang in the slots of a short table; two cells share one."""
    for k in range(7):
        pen.box(30.0 + 34.0 * k, 150.0, 30.0, 22.0, "body")
        pen.words(str(k), 45.0 + 34.0 * k, 188.0, "text2")
    for k, loads in ((1, ("chalk", "chalk")), (3, ("green", "violet", "green")), (6, ("chalk",))):
        for place, color in enumerate(loads):
            pen.line(
                ((45.0 + 34.0 * k, 150.0 - 26.0 * place), (45.0 + 34.0 * k, 132.0 - 26.0 * place)),
                "text2",
                1.2,
            )
            dot(pen, (45.0 + 34.0 * k, 128.0 - 26.0 * place), color, 5.5)
    pen.words("cells (2, 1) and (4, 4)", 147.0, 44.0, "text2")


def draw_depth(pen: Pen) -> None:
    """A corner of a mesh inside another: border vertices with their ways out, and one farther in."""
    pen.area(((20.0, 104.0), (276.0, 104.0), (276.0, 190.0), (20.0, 190.0)), "green", 0.6)
    pen.line(((20.0, 104.0), (276.0, 104.0)), "text1", 1.8)
    rim = ((84.0, 20.0), (110.0, 128.0), (150.0, 162.0), (192.0, 126.0), (214.0, 20.0))
    pen.area(rim, "chalk", 0.6)
    pen.line(rim, "text1", 1.8)
    for p in rim[1:4]:
        pen.line(((150.0, 70.0), p), "text2", 1.0)
    for p in rim[1:4]:
        pen.arrow(p, (p[0], 104.0), "vermilion", 2.0)
        dot(pen, p, "vermilion", 4.5)
    dot(pen, (104.0, 104.0), "amber", 4.0)
    dot(pen, (198.0, 104.0), "amber", 4.0)
    pen.formula("d", 168.0, 140.0)
