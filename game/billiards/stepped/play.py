"""The stepped table: the exact table's physics in fixed steps of time, as a game engine has it.

In each step balls are slowed down and moved (`stepped_cloth`), then contacts are settled
(`stepped_contacts`). Errors fall with the first power of the step. It needs steps in which a ball moves less
than its radius, 3 ms at 10 m/s; in longer ones hits are missed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.batch import Elements
from game.billiards.laws.lean import lean_kernel
from game.billiards.shot.physics import ShotError
from game.billiards.shot.sampled import (
    SAMPLE_COLUMNS,
    SAMPLE_MOTION,
    SampledTrajectory,
    check_steps,
    sampled_trajectory,
    samples_for,
)
from game.billiards.shot.shot import Shot
from game.billiards.stepped import contacts
from game.billiards.stepped.cloth import step_on_cloth
from game.billiards.stepped.contacts import log_event, settle_contacts

STEPS, SAMPLES, STRIDE = range(3, 6)  # counters, after those of the contacts; stride: steps between samples
COUNTERS = 6
MAX_EVENTS = 20_000  # kept of one shot; breaks have about 150
MAX_PASSES = 1_000
STEP = 1.0 / 240.0  # s, unless said otherwise
PASSES = 4


class Steps(NamedTuple):
    """Working arrays of one shot: state, modes, pairs as in `state`; old (2, n) m."""

    state: Floats
    modes: NDArray[np.int64]
    pairs: Floats
    old: Floats


class StepLog(NamedTuple):
    """What a shot in steps reports: events (e, 4), counters (6,), named above."""

    events: Floats
    counters: NDArray[np.int64]


@lean_kernel
def is_at_rest(modes, physics):
    """True if nothing will happen any more: all balls rest, or spin in place for ever."""
    spins_for_ever = physics[s.SPINNING_FRICTION] * physics[s.GRAVITY] == 0.0
    for i in range(modes.shape[1]):
        motion = modes[s.MOTION, i]
        if motion != s.STATIONARY and motion != s.POCKETED and not (motion == s.SPINNING and spins_for_ever):
            return False
    return True


@lean_kernel
def write_sample(state, modes, samples):
    """Write the balls as they are to samples (n, 8)."""
    for i in range(state.shape[1]):
        for column in range(SAMPLE_MOTION):
            samples[i, column] = state[s.X + column, i]
        samples[i, SAMPLE_MOTION] = modes[s.MOTION, i]


@lean_kernel
def keep_sample(state, modes, time, times, samples, counters):
    """Write a sample, having dropped every second when the list is full."""
    row = counters[SAMPLES]
    if row == times.shape[0]:
        row = (row + 1) // 2
        for k in range(1, row):
            times[k] = times[2 * k]
            for i in range(state.shape[1]):
                for column in range(SAMPLE_COLUMNS):
                    samples[k, i, column] = samples[2 * k, i, column]
        counters[STRIDE] *= 2
    times[row] = time
    write_sample(state, modes, samples[row])
    counters[SAMPLES] = row + 1


@lean_kernel
def take_step(steps, elements, physics, dt, now, passes, log):
    """One step of dt s, to the time `now` (s)."""
    state, modes, _, old = steps
    for i in range(state.shape[1]):
        state[s.TIME, i] = now
        old[contacts.OLD_X, i] = state[s.X, i]
        old[contacts.OLD_Y, i] = state[s.Y, i]
        if modes[s.MOTION, i] != s.STATIONARY and modes[s.MOTION, i] != s.POCKETED:
            event = step_on_cloth(state, modes, i, dt, physics)
            if event != s.NO_EVENT:
                log_event(log.events, log.counters, now, event, i, -1)
    settle_contacts(steps, elements, physics, passes, log)


@lean_kernel
def play_steps(steps, elements, physics, dt, until, passes, log, times, samples):
    """Play a shot in steps of dt s until all balls rest, or to the time `until` (s).

    The last step may be shorter. Writes the log, times (m,) and samples (m, n, 8).
    """
    state, modes = steps.state, steps.modes
    counters = log.counters
    step = 0
    now = 0.0
    counters[STRIDE] = 1
    keep_sample(state, modes, now, times, samples, counters)
    while now < until and not is_at_rest(modes, physics):
        before = now
        step += 1
        now = step * dt
        if now > until - 1e-9 * dt:
            now = until
        take_step(steps, elements, physics, now - before, now, passes, log)
        if step % counters[STRIDE] == 0:
            keep_sample(state, modes, now, times, samples, counters)
    if times[counters[SAMPLES] - 1] < now:
        keep_sample(state, modes, now, times, samples, counters)
    counters[STEPS] = step


@lean_kernel
def go_on(state, modes, pairs, old, cushions, jaws, pockets, physics, dt, last, passes, events, counters):
    """Go on in steps of dt s to the end of the step `last`, or until all balls rest; true if they do.

    Writes the log as `play_steps` does, but no samples. (Arrays one by one: it is called for every few steps,
    and the three tuples would take longer to pass than those steps to compute.)
    """
    steps = Steps(state, modes, pairs, old)
    elements = Elements(cushions, jaws, pockets)
    log = StepLog(events, counters)
    while counters[STEPS] < last and not is_at_rest(modes, physics):
        before = counters[STEPS] * dt
        counters[STEPS] += 1
        now = counters[STEPS] * dt
        take_step(steps, elements, physics, now - before, now, passes, log)
    return is_at_rest(modes, physics)


def steps_for(shot: Shot) -> Steps:
    """The balls of a shot on the table, at time 0."""
    n = len(shot.balls)
    steps = Steps(
        np.zeros((s.FLOAT_ROWS, n)),
        np.zeros((s.INTEGER_ROWS, n), np.int64),
        np.zeros((s.PAIR_PLANES, n, n)),
        np.zeros((2, n)),
    )
    steps.state[s.X : s.WZ + 1] = shot.balls[:, : s.IN_WZ + 1].T
    steps.state[s.RADIUS] = shot.balls[:, s.IN_RADIUS]
    steps.state[s.MASS] = shot.balls[:, s.IN_MASS]
    steps.state[s.CLEAR] = shot.balls[:, s.IN_CLEAR]
    steps.state[s.RAIL_TIME] = -1.0
    steps.modes[s.MOTION] = shot.balls[:, s.IN_MOTION]
    steps.pairs[s.MET] = -1.0
    return steps


class SteppedPlay:
    """A shot being played on the stepped table: the time reached (s), events, counts.

    ShotError for passes out of range.
    """

    def __init__(self, shot: Shot, passes: int) -> None:
        if (
            isinstance(passes, bool)
            or not isinstance(passes, int | np.integer)
            or not 1 <= passes <= MAX_PASSES
        ):
            raise ShotError(f"passes: must be a whole number from 1 to {MAX_PASSES}, got {passes!r}")
        self.time = 0.0
        self.passes = int(passes)
        self.arrays = steps_for(shot)
        # a copy, for kernels are compiled again for arrays that may not be written to
        self.elements = Elements(*np.split(shot.layout.elements.copy(), np.cumsum(shot.layout.counts)[:2]))
        self.constants = shot.constants
        self.middle = shot.layout.middle
        self.log = StepLog(np.empty((MAX_EVENTS, 4)), np.zeros(COUNTERS, np.int64))

    def play_to(self, step: int, dt: float) -> bool:
        """Go on in steps of dt s to the end of the step of that number; True if nothing moves any more."""
        at_rest = go_on(*self.arrays, *self.elements, self.constants, dt, step, self.passes, *self.log)
        self.time = int(self.log.counters[STEPS]) * dt
        return bool(at_rest)

    def write(self, sample: Floats) -> None:
        """Write the balls as they are to sample (n, 8)."""
        write_sample(self.arrays.state, self.arrays.modes, sample)
        sample[:, :2] += self.middle

    @property
    def events(self) -> Floats:
        """Events so far (e, 4), as in `Trajectory`; a view."""
        return self.log.events[: self.log.counters[contacts.EVENTS]]

    @property
    def counts(self) -> dict[str, int]:
        """How much work it was, by name."""
        counters = self.log.counters
        return {
            "steps": int(counters[STEPS]),
            "pair_tests": int(counters[contacts.PAIR_TESTS]),
            "lost_events": int(counters[contacts.LOST_EVENTS]),
        }


def simulate_stepped(
    shot: Shot, dt: float = STEP, passes: int = PASSES, until: float = 60.0
) -> SampledTrajectory:
    """Play a shot in steps of dt s, with up to `passes` rounds of contacts in each, at most to `until` (s).

    ShotError names an option out of range, or says that a number became infinite.
    """
    check_steps(dt, until)
    play = SteppedPlay(shot, passes)
    n = len(shot.balls)
    times = np.empty(samples_for(n))
    samples = np.empty((len(times), n, SAMPLE_COLUMNS))
    play_steps(
        play.arrays, play.elements, play.constants, float(dt), float(until), play.passes, play.log,
        times, samples,
    )  # fmt: skip
    kept = int(play.log.counters[SAMPLES])
    samples = samples[:kept].copy()
    samples[:, :, :2] += play.middle
    return sampled_trajectory(shot, play.events.copy(), times[:kept].copy(), samples, play.counts)
