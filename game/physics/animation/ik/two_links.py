"""Two links have a closed form: the law of cosines gives the elbow, and the rest follows."""

from __future__ import annotations

import math

from game.physics.animation.skeleton import SkeletonError
from game.physics.kernels import elementary


def two_link_angles(
    first: float, second: float, target: tuple[float, float], elbow_down: bool = True
) -> tuple[float, float]:
    """Angles (rad) of two links (m) from the origin to ``target``, the second against the first.

    A target out of reach, or in the hole, gives the pose nearest to it. Elbow down is the solution in which
    the second link turns counterclockwise. SkeletonError for links without length.
    """
    if not (0.0 < first < math.inf and 0.0 < second < math.inf):
        raise SkeletonError(f"links: expected finite lengths above 0 m, got {first!r} and {second!r}")
    x, y = float(target[0]), float(target[1])
    cosine = (x * x + y * y - first * first - second * second) / (2.0 * first * second)
    bend = elementary.acos(min(max(cosine, -1.0), 1.0)) * (1.0 if elbow_down else -1.0)
    toward = elementary.atan2(y, x) if x != 0.0 or y != 0.0 else 0.0
    return toward - elementary.atan2(
        second * elementary.sin(bend), first + second * elementary.cos(bend)
    ), bend
