"""How the kinetic sweep is drawn: bounds of boxes, and the queue of what is to be looked at again."""

from __future__ import annotations

import numpy as np

from game.physics.broadphase import KineticSweep
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.ui.canvas.canvas import Canvas

MOST_DRAWN = 200  # bounds
STEPS_SHOWN = 64
TALLEST = 1.2  # m, of the queue's bars


def draw_bounds(canvas: Canvas, phase: KineticSweep) -> None:
    """The bounds of the first boxes, and a bar for each coming step: how many bounds are used up in it."""
    for box in phase.ids()[:MOST_DRAWN].tolist():
        corners = phase.polygon(box)
        if len(corners):
            corners = np.clip(corners, 0.0, (WIDTH, HEIGHT))
            canvas.polygon(corners, outline="chalk", width=1.0)
    coming = phase.coming_events()[:STEPS_SHOWN]
    most = max(int(coming.max(initial=0)), 1)
    width = WIDTH / STEPS_SHOWN
    for step in np.flatnonzero(coming).tolist():
        x = (step + 0.5) * width
        canvas.line((x, 0.0), (x, TALLEST * float(coming[step]) / most), "amber", 3.0)
