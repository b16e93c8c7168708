"""How far a stroke may be off and still score: in aim, in speed, and where the tip meets the ball."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.map.carom import Position
from game.billiards.search import strokes as s
from game.physics.kernels import elementwise

OFFSETS: Floats = elementwise.power(1.28, np.arange(24.0)) / elementwise.power(
    1.28, 23.0
)  # of the farthest, from the middle out
FARTHEST_AIM = np.radians(6.0)  # rad
FARTHEST_SPEED = 0.5  # of the speed
TIP_CELLS = 25  # of the map of the tip, to a side
TIP_REACH = 0.6  # ball radii
MISSED, OTHERWISE, AS_MEANT = range(3)


class Tolerance(NamedTuple):
    """How far each may be off to either side (less, more) while all between scores: aim rad (clockwise
    first), speed m/s, tip left and up in ball radii.
    """

    aim: tuple[float, float]
    speed: tuple[float, float]
    left: tuple[float, float]
    up: tuple[float, float]


def tolerance_of(position: Position, stroke: Stroke) -> Tolerance:
    """The tolerance of a stroke, one variable at a time, at 24 distances each; all 0 if it misses."""
    farthest = (
        (s.AZIMUTH, FARTHEST_AIM), (s.SPEED, FARTHEST_SPEED * stroke.cue_speed), (s.TIP_LEFT, TIP_REACH),
        (s.TIP_UP, TIP_REACH),
    )  # fmt: skip
    strokes = [np.array([stroke], dtype=np.float64)]
    for column, reach in farthest:
        for sign in (-1.0, 1.0):
            tried = np.repeat(strokes[0], len(OFFSETS), axis=0)
            tried[:, column] += sign * reach * OFFSETS
            strokes.append(tried)
    every = np.concatenate(strokes)
    every[:, s.SPEED] = np.maximum(every[:, s.SPEED], s.LEAST_SPEED)
    off_ball = elementwise.hypot(every[:, s.TIP_LEFT], every[:, s.TIP_UP]) > 0.99
    every[off_ball, s.TIP_LEFT : s.TIP_UP + 1] = 0.0
    scores = position.wanted.scores(position.play(every)) & ~off_ball
    if not scores[0]:
        return Tolerance((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0))
    runs = scores[1:].reshape(len(farthest), 2, len(OFFSETS))
    reached = []
    for (_, reach), sides in zip(farthest, runs, strict=True):
        good = [int(np.argmin(side)) if not side.all() else len(OFFSETS) for side in sides]
        less, more = (reach * float(OFFSETS[count - 1]) if count else 0.0 for count in good)
        reached.append((less, more))
    return Tolerance(*reached)


def tip_map(position: Position, stroke: Stroke, cells: int = TIP_CELLS) -> NDArray[np.int8]:
    """What comes of the stroke with the tip elsewhere: (cells, cells), rows from the top, columns from the
    left as the player sees the ball, over TIP_REACH radii to each side. MISSED, OTHERWISE (it scores by
    another way), AS_MEANT; beyond the circle of that radius -1.
    """
    axis = np.linspace(-TIP_REACH, TIP_REACH, cells)
    ups, rights = np.meshgrid(-axis, axis, indexing="ij")
    inside = elementwise.hypot(ups, rights) <= TIP_REACH * (1.0 + 1e-9)
    strokes = np.repeat(np.array([stroke], dtype=np.float64), int(inside.sum()) + 1, axis=0)
    strokes[1:, s.TIP_LEFT] = -rights[inside]
    strokes[1:, s.TIP_UP] = ups[inside]
    routes = position.play(strokes)
    scores = position.wanted.scores(routes)
    found = np.where(scores, np.where(routes.codes == routes.codes[0], AS_MEANT, OTHERWISE), MISSED)
    picture = np.full((cells, cells), -1, np.int8)
    picture[inside] = found[1:]
    return picture
