"""What is heard of a shot as a rhythm: the times of its clicks, those close together as one."""

from __future__ import annotations

from game.billiards.shot.impacts import heard_impacts
from game.billiards.shot.trajectory import Trajectory

TOGETHER = 0.012  # s; impacts this close are one to the ear


def clicks_of(trajectory: Trajectory) -> tuple[float, ...]:
    """Times (s) at which something is heard, the stroke (0) first; of impacts within TOGETHER the first."""
    times = [0.0]
    for impact in heard_impacts(trajectory):
        if impact.time - times[-1] >= TOGETHER:
            times.append(impact.time)
    return tuple(times)
