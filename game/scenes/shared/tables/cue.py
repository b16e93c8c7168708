"""The mouse cue: aim by moving, power by pulling back, release to strike, cancel to take it back.

All of it is one small array, so a half-drawn stroke is in the snapshot and in the replay like any ball.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary
from game.stage import Pointer

AIMING, PULLING, STRIKING = 0.0, 1.0, 2.0
MAX_SPEED = 10.0  # m/s, of the ball; a hard break is 8 to 10
FULL_PULL = 0.45  # m, pulled back for the full speed
LEAST_SPEED = 0.05  # m/s; a shorter pull is taken as a change of mind
REST_GAP = 0.012  # m, between tip and ball while aiming
FINE = 0.1  # share of the pointer's turn that counts while Shift is held
NUDGE = math.radians(0.1)  # rad, turn for a key


class CueControl:
    """Aim (rad), speed (m/s) and phase of a cue. ``data``: (7,) float64, the whole state."""

    def __init__(self, aim: float = 0.0):
        # aim, speed, phase, anchor x, y (where the pull began), bearing of the pointer, gap from tip to ball
        self.data: NDArray[np.float64] = np.array([aim, 0.0, AIMING, 0.0, 0.0, math.nan, REST_GAP])
        self.data[5] = aim

    @property
    def aim(self) -> float:
        """Direction of the stroke, rad from the x axis."""
        return float(self.data[0])

    @property
    def speed(self) -> float:
        """Speed that the ball would get, m/s."""
        return float(self.data[1])

    @property
    def phase(self) -> float:
        """AIMING, PULLING or STRIKING."""
        return float(self.data[2])

    @property
    def gap(self) -> float:
        """Distance between tip and ball, m."""
        return float(self.data[6])

    def point_to(self, aim: float) -> None:
        """Set the direction, rad."""
        self.data[0] = math.remainder(aim, 2.0 * math.pi)

    def pointer(self, event: Pointer, ball_x: float, ball_y: float, ready: bool) -> None:
        """Take a pointer event; the ball lies at (ball_x, ball_y) m; ``ready``: it may be struck now."""
        if event.kind == "cancel" or (event.kind == "down" and event.button == 3):
            self.let_go()
        elif event.kind == "move":
            self._move(event, ball_x, ball_y)
        elif event.kind == "down" and event.button == 1 and ready and self.phase == AIMING:
            self.data[2:5] = PULLING, event.x, event.y
        elif event.kind == "up" and event.button == 1 and self.phase == PULLING:
            if self.speed >= LEAST_SPEED:
                self.data[2] = STRIKING
            else:
                self.let_go()

    def nudge(self, name: str) -> None:
        """Turn the cue a little: an action "left" (against the clock as drawn) or "right"."""
        if self.phase == AIMING:
            self.point_to(self.aim + (NUDGE if name == "left" else -NUDGE))

    def strike(self, aim: float, speed: float) -> None:
        """Begin a stroke without a hand: as a demonstration or a test does."""
        self.point_to(aim)
        self.data[1] = min(max(speed, 0.0), MAX_SPEED)
        self.data[2] = STRIKING
        self.data[6] = self._gap_of_pull()

    def let_go(self) -> None:
        """Take the stroke back; a stroke that has begun goes on."""
        if self.phase != STRIKING:
            self.data[1:3] = 0.0, AIMING
            self.data[6] = REST_GAP

    def advance(self, dt: float) -> bool:
        """Move the cue for dt; True in the step in which the tip reaches the ball."""
        if self.phase != STRIKING:
            return False
        # from rest to the full speed over the pull: constant acceleration, v^2 = 2 a s, mean speed v / 2
        pull = self._gap_of_pull()
        share = max(1.0 - self.gap / pull, 0.0)
        self.data[6] -= dt * self.speed * max(math.sqrt(share), 0.25)
        if self.gap > 0.0:
            return False
        self.data[2] = AIMING
        self.data[6] = REST_GAP
        return True

    def _gap_of_pull(self) -> float:
        return REST_GAP + FULL_PULL * self.speed / MAX_SPEED

    def _move(self, event: Pointer, ball_x: float, ball_y: float) -> None:
        if self.phase == PULLING:
            back = -(event.x - self.data[3]) * elementary.cos(self.aim) - (
                event.y - self.data[4]
            ) * elementary.sin(self.aim)
            self.data[1] = MAX_SPEED * min(max(back / FULL_PULL, 0.0), 1.0)
            self.data[6] = self._gap_of_pull()
            return
        dx, dy = event.x - ball_x, event.y - ball_y
        if dx * dx + dy * dy < 1e-12 or self.phase == STRIKING:
            return
        bearing = elementary.atan2(dy, dx)
        if event.shift:
            self.point_to(self.aim + FINE * math.remainder(bearing - self.data[5], 2.0 * math.pi))
        else:
            self.point_to(bearing)
        self.data[5] = bearing


def longest_swing_s(speed: float) -> float:
    """How long a stroke of a speed (m/s of the ball) takes from the pull to the hit, at most, s: see
    `CueControl.advance`, which moves the cue at a quarter of the speed at least.
    """
    able = max(speed, LEAST_SPEED)
    return (REST_GAP + FULL_PULL * able / MAX_SPEED) / (0.25 * able)
