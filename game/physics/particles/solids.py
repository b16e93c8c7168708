"""Round solids and the floor: where their surfaces are and how they move.

A solid is a row (centre x, y, radius, velocity x, y, restitution); the floor comes after the last of them.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.compiler.decorator import lean_kernel

X, Y, RADIUS, VELOCITY_X, VELOCITY_Y, RESTITUTION = range(6)
COLUMNS = 6
LARGEST = 1e6  # m; radii and coordinates above this lose millimetres of the root's accuracy


@lean_kernel
def surface(solids, j, floor, x, y, t):
    """Distance (m, negative inside) and outward normal (gap, nx, ny) of solid j as it is t (s) into the step.

    At the exact centre of a disc the normal is up.
    """
    if j == solids.shape[0]:
        return y - floor, 0.0, 1.0
    dx = x - (solids[j, 0] + t * solids[j, 3])
    dy = y - (solids[j, 1] + t * solids[j, 4])
    distance = math.sqrt(dx * dx + dy * dy)
    if distance < 1e-150:
        return -solids[j, 2], 0.0, 1.0
    return distance - solids[j, 2], dx / distance, dy / distance


@lean_kernel
def surface_velocity(solids, j):
    """Velocity (m/s) of solid j, 0 for the floor."""
    if j == solids.shape[0]:
        return 0.0, 0.0
    return solids[j, 3], solids[j, 4]


@lean_kernel
def sample_discs(points, solids, distances, normals, velocities):
    """Nearest surface of any disc to each point: written to ``distances``, ``normals``, ``velocities``."""
    for i in range(points.shape[0]):
        distances[i] = math.inf
        for j in range(solids.shape[0]):
            gap, nx, ny = surface(solids, j, 0.0, points[i, 0], points[i, 1], 0.0)
            if gap < distances[i]:
                distances[i] = gap
                normals[i, 0] = nx
                normals[i, 1] = ny
                velocities[i, 0] = solids[j, 3]
                velocities[i, 1] = solids[j, 4]


class Discs:
    """Round solids that can be put, moved and asked where their surface is.

    centres: (k, 2) m. radii: (k,) m, above 0. restitution: (k,) or one number, 0 to 1. Up to ``capacity`` of
    them. ``rows``: (k, COLUMNS), the array that kernels read; ``impulses``: (k, 2) N s for particles of
    1 kg, what the last step's particles gave to each. ValueError for what makes no sense.
    """

    def __init__(
        self,
        centres: ArrayLike = (),
        radii: ArrayLike = (),
        restitution: ArrayLike | float = 0.5,
        capacity: int = 64,
    ):
        places = np.asarray(centres, dtype=np.float64).reshape(-1, 2)
        sizes = np.asarray(radii, dtype=np.float64).reshape(-1)
        if len(places) != len(sizes):
            raise ValueError(f"radii: expected {len(places)}, one for each centre, got {len(sizes)}")
        bounce = np.broadcast_to(np.asarray(restitution, dtype=np.float64), sizes.shape)
        self.capacity = capacity
        self._store = np.zeros((capacity, COLUMNS))
        self._impulses = np.zeros((capacity, 2))
        self._rows, self._given = self._store[:0], self._impulses[:0]  # the same arrays as long as they fit
        self.count = 0
        for place, size, e in zip(places, sizes, bounce, strict=True):
            self.add(place, float(size), float(e))

    def __len__(self) -> int:
        return self.count

    @property
    def rows(self) -> NDArray[np.float64]:
        """The rows that kernels read, (n, columns); a view."""
        if len(self._rows) != self.count:
            self._rows = self._store[: self.count]
        return self._rows

    @property
    def impulses(self) -> NDArray[np.float64]:
        """What each disc was given, (n, 2) N s for particles of 1 kg; a view."""
        if len(self._given) != self.count:
            self._given = self._impulses[: self.count]
        return self._given

    @property
    def centres(self) -> NDArray[np.float64]:
        """Centres (n, 2) m; a view."""
        return self._store[: self.count, :2]

    @property
    def radii(self) -> NDArray[np.float64]:
        """Radii (n,) m; a view."""
        return self._store[: self.count, RADIUS]

    def add(self, centre: ArrayLike, radius: float, restitution: float = 0.5) -> int:
        """Put one more, its centre (2,) m, its radius m; returns its index.

        ValueError if there is no space or a number is absurd.
        """
        if self.count == self.capacity:
            raise ValueError(f"solids: at most {self.capacity}")
        row = np.zeros(COLUMNS)
        row[:2] = checked_point("centre", centre)
        row[RADIUS] = radius
        row[RESTITUTION] = restitution
        if not 0.0 < radius <= LARGEST:
            raise ValueError(f"radius = {radius!r}: expected a number above 0, at most {LARGEST:g} m")
        if not 0.0 <= restitution <= 1.0:
            raise ValueError(f"restitution = {restitution!r}: expected 0 to 1")
        self._store[self.count] = row
        self.count += 1
        return self.count - 1

    def remove(self, index: int) -> None:
        """Take one away; those after it move up. ValueError for a number that none has."""
        self._known(index)
        self._store[index : self.count - 1] = self._store[index + 1 : self.count]
        self.count -= 1

    def place(self, index: int, centre: ArrayLike) -> None:
        """Put one elsewhere (2,) m at once, without a velocity from that. ValueError as `add`, `remove`."""
        self._known(index)
        self._store[index, :2] = checked_point("centre", centre)

    def carry(self, index: int, velocity: ArrayLike) -> None:
        """Let one move with a velocity (2,) m/s during the coming steps. ValueError as `place`."""
        self._known(index)
        self._store[index, VELOCITY_X : VELOCITY_Y + 1] = checked_point("velocity", velocity)

    def _known(self, index: int) -> None:
        if not 0 <= index < self.count:
            raise ValueError(f"solid {index}: there are {self.count}")

    def move(self, dt: float) -> None:
        """Centres go on by their velocities over dt (s)."""
        self.rows[:, :2] += dt * self.rows[:, VELOCITY_X : VELOCITY_Y + 1]

    def restore(self, rows: NDArray[np.float64], impulses: NDArray[np.float64]) -> None:
        """Be the discs of these rows (n, COLUMNS) and impulses (n, 2) again."""
        self.count = len(rows)
        self.rows[:] = rows
        self.impulses[:] = impulses

    def sample(
        self, points: ArrayLike
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Distance (n,) m, outward normal (n, 2) and velocity (n, 2) m/s of the surface nearest to points.

        Negative inside; infinitely far, with a zero normal, if there are no discs.
        """
        places = np.ascontiguousarray(points, dtype=np.float64).reshape(-1, 2)
        distances = np.empty(len(places))
        normals = np.zeros((len(places), 2))
        velocities = np.zeros((len(places), 2))
        sample_discs(places, self.rows, distances, normals, velocities)
        return distances, normals, velocities


def checked_point(name: str, point: ArrayLike) -> NDArray[np.float64]:
    """Two finite numbers (2,) within the world, or ValueError."""
    pair = np.asarray(point, dtype=np.float64)
    if pair.shape != (2,) or not np.all(np.abs(pair) <= LARGEST):
        raise ValueError(f"{name} = {point!r}: expected two numbers up to {LARGEST:g}")
    return pair
