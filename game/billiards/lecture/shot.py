"""A shot played on the lecture's table: velocity added to position, no spin, friction by a factor.

What the lecture's table cannot hold is left out: spin, throw, what the cushion does to the spin. Loss at
balls and cushions is the shot's. Friction there takes a share of the speed away each frame, where the cloth
takes a constant deceleration. The two can agree at one speed only. The factor is chosen so that a rolling
ball of REFERENCE_SPEED stops (falls below MINIMUM) after the time v/(mu_r g) that it takes on the cloth:
faster balls then stop too soon, and slower ones roll on for too long.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.layout import FAR
from game.billiards.laws.lean import lean_kernel
from game.billiards.lecture import state as st
from game.billiards.lecture.settings import FRAME_RATE, LectureSettings, lecture_settings
from game.billiards.lecture.state import BALL_COLLISIONS, FRICTION, MINIMUM_SPEED, POCKETS, WALLS
from game.billiards.lecture.table import LectureTable
from game.billiards.shot import sampled
from game.billiards.shot.physics import ShotError
from game.billiards.shot.sampled import SampledTrajectory, check_steps, sampled_trajectory, samples_for
from game.billiards.shot.shot import Shot
from game.billiards.table.table import Table, checked_table
from game.physics.kernels import elementary

REFERENCE_SPEED = 1.0  # m/s
MINIMUM = 0.01  # m/s; finer than the table's default, for a shot is compared with the exact table
STEP = 1.0 / 60.0  # s, unless said otherwise
EFFECTS = WALLS | BALL_COLLISIONS | FRICTION | MINIMUM_SPEED | POCKETS


def friction_factor(rolling: float, gravity: float) -> float:
    """The lecture's factor per frame for a coefficient of rolling friction; 1 if there is none.

    With the factor f the speed falls as f^(60 t), so f = (v_min/v)^(1/(60 t)) where t = v/(mu_r g).
    """
    return elementary.pow(MINIMUM / REFERENCE_SPEED, rolling * gravity / (FRAME_RATE * REFERENCE_SPEED))


def lecture_settings_for(
    shot: Shot, substeps: int = 1, rule: str = "conserving", order: str = "pairwise"
) -> LectureSettings:
    """Settings of the lecture's table for a shot, stepped as printed: one pass, balls put on the wall."""
    physics = shot.physics
    moves_for_ever = physics.rolling == 0.0
    return lecture_settings(
        bounce=float(shot.constants[s.CUSHION_RESTITUTION]),
        restitution=float(shot.constants[s.BALL_RESTITUTION]),
        friction=friction_factor(physics.rolling, physics.gravity),
        minimum_speed=0.0 if moves_for_ever else MINIMUM,
        substeps=substeps,
        passes=1,
        rule=rule,
        order=order,
        repositioning="clamp",
        walls_again=False,
    )


def bed_of(shot: Shot) -> Table:
    """The bed within the rails, its lower left corner the origin; ShotError if it is not a rectangle.

    Files may have tables whose noses begin elsewhere. Open cloth is a bed of any size.
    """
    layout = shot.layout
    left, right, lower, upper = layout.free
    rails, jaws, _ = layout.counts
    bounded = max(right, upper) < FAR and min(left, lower) > -FAR
    if not ((bounded or rails == 0) and shot.balls[:, s.IN_CLEAR].all()):
        raise ShotError("table: the lecture's is a rectangle with rails on its four sides, or open cloth")
    width, length = (right - left, upper - lower) if bounded else (1.0, 1.0)
    elements = layout.elements.copy()
    elements[:, 0:2] += 0.5 * width, 0.5 * length
    elements[:rails, 2:4] += 0.5 * width, 0.5 * length
    discs = elements[rails:, :3]
    height = shot.table.cushion_height
    return checked_table(width, length, height, elements[:rails, :6], discs[:jaws], discs[jaws:])


def lecture_table_for(shot: Shot, settings: LectureSettings) -> LectureTable:
    """The lecture's table with a shot's balls. ShotError if the bed is not a rectangle with its rails."""
    bed = bed_of(shot)
    lectured = LectureTable(
        bed,
        shot.balls[:, :2] + (0.5 * bed.width, 0.5 * bed.length),
        shot.balls[:, s.IN_RADIUS],
        shot.balls[:, s.IN_MASS],
        shot.balls[:, s.IN_VX : s.IN_VY + 1],
        EFFECTS,
        settings,
    )
    for ball in np.flatnonzero(shot.balls[:, s.IN_MOTION] == s.POCKETED).tolist():
        lectured.remove(ball)
    return lectured


