"""The card: a star in the circles of its tree."""

from __future__ import annotations

from game.physics.spacetime.tree import RADIUS, tree_of
from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"p02": CloseUp(shown_s=1.0, zoom=1.2, across=0.45, down=0.5)}


def draw_tree(pen: Pen) -> None:
    """An outline, and circles that cover it at the second level."""
    pen.fill("stage")
    for kind, x, color in (("star", 50.0, "chalk"), ("comb", 116.0, "green")):
        tree = tree_of(kind, 0)
        pen.area([(x + 32.0 * a, 52.0 - 32.0 * b) for a, b in tree.outline.tolist()], color)
        for node in tree.level(2):
            a, b, radius = tree.nodes[node, : RADIUS + 1].tolist()
            pen.disc(x + 32.0 * a, 52.0 - 32.0 * b, max(32.0 * radius, 1.0), "vermilion", ring=1.0)
