"""The Jacobian in the picture: how the end moves as each joint turns, and what the error asks of each."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_number

SWEEP = 0.16  # rad to either side, of an arc of the end
FULL_TURN = 0.9  # rad, of the arc at the joint of which most is asked
FEW = 8  # joints of which the numbers are written


class Pull(NamedTuple):
    """columns (n, 2) m/rad: those of J. asked (n,) m²: J^T e, of each joint."""

    columns: Floats
    asked: Floats


def pull_of(joints: Floats, end: Floats, target: Floats) -> Pull:
    """Of a chain with joints (n, 2) m and its end (2,) m towards a target (2,) m."""
    arms = end - joints
    columns = np.column_stack((-arms[:, 1], arms[:, 0]))
    return Pull(columns, columns @ (target - end))


def draw_jacobian(canvas: Canvas, joints: Floats, end: Floats, target: Floats) -> None:
    """Arcs through the end about each joint, an arrow along each column, arcs at the joints as J^T e asks."""
    pull = pull_of(joints, end, target)
    off = target - end
    asks = math.sqrt(float(off @ off)) > canvas.px(1.0)  # else what is left is rounding
    most = float(np.abs(pull.asked).max(initial=0.0)) if asks else 0.0
    for i, joint in enumerate(joints):
        arm = end - joint
        radius, angle = math.sqrt(float(arm @ arm)), math.atan2(float(arm[1]), float(arm[0]))
        canvas.arc(tuple(joint), radius, angle - SWEEP, angle + SWEEP, "pink", 1.2, 0.7)
        canvas.arrow(tuple(end), tuple(pull.columns[i]), "pink", None, 0.22, 1.6)
        if most > 0.0:
            share = float(pull.asked[i]) / most
            canvas.arc(tuple(joint), canvas.px(15.0), angle, angle + FULL_TURN * share, "amber", 3.0)
        if asks and len(joints) <= FEW:
            words = canvas.figure(("asked", i), format_number(float(pull.asked[i]), 2))
            canvas.label(tuple(joint), words, "amber", 11, offset=(0.0, 17.0), clear=True)
    canvas.arrow(tuple(end), tuple(target - end), "text1", "e")
