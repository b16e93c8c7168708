"""What teaches: contacts, velocities, the front, and where the formula has each block stop."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.solids.arrays.state import ASLEEP, DYNAMIC
from game.scenes.domino.course import height_at
from game.scenes.domino.world import DominoWorld
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.worlds.painting.marks import draw_contacts, draw_velocities

SECONDS = 0.15  # s: a velocity is drawn as the way of this time
SLOW = 0.15  # m/s, no mark


def draw_marks(canvas: Canvas, model: DominoWorld, places: Floats) -> None:
    """All of them."""
    world = model.world
    draw_contacts(canvas, world, 2.2)
    rows = world.bodies
    awake = np.flatnonzero(rows.flags & (DYNAMIC | ASLEEP) == DYNAMIC)
    moving = awake[np.hypot(*rows.velocities[awake].T) > SLOW]
    draw_velocities(canvas, places[moving], rows.velocities[moving], SECONDS, 1.8)
    wave = model.dominoes.wave.speed
    if model.dominoes.last >= 0:
        x, y = model.front()
        canvas.line((x, y - 0.9), (x, y + 1.1), "vermilion", 1.4, dash=EXACT_DASH)
        if wave > 0.0:
            words = canvas.figure("wave", f"{wave:.2f} m/s, theory {model.theory():.2f}")
            canvas.label((x, y + 1.2), words, "vermilion", 13, "semibold", "bottom", (0.0, -4.0), clear=True)
    for k, entry in enumerate(model.content.sliders):
        stop = model.blocks.stop_by_law(k, model.gravity())
        if math.isfinite(stop):
            shift_x, shift_y = 0.12 * k, 0.17 * k
            y, _ = height_at(model.floors[entry.floor], stop)
            foot = stop + shift_x, y + shift_y
            canvas.line(foot, (foot[0], foot[1] + 0.8), "text1", 1.4, dash=EXACT_DASH)
