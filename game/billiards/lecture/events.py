"""What happened in a step of the lecture's table, one event at a time."""

from __future__ import annotations

from typing import NamedTuple

from game.arrays import Floats
from game.billiards.lecture.state import EVENT_NAMES


class TableEvent(NamedTuple):
    """One thing that happened in the last step.

    kind: ball-ball, cushion, jaw or pocket. ball; other: ball, or row of the cushion, jaw or pocket. time: s
    since the step began. speed: m/s at which they closed. impulse: N s. position: x, y in m.
    """

    kind: str
    ball: int
    other: int
    time: float
    speed: float
    impulse: float
    position: tuple[float, float]


def table_events(rows: Floats, middle: Floats) -> list[TableEvent]:
    """Events of rows (k, 8), as the kernels write them; ``middle`` (2,) m: where positions count from."""
    mx, my = middle.tolist()
    return [
        TableEvent(
            EVENT_NAMES[int(kind)], int(ball), int(other), time, speed, impulse, (x + mx, y + my)
        )
        for kind, ball, other, time, speed, impulse, x, y in rows.tolist()
    ]  # fmt: skip
