"""What the picture of the lecture's table remembers: contacts of the last moments, and those not noticed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game.billiards.lecture.state import (
    BALL_BALL,
    BALL_POCKET,
    EVENT_X,
    EVENT_Y,
    FIRST,
    IMPULSE,
    KIND,
    SECOND,
)
from game.billiards.table.passing import COLUMNS, find_passed

if TYPE_CHECKING:
    from game.scenes.lecture_table.scene import LectureTable

Array = NDArray[np.float64]

MARKS = 24  # contacts remembered for the picture
MARK_S = 0.7  # s that a contact is shown
LEAST_IMPULSE = 1e-3  # N s, that is worth a mark
PASSED_S = 3.0  # s that a contact is shown that was not noticed

_found = np.zeros((1, COLUMNS))


def no_marks() -> Array:
    """Marks (24, 4): x, y from the middle in m, age in s, impulse in N s, negative at a cushion."""
    marks = np.zeros((MARKS, 4))
    marks[:, 2] = MARK_S
    return marks


def take_events(scene: LectureTable, dt: float) -> None:
    """The contacts of a step become marks; balls in pockets begin to sink."""
    marks = scene.marks
    marks[:, 2] += dt
    np.minimum(marks[:, 2], MARK_S, out=marks[:, 2])
    for row in scene.table.event_rows.tolist():
        if row[KIND] == BALL_POCKET:
            scene.sunk_s[int(row[FIRST])] = 0.0
        elif row[IMPULSE] > LEAST_IMPULSE:
            sign = 1.0 if row[KIND] == BALL_BALL else -1.0
            marks[scene.next_mark] = (row[EVENT_X], row[EVENT_Y], 0.0, row[IMPULSE] * sign)
            scene.next_mark = (scene.next_mark + 1) % MARKS


def take_passed(scene: LectureTable, before: Array) -> None:
    """Pairs that went through each other in the step are counted, and the first is kept for the picture.

    before: offsets (n, 2) m at the beginning of the step.
    """
    state = scene.table.state
    free = state.in_play.copy()
    for row in scene.table.event_rows.tolist():
        free[int(row[FIRST])] = False
        if row[KIND] == BALL_BALL:
            free[int(row[SECOND])] = False
    count = find_passed(before, state.offsets, state.radii, free, _found)
    if count:
        scene.unseen += count
        scene.passed = (scene.played_s, *_found[0].tolist())