@lean_kernel
def write_sample(offsets, velocities, in_play, radii, middle_x, middle_y, sample):
    """Write the balls as they are to sample (n, 8), about a middle (m); what moves rolls."""
    for i in range(radii.shape[0]):
        vx = velocities[i, 0]
        vy = velocities[i, 1]
        sample[i, sampled.SAMPLE_X] = offsets[i, 0] + middle_x
        sample[i, sampled.SAMPLE_Y] = offsets[i, 1] + middle_y
        sample[i, sampled.SAMPLE_VX] = vx
        sample[i, sampled.SAMPLE_VY] = vy
        sample[i, sampled.SAMPLE_WX] = -vy / radii[i]
        sample[i, sampled.SAMPLE_WY] = vx / radii[i]
        sample[i, sampled.SAMPLE_WZ] = 0.0
        if not in_play[i]:
            sample[i, sampled.SAMPLE_MOTION] = s.POCKETED
        elif vx != 0.0 or vy != 0.0:
            sample[i, sampled.SAMPLE_MOTION] = s.ROLLING
        else:
            sample[i, sampled.SAMPLE_MOTION] = s.STATIONARY


class LecturePlay:
    """A shot being played on the lecture's table: the time reached (s), rows of events, counts."""

    def __init__(self, shot: Shot, settings: LectureSettings) -> None:
        self.table = lecture_table_for(shot, settings)
        self.middle = shot.layout.middle
        self.time = 0.0
        self.rows: list[Floats] = []
        self.counts = {"steps": 0, "pair_tests": 0, "lost_events": 0}

    def advance(self, dt: float, steps: int) -> None:
        """Go on by so many steps. ShotError if a number is not finite any more."""
        self.table.step(dt, steps)
        if self.table.not_finite >= 0:
            raise ShotError(
                f"ball {self.table.not_finite}: its numbers grew without limit by {self.time:.3g} s"
            )
        if len(self.table.event_rows):
            events = self.table.event_rows[:, [st.TIME, st.KIND, st.FIRST, st.SECOND]]
            events[:, 0] += self.time
            self.rows.append(events)
        counters = self.table.counters
        self.counts["steps"] += steps
        self.counts["pair_tests"] += counters["pair_tests"]
        self.counts["lost_events"] += counters["events_lost"]
        self.time += steps * dt

    def play_to(self, step: int, dt: float) -> bool:
        """Go on in steps of dt s to the end of the step of that number; True if nothing moves any more."""
        if self.table.moving and self.counts["steps"] < step:
            self.advance(dt, step - self.counts["steps"])
        return not self.table.moving

    def write(self, sample: Floats) -> None:
        """Write the balls as they are to sample (n, 8)."""
        state = self.table.state
        write_sample(state.offsets, state.velocities, state.in_play, state.radii, *self.middle, sample)

    @property
    def events(self) -> Floats:
        """Events so far (e, 4), as in `Trajectory`."""
        return np.concatenate(self.rows) if self.rows else np.empty((0, 4))


def simulate_lecture(
    shot: Shot,
    dt: float = STEP,
    substeps: int = 1,
    rule: str = "conserving",
    order: str = "pairwise",
    until: float = 60.0,
) -> SampledTrajectory:
    """Play a shot on the lecture's table in steps of dt s, at most to the time `until` (s).

    substeps (0: automatic), rule, order: as in `lecture_settings`. Events are contacts only, to the substep.
    ValueError names an option out of range, or a ball whose numbers did not stay finite.
    """
    check_steps(dt, until)
    play = LecturePlay(shot, lecture_settings_for(shot, substeps, rule, order))
    whole = int(until / dt * (1.0 + 1e-12))
    rest = until - whole * dt
    capacity = samples_for(len(shot.balls))
    stride = max(1, math.ceil(whole / (capacity - 2)))
    times = np.zeros(min(capacity, whole + 2))
    samples = np.empty((len(times), len(shot.balls), sampled.SAMPLE_COLUMNS))
    play.write(samples[0])
    kept = 1
    while play.table.moving and (play.counts["steps"] < whole or rest > 1e-9 * dt):
        left = whole - play.counts["steps"]
        if left > 0:
            play.advance(float(dt), min(stride, left))
        else:
            play.advance(rest, 1)
            rest = 0.0
        times[kept] = play.time
        play.write(samples[kept])
        kept += 1
    return sampled_trajectory(shot, play.events, times[:kept].copy(), samples[:kept].copy(), play.counts)
