"""The lecture's billiard table, playable: real proportions, a mouse cue, and every parameter of the model."""

from __future__ import annotations

import math
from collections import deque
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.lecture.state import (
    BALL_COLLISIONS,
    LECTURE_EFFECTS,
    LectureSettings,
)
from game.billiards.lecture.table import LectureTable as Table
from game.billiards.lecture.table import warm_ups as table_warm_ups
from game.billiards.table.passing import warm_up as warm_passing
from game.lab.studies.billiards.lecture_table import lecture_table_study
from game.levels import Level
from game.scenes.lecture_table import LECTURE_TABLE, marks, turns
from game.scenes.lecture_table import sounds as lecture_table_sounds
from game.scenes.lecture_table.figure import draw_tunnelling
from game.scenes.lecture_table.level import LectureTableContent, content_of, layout_of
from game.scenes.lecture_table.parameters import LectureTableModel
from game.scenes.shared.tables import view as table_view
from game.scenes.shared.tables.cue import STRIKING, CueControl
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.stage import (
    Equation,
    Frame,
    Hearing,
    Hint,
    Pointer,
    Readout,
    SceneAction,
    Strip,
    Toggle,
    WarmUp,
)

Array = NDArray[np.float64]

TURN_ENDS_S = 0.4  # s of rest before the turn is over
SUNK_S = 0.35  # s in which a pocketed ball drops out of sight
LEAST_OVERLAP = 1e-12  # m; below that touching balls overlap by rounding only


class LectureTableState(NamedTuple):
    """The table as in billiards.lecture_state, and what is around it.

    cue (7,) as in cue_control; sunk_s (n,) s since a ball fell; marks (24, 4): x, y, age, impulse.
    """

    offsets: Array
    velocities: Array
    orientations: Array
    in_play: NDArray[np.bool_]
    pocketed_by: NDArray[np.int64]
    cue: Array
    sunk_s: Array
    marks: Array


