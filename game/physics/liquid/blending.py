"""Runs of liquids between recorded ones (Raveendran, Wojtan, Thuerey and Turk 2014).

Each run is a signed distance in place and time. A deformation of place and time carries the surface of the
first onto that of another: each point goes towards the nearest whose normal is alike, and stays near its
neighbours. Between the runs, places are carried a part of the way, and there the distances are mixed. Without
the deformation, what does not overlap vanishes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid.deforming import corner, deform, match, place_samples, shift_of
from game.physics.liquid.distances import Run, lasting

MOST_SAMPLES = 1500  # of a surface
ROUNDS = 14  # of matching and deforming
STIFF, SOFTER = 30.0, 0.7  # of the deformation beside a sample at each node; its share from round to round
TURNED = 0.35  # m that normals at right angles count as
HINT = 1.0  # what a hint of the hand weighs, beside all samples of the first surface
INVERSIONS = 8  # turns in which a place's origin is found


class Alignment(NamedTuple):
    """shift: (lt, ly, lx, 3) m that the first run's place and time go, at nodes of a lattice over the run.

    pairs: (n, 6) matched points of both surfaces, m, as the last round had them.
    """

    shift: Floats
    pairs: Floats


@inner_kernel
def _shift_at(shift, t, y, x, ratio):
    """The deformation at a place in nodes of the run; ratio: nodes of the lattice for one of the run."""
    a, p = corner(t * ratio[0], shift.shape[0] - 1.0, shift.shape[0])
    b, q = corner(y * ratio[1], shift.shape[1] - 1.0, shift.shape[1])
    c, r = corner(x * ratio[2], shift.shape[2] - 1.0, shift.shape[2])
    found = (0.0, 0.0, 0.0)
    for m in range(8):
        i, j, k = m & 1, m >> 1 & 1, m >> 2
        part = (p if i else 1.0 - p) * (q if j else 1.0 - q) * (r if k else 1.0 - r)
        if part != 0.0:
            here = shift[
                min(a + i, shift.shape[0] - 1), min(b + j, shift.shape[1] - 1), min(c + k, shift.shape[2] - 1)
            ]
            found = (found[0] + part * here[0], found[1] + part * here[1], found[2] + part * here[2])
    return found


@inner_kernel
def _distance_at(distance, t, y, x):
    """A signed distance at a place in nodes; a node gives its own value to the last bit."""
    a, p = corner(t, distance.shape[0] - 1.0, distance.shape[0])
    b, q = corner(y, distance.shape[1] - 1.0, distance.shape[1])
    c, r = corner(x, distance.shape[2] - 1.0, distance.shape[2])
    total = 0.0
    for m in range(8):
        i, j, k = m & 1, m >> 1 & 1, m >> 2
        part = (p if i else 1.0 - p) * (q if j else 1.0 - q) * (r if k else 1.0 - r)
        if part != 0.0:
            total += part * distance[a + i, b + j, c + k]
    return total


@lean_kernel
def mix(distances, shifts, weights, frame, steps, mixed):
    """A picture (rows, columns) of signed distances m between runs, at a time in frames.

    distances: (runs, frames, rows, columns); shifts: (runs, lt, ly, lx, 3) m from the first run to each;
    weights: (runs,), of sum 1. A weight of 1 gives that run itself, to the last bit.
    """
    runs, shape = len(distances), distances.shape
    ratio = (
        (shifts.shape[1] - 1.0) / max(shape[1] - 1.0, 1.0),
        (shifts.shape[2] - 1.0) / max(shape[2] - 1.0, 1.0),
        (shifts.shape[3] - 1.0) / max(shape[3] - 1.0, 1.0),
    )
    for row in range(shape[2]):
        for column in range(shape[3]):
            t, y, x = frame, row * 1.0, column * 1.0
            gone = (0.0, 0.0, 0.0)
            for _ in range(INVERSIONS):
                gone = (0.0, 0.0, 0.0)
                for k in range(runs):
                    if weights[k] != 0.0:
                        own = _shift_at(shifts[k], t, y, x, ratio)
                        gone = (
                            gone[0] + weights[k] * own[0], gone[1] + weights[k] * own[1],
                            gone[2] + weights[k] * own[2],
                        )  # fmt: skip
                t, y, x = frame - gone[0] / steps[0], row - gone[1] / steps[1], column - gone[2] / steps[2]
            total = 0.0
            gone = (0.0, 0.0, 0.0)
            for k in range(runs):
                if weights[k] != 0.0:
                    own = _shift_at(shifts[k], t, y, x, ratio)
                    gone = (
                        gone[0] + weights[k] * own[0], gone[1] + weights[k] * own[1],
                        gone[2] + weights[k] * own[2],
                    )  # fmt: skip
            for k in range(runs):
                if weights[k] != 0.0:
                    own = _shift_at(shifts[k], t, y, x, ratio)
                    total += weights[k] * _distance_at(
                        distances[k],
                        frame + (own[0] - gone[0]) / steps[0],
                        row + (own[1] - gone[1]) / steps[1],
                        column + (own[2] - gone[2]) / steps[2],
                    )
            mixed[row, column] = total


def _thinned(run: Run) -> tuple[Floats, Floats]:
    """At most ``MOST_SAMPLES`` points of a surface, evenly among them, and normals."""
    every = max(1, math.ceil(len(run.points) / MOST_SAMPLES))
    return np.ascontiguousarray(run.points[::every]), np.ascontiguousarray(run.normals[::every])


def _lattice(run: Run, nodes: int) -> tuple[int, int, int]:
    """Nodes of the deformation's lattice along each axis, at most so many, no more than the run has."""
    lengths = run.steps * (np.array(run.distance.shape) - 1)
    pitch = max(float(np.max(lengths)) / (nodes - 1), 1e-12)
    found = [
        min(max(round(float(one) / pitch) + 1, 2), many)
        for one, many in zip(lengths, run.distance.shape, strict=True)
    ]
    return found[0], found[1], found[2]


