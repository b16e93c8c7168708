"""Recorded runs, what lies between them, and links of the hand that tell which points belong together."""

from __future__ import annotations

import math
from collections.abc import Sequence
from time import perf_counter
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.liquid.blending import Blend
from game.physics.liquid.distances import Run, area_of, lasting
from game.scenes.blend.level import GAP, MOST_LINKS, BlendContent, RunEntry
from game.scenes.blend.parameters import BlendParameters
from game.scenes.blend.recording import FRAME, between, recorded, speed_of_time
from game.worlds.world import Kept, World


class BlendState(NamedTuple):
    """clock: (1,) s of the runs; links: (n, 7): number of the other run, then both points (t, y, x) m."""

    clock: Floats
    links: Floats


class Shown(NamedTuple):
    """A place of the square that is compared with a true run. weights: of the recorded ones; blended, true:
    (frames, rows, columns) m; area, misplaced: shares of the true run's area, means over the run.
    """

    across: float
    up: float
    weights: tuple[float, ...]
    entry: RunEntry
    blended: Floats
    true: Floats
    area: float
    misplaced: float


def _links(content: BlendContent) -> Floats:
    """(n, 7) as in the state. ValueError for a link to a run that is not there."""
    if any(one.run > len(content.runs) for one in content.links):
        raise ValueError(f"links.run: expected at most {len(content.runs)}, the number of runs")
    speed = speed_of_time(content.tank)
    rows = [
        (
            one.run - 1,
            speed * one.first[0],
            one.first[2],
            one.first[1],
            speed * one.other[0],
            one.other[2],
            one.other[1],
        )
        for one in content.links
    ]
    return np.array(rows, dtype=np.float64).reshape(-1, 7)


