"""How deep two shapes overlap: by translation alone, with rotation, and by brute force."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.kernels import elementwise
from game.physics.narrowphase.depth import search as searching
from game.physics.narrowphase.depth.grid import grid_search, overlap_of
from game.physics.narrowphase.depth.shape import Shape
from game.physics.narrowphase.depth.sums import Differences, Parts

Place = tuple[float, float, float]  # m, m, rad
SLACK = 1e-11  # of the reaches: so much overlap is rounding
MOST_INTERVALS = 8_192
TOLERANCE = 1e-3  # m


class Escape(NamedTuple):
    """A motion of A that leaves no common interior: turned by angle (rad) about its centroid, then moved by
    (x, y) m. sigma: its object norm, m; certain: no motion is shorter than that, m; evaluations: angles, or
    motions of a grid, that were tried."""

    sigma: float
    x: float
    y: float
    angle: float
    certain: float
    evaluations: int


class ShapePair:
    """Two shapes, each with the place of its centroid and an angle. ValueError unless these are finite."""

    def __init__(
        self, a: Shape, b: Shape, place_a: Place = (0.0, 0.0, 0.0), place_b: Place = (0.0, 0.0, 0.0)
    ):
        self.a, self.b = a, b
        edges = len(a) * len(b.corners) + len(b) * len(a.corners)
        count = len(a) * len(b)
        self._differences = Differences(
            np.zeros((edges, 3)), np.zeros(count + 1, dtype=np.int64), np.zeros(count)
        )
        self._rows = np.zeros((MOST_INTERVALS, searching.INTERVAL))
        self._count = 0
        self.place(place_a, place_b)

    def place(self, place_a: Place, place_b: Place) -> None:
        """Put both somewhere: centroid m, m and angle rad. ValueError unless finite."""
        if not all(math.isfinite(value) for value in (*place_a, *place_b)):
            raise ValueError(f"places: expected finite numbers, not {place_a}, {place_b}")
        self.place_a, self.place_b = place_a, place_b
        corners_a = np.concatenate(self.a.placed(0.0, 0.0, place_a[2]))
        corners_b = np.concatenate(
            self.b.placed(place_b[0] - place_a[0], place_b[1] - place_a[1], place_b[2])
        )
        self._a = Parts(corners_a, self.a.starts, self.a.reaches)
        self._b = Parts(corners_b, self.b.starts, self.b.reaches)
        self.slack = SLACK * (self.a.reach + self.b.reach)

    def _pair(self) -> tuple[Any, ...]:
        return self._a, self._b, self._differences, self.a.gyration, self.slack

    def moved(self, escape: Escape, part: float = 1.0) -> Place:
        """Where A is after that part of a motion."""
        x, y, angle = self.place_a
        return x + part * escape.x, y + part * escape.y, angle + part * escape.angle

    def overlap(self, x: float = 0.0, y: float = 0.0, angle: float = 0.0) -> float:
        """The deepest overlap (m) of two parts after a motion of A, by separating axes; at most 0: none."""
        return float(overlap_of(self._a, self._b, float(x), float(y), float(angle)))

    def translational(self) -> Escape:
        """The shortest displacement without turning, exact."""
        d, x, y = self.depths([0.0])[0].tolist()
        return Escape(d, x, y, 0.0, d, 1)

    def depths(self, angles: ArrayLike) -> Floats:
        """(n, 3) m: for A turned by each of angles (n,) rad, the least displacement, and that as (x, y)."""
        turned = np.ascontiguousarray(angles, dtype=np.float64)
        found = np.zeros((len(turned), 3))
        searching.sample_depths(self._pair(), turned, found)
        return found

    def sigmas(self, angles: ArrayLike) -> Floats:
        """(n,) m: the object norm of the shortest motion with each angle."""
        turns = 2.0 * self.a.gyration * elementwise.sin(0.5 * np.asarray(angles))
        return np.asarray(elementwise.hypot(self.depths(angles)[:, 0], turns))

    def generalised(self, tolerance: float = TOLERANCE) -> Escape:
        """The shortest motion by the object norm, to ``tolerance`` (m, at least 1e-9 of the shapes' reach).

        If `Escape.certain` is less than sigma by more, a gap fits at one single angle only, or there were too
        many intervals. ValueError for a tolerance that is not positive and finite.
        """
        if not 0.0 < tolerance < math.inf:
            raise ValueError(f"tolerance: expected a positive length, not {tolerance} m")
        answer = np.zeros(searching.ANSWER)
        finest = max(float(tolerance), 1e-9 * (self.a.reach + self.b.reach))
        searching.search(self._pair(), finest, self._rows, answer)
        self._count = int(answer[searching.INTERVALS])
        sigma, x, y, angle, certain, evaluations, _ = answer.tolist()
        return Escape(sigma, x, y, angle, certain, int(evaluations))

    @property
    def intervals(self) -> Floats:
        """(n, 5) those of the last search: middle, half the width (rad), sigma, bound (m), state."""
        return self._rows[: self._count]

    def by_grid(self, side: int = 41, turns: int = 41) -> Escape:
        """The shortest motion of a grid, ``side`` places each way and so many angles, rounded up to odd.

        It reaches as far as the translational depth goes. ValueError for fewer than 3 of either.
        """
        if min(side, turns) < 3:
            raise ValueError(f"grid: expected at least 3 places and 3 angles, not {side} and {turns}")
        reach = self.translational().sigma
        if reach == 0.0:
            return Escape(0.0, 0.0, 0.0, 0.0, 0.0, 1)
        answer = np.zeros(5)
        counts = (int(side) | 1, int(turns) | 1)
        grid_search(self._a, self._b, self.a.gyration, 1.000001 * reach, counts, self.slack, answer)
        sigma, x, y, angle, tested = answer.tolist()
        if not math.isfinite(sigma):  # no motion of the grid separates
            return self.translational()._replace(evaluations=int(tested))
        return Escape(sigma, x, y, angle, 0.0, int(tested))
