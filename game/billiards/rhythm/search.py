"""A shot whose impacts meet a given beat, found by search over the stroke and where the balls lie.

Motion that meets sound is found, not steered: every candidate is a shot of the exact table, played as any
other. A ball that no other has met yet may lie anywhere. So for the next beat one is laid where a ball that
moves then will just meet it, in any direction: the impact is on the beat to rounding, and what came before
stays as it was. A beam search (Lowerre 1976) keeps the layouts that are heard least between the beats. What
clicks off the beat at the end, at a cushion mostly, is then moved by an evolution strategy with plus
selection (Rechenberg 1973). Layouts evolve side by side, so that no early luck drives out the others. The
tip's click is the first beat. Cost: see `candidates.rate_shots`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.rhythm.candidates import EXTRA, FARTHEST_MISS, STROKE, Candidates
from game.billiards.rhythm.hearing import TOGETHER, clicks_of
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import Shot
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import simulate_exact
from game.billiards.table.table import Table
from game.physics.kernels import elementary, elementwise, linear

MOST_BEATS, MOST_SECONDS, LEAST_GAP = 16, 12.0, 0.08
SLOWEST, FASTEST = 0.8, 5.0  # m/s, of the stroke
LEAST_MOVING = 0.15  # m/s; what is slower by then is not laid anything in its way
WIDEST = 1.25  # rad from its path, at which a ball meets the one laid for it
LIVELY = 2.0  # m/s; below it, the slower the fastest ball, the less is hoped for
MOST_FEARED = 3  # beats
BEAM, DIRECTIONS, FAMILY = (
    64,
    16,
    4,
)  # layouts kept; balls laid for each that moves; children kept of one layout
CHILDREN, HEARD = 96, 3  # of a layout in a round of the evolution; listened to of these


class Rhythm(NamedTuple):
    """A shot on the beat. Times in s after the stroke."""

    shot: Shot
    beats: tuple[float, ...]  # the first is the stroke itself, 0
    impacts: tuple[float, ...]  # heard between the first beat and the last
    misses: tuple[float, ...]  # of each beat: nearest impact less the beat
    candidate: tuple[float, ...]  # as `candidates` has them
    speed: float  # m/s, of the fastest ball at the last beat

    @property
    def error_s(self) -> float:
        """Root mean square of the misses."""
        return math.sqrt(sum(miss * miss for miss in self.misses) / len(self.misses))

    @property
    def extras(self) -> int:
        """Impacts that no beat asks for."""
        return max(len(self.impacts) - len(self.beats), 0)

    def promise(self, beats_left: int) -> float:
        """The cost, and what is to be feared of balls too slow for so many beats more."""
        lack = max(elementary.log(LIVELY / max(self.speed, 1e-3)), 0.0)
        return self.cost + EXTRA * lack * min(beats_left, MOST_FEARED)

    @property
    def cost(self) -> float:
        """What the search makes small, s."""
        capped = [min(abs(miss), FARTHEST_MISS) for miss in self.misses]
        return math.sqrt(sum(miss * miss for miss in capped) / len(capped)) + EXTRA * self.extras


def rhythm_of(trajectory: Trajectory, beats: tuple[float, ...], candidate: Floats) -> Rhythm:
    """How a candidate that was played meets some beats (s)."""
    times = tuple(time for time in clicks_of(trajectory) if time <= beats[-1] + TOGETHER)
    misses = tuple(min((time - beat for time in times), key=abs) for beat in beats)
    speed = float(np.max(elementwise.hypot(*trajectory.state_at(beats[-1]).velocities.T)))
    return Rhythm(trajectory.shot, beats, times, misses, tuple(candidate.tolist()), speed)


def check_beats(beats: Sequence[float]) -> tuple[float, ...]:
    """Beats (s) from the first on; ValueError unless there are 2 to MOST_BEATS, in order and apart."""
    times = tuple(float(beat) - float(beats[0]) for beat in beats) if len(beats) else ()
    if not 2 <= len(times) <= MOST_BEATS:
        raise ValueError(f"beats: expected 2 to {MOST_BEATS}, got {len(times)}")
    for before, after in pairwise(times):
        if not after - before >= LEAST_GAP:
            raise ValueError(f"beats: expected at least {LEAST_GAP:g} s between two, got {after - before:g}")
    if not times[-1] <= MOST_SECONDS:
        raise ValueError(f"beats: expected at most {MOST_SECONDS:g} s in all, got {times[-1]:g}")
    return times


class RhythmSearch:
    """The search for one beat: ``improve`` goes one step on, ``best`` is what it has come to.

    First a step for each beat lays the balls, so that there are as many as beats; every further one varies
    them. What it finds depends on the arguments alone. ValueError, naming the argument, for absurd ones.
    """

    def __init__(
        self, beats: Sequence[float], table: Table, physics: Physics = Physics(), seed: int = 0  # noqa: B008
    ) -> None:  # fmt: skip
        self.beats = check_beats(beats)
        self._rng = np.random.default_rng(seed)
        self._table, self._physics = table, physics
        self._candidates = Candidates(table, physics, 1)
        self._rows = self._first_strokes()
        self._found: list[Rhythm | None] = [self._rhythm(row, self.beats[:1]) for row in self._rows]
        self.steps = 0

    @property
    def laid(self) -> bool:
        """Whether a ball has been laid for every beat."""
        return self._candidates.balls == len(self.beats)

    def best(self) -> Rhythm | None:
        """The best shot yet for the beats that have their ball; None if every layout has failed."""
        found = [one for one in self._found if one is not None]
        return min(found, key=lambda one: one.cost, default=None)

    def improve(self) -> None:
        """Lay the ball of the next beat; once all lie, vary them."""
        self.steps += 1
        if not self.laid:
            self._lay_next()
        elif len(self._rows):
            self._vary()

    def run(
        self, steps: int, go_on: Callable[[], bool] = lambda: True, good_s: float = 1e-3
    ) -> Rhythm | None:
        """So many steps, unless it is told to stop, or the cost has come to ``good_s``; what was found."""
        for _ in range(steps):
            best = self.best()
            if not go_on() or (self.laid and best is not None and best.cost <= good_s):
                break
            self.improve()
        return self.best() if self.laid else None

    def _first_strokes(self) -> Floats:
        """Strokes at a cue ball alone, at random."""
        count, width, length = 8 * BEAM, self._table.width, self._table.length
        drawn = self._rng.random((count, 6))
        low = np.array([SLOWEST, -math.pi, -0.4, -0.4, 0.2 * width, 0.15 * length])
        high = np.array([FASTEST, math.pi, 0.4, 0.4, 0.8 * width, 0.85 * length])
        return np.asarray(low + (high - low) * drawn)

    # -- one ball a beat ----------------------------------------------------------------------------

    def _lay_next(self) -> None:
        """Lay a ball where one that moves at the next beat just meets it; keep the best layouts."""
        number = self._candidates.balls
        beats = self.beats[: number + 1]
        drawn, parents = [], []
        for parent, row in enumerate(self._rows):
            trajectory = self._play(row, beats[-1])
            if trajectory is not None and trajectory.end_time >= 0.0:
                for child in self._meetings(row, trajectory, beats[-1]):
                    drawn.append(child)
                    parents.append(parent)
        self._candidates = Candidates(self._table, self._physics, number + 1)
        rows = np.array(drawn).reshape(-1, STROKE + 2 * (number + 1))
        costs = self._candidates.rough_costs(rows, np.array(beats)) if len(rows) else np.empty(0)
        self._keep(rows, costs, parents, beats)

    def _meetings(self, row: Floats, trajectory: Trajectory, beat: float) -> list[Floats]:
        """The layout with one more ball, in each of some directions from each ball that moves at the beat."""
        state = trajectory.state_at(beat)
        found = []
        for position, velocity in zip(state.positions, state.velocities, strict=True):
            if elementary.length(*velocity) > LEAST_MOVING:
                path = elementary.atan2(velocity[1], velocity[0])
                for turn in linear.uniform(self._rng, -WIDEST, WIDEST, DIRECTIONS):
                    away = 2.0 * self._candidates.radius
                    place = position + away * np.array(
                        [elementary.cos(path + turn), elementary.sin(path + turn)]
                    )
                    found.append(np.concatenate([row, place]))
        return found

    def _keep(self, rows: Floats, costs: Floats, parents: list[int], beats: tuple[float, ...]) -> None:
        """Keep the best of some layouts by what is heard of them, few of one family."""
        families: dict[int, int] = {}
        kept: list[tuple[Floats, Rhythm]] = []
        shuffled = self._rng.permutation(len(costs))  # many cost nothing: no parent comes first among them
        for i in shuffled[np.argsort(costs[shuffled], kind="stable")]:
            if len(kept) == 4 * BEAM or not math.isfinite(costs[i]):
                break
            if families.get(parents[i], 0) < FAMILY and (found := self._rhythm(rows[i], beats)) is not None:
                families[parents[i]] = families.get(parents[i], 0) + 1
                kept.append((rows[i], found))
        left = len(self.beats) - len(beats)
        kept.sort(key=lambda one: one[1].promise(left))
        self._rows = np.array([row for row, _ in kept[:BEAM]]).reshape(-1, rows.shape[1])
        self._found = [found for _, found in kept[:BEAM]]

    # -- all at once --------------------------------------------------------------------------------

    def _vary(self) -> None:
        """One round of the evolution of each layout."""
        children = self._children()
        rough = self._candidates.rough_costs(children, np.array(self.beats)).reshape(-1, CHILDREN)
        for line in range(len(self._rows)):
            for i in np.argsort(rough[line], kind="stable")[:HEARD]:
                known = self._found[line]
                if known is not None and rough[line, i] > known.cost + EXTRA:  # quiet impacts count there
                    break
                child = children[line * CHILDREN + i]
                found = self._rhythm(child, self.beats)
                if found is not None and (known is None or found.cost < known.cost):
                    self._rows[line], self._found[line] = child, found

    def _children(self) -> Floats:
        """CHILDREN of each layout: all numbers varied, a few, or one ball alone; by much and by little."""
        count, width = len(self._rows) * CHILDREN, self._rows.shape[1]
        size = np.array([2.0, math.pi, 0.5, 0.5] + [self._table.width, self._table.length] * len(self.beats))
        spread = size * elementwise.power(10.0, linear.uniform(self._rng, -6.0, -0.5, (count, 1)))
        touched = self._rng.random((count, width)) < self._rng.choice([0.15, 0.5, 1.0], (count, 1))
        ball = self._rng.integers(-STROKE // 2, len(self.beats), count)
        only = np.arange(width)[None, :] // 2 == (ball + STROKE // 2)[:, None]
        touched = np.where(self._rng.random((count, 1)) < 0.5, only, touched)
        children = np.repeat(self._rows, CHILDREN, axis=0)
        children += spread * touched * self._rng.standard_normal((count, width))
        children[:, 0] = np.clip(children[:, 0], SLOWEST, FASTEST)
        children[:, 2:STROKE] = np.clip(children[:, 2:STROKE], -0.5, 0.5)
        return children

    # -- one candidate ------------------------------------------------------------------------------

    def _play(self, row: Floats, until: float) -> Trajectory | None:
        """A candidate played; None if it is no shot (a ball in a jaw, or in another)."""
        try:
            return simulate_exact(self._candidates.shot(row), until=until)
        except ValueError:
            return None

    def _rhythm(self, row: Floats, beats: tuple[float, ...]) -> Rhythm | None:
        """What is heard of a candidate beside the beats; None if it is no shot."""
        trajectory = self._play(row, beats[-1] + FARTHEST_MISS)
        if trajectory is None:
            return None
        return rhythm_of(trajectory, beats, row)