class BlendWorld(World):
    """The runs of a level. blend: what lies between; squares: compared with true runs; prepared: s."""

    state_type = BlendState

    def __init__(self, content: BlendContent, parameters: BlendParameters, active: EffectSet, seed: int):
        if len(content.runs) not in (2, 4):
            raise ValueError(f"runs: expected two or four, not {len(content.runs)}")
        self.clock: Floats = np.zeros(1)
        self.links: Floats = _links(content)
        super().__init__(content, parameters, active, Kept(self, "clock", "links"))
        began = perf_counter()
        self.runs = [recorded(entry, content.tank, content.cells) for entry in content.runs]
        self.recorded = perf_counter() - began
        self.cell = float(self.runs[0].steps[2])
        self._align()

    def _align(self) -> None:
        """Find the deformations with the links that there are, and compare."""
        began = perf_counter()
        hints = [self.links[self.links[:, 0] == k][:, 1:] for k in range(1, len(self.runs))]
        self.blend = Blend(self.runs, hints, int(self.parameters.nodes))
        self.prepared = perf_counter() - began
        self._aligned = self.links.copy()
        self.squares = [self._compare(across, up) for up in self._parts()[1] for across in self._parts()[0]]

    def _parts(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        thirds = (0.0, 0.5, 1.0)
        return thirds, thirds if len(self.runs) == 4 else (0.0,)

    def weights(self, across: float, up: float) -> tuple[float, ...]:
        """Of the recorded runs; of four, bilinear."""
        row = (1.0 - across, across)
        if len(self.runs) == 2:
            return row
        return tuple(v * u for v in (1.0 - up, up) for u in row)

    def _compare(self, across: float, up: float) -> Shown:
        weights, blend = self.weights(across, up), self.blend
        entry = between(self.content.runs, weights)
        true = lasting(self._true(entry, weights), blend.frames).distance[: blend.frames]
        blended = np.stack([blend.at(frame, weights) for frame in range(blend.frames)])
        inside = self.dry(entry)
        size, off, apart = 0.0, 0.0, 0.0
        for ours, theirs in zip(blended, true, strict=False):
            one, other = self.area(ours, inside), self.area(theirs, inside)
            both = self.area(np.maximum(ours, theirs), inside)
            size, off, apart = size + other, off + abs(one - other), apart + 0.5 * (one + other - 2.0 * both)
        if size == 0.0:
            return Shown(across, up, weights, entry, blended, true, math.nan, math.nan)
        return Shown(across, up, weights, entry, blended, true, off / size, apart / size)

    def _true(self, entry: RunEntry, weights: Sequence[float]) -> Run:
        if 1.0 in weights:
            return self.runs[weights.index(1.0)]
        return recorded(entry, self.content.tank, self.content.cells)

    def dry(self, entry: RunEntry) -> np.ndarray:
        """(rows, columns) nodes in the wall of a run."""
        rows, columns = self.runs[0].distance.shape[1:]
        x, y = np.arange(columns) * self.cell, np.arange(rows) * self.cell
        across = np.abs(x - entry.at) < 0.5 * entry.width
        return across[None, :] & (y < entry.height)[:, None]

    def area(self, distance: Floats, inside: np.ndarray) -> float:
        """m² of liquid outside of a wall."""
        return area_of(np.where(inside, self.cell, distance), self.cell)

    # -- now --------------------------------------------------------------------------------------------

    @property
    def frame(self) -> float:
        """The time in pictures."""
        return min(float(self.clock[0]) / FRAME, self.blend.frames - 1.0)

    def advance(self, dt: float) -> str:
        """The runs go on, and begin again at their end."""
        words = self.blend.warning if self.time == 0.0 else ""
        length = (self.blend.frames - 1) * FRAME
        self.clock[0] = (self.clock[0] + dt) % length
        self.time += dt
        return words

    def restore(self, state: BlendState) -> None:
        super().restore(state)
        if not np.array_equal(self.links, self._aligned):
            self._align()

    def now(self, aligned: bool) -> tuple[Floats, RunEntry]:
        """Signed distances between the runs as the weights are, and the wall there."""
        weights = self.weights(self.parameters.across, self.parameters.up)
        return self.blend.at(self.frame, weights, aligned), between(self.content.runs, weights)

    def areas(self) -> tuple[float, float, float]:
        """m² now: aligned, plain, and the weighted mean of the recorded runs."""
        weights = self.weights(self.parameters.across, self.parameters.up)
        (aligned, entry), (plain, _) = self.now(True), self.now(False)
        inside = self.dry(entry)
        parts = [
            weight * self.area(self.blend.at(self.frame, np.eye(len(self.runs))[k].tolist()), self.dry(one))
            for k, (weight, one) in enumerate(zip(weights, self.content.runs, strict=True))
        ]
        return self.area(aligned, inside), self.area(plain, inside), sum(parts)

    # -- tanks and links ----------------------------------------------------------------------------------

    def corner(self, column: int, row: int) -> tuple[float, float]:
        """Lower left corner of a tank of the picture, m; rows from below."""
        width, height = self.content.tank
        gap = GAP * height
        return column * (width + gap), row * (height + gap)

    def corners(self) -> list[tuple[float, float]]:
        """Of the tanks with recorded runs."""
        if len(self.runs) == 2:
            return [self.corner(0, 1), self.corner(1, 1)]
        return [self.corner(column, row) for row in (0, 2) for column in (0, 2)]

    def link(self, start: tuple[float, float], end: tuple[float, float]) -> str:
        """Let a point of the first run belong to one of another; why not, or ""."""
        first, other = self._in_tank(start), self._in_tank(end)
        if first is None or other is None or first[0] != 0 or other[0] == 0:
            return "Drag from the first recorded tank to another one."
        if len(self.links) >= MOST_LINKS:
            return f"There are {MOST_LINKS} links, and no more."
        speed, now = speed_of_time(self.content.tank), float(self.clock[0])
        later = now + float(self.parameters.later)
        link = (other[0], speed * now, first[2], first[1], speed * later, other[2], other[1])
        self.links = np.concatenate([self.links, np.array([link], dtype=np.float64)])
        self._align()
        return ""

    def forget(self) -> str:
        """Take all links away."""
        if not len(self.links):
            return "There are no links."
        self.links = self.links[:0]
        self._align()
        return ""

    def _in_tank(self, at: tuple[float, float]) -> tuple[int, float, float] | None:
        width, height = self.content.tank
        for number, (left, bottom) in enumerate(self.corners()):
            if 0.0 <= at[0] - left <= width and 0.0 <= at[1] - bottom <= height:
                return number, at[0] - left, at[1] - bottom
        return None
