"""What leaves a room, as arrays that another room takes in: spray back into water, flakes to a heap."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats

EXIT_REASONS = ("hit", "crossed", "settled", "burnt", "evaporated")


class Exit(NamedTuple):
    """What left in a step, n rows."""

    reason: NDArray[np.int64]  # (n,) of EXIT_REASONS
    position: Floats  # (n, 2) m
    velocity: Floats  # (n, 2) m/s
    mass: Floats  # (n,) kg
    heat: Floats  # (n,) J
    time: Floats  # (n,) s since the step began
    body: NDArray[np.int64]  # (n,) body that was hit, -1 for none


class Exits:
    """Gathers what leaves until another room takes it."""

    def __init__(self) -> None:
        self._rows: list[tuple[object, ...]] = []

    def add(
        self, reason: str, position: ArrayLike, velocity: ArrayLike, mass: float, *, heat: float = 0.0,
        time: float = 0.0, body: int = -1,
    ) -> None:  # fmt: skip
        """One thing leaves. ValueError for an unknown reason, a negative mass, or what is not finite."""
        if reason not in EXIT_REASONS:
            raise ValueError(f"reason = {reason!r}: expected one of {', '.join(EXIT_REASONS)}")
        numbers = [*np.asarray(position, dtype=float), *np.asarray(velocity, dtype=float), mass, heat, time]
        if len(numbers) != 7 or not np.isfinite(numbers).all() or mass < 0.0:
            raise ValueError("exit: expected a place, a velocity, a mass from 0, heat and time, all finite")
        self._rows.append((EXIT_REASONS.index(reason), *numbers, body))

    def take(self) -> Exit:
        """All that left since the last time; afterwards there is none."""
        rows = np.array(self._rows, dtype=np.float64).reshape(-1, 9)
        self._rows = []
        return Exit(
            rows[:, 0].astype(np.int64), rows[:, 1:3].copy(), rows[:, 3:5].copy(), rows[:, 5].copy(),
            rows[:, 6].copy(), rows[:, 7].copy(), rows[:, 8].astype(np.int64),
        )  # fmt: skip
