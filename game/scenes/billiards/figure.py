"""The help figure: where a stroke is aimed."""

from __future__ import annotations

import math

import pygame

from game.scenes.shared.marks import ahead, between, curve, dot, right_angle, spaced
from game.ui.canvas.pen import Pen, Point
from game.ui.look.theme import POCKET_RING

RADIUS = 19.0
POCKET = pygame.Color("#0A0E11")


def draw_aim(pen: Pen) -> None:
    """A rolling cue ball after a cut of 35 degrees: off along the tangent, then bent until it rolls."""
    aim, cut, throw = 4.0, 35.0, 5.0
    normal, tangent = aim + cut, aim + cut - 90.0
    cue, ghost = (38.0, 116.0), ahead((38.0, 116.0), aim, 94.0)
    target = ahead(ghost, normal, 2.0 * RADIUS)
    pocket = ahead(target, normal - throw, 99.0)
    pen.disc(*pocket, 24.0, POCKET)
    pen.disc(*pocket, 24.0, POCKET_RING, ring=1.6)
    pen.line((ahead(ghost, normal, 3.0 * RADIUS), ahead(target, normal, 78.0)), "text2", 1.1, dash=3.5)
    pen.line((ahead(ghost, aim, RADIUS), ahead(ghost, aim, 94.0)), "text2", 1.1, dash=3.5)
    pen.line((ghost, ahead(ghost, tangent, 108.0)), "text2", 1.1, dash=3.5)
    for center, veil in ((cue, 0.0), (target, 0.2)):
        pen.disc(*center, RADIUS, pen.veiled("inset" if veil else "hover", veil))
        pen.disc(*center, RADIUS, "text1", ring=1.5)
    curve(pen, [ahead(ghost, degrees, RADIUS) for degrees in range(0, 361, 5)], "text1", 1.3, 4.0)
    pen.line((ghost, target), "text1", 1.2)
    pen.arrow(cue, ahead(cue, aim, 62.0), "chalk", 2.2)
    pen.arrow(ghost, ahead(ghost, tangent, 70.0), "chalk", 2.2)
    pen.arrow(ahead(target, normal - throw, RADIUS), ahead(pocket, normal - throw, -6.0), "green", 2.0)
    path = _path(ghost, normal, cut, 70.0, 44.0)
    pen.line(path[:-1], "green", 2.0)
    pen.arrow(path[-2], path[-1], "green", 2.0)
    pen.arc(ghost, 74.0, aim, normal, "text1", 1.2)
    right_angle(pen, ghost, tangent, color="text2")
    dot(pen, ahead(ghost, normal, RADIUS), "amber", 3.4)
    pen.formula(r"\v{v}", cue[0] + 40.0, cue[1] - 15.0, "chalk")
    pen.formula("2R", *ahead(between(ghost, target, 0.45), normal + 90.0, 27.0))
    pen.formula(r"\text{35°}", *ahead(ghost, aim + 0.42 * cut, 90.0))
    pen.words("throw", *ahead(target, normal + 11.0, 62.0), "green", align="right")
    pen.words("ghost ball", ghost[0] + 7.0, ghost[1] + 31.0, "text2", align="right")
    pen.formula(r"\v{v}_0", *ahead(ahead(ghost, tangent, 60.0), tangent - 90.0, 13.0), "chalk")
    pen.formula(r"\v{r}(t)", path[-1][0] + 2.0, path[-1][1] - 22.0, "green")


def _path(start: Point, normal: float, cut: float, sliding: float, rolling: float) -> list[Point]:
    """Path of a rolling ball's centre from an impact: ``sliding`` along the tangent, then straight on.

    With speed v it leaves with v sin(cut) along the tangent; its spin pulls it along the normal until it
    rolls, with 2/7 v cos(cut) along it. A parabola in between: the mean of that speed is the half.
    """
    slope = (2.0 / 7.0) / math.tan(math.radians(cut))
    bend = [(s, 0.5 * slope * s * s / sliding) for s in spaced(0.0, sliding, 30)]
    bend.append((sliding + rolling, slope * (0.5 * sliding + rolling)))
    return [ahead(ahead(start, normal - 90.0, s), normal, n) for s, n in bend]
