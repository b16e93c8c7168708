"""A trajectory that is known at samples: of the tables that step in time."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.orientation import turn
from game.billiards.shot.physics import ShotError
from game.billiards.shot.shot import Shot
from game.billiards.shot.trajectory import TableState, Trajectory, rotation_matrices
from game.physics.kernels import linear

# columns of samples (m, n, 8)
SAMPLE_X, SAMPLE_Y, SAMPLE_VX, SAMPLE_VY, SAMPLE_WX, SAMPLE_WY, SAMPLE_WZ, SAMPLE_MOTION = range(8)
SAMPLE_COLUMNS = 8
MAX_SAMPLES = 8192  # of one shot, a power of two; more are thinned out to every second, fourth, ...
MAX_ROWS = 2**17  # balls x samples
MAX_DT = 10.0  # s
MAX_UNTIL = 1e6  # s
MAX_STEPS = 20_000_000


def check_steps(dt: float, until: float) -> None:
    """ShotError if the step or the time to play is absurd."""
    for name, value, most in (("dt", dt, MAX_DT), ("until", until, MAX_UNTIL)):
        if isinstance(value, bool) or not (isinstance(value, int | float) and 0.0 < value <= most):
            raise ShotError(f"{name}: must be above 0 and at most {most:g} s, got {value!r}")
    if until / dt > MAX_STEPS:
        raise ShotError(f"dt: {until:g} s would be more than {MAX_STEPS} steps of {dt!r} s")


def samples_for(n: int) -> int:
    """How many samples of n balls are kept, an even number."""
    return max(64, min(MAX_SAMPLES, MAX_ROWS // n // 2 * 2))


@lean_kernel
def turn_samples(times, samples, turns):
    """Quaternions (m, n, 4) at the samples, each ball turned from one to the next by its mean spin.

    turns[0] is where it begins.
    """
    for k in range(1, times.shape[0]):
        half = 0.5 * (times[k] - times[k - 1])
        for i in range(samples.shape[1]):
            for part in range(4):
                turns[k, i, part] = turns[k - 1, i, part]
            turn(
                turns[k, i],
                half * (samples[k - 1, i, SAMPLE_WX] + samples[k, i, SAMPLE_WX]),
                half * (samples[k - 1, i, SAMPLE_WY] + samples[k, i, SAMPLE_WY]),
                half * (samples[k - 1, i, SAMPLE_WZ] + samples[k, i, SAMPLE_WZ]),
            )


@lean_kernel
def turn_between(before, now, elapsed, turns):
    """Turn quaternions (n, 4), in place, by the mean of the spins of two samples (n, 8) `elapsed` s apart."""
    for i in range(turns.shape[0]):
        turn(
            turns[i],
            0.5 * elapsed * (before[i, SAMPLE_WX] + now[i, SAMPLE_WX]),
            0.5 * elapsed * (before[i, SAMPLE_WY] + now[i, SAMPLE_WY]),
            0.5 * elapsed * (before[i, SAMPLE_WZ] + now[i, SAMPLE_WZ]),
        )


class SampledTrajectory(Trajectory):
    """A shot played in steps; between samples everything is linear in time.

    rows (e, 4) and end (n, 11) as in `Trajectory`; there are no closed forms, so no segments. sample_times
    (m,) s, rising from 0 to end_time. samples (m, n, 8): columns as named above, SI, in the table's frame.
    counts: how much work it was, by name; "lost_events" are those beyond the capacity for them.
    """

    def __init__(
        self,
        shot: Shot,
        rows: Floats,
        end: Floats,
        sample_times: Floats,
        samples: Floats,
        counts: dict[str, int],
    ) -> None:
        super().__init__(shot, rows, np.empty((0, s.SEGMENT_COLUMNS)), end, float(sample_times[-1]))
        self.sample_times = sample_times
        self.samples = samples
        self.counts = counts

    def state_at(self, time: float) -> TableState:
        """State at any time (s); before 0 that of 0, after the end that of the end."""
        time = self._within(time)
        k, now = self._between(time)
        motions = self.samples[k, :, SAMPLE_MOTION].astype(np.int64)
        return TableState(time, now[:, 0:2], now[:, 2:4], now[:, 4:7], motions)

    def orientations_at(self, time: float, starting: ArrayLike | None = None) -> Floats:
        """Rotation matrices (n, 3, 3), ball to table, at a time (s); `starting` (n, 3, 3): at time 0."""
        time = self._within(time)
        k, now = self._between(time)
        turns = self._turns[k].copy()
        turn_between(self.samples[k], now, time - float(self.sample_times[k]), turns)
        matrices = rotation_matrices(turns)
        return (
            matrices if starting is None else linear.product(matrices, np.asarray(starting, dtype=np.float64))
        )

    def _between(self, time: float) -> tuple[int, Floats]:
        """The sample at or before a time, and the columns of samples (n, 8) at that time."""
        k = int(np.searchsorted(self.sample_times, time, side="right")) - 1
        if k + 1 >= len(self.sample_times):
            return k, self.samples[k].copy()
        begin, end = self.sample_times[k : k + 2].tolist()
        part = (time - begin) / (end - begin)
        return k, self.samples[k] + part * (self.samples[k + 1] - self.samples[k])

    @cached_property
    def _turns(self) -> Floats:
        turns = np.zeros((*self.samples.shape[:2], 4))
        turns[0, :, 0] = 1.0
        turn_samples(self.sample_times, self.samples, turns)
        return turns


def sampled_trajectory(
    shot: Shot, rows: Floats, times: Floats, samples: Floats, counts: dict[str, int]
) -> SampledTrajectory:
    """A trajectory from events (e, 4), times (m,) s and samples (m, n, 8) in the table's frame.

    ShotError if the end is not finite.
    """
    if not np.isfinite(samples[-1]).all():
        raise ShotError("a number of the shot's end state is not finite")
    end = shot.balls[:, : s.IN_COLUMNS].copy()
    end[:, : s.IN_WZ + 1] = samples[-1, :, :SAMPLE_MOTION]
    end[:, s.IN_MOTION] = samples[-1, :, SAMPLE_MOTION]
    return SampledTrajectory(shot, rows, end, times, samples, counts)
