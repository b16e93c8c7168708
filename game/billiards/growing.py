"""Shots on the tables that step, computed as far as they are asked for.

A minute in steps of 50 µs takes more than a second to compute. A picture needs a sixtieth of a second of it
at a time. What is known of a moment does not depend on how much has been computed beyond it.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np

from game.arrays import Floats
from game.billiards.laws.state import IN_MOTION, IN_WZ
from game.billiards.lecture.shot import LecturePlay, lecture_settings_for
from game.billiards.shot.physics import ShotError
from game.billiards.shot.sampled import (
    SAMPLE_COLUMNS,
    SAMPLE_MOTION,
    SampledTrajectory,
    check_steps,
    turn_samples,
)
from game.billiards.shot.shot import Shot
from game.billiards.stepped.play import SteppedPlay

GRID_HZ = 120.0  # what lies at multiples of 1/120 s is known to one step, however short that is
FIRST_CAPACITY = 256  # samples


class Play(Protocol):
    """A shot that is being played in steps. time: s since the beginning."""

    time: float

    @property
    def events(self) -> Floats:
        """Events so far (e, 4), as in `Trajectory`."""

    def write(self, sample: Floats) -> None:
        """Write the balls as they are to sample (n, 8)."""

    def play_to(self, step: int, dt: float) -> bool:
        """Go on in steps of dt s to the end of the step of that number; True if nothing moves any more."""


class GrowingTrajectory(SampledTrajectory):
    """A trajectory that is known up to end_time, and is computed further when a later state is asked for.

    play: the shot, at time 0. dt: length of a step, s. until: where it is broken off, s, at a whole step.
    complete: nothing comes after end_time. ShotError, also from `compute`: a number is not finite.
    """

    def __init__(self, shot: Shot, play: Play, dt: float, until: float) -> None:
        check_steps(dt, until)
        n = len(shot.balls)
        self._play = play
        self._dt = float(dt)
        self._last = int(until / dt * (1.0 + 1e-12))
        self._step = 0
        self._kept = 0
        self._turned = 1
        self._times = np.zeros(FIRST_CAPACITY)
        self._samples = np.empty((FIRST_CAPACITY, n, SAMPLE_COLUMNS))
        self._quaternions = np.zeros((FIRST_CAPACITY, n, 4))
        self._quaternions[0, :, 0] = 1.0
        super().__init__(shot, play.events, shot.balls.copy(), self._times[:1], self._samples[:1], {})
        self._keep(play.play_to(0, self._dt))

    def compute(self, time: float) -> None:
        """Go on at least up to a time (s), or to the end."""
        if self.end_time >= time or self.complete:
            return
        while self._times[self._kept - 1] < time and not self.complete:
            self._step = min(next_stop(self._step, self._dt), self._last)
            self._keep(self._play.play_to(self._step, self._dt))
        self.rows = self._play.events
        for name in ("events", "final", "digest"):
            self.__dict__.pop(name, None)

    def _within(self, time: float) -> float:
        self.compute(time)
        return super()._within(time)

    def _keep(self, at_rest: bool) -> None:
        """Keep the balls as a sample."""
        k = self._kept
        if k == len(self._times):
            self._times, self._samples, self._quaternions = (
                np.concatenate((a, np.zeros_like(a))) for a in (self._times, self._samples, self._quaternions)
            )
        self._times[k] = self._play.time
        self._play.write(self._samples[k])
        if not np.isfinite(self._samples[k]).all():
            raise ShotError(f"a number of the shot is not finite at {self._times[k]:.6g} s")
        self._kept = k + 1
        self.complete = at_rest or self._step >= self._last
        self.sample_times = self._times[: k + 1]
        self.samples = self._samples[: k + 1]
        self.end_time = float(self._times[k])
        self.end[:, : IN_WZ + 1] = self._samples[k, :, :SAMPLE_MOTION]
        self.end[:, IN_MOTION] = self._samples[k, :, SAMPLE_MOTION]

    @property
    def _turns(self) -> Floats:
        """Quaternions at the samples (m, n, 4); those that are new since the last time are computed."""
        new = slice(self._turned - 1, self._kept)
        turn_samples(self._times[new], self._samples[new], self._quaternions[new])
        self._turned = self._kept
        return self._quaternions


def next_stop(step: int, dt: float) -> int:
    """The step after which the next sample is kept: each one, or if they are short those around the grid."""
    if 2.0 * GRID_HZ * dt >= 1.0:
        return step + 1
    ahead = int(step * dt * GRID_HZ * (1.0 + 1e-12)) + 1  # of the grid
    before = int(ahead / (GRID_HZ * dt) * (1.0 + 1e-12))
    return before if before > step else step + 1


def grow_lecture(shot: Shot, dt: float, until: float) -> GrowingTrajectory:
    """A shot on the lecture's table, as `simulate_lecture` has it."""
    return GrowingTrajectory(shot, LecturePlay(shot, lecture_settings_for(shot)), dt, until)


def grow_stepped(shot: Shot, dt: float, passes: int, until: float) -> GrowingTrajectory:
    """A shot on the stepped table, as `simulate_stepped` has it."""
    return GrowingTrajectory(shot, SteppedPlay(shot, passes), dt, until)