class LectureTable(LectureTableModel):
    """The billiard table as the lecture builds it. In each step a ball's velocity is added to its position;
    what has gone wrong by then is repaired: a ball beyond a cushion is put back and turned round, two balls
    that overlap are moved apart and exchange the parts of their velocities along the line of centres, every
    speed shrinks by a friction factor, and what is slower than a minimum stops.

    That is simple, and it fails in ways that can be seen here. A fast ball jumps over a ball or a cushion
    between two steps; contacts resolved one after the other break the symmetry of a break; a friction factor
    per frame makes the table faster or slower with the frame rate. Substeps, joint contacts and a factor per
    second mend each of them, at the price shown under "What accuracy costs".
    """

    name, task, title = LECTURE_TABLE.names
    effects = LECTURE_EFFECTS
    quarter_turns = 1
    takes = frozenset(("right",))
    content_type = LectureTableContent
    study = lecture_table_study

    aim_line = Toggle(
        True, group="Balls", label="Aim line", help="ghost ball and the straight lines after it"
    )

    strips = (
        Strip("Energy", "J", ("energy",)),
        Strip("Momentum", "kg m/s", ("along", "across")),
        Strip("Overlap", "m", ("overlap",)),
    )
    hints = (
        Hint(("Move",), "aim"),
        Hint(("Drag",), "pull back"),
        Hint(("Shift",), "fine aim"),
        Hint(("Esc",), "take back"),
    )
    actions = (
        SceneAction("rack", "new rack", "R"),
        SceneAction("demo", "plays itself", "D"),
        SceneAction("left", "turn the cue left", "left"),
        SceneAction("right", "turn the cue right", "right"),
    )
    figure = staticmethod(draw_tunnelling)
    equations = (
        Equation("Motion", r"\v{x}_{n+1} = \v{x}_n + \v{v}_n \Delta t", "the lecture, Euler"),
        Equation("Cushion", r"x' = w - e (x - w), v' = -e v", "overshoot given back"),
        Equation(
            "Impulse along the line of centres",
            r"j = \frac{(1+e) m_1 m_2}{m_1 + m_2} (\v{v}_1 - \v{v}_2) \cdot \v{n}",
            "Newton 1687",
        ),
        Equation("Friction", r"\v{v}_{n+1} = f^{60 \Delta t} \v{v}_n", "the lecture, per second"),
    )
    try_this = (
        "Open the hard case through the ball: with one substep the white ball jumps over the 8.",
        "Set the order to pair by pair and break straight on: left and right no longer mirror each other.",
        "Set friction to per frame and change the step: the same stroke runs a different way.",
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        self.content = level.content if level is not None and level.content is not None else None
        content = self.content or LectureTableContent(plays_itself=True)
        layout = layout_of(content, self.radius_spread, self.mass_spread, self.seed)
        self.numbers = layout.numbers
        self.table = Table(
            layout.table,
            layout.positions,
            layout.radii,
            layout.masses,
            layout.velocities,
            self.active,
            self.settings(),
        )
        self.table.state.orientations[:] = scattered_orientations(len(layout.numbers), self.seed)
        self.cue = CueControl(0.5 * math.pi)
        self.sunk_s = np.full(len(layout.numbers), SUNK_S)
        self.marks = marks.no_marks()
        self.next_mark = 0
        self.unseen = 0  # contacts that happened between two steps and were not noticed
        self.passed: tuple[float, ...] = ()  # when (s played), and the row of billiards.passing
        self.strokes = 0
        self.played_s = 0.0
        self.struck_s = -math.inf  # when the cue last met the white ball, of the time played
        self.player = 0
        self.down_before = 0
        self.rest_s = 0.0
        self.turn_open = False
        self.plays_itself = content.plays_itself
        self.stroke = content.stroke
        self.told: deque[str] = deque(maxlen=8)

    def parameter_changed(self, name: str) -> None:
        if name not in ("step_length", "aim_line"):
            self.table.configure(
                **{field: getattr(self.settings(), field) for field in LectureSettings.__dataclass_fields__}
            )

    def effects_changed(self) -> None:
        self.table.effects = self.active

    def state(self) -> LectureTableState:
        state = self.table.state
        return LectureTableState(
            state.offsets,
            state.velocities,
            state.orientations,
            state.in_play,
            state.pocketed_by,
            self.cue.data,
            self.sunk_s,
            self.marks,
        )

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            *(WarmUp(*row) for row in table_warm_ups()),
            WarmUp("unseen contacts", warm_passing),
            *table_view.warm_ups(),
        ]

    def hearing(self) -> Hearing:
        return lecture_table_sounds.hearing_of(self)

    # -- stepping -----------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self.cue.advance(dt) and self.white_ready:
            aim, speed = self.cue.aim, self.cue.speed
            self.table.strike(0, (speed * math.cos(aim), speed * math.sin(aim)))
            self.strokes += 1
            self.struck_s = self.played_s + dt
        self.played_s += dt
        before = self.table.state.offsets.copy()
        self.table.step(dt)
        self.sunk_s += dt
        np.minimum(self.sunk_s, SUNK_S, out=self.sunk_s)
        marks.take_events(self, dt)
        if BALL_COLLISIONS in self.active and self.table.moving:
            marks.take_passed(self, before)
        if self.table.moving or self.cue.phase == STRIKING:
            self.rest_s = 0.0
            self.turn_open = True
        else:
            self.rest_s += dt
            if self.turn_open and self.rest_s > TURN_ENDS_S:
                turns.end_turn(self)
            turns.play_by_itself(self)

    # -- the hand -----------------------------------------------------------------------------------

    @property
    def has_white(self) -> bool:
        """True if ball 0 is the white one."""
        return bool(self.numbers[0] == 0)

    @property
    def white_ready(self) -> bool:
        """The white ball lies at rest, and so do all others."""
        return self.has_white and bool(self.table.state.in_play[0]) and not self.table.moving

    @property
    def balls_down(self) -> int:
        """Numbered balls in the pockets."""
        return int(np.count_nonzero(~self.table.state.in_play[1:]))

    def pointer(self, event: Pointer) -> None:
        if not self.has_white:
            return
        if event.kind == "down" and event.button == 1 and self.plays_itself:
            self.plays_itself = False
            self.told.append("The cue is yours: pull back and let go.")
        if self.plays_itself:
            return
        white = self.table.positions[0]
        self.cue.pointer(event, float(white[0]), float(white[1]), self.white_ready)

    def action(self, name: str) -> None:
        if name == "rack":
            plays, player = self.plays_itself, self.player
            self.build(self.level)
            self.plays_itself, self.player = plays, player
        elif name == "demo":
            self.plays_itself = not self.plays_itself
            self.cue.let_go()
        else:
            self.cue.nudge(name)

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return table_view.frame_of(self.table.table)

    def draw(self, canvas: Any, alpha: float) -> None:
        table_view.draw_lecture_table(self, canvas, alpha)

    def readouts(self) -> tuple[Readout, ...]:
        along, across = self.table.momentum[1], self.table.momentum[0]
        white = self.table.velocities[0]
        overlap = self.table.deepest_overlap
        return (
            Readout("balls down", self.balls_down),
            Readout("white ball", math.sqrt(float(white @ white)), "m/s"),
            Readout("energy", self.table.energy, "J"),
            Readout("along", along, "kg m/s"),
            Readout("across", across, "kg m/s"),
            Readout("overlap", overlap if overlap > LEAST_OVERLAP else 0.0, "m"),
            Readout("passed unseen", self.unseen),
            Readout("substeps", self.table.counters["substeps"]),
            Readout("strokes", self.strokes),
        )

    def messages(self) -> list[str]:
        told = list(self.told)
        self.told.clear()
        return told

    def save_content(self) -> LectureTableContent:
        return content_of(self.table, self.numbers, self.content, self.plays_itself)
