"""What a solid of any room answers to others: where its surface is, how it moves, and how it takes a push.

Rooms meet by arrays. SI units; distance is negative inside, the normal looks outward, room temperature is
293.15 K.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats

FAR = np.inf  # m: the distance where there is no solid at all
ROOM_TEMPERATURE = 293.15  # K


class Sample(NamedTuple):
    """What there is at points; arrays of n rows."""

    distance: Floats  # (n,) m, negative inside
    normal: Floats  # (n, 2) outward; zero if there is no solid
    velocity: Floats  # (n, 2) m/s of the surface
    friction: Floats  # (n,)
    temperature: Floats  # (n,) K
    body: NDArray[np.int64]  # (n,) which body it is, for push; -1 for none


class Surface(Protocol):
    """The surface between rooms."""

    def sample(self, points: ArrayLike) -> Sample:
        """Of the nearest surface at points (n, 2) m."""

    def inverse_mass(self, body: int) -> tuple[float, float, tuple[float, float]]:
        """1/m (1/kg), 1/I (1/(kg m²)) and centre (m) of a body; zeros for what nothing moves."""

    def held_up(self, bodies: NDArray[np.int64], dt: float) -> Floats:
        """(n, 3) N s, N s, N m s about its centre: what contacts give each of these bodies (n,) in a step of
        dt (s), as far as its room knows from the step before.
        """

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike, during: float = 0.0) -> None:
        """An impulse (2,) N s on a body at a point (2,) m.

        during: s of its room's next step, in which it comes evenly, where the room has parts of a step; 0 is
        at once.
        """

    def heat(self, body: int, joule: float) -> None:
        """Heat (J) into a body, or out of it if negative."""


def empty_sample(count: int) -> Sample:
    """Where there is nothing."""
    return Sample(
        np.full(count, FAR), np.zeros((count, 2)), np.zeros((count, 2)), np.zeros(count),
        np.full(count, ROOM_TEMPERATURE), np.full(count, -1, dtype=np.int64),
    )  # fmt: skip


def checked_places(points: ArrayLike) -> Floats:
    """Points (n, 2) as an array; ValueError for what is not finite or no points."""
    places = np.ascontiguousarray(points, dtype=np.float64)
    if places.ndim == 1 and places.size == 2:
        places = places.reshape(1, 2)
    if places.ndim != 2 or places.shape[1] != 2 or not np.isfinite(places).all():
        raise ValueError("points: expected finite points (n, 2)")
    return places


class Warmth:
    """Temperature of bodies, K, for rooms that have none of their own: heat over heat capacity.

    capacity: J/(kg K), of what all bodies are made of. Bodies of infinite mass keep their temperature.
    """

    def __init__(self, capacity: float = 900.0):
        if not 0.0 < capacity < np.inf:
            raise ValueError(f"capacity = {capacity!r}: expected a number above 0, J/(kg K)")
        self.capacity = capacity
        self.temperatures: dict[int, float] = {}

    def of(self, body: int) -> float:
        """Temperature of a body, K."""
        return self.temperatures.get(body, ROOM_TEMPERATURE)

    def add(self, body: int, joule: float, inverse_mass: float) -> None:
        """Heat (J) into a body. ValueError for what is not finite, or would cool it below 0 K."""
        if not np.isfinite(joule):
            raise ValueError(f"joule = {joule!r}: expected a finite number")
        after = self.of(body) + joule * inverse_mass / self.capacity
        if after <= 0.0:
            raise ValueError(f"joule = {joule!r}: body {body} would be at {after:g} K")
        self.temperatures[body] = after

    def array(self, bodies: NDArray[np.int64]) -> Floats:
        """Temperatures (n,) K of bodies (n,), room temperature for -1."""
        if not self.temperatures:
            return np.full(len(bodies), ROOM_TEMPERATURE)
        return np.array([self.of(int(body)) for body in bodies])
