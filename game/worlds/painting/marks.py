"""Marks that teach: contacts and velocities."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.solids import SolidWorld
from game.physics.solids.arrays import state as s
from game.ui.canvas.canvas import Canvas


def draw_contacts(canvas: Canvas, world: SolidWorld, size: float) -> None:
    """Dots of ``size`` design px where solids touch."""
    points = contact_places(world)
    if len(points):
        canvas.discs(points, canvas.px(size), "amber")


def draw_velocities(canvas: Canvas, places: Floats, velocities: Floats, seconds: float, width: float) -> None:
    """From places (n, 2) m the ways of so many seconds."""
    if len(places):
        canvas.segments(places, places + seconds * velocities, "chalk", width)


def contact_places(world: SolidWorld) -> Floats:
    """Points (k, 2) m at which solids touch."""
    contacts, rows = world.contacts, world.bodies
    touching = contacts.marks[:, s.TOUCHING] == 1
    marks, manifolds = contacts.marks[touching], contacts.manifolds[touching]
    a = contacts.bodies[touching, 0]
    c, sine = rows.rotations[a, 0], rows.rotations[a, 1]
    found = [np.zeros((0, 2))]
    for k in range(2):
        here, at = marks[:, s.POINTS] > k, s.FIRST_POINT + k * s.POINT_WIDTH
        x, y = manifolds[here, at], manifolds[here, at + 1]
        cos, sin = c[here], sine[here]
        found.append(np.stack([cos * x - sin * y, sin * x + cos * y], axis=1) + rows.positions[a[here]])
    return np.concatenate(found)
