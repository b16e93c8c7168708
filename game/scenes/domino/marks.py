"""What teaches: contacts, velocities, the front, and where the formula has each block stop."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.physics.dominoes import stopping_distance
from game.physics.solids.state import ASLEEP, DYNAMIC
from game.scenes.domino.course import height_at
from game.scenes.domino.model import DominoModel
from game.scenes.domino.tables import SLIDER_MU, SLIDER_SPEED, SLIDER_X
from game.ui.canvas.canvas import EXACT_DASH, Canvas
from game.worlds.members.touching import contact_places

Floats = NDArray[np.float64]
SECONDS = 0.15  # s: a velocity is drawn as the way of this time
SLOW = 0.15  # m/s, no mark


def stop_of(model: DominoModel, number: int) -> float:
    """Where (x, m) the formula has a block stop that has been measured; NaN before, and if it never does."""
    row, entry = model.sliders[number], model.content.sliders[number]
    if row[SLIDER_SPEED] < 0.0:
        return math.nan
    x = float(row[SLIDER_X])
    _, slope = height_at(model.floors[entry.floor], x + 0.01)
    way = stopping_distance(float(row[SLIDER_SPEED]), float(row[SLIDER_MU]), -slope, model.gravity())
    return x + way * math.cos(slope) if math.isfinite(way) else math.nan


def draw_marks(canvas: Canvas, model: DominoModel, places: Floats) -> None:
    """All of them."""
    world = model.world
    points = contact_places(world)
    if len(points):
        canvas.discs(points, canvas.px(2.2), "amber")
    rows = world.bodies
    awake = np.flatnonzero(rows.flags & (DYNAMIC | ASLEEP) == DYNAMIC)
    moving = awake[np.hypot(*rows.velocities[awake].T) > SLOW]
    if len(moving):
        canvas.segments(places[moving], places[moving] + SECONDS * rows.velocities[moving], "chalk", 1.8)
    if model.last >= 0:
        x, y = model.front()
        canvas.line((x, y - 0.9), (x, y + 1.1), "vermilion", 1.4, dash=EXACT_DASH)
        if model.wave > 0.0:
            words = canvas.figure("wave", f"{model.wave:.2f} m/s, theory {model.theory():.2f}")
            canvas.label((x, y + 1.2), words, "vermilion", 13, "semibold", "bottom", (0.0, -4.0), clear=True)
    for k, entry in enumerate(model.content.sliders):
        stop = stop_of(model, k)
        if math.isfinite(stop):
            shift_x, shift_y = 0.12 * k, 0.17 * k
            y, _ = height_at(model.floors[entry.floor], stop)
            foot = stop + shift_x, y + shift_y
            canvas.line(foot, (foot[0], foot[1] + 0.8), "text1", 1.4, dash=EXACT_DASH)
