"""What is heard of steel balls: on steel, on wood, on rails; and how they roll on tracks."""

from __future__ import annotations

import numpy as np

from game.arrays import Flags, Floats
from game.physics.kernels import elementwise
from game.physics.solids import SolidWorld
from game.physics.solids.arrays.state import DISC, SEGMENT
from game.physics.solids.tracks import motion as m
from game.worlds.hearing import impacts
from game.worlds.rubbing import Rubbing, riding

STEEL, WOOD, RAIL = range(3)
LEAST = 0.15  # m/s of approach; what leans is silent
MOST = 32  # sounds that are remembered: the latest
REFERENCE = 0.25  # kg of a ball of 0.1 m; a heavier one sounds as this one that is faster


def impacts_now(world: SolidWorld, began: float, wooden: list[int]) -> Floats:
    """Contacts of solids that began in a step: (k, 4). wooden: bodies of wood."""
    found = impacts(world, LEAST)
    if not len(found.rows):
        return np.zeros((0, 4))
    of_wood = np.isin(found.bodies, wooden).any(axis=1)
    kinds = np.where((found.shapes == DISC).all(axis=1), STEEL, RAIL)
    neither = ((found.shapes != DISC) & (found.shapes != SEGMENT)).any(axis=1)
    return found.heard(began, np.where(of_wood | neither, WOOD, kinds), found.by_impulse(REFERENCE, 1.6))


def landings(before: Floats, rows: Floats, flew: Flags, fall: float, began: float) -> Floats:
    """Balls (x, y, vx, vy in four columns, before and after) that met a track in flight.

    fall: m/s that gravity has given them in the step.
    """
    jump = rows[:, 2:4] - before[:, 2:4]
    jump[:, 1] += fall
    loud = elementwise.hypot(jump[:, 0], jump[:, 1])
    met = np.flatnonzero(flew & (loud > LEAST))
    kinds = np.full(len(met), float(RAIL))
    return np.stack([np.full(len(met), began), kinds, loud[met], rows[met, 0]], axis=1)


def ridden(before: Floats, rows: Floats, rolls: Flags, fall: float, dt: float) -> Rubbing:
    """How balls (rows before and after a step of dt s) roll on tracks. rolls: which, at both ends of it.

    fall: m/s that gravity has given them in the step; what is more than that, the track has given.
    """
    given = rows[rolls, m.VX : m.VY + 1] - before[rolls, m.VX : m.VY + 1] + (0.0, fall)
    pushes = elementwise.hypot(given[:, 0], given[:, 1])
    now = rows[rolls]
    return riding(now[:, m.MASS], pushes, np.abs(now[:, m.SPEED]), now[:, m.X], dt)
