"""The help figures: levels of a circle tree, and two horns that come to touch."""

from __future__ import annotations

import numpy as np

from game.physics.spacetime.tree import RADIUS, tree_of
from game.scenes.shared.marks import dot, outline
from game.ui.canvas.pen import Pen


def draw_levels(pen: Pen) -> None:
    """A comb and the circles of its first levels."""
    tree = tree_of("comb", 0)
    for depth, (x, y) in enumerate(((78.0, 62.0), (216.0, 62.0), (78.0, 160.0), (216.0, 160.0))):
        outline(pen, [(x + 40.0 * a, y - 40.0 * b) for a, b in tree.outline.tolist()], "text1", 1.2)
        for node in tree.level(depth):
            a, b, radius = tree.nodes[node, : RADIUS + 1].tolist()
            pen.disc(x + 40.0 * a, y - 40.0 * b, max(40.0 * radius, 1.5), "vermilion", ring=1.0)
        pen.words(f"level {depth}", x, y + 40.0, "text2")


def draw_horns(pen: Pen) -> None:
    """Two bounds that widen with the square of the time, on their way towards each other."""
    for x, color, way in ((40.0, "chalk", 1.0), (256.0, "green", -1.0)):
        for t in np.linspace(0.0, 1.0, 6).tolist():
            pen.disc(x + way * 62.0 * t, 104.0, 22.0 + 24.0 * t * t, color, ring=1.2)
        dot(pen, (x, 104.0), color, 4.0)
    pen.arrow((40.0, 172.0), (102.0, 172.0), "chalk")
    pen.arrow((256.0, 172.0), (194.0, 172.0), "green")
    pen.formula(r"\v{x} + \v{v} t", 148.0, 190.0)
    pen.formula(r"R + \frac{1}{2} A t^2", 148.0, 28.0)


def draw_bounds(pen: Pen) -> None:
    """Two nodes: circles about the parts, discs within them, and the two bounds between."""
    for x, color, out in ((74.0, "chalk", 46.0), (222.0, "green", 40.0)):
        pen.disc(x, 100.0, out, color, ring=1.4)
        pen.disc(x, 100.0, 20.0, color)
    pen.arrow((120.0, 100.0), (182.0, 100.0), "amber", 1.8)
    pen.line(((94.0, 134.0), (202.0, 134.0)), "vermilion", 1.8)
    for x in (94.0, 202.0):
        pen.line(((x, 100.0), (x, 138.0)), "text3", 1.0, dash=3.0)
    pen.words("at least", 150.0, 84.0, "amber")
    pen.words("at most", 148.0, 150.0, "vermilion")
