"""Where particles live: a ring in the order of birth, one row for each quantity.

A birth takes the place behind the youngest, a death frees that of the oldest; nothing is ever moved.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.particles import encounters
from game.physics.particles.births import IDENTITY_STEP
from game.physics.particles.solids import LARGEST

MAX_CAPACITY = 4_000_000
PADDING = 72  # numbers between the rows, so that equal indices do not fall on one set of a cache
BY_HAND = 1 << 12  # stands for the emitter in the identity of particles that were put by hand


class Pool:
    """Places for ``capacity`` particles; ValueError unless that is 1 to MAX_CAPACITY.

    fields: (5, n) x, y (m), vx, vy (m/s), instant of birth (s). tags: (2, n) identity; number of the step,
    from 1, of the last touch, negative for the floor, or 0. tallies: counters, see encounters. time_s: kept
    by the system.
    """

    time_s: float

    def __init__(self, capacity: int):
        if isinstance(capacity, bool) or not isinstance(capacity, int) or not 1 <= capacity <= MAX_CAPACITY:
            raise ValueError(f"capacity = {capacity!r}: expected 1 to {MAX_CAPACITY}")
        self.capacity = capacity
        self.fields = np.zeros((5, capacity + PADDING))
        self.tags = np.zeros((2, capacity), dtype=np.int64)
        self.tallies = np.zeros(encounters.TALLIES, dtype=np.int64)

    def __len__(self) -> int:
        return int(self.tallies[encounters.COUNT])

    @property
    def born(self) -> int:
        """Particles ever born."""
        return int(self.tallies[encounters.BORN])

    @property
    def died(self) -> int:
        """Particles ever dead of age."""
        return int(self.tallies[encounters.DIED])

    @property
    def dropped(self) -> int:
        """Births for which there was no place."""
        return int(self.tallies[encounters.DROPPED])

    @property
    def impacts(self) -> int:
        """Flights of a step with an impact, ever."""
        return int(self.tallies[encounters.IMPACTS])

    @property
    def cut_short(self) -> int:
        """Flights in which a step's greatest number of contacts was reached, and the time left dropped."""
        return int(self.tallies[encounters.CUT_SHORT])

    @property
    def unreported(self) -> int:
        """Reports for which there was no line."""
        return int(self.tallies[encounters.UNREPORTED])

    def segments(self) -> tuple[tuple[int, int], ...]:
        """Places that are taken, as one or two ranges, the oldest particle first."""
        head = int(self.tallies[encounters.HEAD])
        end = head + len(self)
        if end <= self.capacity:
            return ((head, end),)
        return ((head, self.capacity), (0, end - self.capacity))

    def living(self, rows: NDArray) -> NDArray:
        """The part of rows (..., n) that is taken, the oldest first; a view if it is one piece."""
        parts = [rows[..., low:high] for low, high in self.segments()]
        return parts[0] if len(parts) == 1 else np.concatenate(parts, axis=-1)

    @property
    def positions(self) -> NDArray[np.float64]:
        """(n, 2) m, a copy; the oldest particle first."""
        return np.array(self.living(self.fields[:2]).T, order="C")

    @property
    def velocities(self) -> NDArray[np.float64]:
        """(n, 2) m/s, a copy."""
        return np.array(self.living(self.fields[2:4]).T, order="C")

    @property
    def ages(self) -> NDArray[np.float64]:
        """(n,) s."""
        return self.time_s - self.living(self.fields[4])

    @property
    def identities(self) -> NDArray[np.int64]:
        """(n,): emitter * IDENTITY_STEP + serial number, BY_HAND for the emitter of those put by hand."""
        return np.array(self.living(self.tags[0]))

    def add(self, positions: ArrayLike, velocities: ArrayLike) -> None:
        """Put particles (n, 2) m, (n, 2) m/s that are born now; what has no place is dropped and counted.

        ValueError unless there are as many velocities, all finite and within the world.
        """
        places = _pairs("positions", positions)
        speeds = _pairs("velocities", velocities)
        if places.shape != speeds.shape:
            raise ValueError(f"velocities: expected {len(places)} pairs, got {len(speeds)}")
        count = min(len(places), self.capacity - len(self))
        slots = (int(self.tallies[encounters.HEAD]) + len(self) + np.arange(count)) % self.capacity
        self.fields[0:2, slots] = places[:count].T
        self.fields[2:4, slots] = speeds[:count].T
        self.fields[4, slots] = self.time_s
        self.tags[0, slots] = BY_HAND * IDENTITY_STEP + self.born + np.arange(count)
        self.tags[1, slots] = 0
        self.tallies[encounters.COUNT] += count
        self.tallies[encounters.BORN] += count
        self.tallies[encounters.DROPPED] += len(places) - count

    def clear(self) -> None:
        """Let all die now."""
        self.tallies[encounters.DIED] += self.tallies[encounters.COUNT]
        self.tallies[encounters.COUNT] = 0

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        assert 0 <= len(self) <= self.capacity, "count"
        assert 0 <= self.tallies[encounters.HEAD] < self.capacity, "head"
        assert self.born == self.died + len(self), "born = died + alive"
        assert np.all(np.diff(self.living(self.fields[4])) >= 0.0), "in the order of birth"
        assert np.all(np.isfinite(self.living(self.fields))), "finite"


def _pairs(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """(n, 2) finite numbers within the world, or ValueError."""
    pairs = np.array(values, dtype=np.float64).reshape(-1, 2)
    if not np.all(np.abs(pairs) <= LARGEST):
        raise ValueError(f"{name}: expected finite numbers up to {LARGEST:g}")
    return pairs
