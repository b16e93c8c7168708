"""Grains in a sound field: their laws, and a step of all of them.

A substep drifts half the way, kicks by the field at that moment with the drag before and after it, and drifts
on: second order in its length (Strang 1968). The drag is Stokes' with Schiller and Naumann's (1933) factor 1
+ 0.15 Re^0.687, with the rate taken at the speed halfway. It is applied exactly, so that no step is too long
for it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, kernel
from game.physics.acoustics.effects import CONTACTS_BIT, DRAG_BIT, GRAVITY_BIT, GROUND_BIT, SOUND_BIT
from game.physics.acoustics.field import Wave, aim, force_at
from game.physics.acoustics.paths import place_at
from game.physics.kernels import elementary

X, Y, VX, VY = range(4)
FIELDS = 4
BOUNCE = 0.3  # restitution of grains at walls and at each other
WAY, SPEED, FOCUS_X, FOCUS_Y = range(4)  # the focus: way along its figure (m), speed (m/s), place (m)
LED, FOLLOWS, STANDS = range(3)  # how the focus moves: along its figure, after the hand, not at all


class Air(NamedTuple):
    """What the grains fly in."""

    density: float  # kg/m³
    viscosity: float  # Pa s
    sound: float  # m/s


class Grain(NamedTuple):
    """A sphere: radius m, density kg/m³, speed of sound in it m/s."""

    radius: float
    density: float
    sound: float

    @property
    def volume(self) -> float:
        """m³."""
        return 4.0 / 3.0 * math.pi * (self.radius * self.radius * self.radius)

    @property
    def mass(self) -> float:
        """kg."""
        return self.volume * self.density

    def contrast(self, air: Air) -> tuple[float, float]:
        """f1 and f2 of Gor'kov's potential, without unit."""
        squeezed = air.density * (air.sound * air.sound) / (self.density * (self.sound * self.sound))
        heavier = self.density / air.density
        return 1.0 - squeezed, 2.0 * (heavier - 1.0) / (2.0 * heavier + 1.0)


class GrainState(NamedTuple):
    """fields: (4, n) place (m) and velocity (m/s); focus: (4,) see WAY; phases: (transducers,) rad."""

    fields: Floats
    focus: Floats
    phases: Floats


class Lead(NamedTuple):
    """How the focus moves in a step."""

    mode: int
    speed: float  # m/s that it comes to
    acceleration: float  # m/s²
    hand_x: float  # m, where the hand is
    hand_y: float


class Flight(NamedTuple):
    """What a step computes, and the laws of a grain."""

    mask: int
    substeps: int
    gravity: float  # m/s²
    mass: float  # kg
    radius: float  # m
    stokes: float  # 1/s, rate of Stokes' drag
    reynolds: float  # s/m, Reynolds number for a speed
    half: float  # m, half the space between the rows


@inner_kernel
def _drag(vx, vy, rate, reynolds, h):
    """The velocity after h (s) of drag, its rate taken at the speed half the way."""
    number = reynolds * math.sqrt(vx * vx + vy * vy)
    number *= elementary.exp(-0.5 * rate * (1.0 + 0.15 * elementary.pow(number, 0.687)) * h)
    left = elementary.exp(-rate * (1.0 + 0.15 * elementary.pow(number, 0.687)) * h)
    return vx * left, vy * left


@inner_kernel
def _lead(focus, lead, path, h):
    """Move the focus on by h (s)."""
    if lead.mode == LED:
        change = min(max(lead.speed - focus[SPEED], -lead.acceleration * h), lead.acceleration * h)
        focus[WAY] += (focus[SPEED] + 0.5 * change) * h
        focus[SPEED] += change
        focus[FOCUS_X], focus[FOCUS_Y] = place_at(path, focus[WAY])
    elif lead.mode == FOLLOWS:
        dx, dy = lead.hand_x - focus[FOCUS_X], lead.hand_y - focus[FOCUS_Y]
        far = math.sqrt(dx * dx + dy * dy)
        part = min(1.0, lead.speed * h / far) if far > 0.0 else 0.0
        focus[FOCUS_X] += part * dx
        focus[FOCUS_Y] += part * dy


@inner_kernel
def _stop_at_walls(fields, flight, i):
    """Below, above and beside are the rows: grains bounce off them a little and come to rest."""
    reach = flight.half - flight.radius
    for axis in range(2):
        if abs(fields[axis, i]) > reach:
            side = 1.0 if fields[axis, i] > 0.0 else -1.0
            fields[axis, i] = side * reach
            if side * fields[VX + axis, i] > 0.0:
                fields[VX + axis, i] *= -BOUNCE
                fields[VY - axis, i] *= 0.5


@inner_kernel
def _part_grains(fields, radius):
    """Push grains that overlap apart, and take most of the speed at which they close in."""
    count = fields.shape[1]
    for i in range(count):
        for j in range(i):
            dx, dy = fields[X, i] - fields[X, j], fields[Y, i] - fields[Y, j]
            squared = dx * dx + dy * dy
            if squared >= 4.0 * radius * radius:
                continue
            far = math.sqrt(squared)
            nx, ny = (dx / far, dy / far) if far > 0.0 else (1.0, 0.0)
            push = 0.5 * (2.0 * radius - far)
            fields[X, i] += push * nx
            fields[Y, i] += push * ny
            fields[X, j] -= push * nx
            fields[Y, j] -= push * ny
            closing = (fields[VX, i] - fields[VX, j]) * nx + (fields[VY, i] - fields[VY, j]) * ny
            if closing < 0.0:
                impulse = 0.5 * (1.0 + BOUNCE) * closing
                fields[VX, i] -= impulse * nx
                fields[VY, i] -= impulse * ny
                fields[VX, j] += impulse * nx
                fields[VY, j] += impulse * ny


@kernel
def advance(fields, focus, sources, offsets, path, wave, flight, lead, dt):
    """Go on by dt (s): the focus moves, the phases follow it in each substep, the grains fly."""
    h = dt / flight.substeps
    pull = flight.gravity if flight.mask & GRAVITY_BIT else 0.0
    for _ in range(flight.substeps):
        _lead(focus, lead, path, 0.5 * h)
        if lead.mode != STANDS:
            aim(sources, wave.number, focus[FOCUS_X], focus[FOCUS_Y], offsets)
        for i in range(fields.shape[1]):
            x, y = fields[X, i] + 0.5 * h * fields[VX, i], fields[Y, i] + 0.5 * h * fields[VY, i]
            vx, vy = fields[VX, i], fields[VY, i]
            fx, fy = force_at(sources, wave, x, y) if flight.mask & SOUND_BIT else (0.0, 0.0)
            if flight.mask & DRAG_BIT:
                vx, vy = _drag(vx, vy, flight.stokes, flight.reynolds, 0.5 * h)
            vx += h * fx / flight.mass
            vy += h * (fy / flight.mass - pull)
            if flight.mask & DRAG_BIT:
                vx, vy = _drag(vx, vy, flight.stokes, flight.reynolds, 0.5 * h)
            fields[X, i], fields[Y, i] = x + 0.5 * h * vx, y + 0.5 * h * vy
            fields[VX, i], fields[VY, i] = vx, vy
        _lead(focus, lead, path, 0.5 * h)
        if flight.mask & CONTACTS_BIT:
            _part_grains(fields, flight.radius)
        if flight.mask & GROUND_BIT:
            for i in range(fields.shape[1]):
                _stop_at_walls(fields, flight, i)


def wave_of(grain: Grain, air: Air, frequency: float, piston: float) -> Wave:
    """The field's numbers for a grain; frequency Hz, piston m (radius of a transducer)."""
    omega = 2.0 * math.pi * frequency
    f1, f2 = grain.contrast(air)
    return Wave(
        omega / air.sound,
        omega / air.sound * piston,
        grain.volume * f1 / (4.0 * air.density * (air.sound * air.sound)),
        3.0 * grain.volume * f2 / (8.0 * air.density * (omega * omega)),
    )


def escape_estimate(force: float, grain: Grain, air: Air) -> float:
    """The steady speed (m/s) at which the air's drag is as large as the strongest force (N) of a trap."""
    low, high = 0.0, 1e4
    for _ in range(80):
        middle = 0.5 * (low + high)
        number = 2.0 * grain.radius * air.density * middle / air.viscosity
        drag = (
            6.0
            * math.pi
            * air.viscosity
            * grain.radius
            * middle
            * (1.0 + 0.15 * elementary.pow(number, 0.687))
        )
        low, high = (middle, high) if drag < force else (low, middle)
    return low
