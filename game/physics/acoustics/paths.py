"""Closed figures that the focus is led along, by their length."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary, elementwise

POINTS = 720
PLACE_X, PLACE_Y, WAY = range(3)


def _circle(t: Floats) -> tuple[Floats, Floats]:
    return elementwise.cos(t), elementwise.sin(t)


def _eight(t: Floats) -> tuple[Floats, Floats]:
    return elementwise.sin(t), elementwise.sin(t) * elementwise.cos(t)  # Gerono


def _heart(t: Floats) -> tuple[Floats, Floats]:
    x = 16.0 * elementary.cube(elementwise.sin(t))
    y = (
        13.0 * elementwise.cos(t)
        - 5.0 * elementwise.cos(2.0 * t)
        - 2.0 * elementwise.cos(3.0 * t)
        - elementwise.cos(4.0 * t)
    )
    return x / 17.0, (y + 2.5) / 17.0


def _line(t: Floats) -> tuple[Floats, Floats]:
    return elementwise.cos(t), np.zeros_like(t)


def _rose(t: Floats) -> tuple[Floats, Floats]:
    return elementwise.cos(1.5 * t) * elementwise.cos(0.5 * t), elementwise.cos(1.5 * t) * elementwise.sin(
        0.5 * t
    )  # three leaves


FIGURES: dict[str, Callable[[Floats], tuple[Floats, Floats]]] = {
    "circle": _circle, "eight": _eight, "heart": _heart, "line": _line, "rose": _rose,
}  # fmt: skip


def figure_path(figure: str, size: float) -> Floats:
    """A figure as (n, 3): places (m) and the way to each (m), closed; ``size`` is half its width, m.

    ValueError for another figure or a size that is not finite and above 0.
    """
    if figure not in FIGURES:
        raise ValueError(f"figure = {figure!r}: expected one of {', '.join(FIGURES)}")
    if not 0.0 < size < math.inf:
        raise ValueError(f"size = {size!r}: expected a finite number above 0 m")
    x, y = FIGURES[figure](np.linspace(0.0, 2.0 * math.pi, POINTS + 1))
    path = np.empty((POINTS + 1, 3))
    path[:, PLACE_X], path[:, PLACE_Y] = size * x, size * y
    path[:, WAY] = np.concatenate(
        [[0.0], np.cumsum(elementwise.hypot(np.diff(path[:, 0]), np.diff(path[:, 1])))]
    )
    return path


@inner_kernel
def place_at(path, way):
    """The place after a way (m) along a closed path, over and over."""
    last = path.shape[0] - 1
    total = path[last, WAY]
    rest = way - total * np.floor(way / total)
    low, high = 0, last
    while high - low > 1:
        middle = (low + high) // 2
        if path[middle, WAY] <= rest:
            low = middle
        else:
            high = middle
    part = (rest - path[low, WAY]) / (path[low + 1, WAY] - path[low, WAY])
    x = path[low, PLACE_X] + part * (path[low + 1, PLACE_X] - path[low, PLACE_X])
    y = path[low, PLACE_Y] + part * (path[low + 1, PLACE_Y] - path[low, PLACE_Y])
    return x, y
