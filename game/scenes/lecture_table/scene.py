"""The lecture's billiard table, playable: real proportions, a mouse cue, and every parameter of the model."""

from __future__ import annotations

import math
from typing import Any

from game.billiards.lecture.state import LECTURE_EFFECTS
from game.billiards.lecture.table import warm_ups as table_warm_ups
from game.billiards.table.passing import warm_up as warm_passing
from game.lab.studies.billiards.lecture_table import lecture_table_study
from game.scenes.lecture_table import LECTURE_TABLE, view
from game.scenes.lecture_table.figure import draw_tunnelling
from game.scenes.lecture_table.hand import take_action, take_pointer
from game.scenes.lecture_table.level import LectureTableContent, content_of, layout_of
from game.scenes.lecture_table.model import LectureTableModel, LectureTableState
from game.scenes.lecture_table.parameters import LectureTableParameters
from game.scenes.lecture_table.readouts import readouts_of
from game.scenes.lecture_table.sounds import hearing_of
from game.scenes.lecture_table.turns import Turns
from game.scenes.shared.tables import view as table_view
from game.scenes.shared.tables.cue import CueControl
from game.stage import Equation, Frame, Hearing, Hint, Pointer, Scene, SceneAction, Strip, WarmUp
from game.worlds.scene import ModelScene, Told


class LectureTable(ModelScene):
    """The billiard table as the lecture builds it. In each step a ball's velocity is added to its position;
    what has gone wrong by then is repaired: a ball beyond a cushion is put back and turned round. Two balls
    that overlap are moved apart and exchange the parts of their velocities along the line of centres. Every
    speed shrinks by a friction factor, and what is slower than a minimum stops.

    That is simple, and it fails in ways that can be seen here. A fast ball jumps over a ball or a cushion
    between two steps. Contacts resolved one after the other break the symmetry of a break. A friction factor
    per frame makes the table faster or slower with the frame rate. Substeps, joint contacts and a factor per
    second mend each of them, at the price shown under "What accuracy costs".
    """

    name, task, title = LECTURE_TABLE.names
    parameters_type = LectureTableParameters
    parameters: LectureTableParameters
    effects = LECTURE_EFFECTS
    quarter_turns = 1
    takes = frozenset(("right",))
    content_type = LectureTableContent
    default_content = LectureTableContent(plays_itself=True)
    told = Told(readouts_of)
    restore = Scene.restore  # the arrays stay where they are
    study = lecture_table_study

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
        Equation("Speed", r"\abs{\v{v}} = \sqrt{v_x^2 + v_y^2}", "of the velocity"),
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
        "Open the hard case through the ball: with one substep the cue ball jumps over the 8.",
        "Set the order to pair by pair and break straight on: left and right no longer mirror each other.",
        "Set friction to per frame and change the step: the same stroke takes a different course.",
    )

    # -- building and stepping ----------------------------------------------------------------------

    def make(self, content: LectureTableContent) -> None:
        chosen = self.parameters
        layout = layout_of(content, chosen.radius_spread, chosen.mass_spread, self.seed)
        self.model = LectureTableModel(layout, chosen, self.active, self.seed)
        self.cue = CueControl(0.5 * math.pi)
        self.turns = Turns(self.model, self.cue, content, self.seed)
        self.said = self.turns.messages

    def parameter_changed(self, name: str) -> None:
        table = self.model.table
        table.settings = self.parameters.settings_after(name, table.settings)

    def effects_changed(self) -> None:
        self.model.table.effects = self.active

    def advance(self, dt: float) -> None:
        if self.cue.advance(dt) and self.model.cue_ball_ready:
            self.model.strike(self.cue.aim, self.cue.speed, dt)
        self.model.advance(dt)
        if self.turns.advance(dt):
            self._rack_again()

    def _rack_again(self) -> None:
        """All balls as they began; who plays stays."""
        before = self.turns
        self.build(self.level)
        self.turns.plays_itself, self.turns.player = before.plays_itself, before.player

    def state(self) -> LectureTableState:
        return self.model.state(self.cue.data)

    def save_content(self) -> LectureTableContent:
        model, base = self.model, self.content_of(self.level)
        return content_of(model.table, model.numbers, base, self.turns.plays_itself)

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            *(WarmUp(*row) for row in table_warm_ups()),
            WarmUp("unseen contacts", warm_passing),
            *table_view.warm_ups(),
        ]

    # -- the hand, and what is shown ----------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        take_pointer(self.turns, event)

    def action(self, name: str) -> None:
        if name == "rack":
            self._rack_again()
        else:
            take_action(self.turns, name)

    def frame(self) -> Frame:
        return table_view.frame_of(self.model.table.table)

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(canvas, self.model, self.turns, self.previous, alpha)

    def hearing(self) -> Hearing:
        return hearing_of(self.model, self.cue.speed)
