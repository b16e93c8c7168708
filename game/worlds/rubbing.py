"""What rolls and slides in a world of solids, as a microphone hears it: by normal force and speed."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.solids import SolidWorld
from game.physics.solids.arrays import state as s
from game.stage import Steady

QUIETEST = 0.02  # m/s; what creeps is silent
LOUDEST = 0.5  # level at the reference and above
BRIGHTEST = 4.0  # m/s, from which on nothing sounds brighter


class Rubbing(NamedTuple):
    """One of rolling and sliding: power W (sum of normal force times speed), mean speed m/s, mean place m."""

    power: float
    speed: float
    x: float

    def heard(self, kind: str, reference: float, half: float, middle: float) -> list[Steady]:
        """As a sound of a kind (of `ui.steady`): loudest at ``reference`` W and above, as its root below."""
        level = LOUDEST * math.sqrt(min(self.power / reference, 1.0))
        pan = max(-1.0, min(1.0, (self.x - middle) / half))
        return [Steady(kind, level, min(self.speed / BRIGHTEST, 1.0), pan)] if level > 0.0 else []

    def along_with(self, other: Rubbing) -> Rubbing:
        """Both at once: speeds are weighed by normal force, places by power."""
        powers = self.power, other.power
        if not min(powers) > 0.0:
            return self if powers[0] > 0.0 else other
        power = powers[0] + powers[1]
        pressed = powers[0] / self.speed + powers[1] / other.speed
        return Rubbing(power, power / pressed, (powers[0] * self.x + powers[1] * other.x) / power)


def riding(masses: Floats, pushes: Floats, speeds: Floats, xs: Floats, dt: float) -> Rubbing:
    """Rolling of balls on tracks. pushes: m/s that the track has given each in a step of dt (s), all (n,).

    speeds: m/s along the track; xs: m; masses: kg.
    """
    return _summed(masses * pushes / dt, speeds, xs)


def rubbing_heard(
    world: SolidWorld, dt: float, reference: float, half: float, middle: float, ridden: Rubbing | None = None
) -> list[Steady]:
    """Rolling and sliding at the end of a step of dt (s); see `Rubbing.heard`. ridden: rolling on tracks."""
    rolling, sliding = rubbing(world, dt / world.settings.substeps)
    rolling = rolling.along_with(ridden or SILENT)
    return [
        *rolling.heard("rolling", reference, half, middle), *sliding.heard("sliding", reference, half, middle)
    ]  # fmt: skip


SILENT = Rubbing(0.0, 0.0, 0.0)


def rubbing(world: SolidWorld, substep: float) -> tuple[Rubbing, Rubbing]:
    """Rolling and sliding of the last substep, whose length is ``substep`` s.

    A contact slides with the difference of both bodies' velocities along the surface. A disc rolls with its
    spin, relative to the other body, times its radius.
    """
    contacts, rows = world.contacts, world.bodies
    count = int(contacts.count[0])
    touching = np.flatnonzero(contacts.marks[:count, s.TOUCHING] == 1)
    if not len(touching) or substep <= 0.0:
        return SILENT, SILENT
    marks, manifolds = contacts.marks[touching], contacts.manifolds[touching]
    a, b = contacts.bodies[touching].T
    cos, sin = rows.rotations[a].T
    nx, ny = manifolds[:, s.NORMAL_X], manifolds[:, s.NORMAL_Y]
    tangents = np.stack([-(sin * nx + cos * ny), cos * nx - sin * ny], axis=1)
    discs = world.shapes.kinds[contacts.shapes[touching]] == s.DISC
    radii = np.where(discs, world.shapes.radii[contacts.shapes[touching]], 0.0).max(axis=1)
    turning = np.abs(rows.spins[a] - rows.spins[b])
    forces, slides, rolls, xs = [], [], [], []
    for k in range(2):
        at = s.FIRST_POINT + k * s.POINT_WIDTH
        x, y = manifolds[:, at + s.IN_A_X], manifolds[:, at + s.IN_A_Y]
        places = np.stack([cos * x - sin * y, sin * x + cos * y], axis=1) + rows.positions[a]
        apart = _velocities(rows, a, places) - _velocities(rows, b, places)
        used = marks[:, s.POINTS] > k
        forces.append(np.where(used, manifolds[:, at + s.NORMAL_IMPULSE], 0.0) / substep)
        slides.append(np.abs((apart * tangents).sum(axis=1)))
        rolls.append(turning * radii)
        xs.append(places[:, 0])
    force, place = np.concatenate(forces), np.concatenate(xs)
    return (
        _summed(force, np.concatenate(rolls), place),
        _summed(force, np.concatenate(slides), place),
    )


def _velocities(rows: s.Bodies, bodies: Floats, places: Floats) -> Floats:
    """Of points (k, 2) m that bodies carry along, (k, 2) m/s."""
    away, spins = places - rows.positions[bodies], rows.spins[bodies]
    return rows.velocities[bodies] + np.stack([-spins * away[:, 1], spins * away[:, 0]], axis=1)


def _summed(force: Floats, speed: Floats, place: Floats) -> Rubbing:
    """Of contacts by normal force N, speed m/s and place m."""
    powers = np.where(speed > QUIETEST, force * speed, 0.0)
    power = float(powers.sum())
    if not power > 0.0:
        return SILENT
    pressed = float(force[powers > 0.0].sum())
    return Rubbing(power, power / pressed, float((powers * place).sum() / power))
