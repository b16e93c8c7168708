"""Round things of other rooms as surfaces: discs of particles, colliding spheres, billiard balls.

All are discs by arrays: centre, radius, velocity, spin and inverse mass of each. The room's own way to
take an impulse is given as a function.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.physics.kernels import elementwise
from game.physics.particles.solids import VELOCITY_X, VELOCITY_Y, Discs
from game.physics.spheres.spheres import SphereBodies
from game.physics.surfaces.surface import Sample, Warmth, checked_places, empty_sample


def sample_round(
    points: Floats, centres: Floats, radii: Floats, velocities: Floats, spins: Floats, friction: float
) -> Sample:
    """Of the nearest of discs: centres (m, 2), radii (m,), velocities (m, 2) m/s, spins (m,) rad/s."""
    found = empty_sample(len(points))
    if not len(centres) or not len(points):
        return found
    apart = points[:, None, :] - centres[None, :, :]
    lengths = elementwise.hypot(apart[..., 0], apart[..., 1])
    nearest = np.argmin(lengths - radii, axis=1)
    rows = np.arange(len(points))
    away, length = apart[rows, nearest], lengths[rows, nearest]
    found.distance[:] = length - radii[nearest]
    some = length > 0.0
    found.normal[some] = away[some] / length[some, None]
    found.normal[~some] = 0.0, 1.0
    turning = np.stack([-away[:, 1], away[:, 0]], axis=1)
    found.velocity[:] = velocities[nearest] + spins[nearest, None] * turning
    found.friction[:] = friction
    found.body[:] = nearest
    return found


class DiscSurface:
    """Discs that particles fall on. They are led, not pushed: their inverse mass is 0; what hits them is
    noted.
    """

    def __init__(self, discs: Discs, friction: float = 0.0, warmth: Warmth | None = None):
        self.discs, self.friction, self.warmth = discs, friction, warmth or Warmth()

    def sample(self, points: ArrayLike) -> Sample:
        """Of the nearest disc."""
        rows, places = self.discs.rows, checked_places(points)
        speeds = rows[:, VELOCITY_X : VELOCITY_Y + 1]
        found = sample_round(
            places, self.discs.centres, self.discs.radii, speeds, np.zeros(len(rows)), self.friction
        )
        return found._replace(temperature=self.warmth.array(found.body))

    def inverse_mass(self, body: int) -> tuple[float, float, tuple[float, float]]:
        """Zeros, and the centre."""
        self._known(body)
        x, y = self.discs.centres[body].tolist()
        return 0.0, 0.0, (x, y)

    def held_up(self, bodies: NDArray[np.int64], dt: float) -> Floats:
        """Not known: nothing."""
        return np.zeros((len(bodies), 3))

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike, during: float = 0.0) -> None:
        """The impulse is added to what the disc was given; it does not move."""
        self._known(body)
        self.discs.impulses[body] += np.asarray(impulse, dtype=np.float64)

    def heat(self, body: int, joule: float) -> None:
        """Nothing warms what has infinite mass."""
        self._known(body)
        self.warmth.add(body, joule, 0.0)

    def _known(self, body: int) -> None:
        if not 0 <= body < self.discs.count:
            raise ValueError(f"body {body!r}: there are {self.discs.count}")


class SphereSurface:
    """Single colliding spheres, seen in the plane z = 0."""

    def __init__(self, spheres: SphereBodies, friction: float = 0.0, warmth: Warmth | None = None):
        if not spheres.single:
            raise ValueError("spheres: bodies of several spheres have no surface in the plane")
        self.spheres, self.friction, self.warmth = spheres, friction, warmth or Warmth()

    def sample(self, points: ArrayLike) -> Sample:
        """Of the nearest sphere."""
        spheres = self.spheres
        found = sample_round(
            checked_places(points), spheres.state.positions[:, :2], spheres.composition.radii,
            spheres.velocities[:, :2], spheres.turning[:, 2], self.friction,
        )  # fmt: skip
        return found._replace(temperature=self.warmth.array(found.body))

    def inverse_mass(self, body: int) -> tuple[float, float, tuple[float, float]]:
        """1/m, 1/I about z, and the centre."""
        self._known(body)
        parts = self.spheres.composition
        x, y = self.spheres.state.positions[body, :2].tolist()
        mass = float(parts.masses[body])
        return (0.0 if np.isinf(mass) else 1.0 / mass), float(parts.inverse_inertias[body, 2]), (x, y)

    def held_up(self, bodies: NDArray[np.int64], dt: float) -> Floats:
        """Not known: nothing."""
        return np.zeros((len(bodies), 3))

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike, during: float = 0.0) -> None:
        """Linear and angular momentum change at once."""
        self._known(body)
        if np.isinf(self.spheres.composition.masses[body]):
            return
        state = self.spheres.state
        jx, jy = np.asarray(impulse, dtype=np.float64).tolist()
        x, y = (np.asarray(point, dtype=np.float64) - state.positions[body, :2]).tolist()
        state.momenta[body, :2] += jx, jy
        state.spins[body, 2] += x * jy - y * jx

    def heat(self, body: int, joule: float) -> None:
        """Heat J into a sphere."""
        self.warmth.add(body, joule, self.inverse_mass(body)[0])

    def _known(self, body: int) -> None:
        if not 0 <= body < self.spheres.count:
            raise ValueError(f"body {body!r}: there are {self.spheres.count}")


class BallSurface:
    """Balls of any other room (billiards), given by functions that read and push them.

    read: () -> centres (n, 2) m, velocities (n, 2) m/s. strike: (ball, impulse (2,) N s) -> None. mass kg
    and radius m are of each ball; spin about the vertical has no part in the plane of the table.
    """

    def __init__(
        self, read: Callable[[], tuple[Floats, Floats]], strike: Callable[[int, Floats], None], radius: float,
        mass: float, friction: float = 0.06,
    ):  # fmt: skip
        for name, value in (("radius", radius), ("mass", mass)):
            if not 0.0 < value < np.inf:
                raise ValueError(f"{name} = {value!r}: expected a number above 0")
        self.read, self.strike, self.radius, self.mass, self.friction = read, strike, radius, mass, friction
        self.warmth = Warmth()

    def sample(self, points: ArrayLike) -> Sample:
        """Of the nearest ball."""
        centres, velocities = self.read()
        n = len(centres)
        found = sample_round(
            checked_places(points), centres, np.full(n, self.radius), velocities, np.zeros(n), self.friction
        )
        return found._replace(temperature=self.warmth.array(found.body))

    def inverse_mass(self, body: int) -> tuple[float, float, tuple[float, float]]:
        """1/m, of a solid ball 1/I, and the centre."""
        x, y = self.read()[0][body].tolist()
        return 1.0 / self.mass, 2.5 / (self.mass * (self.radius * self.radius)), (x, y)

    def held_up(self, bodies: NDArray[np.int64], dt: float) -> Floats:
        """Not known: nothing."""
        return np.zeros((len(bodies), 3))

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike, during: float = 0.0) -> None:
        """The ball takes the impulse in its centre: it slides, and the cloth makes it roll."""
        self.strike(body, np.asarray(impulse, dtype=np.float64))

    def heat(self, body: int, joule: float) -> None:
        """Heat J into a ball."""
        self.warmth.add(body, joule, 1.0 / self.mass)
