"""The help figures: forces on a pendulum, an impact seen too late, the modes of a chain."""

from __future__ import annotations

import math

from game.physics.kernels import elementary
from game.scenes.shared.marks import ahead, dot
from game.ui.canvas.pen import Pen


def draw_forces(pen: Pen) -> None:
    """Weight and the pull of the rod; what is left acts along the arc."""
    pivot, length, angle = (148.0, 24.0), 130.0, math.radians(34.0)
    mass = pivot[0] + length * elementary.sin(angle), pivot[1] + length * elementary.cos(angle)
    pen.line((pivot, (pivot[0], pivot[1] + length + 22.0)), "text3", 1.0, dash=3.0)
    pen.arc(pivot, 44.0, -90.0, -90.0 + 34.0, "text2", 1.2)
    pen.formula(r"\phi", pivot[0] + 20.0, pivot[1] + 58.0, "text1")
    pen.line((pivot, mass), "text2", 2.0)
    pen.formula("l", 0.5 * (pivot[0] + mass[0]) + 14.0, 0.5 * (pivot[1] + mass[1]) - 8.0, "text1")
    pen.arrow(mass, (mass[0], mass[1] + 58.0), "chalk", 2.2)
    pen.formula(r"m g", mass[0] + 20.0, mass[1] + 50.0, "chalk")
    along = 58.0 * elementary.sin(angle)
    pen.arrow(
        mass, (mass[0] - along * elementary.cos(angle), mass[1] + along * elementary.sin(angle)), "amber", 2.2
    )
    pen.formula(r"m g \sin \phi", 108.0, mass[1] + 30.0, "amber")
    pen.disc(*mass, 11.0, "body")
    pen.disc(*mass, 11.0, "text1", ring=1.4)
    dot(pen, pivot)


def draw_late_impact(pen: Pen) -> None:
    """Where a ball is after a step: below the ground, put back onto it, and where it should be."""
    ground, step, e = 150.0, 62.0, 0.8
    pen.line(((16.0, ground), (280.0, ground)), "text2", 1.4)
    fall = [(60.0 + t, 30.0 + 0.0085 * t * t) for t in range(0, 150, 3)]
    pen.line([p for p in fall if p[1] <= ground], "text2", 1.2, dash=4.0)
    hit = next(p for p in fall if p[1] >= ground)
    rise = [(hit[0] + t, ground - e * 2.0 * 1.01 * t + 0.0085 * t * t) for t in range(0, 60, 3)]
    pen.line(rise, "text2", 1.2, dash=4.0)
    for k in range(3):
        x = 60.0 + k * step
        y = 30.0 + 0.0085 * elementary.square(k * step)
        pen.disc(x, y, 8.0, "chalk" if k < 2 else "vermilion", ring=1.6)
    late = 60.0 + 2.0 * step
    pen.arrow((late, 158.0), (late, ground - 4.0), "vermilion", 1.6)
    pen.words("end of the step", late + 10.0, 176.0, "vermilion")
    pen.words("the root", hit[0] - 44.0, ground - 14.0, "amber")
    dot(pen, hit, "amber", 4.5)


def draw_modes(pen: Pen) -> None:
    """The first three modes of a chain, one below the other."""
    left, right, beads = 62.0, 262.0, 11
    for mode in (1, 2, 3):
        middle = 42.0 + 56.0 * (mode - 1)
        places = [left + (right - left) * j / (beads + 1) for j in range(beads + 2)]
        heights = [middle - 19.0 * elementary.sin(mode * math.pi * j / (beads + 1)) for j in range(beads + 2)]
        pen.line(((left, middle), (right, middle)), "text3", 0.8, dash=3.0)
        pen.line(list(zip(places, heights, strict=True)), "text2", 1.2)
        for place in list(zip(places, heights, strict=True))[1:-1]:
            dot(pen, place, "chalk", 3.4)
        pen.formula(f"k = {mode}", 30.0, middle, "text1", size=14.0)
        for end in (left, right):
            pen.line((ahead((end, middle), 90.0, 10.0), ahead((end, middle), -90.0, 10.0)), "text1", 2.0)
