"""The checks of the bounding volumes: what is no point and no line is refused here, in one line."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.kernels import elementary

LARGEST = 1e100  # m; products of two such numbers are still far from overflow
SMALLEST = 1e-100  # m; below it, products of two such numbers come near the least that there is
MOST_POINTS = 1 << 20


def as_points(values: ArrayLike, name: str = "points") -> Floats:
    """Points as an (n, 2) array of their own, m; ValueError if there is none or one is no finite point.

    A coordinate below `SMALLEST` is 0: whether three points turn left could not be told from their products.
    """
    try:
        given = np.array(values, dtype=np.float64, order="C")
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected an (n, 2) array of numbers") from None
    if given.ndim != 2 or given.shape[1] != 2:
        raise ValueError(f"{name}: expected shape (n, 2), not {given.shape}")
    if not 1 <= len(given) <= MOST_POINTS:
        raise ValueError(f"{name}: expected 1 to {MOST_POINTS} points, not {len(given)}")
    bad = ~(np.abs(given) <= LARGEST).all(axis=1)
    if bad.any():
        i = int(bad.argmax())
        raise ValueError(f"{name}[{i}]: {given[i].tolist()} is not finite or beyond {LARGEST:g} m")
    given[np.abs(given) < SMALLEST] = 0.0
    return given + 0.0  # no negative zero


def as_step(step_degrees: float) -> float:
    """An angle step in degrees; ValueError unless above 0.001 and up to 90."""
    step = float(step_degrees)
    if not 1e-3 <= step <= 90.0:
        raise ValueError(f"step_degrees: expected 0.001 to 90, not {step_degrees!r}")
    return step


def as_vector(values: Any, name: str) -> tuple[float, float]:
    """Two finite numbers, m; ValueError, by this name, if they are not."""
    try:
        x, y = float(values[0]), float(values[1])
    except (TypeError, ValueError, IndexError):
        raise ValueError(f"{name}: expected two numbers, not {values!r}") from None
    if len(values) != 2 or not (abs(x) <= LARGEST and abs(y) <= LARGEST):
        raise ValueError(f"{name}: expected two numbers up to {LARGEST:g} m, not {values!r}")
    return x, y


def as_angle(angle: float, name: str) -> float:
    """A finite angle, rad; ValueError, by this name, if it is not."""
    if not math.isfinite(angle):
        raise ValueError(f"{name}: expected a finite angle, not {angle!r}")
    return float(angle)


def turns_of(step_degrees: float) -> Floats:
    """Directions (k, 2) from 0 to below 90 degrees, so many degrees apart: cosine and sine."""
    count = max(1, math.ceil(90.0 / step_degrees - 1e-9))
    return np.array(
        [
            (elementary.cos(a), elementary.sin(a))
            for a in (math.radians(i * step_degrees) for i in range(count))
        ]
    )