def align(first: Run, other: Run, hints: Floats | None = None, nodes: int = 16) -> Alignment:
    """The deformation of place and time from the first run to another on nodes alike.

    hints: (n, 6) points of both (t, y, x, m) that belong together. Without a surface it is 0.
    ValueError for runs on different nodes.
    """
    if first.distance.shape[1:] != other.distance.shape[1:] or not np.array_equal(first.steps, other.steps):
        raise ValueError("runs: expected the same nodes and steps")
    hints = np.zeros((0, 6)) if hints is None else np.asarray(hints, dtype=np.float64).reshape(-1, 6)
    shape = _lattice(first, nodes)
    shift: Floats = np.zeros((shape[0] * shape[1] * shape[2], 3))
    if first.empty or other.empty:
        return Alignment(shift.reshape(*shape, 3), np.zeros((0, 6)))
    points, normals = _thinned(first)
    others, other_normals = _thinned(other)
    lengths = np.maximum(first.steps * (np.array(first.distance.shape) - 1), 1e-12)
    scale = (np.array(shape) - 1) / lengths
    moved, spare = np.zeros_like(points), np.zeros((4, len(shift)))
    there, back = np.zeros(len(points), dtype=np.int64), np.zeros(len(others), dtype=np.int64)
    own = _placed(points, scale, shape)
    stiff = STIFF * len(points) / len(shift)
    for _ in range(ROUNDS):
        shift_of(shift, *own, moved)
        carried = points + moved
        match(carried, normals, others, other_normals, TURNED, there)
        match(others, other_normals, carried, normals, TURNED, back)
        places = np.concatenate([points, points[back], hints[:, :3]])
        goals = np.concatenate([others[there] - points, others - points[back], hints[:, 3:] - hints[:, :3]])
        weights = np.concatenate(
            [np.ones(len(points) + len(others)), np.full(len(hints), HINT * len(points))]
        )
        deform((*_placed(places, scale, shape), weights), goals, shape, stiff, shift, spare)
        stiff *= SOFTER
    return Alignment(shift.reshape(*shape, 3), np.concatenate([points, others[there]], axis=1))


def _placed(points: Floats, scale: Floats, shape: tuple[int, int, int]) -> tuple[Longs, Floats]:
    nodes, shares = np.zeros((len(points), 8), dtype=np.int64), np.zeros((len(points), 8))
    place_samples(np.ascontiguousarray(points), scale, shape, nodes, shares)
    return nodes, shares


class Blend:
    """Runs between recorded ones. warning: what keeps them from being aligned, or ""."""

    def __init__(self, runs: Sequence[Run], hints: Sequence[Floats] = (), nodes: int = 16):
        """hints: for each run but the first, as `align` takes them. ValueError for fewer than two runs."""
        if len(runs) < 2:
            raise ValueError(f"runs: expected at least two, not {len(runs)}")
        frames = max(len(run.distance) for run in runs)
        self.runs = tuple(lasting(run, frames) for run in runs)
        self.steps, self.frames = self.runs[0].steps, frames
        self.warning = ""
        if any(run.empty for run in runs):
            self.warning = "A run has no surface: nothing can be aligned, and it vanishes in between."
        elif any(len(run.distance) != frames for run in runs):
            self.warning = "The runs are not equally long: the last picture of the shorter one stays."
        found = [
            align(self.runs[0], run, hints[k] if k < len(hints) else None, nodes)
            for k, run in enumerate(self.runs[1:])
        ]
        self.pairs = tuple(one.pairs for one in found)
        self.distances: Floats = np.stack([run.distance for run in self.runs])
        self.shifts: Floats = np.stack([np.zeros_like(found[0].shift), *(one.shift for one in found)])
        self._still: Floats = np.zeros((len(runs), 2, 2, 2, 3))

    def at(self, frame: float, weights: Sequence[float], aligned: bool = True) -> Floats:
        """(rows, columns) m, of a time in frames; not aligned: the plain mean of the distances.

        ValueError for weights that are not as many as the runs, or whose sum is not 1.
        """
        parts = np.array(weights, dtype=np.float64)
        if parts.shape != (len(self.runs),) or not abs(float(np.sum(parts)) - 1.0) < 1e-9:
            raise ValueError(f"weights = {weights!r}: expected {len(self.runs)} of sum 1")
        mixed: Floats = np.zeros(self.distances.shape[2:])
        shifts = self.shifts if aligned else self._still
        mix(self.distances, shifts, parts, float(frame), self.steps, mixed)
        return mixed
