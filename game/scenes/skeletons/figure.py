"""The help figures: a bent arm (C02), a step of CCD (C03)."""

from __future__ import annotations

import cmath
import math

from game.scenes.shared.marks import ahead, between, curve, dot, spaced, turn
from game.ui.canvas.pen import Pen, Point


def draw_bend(pen: Pen) -> None:
    """A joint bent by 100 degrees: the skin blended by matrices, and by rotors."""
    left, right = (76.0, 142.0), (222.0, 142.0)
    _draw_arm(pen, left, False, "vermilion")
    _draw_arm(pen, right, True, "green")
    pen.line((left, ahead(left, 0.0, 62.0)), "text2", 1.1, dash=3.5)
    pen.arc(left, 54.0, 0.0, BEND, "text1", 1.2)
    pen.formula("a", *ahead(left, 38.0, 64.0))
    pen.words("linear", left[0] - 66.0, 34.0, "text2", align="left", size=13)
    pen.words("rotors", right[0] - 66.0, 34.0, "text2", align="left", size=13)
    pen.formula(r"2r \cos\frac{a}{2}", left[0] + 47.0, left[1] + 40.0, "vermilion")
    pen.formula("2r", right[0] + 40.0, right[1] + 34.0, "green")


def _draw_arm(pen: Pen, joint: Point, rotors: bool, color: str) -> None:
    """A tube round two bones, ribs across it, and in colour the rib at the joint."""

    def skin(x: float, y: float) -> Point:
        moved = _blended(complex(x, y), rotors)
        return joint[0] + moved.real, joint[1] - moved.imag

    sides = [[skin(x, y) for x in spaced(-66.0, 84.0, 151)] for y in (-WIDE, WIDE)]
    pen.area([*sides[0], *reversed(sides[1])], "body", 0.2)
    for x in spaced(-64.0, 80.0, 19):
        pen.line((skin(x, -WIDE), skin(x, WIDE)), "ghost", 1.0)
    for side in sides:
        pen.line(side, "text1", 1.7)
    pen.line((skin(0.0, -WIDE), skin(0.0, WIDE)), color, 2.4)
    pen.line(((joint[0] - 66.0, joint[1]), joint, ahead(joint, BEND, 84.0)), "accent", 2.2)
    dot(pen, joint, "accent", 4.2, ring=1.6)


BEND = 100.0  # degrees
WIDE = 23.0  # half of the arm's breadth
SPREAD = 38.0  # from the joint to where a point follows one bone alone


def _blended(point: complex, rotors: bool) -> complex:
    """Where a point of the straight arm goes; both bones turn about the joint, 0."""
    bend = math.radians(BEND)
    share = min(max(0.5 + 0.5 * point.real / SPREAD, 0.0), 1.0)
    share = share * share * (3.0 - 2.0 * share)
    if rotors:
        rotor = (1.0 - share) + share * cmath.exp(0.5j * bend)
        return point * (rotor / abs(rotor)) ** 2
    return point * ((1.0 - share) + share * cmath.exp(1j * bend))


def draw_ccd(pen: Pen) -> None:
    """A chain of four bones; a turn of its second joint brings the end onto the line to the target."""
    joints: list[Point] = [(40.0, 176.0)]
    for degrees, length in ((80.0, 68.0), (38.0, 66.0), (-22.0, 60.0), (-64.0, 48.0)):
        joints.append(ahead(joints[-1], degrees, length))
    joint, end, target = joints[1], joints[-1], (254.0, 62.0)
    start, goal = _direction(joint, end), _direction(joint, target)
    reach = math.dist(joint, end)
    after = [ahead(joint, _direction(joint, p) + goal - start, math.dist(joint, p)) for p in joints[2:]]
    pen.line((joint, end), "text2", 1.1, dash=3.5)
    pen.line((joint, target), "text2", 1.1, dash=3.5)
    curve(pen, [ahead(joint, s, reach) for s in spaced(start, goal, 40)], "text2", 1.2, 3.5)
    pen.line((joint, *after), "green", 1.8)
    for point in after:
        dot(pen, point, "green", 3.4, ring=1.5)
    pen.line(joints, "text1", 2.4)
    turn(pen, joint, 62.0, start, goal, "amber", 1.8)
    pen.arrow(end, ahead(target, _direction(target, end), 5.0), "vermilion", 1.8)
    for point in joints:
        dot(pen, point, "text1", 4.0, ring=1.6)
    dot(pen, target, "vermilion", 4.5)
    pen.formula(r"\v{p}_i", joint[0] - 17.0, joint[1] - 4.0)
    pen.formula(r"\v{p}_n", end[0] + 2.0, end[1] + 18.0)
    pen.formula(r"\v{t}", target[0] + 12.0, target[1] - 10.0, "vermilion")
    pen.formula(r"\v{e}", *ahead(between(end, target, 0.55), goal - 70.0, 13.0), "vermilion")
    pen.formula(r"\Delta\theta_i", *ahead(joint, 0.5 * (start + goal), 82.0), "amber")
    pen.formula(r"\v{p}_n - \v{p}_i", *ahead(between(joint, end, 0.45), start - 90.0, 14.0), "text2")


def _direction(a: Point, b: Point) -> float:
    """Degrees, counter-clockwise from the right."""
    return math.degrees(math.atan2(a[1] - b[1], b[0] - a[0]))
