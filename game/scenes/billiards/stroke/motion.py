"""The stroke of a cue: its speed, and its motion as key-frames: drawn back, through the ball, out of sight.

A stroke has the speed of its cue. People set and read its power instead: the speed, m/s, of a ball that is
struck in its middle. Both are converted here and nowhere else.

Columns of the track: the distance from tip to ball (m, below 0 after the hit) and how solid the cue is drawn.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

from game.billiards.shot.cue import speed_ratio
from game.physics.animation import Keyframes
from game.scenes.shared.tables.choices import LEAST_POWER
from game.scenes.shared.tables.cue import FULL_PULL, MAX_SPEED, REST_GAP
from game.stage import WarmUp

GAP, SOLID = range(2)
SWING_FEWEST_S, SWING_MOST_S = 0.07, 0.32
FOLLOW = 0.16  # m that the tip goes on behind a hard hit
FOLLOW_S, STAND_S, LEAVE_S = 0.14, 0.22, 0.30
DRAWN, PRACTISED, PUSHED = "drawn", "practised", "pushed"  # how a stroke begins
PRACTICE = ((0.16, 0.55), (0.03, 0.42), (0.13, 0.45), (0.025, 0.38))  # m, and s from the key before


def power_of(cue_speed: float) -> float:
    """Power of a stroke of the cue, m/s."""
    return cue_speed * speed_ratio()


def cue_speed_of(power: float) -> float:
    """Speed of the cue for a power, m/s."""
    return power / speed_ratio()


def power_in_range(power: float) -> float:
    """The nearest power that can be set, m/s."""
    return min(max(power, LEAST_POWER), MAX_SPEED)


class StrokeMotion(NamedTuple):
    """A track, the time at which the tip meets the ball, and that at which the cue has gone, s."""

    track: Keyframes
    hit_s: float
    end_s: float


def pull_of(power: float) -> float:
    """Distance from tip to ball, m, that a power (m/s) asks for."""
    return REST_GAP + FULL_PULL * min(max(power / MAX_SPEED, 0.0), 1.0)


@lru_cache(maxsize=8)
def stroke_motion(cue_speed: float, begins: str) -> StrokeMotion:
    """The motion of a stroke with a speed of the cue, m/s, at the hit.

    begins: PRACTISED, at rest with a few strokes in the air, as a computer player does. DRAWN, where a hand
    has drawn the cue. PUSHED, as the tip meets the ball, since a hand has brought it there.
    """
    power = power_of(cue_speed)
    if begins == PUSHED:
        return _motion([(0.0, 0.0, 1.0)], power)
    practised = begins == PRACTISED
    pull = pull_of(power)
    keys = [(0.0, REST_GAP if practised else pull, 1.0)]
    if practised:
        for gap, seconds in PRACTICE:
            keys.append((keys[-1][0] + seconds, min(gap, 0.6 * pull + 0.02), 1.0))
        keys.append((keys[-1][0] + 0.5, pull, 1.0))
        keys.append((keys[-1][0] + 0.25, pull, 1.0))
    swing = min(max(2.0 * pull / max(power, LEAST_POWER), SWING_FEWEST_S), SWING_MOST_S)
    begun = keys[-1][0]
    # half of the time takes a quarter of the distance: the cue is accelerated evenly until it hits
    keys.append((begun + 0.5 * swing, 0.75 * pull, 1.0))
    keys.append((begun + swing, 0.0, 1.0))
    return _motion(keys, power)


def _motion(keys: list[tuple[float, float, float]], power: float) -> StrokeMotion:
    """The motion up to the hit, the last of the keys (s, m, solid), and what follows it. power m/s."""
    hit = keys[-1][0]
    follow = -(0.02 + FOLLOW * min(power / MAX_SPEED, 1.0))
    keys.append((hit + FOLLOW_S, follow, 1.0))
    keys.append((hit + FOLLOW_S + STAND_S, follow, 1.0))
    end = hit + FOLLOW_S + STAND_S + LEAVE_S
    keys.append((end, follow + 0.12, 0.0))
    return StrokeMotion(Keyframes([key[0] for key in keys], [key[1:] for key in keys], "monotone"), hit, end)


def warm_ups() -> list[WarmUp]:
    """The kernel that samples a track."""
    return [WarmUp("key-frames", lambda: stroke_motion(3.0, PRACTISED).track.sample(0.1))]
