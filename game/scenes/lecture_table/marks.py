"""What the picture of the lecture's table remembers: contacts of the last moments, and those not noticed."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.lecture import state as s
from game.billiards.lecture.table import LectureTable
from game.billiards.table.passing import COLUMNS, find_passed
from game.stage import Part

MARKS = 24  # contacts remembered for the picture
MARK_S = 0.7  # s that a contact is shown
LEAST_IMPULSE = 1e-3  # N s, that is worth a mark


class Marks(Part):
    """Contacts of the last moments, and how many were not noticed.

    rows (24, 4): x, y from the middle in m, age in s, impulse in N s, negative at a cushion. passed: of the
    last contact that was not noticed the time (s played) and the row of billiards.table.passing.
    """

    def __init__(self) -> None:
        self.rows: Floats = np.zeros((MARKS, 4))
        self.rows[:, 2] = MARK_S
        self.next = 0
        self.unseen = 0
        self.passed: tuple[float, ...] = ()
        self._found = np.zeros((1, COLUMNS))

    def take_events(self, table: LectureTable, dt: float) -> None:
        """The contacts of a step become marks, and all marks older."""
        rows = self.rows
        rows[:, 2] += dt
        np.minimum(rows[:, 2], MARK_S, out=rows[:, 2])
        for event in table.event_rows.tolist():
            if event[s.KIND] != s.BALL_POCKET and event[s.IMPULSE] > LEAST_IMPULSE:
                sign = 1.0 if event[s.KIND] == s.BALL_BALL else -1.0
                rows[self.next] = (event[s.EVENT_X], event[s.EVENT_Y], 0.0, event[s.IMPULSE] * sign)
                self.next = (self.next + 1) % MARKS

    def take_passed(self, table: LectureTable, before: Floats, now_s: float) -> None:
        """Pairs that went through each other in the step are counted, and the first is kept for the picture.

        before: offsets (n, 2) m at the beginning of the step. now_s: time played, s.
        """
        state = table.state
        free = state.in_play.copy()
        for row in table.event_rows.tolist():
            free[int(row[s.FIRST])] = False
            if row[s.KIND] == s.BALL_BALL:
                free[int(row[s.SECOND])] = False
        count = find_passed(before, state.offsets, state.radii, free, self._found)
        if count:
            self.unseen += count
            self.passed = (now_s, *self._found[0].tolist())
