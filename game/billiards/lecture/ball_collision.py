"""What one collision of the lecture's ball computed: kept whole, so that it can be drawn step by step."""

from __future__ import annotations

from typing import NamedTuple


class Parts(NamedTuple):
    """A velocity in the frame of the collision: along the line of centres, and across it."""

    normal: float
    tangential: float


class Collision(NamedTuple):
    """All that handle_collision computed, for drawing. Ball 1 is self, ball 2 the other.

    angle: of the line of centres, from ball 2 to ball 1, rad. contact: middle of the overlap. exchanged:
    False if the balls were separating already and only moved apart. Momenta and energies are sums of both.
    """

    rule: str
    distance: float
    overlap: float
    angle: float
    cosa: float
    sina: float
    contact: tuple[float, float]
    positions_before: tuple[tuple[float, float], tuple[float, float]]
    positions_after: tuple[tuple[float, float], tuple[float, float]]
    velocities_before: tuple[tuple[float, float], tuple[float, float]]
    velocities_after: tuple[tuple[float, float], tuple[float, float]]
    parts_before: tuple[Parts, Parts]
    parts_after: tuple[Parts, Parts]
    exchanged: bool
    momentum_before: tuple[float, float]
    momentum_after: tuple[float, float]
    energy_before: float
    energy_after: float


def in_collision_frame(velocity: tuple[float, float], cosa: float, sina: float) -> Parts:
    """A velocity turned by minus the angle of the line of centres, whose cosine and sine are given."""
    vx, vy = velocity
    return Parts(cosa * vx + sina * vy, cosa * vy - sina * vx)


def sum_of(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    """The sum of two vectors of the plane."""
    return a[0] + b[0], a[1] + b[1]
