"""Boxes to try a broad phase on: alike, of very unlike sizes, in a heap, on a line, on a lattice."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise

WORKLOADS = ("equal", "heavy-tail", "power-law", "clustered", "line", "lattice", "teleport")
MEAN_COSINE_DIFFERENCE = 8.0 / (math.pi * math.pi)  # E|cos a - cos b| of independent uniform directions


class MovingBoxes(NamedTuple):
    """Boxes with velocities, (n, 2) each: centres and half sizes in m, velocities in m/s."""

    centers: Floats
    half_sizes: Floats
    velocities: Floats

    @property
    def lowers(self) -> Floats:
        """Lower corners, m."""
        return self.centers - self.half_sizes

    @property
    def uppers(self) -> Floats:
        """Upper corners, m."""
        return self.centers + self.half_sizes


def make_boxes(
    kind: str,
    count: int,
    generator: np.random.Generator,
    extent: tuple[float, float] = (1.0, 1.0),
    fill: float = 0.375,
    speed: float = 0.02,
    ratio: float = 20.0,
    share: float = 0.01,
) -> MovingBoxes:
    """Random square boxes within 0 .. ``extent``, m, of one of the kinds in ``WORKLOADS``.

    ``fill``: a quarter of the mean number of boxes that a box overlaps when centres are uniform. For equal
    boxes, that is the area of all boxes over that of the world. ``speed``: m/s, the same for all, in random
    directions. ``ratio``, ``share``: of heavy-tail, which has two sizes, how many times larger the large
    boxes are, and which part of all boxes they are. The sizes of power-law have a true heavy tail: boxes
    larger than s are in proportion to 1 / s (Pareto's law), up to ``ratio`` times the least size. Teleporting
    boxes are equal ones; that they jump is up to the caller. ValueError for another kind or numbers that make
    no boxes.
    """
    if kind not in WORKLOADS:
        raise ValueError(f"kind = {kind!r}: expected one of {', '.join(WORKLOADS)}")
    width, height = extent
    for name, value in (("fill", fill), ("width", width), ("height", height), ("ratio", ratio)):
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"{name} = {value!r}: expected a finite number above 0")
    if not (count >= 0 and 0.0 <= share <= 1.0 and math.isfinite(speed) and speed >= 0.0):
        raise ValueError(f"count = {count!r}, share = {share!r}, speed = {speed!r}: no such boxes")
    sizes = np.ones(count)
    if kind == "heavy-tail":
        sizes[: round(share * count)] = ratio
    elif kind == "power-law":
        sizes = _pareto_sizes(count, generator, ratio)
    if count:
        # mean overlaps of a box = n E[(s_i + s_j)^2] / area, which is to be 4 fill
        mean_square = 2.0 * float(np.mean(sizes * sizes)) + 2.0 * elementary.square(float(np.mean(sizes)))
        sizes *= math.sqrt(4.0 * fill * width * height / (count * mean_square))
    sizes = np.minimum(sizes, min(width, height))
    centers = _places(kind, count, generator, width, height)
    half_sizes = np.repeat(sizes[:, None] / 2.0, 2, axis=1)
    centers = np.clip(centers, half_sizes, np.array([width, height]) - half_sizes)
    angles = generator.random(count) * 2.0 * math.pi
    velocities = speed * np.stack([elementwise.cos(angles), elementwise.sin(angles)], axis=1)
    return MovingBoxes(centers, half_sizes, velocities)


def _pareto_sizes(count: int, generator: np.random.Generator, ratio: float) -> NDArray[np.float64]:
    """Sizes from 1 to ``ratio`` with P(size > s) = (1/s - 1/ratio) / (1 - 1/ratio), largest first."""
    least = 1.0 / ratio
    return np.sort(1.0 / (least + (1.0 - least) * generator.random(count)))[::-1].copy()


def _places(kind: str, count: int, generator: np.random.Generator, width: float, height: float) -> Floats:
    """Centres of the boxes, (n, 2) m."""
    places = generator.random((count, 2)) * (width, height)
    if kind == "clustered":
        heaps = generator.random((5, 2)) * (0.7 * width, 0.7 * height) + (0.15 * width, 0.15 * height)
        spread = 0.05 * min(width, height)
        places = heaps[generator.integers(0, 5, count)] + spread * generator.standard_normal((count, 2))
    elif kind == "line":
        places[:, 1] = height / 2.0
    elif kind == "lattice":
        columns = max(math.ceil(math.sqrt(count * width / height)), 1)
        rows = max(math.ceil(count / columns), 1)
        number = np.arange(count)
        places = np.stack(
            [(number % columns + 0.5) / columns * width, (number // columns + 0.5) / rows * height], 1
        )
    return places


def expected_pairs(count: int, size: float, extent: tuple[float, float] = (1.0, 1.0)) -> float:
    """Mean number of overlapping pairs of equal square boxes placed uniformly inside the world.

    n (n - 1) / 2 p, with p = (2 s L - s^2) / L^2 on each axis and L = extent - s: the chance that two
    uniform intervals of length s overlap.
    """
    chance = 1.0
    for length in extent:
        free = length - size
        chance *= (2.0 * size * free - size * size) / (free * free)
    return count * (count - 1) / 2.0 * chance


def expected_swaps(count: int, step: float, extent: tuple[float, float] = (1.0, 1.0)) -> float:
    """Mean swaps of sweep and prune, both axes, when boxes move ``step`` metres in random directions.

    Of the four pairs of end points of two boxes each swaps with chance |u_a - u_b| / W on an axis of length
    W: n^2 / 2 times 4 (8 / pi^2) step (1 / W + 1 / H).
    """
    return 2.0 * count * count * MEAN_COSINE_DIFFERENCE * step * (1.0 / extent[0] + 1.0 / extent[1])
