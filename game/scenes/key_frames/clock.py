"""Where in its second a motion is: counted in steps, folded on the way back, held for the time of a frame.

``clock`` is (4,): the phase it began at, steps made since, their length (s), and whether it plays. A phase
runs from 0 to 1, and from 1 to 2 on the way back. Counting steps, not adding times, no rounding gathers.
"""

from __future__ import annotations

import math

from game.arrays import Floats

REPEATS = ("loop", "once", "there-and-back")
ROUNDING = 1e-9  # of a frame: a phase that close to the next one is there


def phase_of(clock: Floats, repeat: str, duration: float) -> float:
    """The phase now; duration: s that the second lasts."""
    begin, steps, dt, _ = clock.tolist()
    if steps == 0.0:
        return float(begin)  # the end of the second is not its beginning while it rests there
    phase = begin + steps * dt / duration
    if repeat == "once":
        return float(min(phase, 1.0))
    return float(phase % (1.0 if repeat == "loop" else 2.0))


def folded(phase: float) -> float:
    """Part of the second, 0 to 1, of a phase."""
    return phase if phase <= 1.0 else 2.0 - phase


def frame_of(phase: float, frames: float) -> int:
    """Number of the frame that is shown; frames: how many the second has."""
    return math.floor(phase * frames + ROUNDING)


def held(phase: float, frames: float) -> float:
    """Part of the second at which the frame that is shown was sampled, the same there and back."""
    frame = float(frame_of(phase, frames))
    if frame > frames:
        frame = 2.0 * frames - frame
    return min(max(frame / frames, 0.0), 1.0)
