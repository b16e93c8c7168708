"""The cards: a pendulum, a bouncing ball, a chain of beads."""

from __future__ import annotations

import math

from game.physics.kernels import elementary
from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {
    "pendulum": CloseUp(shown_s=1.35, zoom=1.5, down=0.6),
    "bouncing-ball": CloseUp(shown_s=1.25, zoom=1.8, down=0.72),
    "spring-chain": CloseUp(zoom=1.1),
}


def draw_pendulum(pen: Pen) -> None:
    """A pendulum at the end of its swing, and where it was."""
    pen.fill("stage")
    pivot, length = (80.0, 12.0), 68.0
    for k, degrees in enumerate((-40.0, -22.0, 0.0, 22.0, 40.0)):
        turn = math.radians(degrees)
        mass = pivot[0] + length * elementary.sin(turn), pivot[1] + length * elementary.cos(turn)
        last = k == 4
        pen.line((pivot, mass), "text2" if last else "line2", 1.6 if last else 0.9)
        pen.disc(*mass, 7.5, "chalk" if last else "line2", ring=0.0 if last else 1.0)
    pen.disc(*pivot, 2.6, "text1")


def draw_bounces(pen: Pen) -> None:
    """The path of a ball, a little lower each time."""
    pen.fill("stage")
    ground, x, speed = 88.0, 14.0, 46.0
    pen.line(((0.0, ground + 5.0), (160.0, ground + 5.0)), "line2", 1.0)
    path = [(x + 0.35 * t, ground - 62.0 + 0.0325 * t * t) for t in range(44)]
    for _ in range(4):
        x0, speed = path[-1][0], 0.8 * speed
        flight = 2.0 * speed / 20.0
        path += [
            (x0 + 8.0 * t, ground - speed * t + 10.0 * t * t) for t in (flight * i / 24 for i in range(1, 25))
        ]
    pen.line(path, "text2", 1.1, dash=3.0)
    pen.disc(*path[56], 5.5, "chalk")
    for i in (30, 80):
        pen.disc(*path[i], 5.5, "line2", ring=1.0)


def draw_chain(pen: Pen) -> None:
    """Beads on springs, in two modes at once."""
    pen.fill("stage")
    beads = [
        (
            16.0 + 128.0 * j / 16,
            48.0 - 22.0 * elementary.sin(math.pi * j / 16) - 9.0 * elementary.sin(3.0 * math.pi * j / 16),
        )
        for j in range(17)
    ]
    pen.line(((16.0, 48.0), (144.0, 48.0)), "line2", 0.8, dash=3.0)
    pen.line(beads, "text2", 1.2)
    for bead in beads[1:-1]:
        pen.disc(*bead, 3.4, "chalk")
    for end in (16.0, 144.0):
        pen.line(((end, 34.0), (end, 62.0)), "text1", 2.0)
