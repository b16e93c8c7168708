"""The lecture's table as it is played: balls, strokes, and what the picture remembers of them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.lecture.state import BALL_COLLISIONS, BALL_POCKET, FIRST, KIND
from game.billiards.lecture.table import LectureTable
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.scenes.lecture_table.level import Layout
from game.scenes.lecture_table.marks import Marks
from game.scenes.lecture_table.parameters import LectureTableParameters
from game.scenes.shared.tables.demo_shots import free_head_spot, scattered_orientations
from game.stage import Part

SUNK_S = 0.35  # s in which a pocketed ball drops out of sight


class LectureTableState(NamedTuple):
    """The table as in billiards/lecture/state.py, and what is around it.

    cue (7,) as in `CueControl`; sunk_s (n,) s since a ball fell; marks (24, 4): x, y, age, impulse.
    """

    offsets: Floats
    velocities: Floats
    orientations: Floats
    in_play: NDArray[np.bool_]
    pocketed_by: NDArray[np.int64]
    cue: Floats
    sunk_s: Floats
    marks: Floats


class LectureTableModel(Part):
    """A table with the balls of a layout. effects: what is computed; seed: how the balls are turned."""

    def __init__(
        self, layout: Layout, parameters: LectureTableParameters, effects: EffectSet, seed: int
    ) -> None:
        self.parameters = parameters
        self.numbers = layout.numbers
        self.table = LectureTable(
            layout.table,
            layout.positions,
            layout.radii,
            layout.masses,
            layout.velocities,
            effects,
            parameters.settings,
        )
        self.table.state.orientations[:] = scattered_orientations(len(layout.numbers), seed)
        self.sunk_s = np.full(len(layout.numbers), SUNK_S)
        self.marks = Marks()
        self.strokes = 0
        self.played_s = 0.0
        self.struck_s = -math.inf  # when the cue last met the cue ball, of the time played

    def state(self, cue: Floats) -> LectureTableState:
        """All that later steps depend on, with that of the cue."""
        state = self.table.state
        return LectureTableState(
            state.offsets,
            state.velocities,
            state.orientations,
            state.in_play,
            state.pocketed_by,
            cue,
            self.sunk_s,
            self.marks.rows,
        )

    def strike(self, aim: float, speed: float, dt: float) -> None:
        """Give the cue ball a velocity, in the step of dt s that is to come."""
        self.table.strike(0, (speed * elementary.cos(aim), speed * elementary.sin(aim)))
        self.strokes += 1
        self.struck_s = self.played_s + dt

    def advance(self, dt: float) -> None:
        """One step of the table, and of what is remembered of it."""
        self.played_s += dt
        before = self.table.state.offsets.copy()
        self.table.step(dt)
        self.sunk_s += dt
        np.minimum(self.sunk_s, SUNK_S, out=self.sunk_s)
        for row in self.table.event_rows.tolist():
            if row[KIND] == BALL_POCKET:
                self.sunk_s[int(row[FIRST])] = 0.0
        self.marks.take_events(self.table, dt)
        if BALL_COLLISIONS in self.table.effects and self.table.moving:
            self.marks.take_passed(self.table, before, self.played_s)

    def put_back_cue_ball(self) -> None:
        """The cue ball comes back to the head spot, or to the free place nearest to it."""
        radius = float(self.table.state.radii[0])
        place = free_head_spot(self.table.table, radius, lambda place: self.table.is_clear(0, place))
        if place is not None:
            self.table.place(0, place)

    @property
    def has_cue_ball(self) -> bool:
        """True if ball 0 is the cue ball."""
        return bool(self.numbers[0] == 0)

    @property
    def cue_ball_ready(self) -> bool:
        """The cue ball is at rest, and so are all others."""
        return self.has_cue_ball and bool(self.table.state.in_play[0]) and not self.table.moving

    @property
    def balls_down(self) -> int:
        """Numbered balls in the pockets."""
        return int(np.count_nonzero(~self.table.state.in_play[1:]))
