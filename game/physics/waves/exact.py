"""Exact solutions of the equations of shallow water: broken dams, flow over a bump, a swinging bowl."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary


class DamBreak(NamedTuple):
    """What comes of a dam between still water of two depths (Stoker 1957).

    left, right: depths m, left the deeper; middle: depth between the wave that goes back and the bore, m;
    speed: of the water there; bore: of the bore, or of the front on a dry bed, m/s; gravity m/s².
    """

    left: float
    right: float
    middle: float
    speed: float
    bore: float
    gravity: float

    def at(self, x: Floats, t: float) -> tuple[Floats, Floats]:
        """Depths m and speeds m/s at places x (m from the dam), t (s, above 0) after it broke."""
        wave = math.sqrt(self.gravity * self.left)
        along = np.asarray(x, dtype=np.float64) / t
        fan = np.maximum(2.0 * wave - along, 0.0) / 3.0  # speed of waves in the fan
        depth, speed = fan * fan / self.gravity, 2.0 / 3.0 * (wave + along)
        tail = self.speed - math.sqrt(self.gravity * self.middle) if self.right > 0.0 else 2.0 * wave
        depth = np.where(along < -wave, self.left, np.where(along < tail, depth, self.middle))
        speed = np.where(along < -wave, 0.0, np.where(along < tail, speed, self.speed))
        ahead = along >= self.bore
        return np.where(ahead, self.right, depth), np.where(ahead, 0.0, speed)


def dam_break(left: float, right: float, gravity: float = 9.81) -> DamBreak:
    """A dam between depths left and right (m); on a dry bed Ritter's (1892).

    ValueError unless left > right >= 0.
    """
    if not 0.0 <= right < left < math.inf or gravity <= 0.0:
        raise ValueError(f"left, right = {left!r}, {right!r}: expected left > right >= 0, and gravity")
    wave = math.sqrt(gravity * left)
    if right == 0.0:
        return DamBreak(left, 0.0, 0.0, 2.0 * wave, 2.0 * wave, gravity)

    def excess(h: float) -> float:
        behind = 2.0 * (wave - math.sqrt(gravity * h))
        return behind - (h - right) * math.sqrt(0.5 * gravity * (h + right) / (h * right))

    low, high = right, left
    for _ in range(200):
        middle = 0.5 * (low + high)
        if excess(middle) > 0.0:
            low = middle
        else:
            high = middle
    middle = 0.5 * (low + high)
    speed = 2.0 * (wave - math.sqrt(gravity * middle))
    return DamBreak(left, right, middle, speed, middle * speed / (middle - right), gravity)


def critical_depth(discharge: float, gravity: float = 9.81) -> float:
    """Depth (m) at which water of a discharge (m²/s) runs as fast as its waves."""
    return elementary.cbrt(discharge * discharge / gravity)


def bernoulli_depth(head: float, discharge: float, gravity: float = 9.81, fast: bool = False) -> float:
    """Depth (m) at which h + q²/(2 g h²) is ``head`` (m): the slow flow, or the fast one.

    ValueError if there is none.
    """
    critical = critical_depth(discharge, gravity)
    if head < 1.5 * critical * (1.0 - 1e-12):
        raise ValueError(f"head = {head!r}: less than {1.5 * critical:g} m, the least of this discharge")
    low, high = (1e-12, critical) if fast else (critical, head)
    for _ in range(200):
        h = 0.5 * (low + high)
        above = h + discharge * discharge / (2.0 * gravity * h * h) > head
        if above != fast:
            high = h
        else:
            low = h
    return 0.5 * (low + high)


def conjugate_depth(depth: float, discharge: float, gravity: float = 9.81) -> float:
    """Depth (m) behind a standing jump of water that comes ``depth`` (m) deep (Bélanger 1841)."""
    froude2 = discharge * discharge / (gravity * depth * depth * depth)
    return 0.5 * depth * (math.sqrt(1.0 + 8.0 * froude2) - 1.0)


class Bowl(NamedTuple):
    """Water that swings with a plane surface in a parabolic trough z = depth (x/half)² (Thacker 1981).

    depth: of the water at rest, in the middle; half: of the width of its surface at rest; swing: how far its
    middle goes to one side; all m. The shores are at the middle plus and minus ``half``.
    """

    depth: float
    half: float
    swing: float
    gravity: float = 9.81

    @property
    def rate(self) -> float:
        """rad/s."""
        return math.sqrt(2.0 * self.gravity * self.depth) / self.half

    def bed(self, x: Floats) -> Floats:
        """Heights (m) of the trough."""
        return self.depth * elementary.square(x / self.half)

    def at(self, x: Floats, t: float) -> tuple[Floats, float]:
        """Depths (m) at places x, and the speed (m/s) of all water, at a time (s)."""
        middle = self.swing * elementary.cos(self.rate * t)
        level = self.depth + self.depth * middle / (self.half * self.half) * (2.0 * x - middle)
        speed = -self.swing * self.rate * elementary.sin(self.rate * t)
        return np.maximum(level - self.bed(x), 0.0), speed
