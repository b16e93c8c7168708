"""What a level file of the two-ball program may say: where the balls begin, and how fast."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import msgspec

WIDTH, HEIGHT = 640.0, 400.0  # px, the lecture's window
FRAME_RATE = 30.0  # 1/s, of the lecture's main loop
FASTEST = 1e6  # px/frame

X = Annotated[float, msgspec.Meta(ge=0.0, le=WIDTH)]
Y = Annotated[float, msgspec.Meta(ge=0.0, le=HEIGHT)]
Speed = Annotated[float, msgspec.Meta(ge=-FASTEST, le=FASTEST)]  # px/frame


class BallEntry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """Position (px, y down) and velocity (px per frame)."""

    position: tuple[X, Y]
    velocity: tuple[Speed, Speed] = (0.0, 0.0)


def entry_of(position: Sequence[float], velocity: Sequence[float]) -> BallEntry:
    """A ball as it stands. One that is outside the window, or faster than `FASTEST`, is kept at the limit."""
    x, y = min(max(position[0], 0.0), WIDTH), min(max(position[1], 0.0), HEIGHT)
    across, down = (min(max(speed, -FASTEST), FASTEST) for speed in velocity)
    return BallEntry(position=(x, y), velocity=(across, down))


class LectureBallsContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a lecture-balls level. The defaults are those of the lecture's main program."""

    ball_1: BallEntry = BallEntry(position=(34.0, 34.0), velocity=(10.0, 15.0))
    ball_2: BallEntry = BallEntry(position=(606.0, 366.0), velocity=(-20.0, -10.0))
