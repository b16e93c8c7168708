"""Figures of artistic billiards: where the balls lie, which way the cue ball must go, what it is worth.

They are figures of Carom's own in the manner of the programme of the Confederation internationale de billard
artistique, whose figures are worth 4 to 11 points. Each has a stroke that makes it on a heated cloth.
"""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.game.arrangement import Stroke

Point = tuple[float, float]

LETTERS = "<>_^yr"  # of a route: cushions left, right, lower and upper; the yellow ball and the red one


class Figure(NamedTuple):
    """One figure. white (the cue ball), yellow, red: places, m. route: what the cue ball touches in order, up
    to the second ball, in LETTERS. points: for making it. stroke: one that does.
    """

    name: str
    points: int
    white: Point
    yellow: Point
    red: Point
    route: str
    stroke: Stroke


FIGURES = (
    Figure("Straight draw", 4, (0.71, 1.20), (0.62, 0.45), (0.71, 1.60), "ry",
           Stroke(2.7527, 1.5679, 0.1181, -0.2083, -0.4607)),
    Figure("Cushion first", 4, (0.40, 0.80), (1.20, 2.30), (0.35, 2.20), "<ry",
           Stroke(3.8657, 2.0731, 0.0, 0.1424, 0.0112)),
    Figure("Draw to the short cushion", 5, (0.71, 1.25), (1.10, 0.25), (0.71, 1.60), "r_y",
           Stroke(2.3309, 1.5678, 0.0864, 0.2212, -0.4841)),
    Figure("Follow off two cushions", 5, (0.50, 1.00), (1.25, 1.60), (0.60, 1.50), "r^>y",
           Stroke(3.9326, 1.3689, 0.0356, -0.2266, 0.4395)),
    Figure("Round the table", 5, (0.50, 0.70), (0.25, 0.35), (0.70, 2.10), "r>^<y",
           Stroke(2.6552, 1.3982, 0.0, -0.1086, 0.3477)),
    Figure("Draw off two cushions", 6, (0.60, 1.20), (0.25, 1.35), (0.66, 1.55), "r_<y",
           Stroke(4.592, 1.3842, 0.0951, -0.355, -0.4587)),
    Figure("Straight follow", 6, (0.71, 1.00), (0.74, 2.40), (0.71, 1.45), "ry",
           Stroke(2.5042, 1.5791, 0.0, 0.0423, 0.0107)),
    Figure("Piqué", 7, (0.71, 1.40), (0.60, 0.95), (0.71, 1.49), "ry",
           Stroke(1.4006, 1.6415, 1.0752, 0.0743, -0.545)),
    Figure("Massé off a cushion", 8, (0.50, 0.40), (0.20, 0.90), (0.60, 0.55), "r<y",
           Stroke(2.0274, 1.0606, 0.6412, 0.4327, -0.2649)),
    Figure("Five cushions", 8, (0.40, 0.60), (1.20, 2.50), (0.90, 2.00), "r^<_>^y",
           Stroke(6.8568, 1.2494, 0.0, -0.0938, -0.5441)),
    Figure("There and back", 9, (0.30, 0.60), (1.00, 0.30), (0.40, 2.30), "r^<_y",
           Stroke(2.3242, 1.5404, 0.0, 0.0195, 0.5201)),
    Figure("Seven cushions", 11, (0.40, 0.60), (1.00, 1.60), (0.90, 2.20), "r>^<_><^y",
           Stroke(7.106, 1.2591, 0.0, 0.4052, 0.153)),
)  # fmt: skip
