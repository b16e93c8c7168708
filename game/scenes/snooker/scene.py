"""Snooker: frames on the exact twelve-foot table, six-red, and practice."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.shot_effects import EXACT_EFFECTS
from game.lab.studies.billiards.long_pot import long_pot_study
from game.levels import Level
from game.scenes.shared.tables.beside.coach_card import draw_coach
from game.scenes.shared.tables.boxes import look_of
from game.scenes.shared.tables.course import REPLAY, ROLLING
from game.scenes.shared.tables.cue_game import CUE_BALL, ENERGY, PLAYS_ITSELF, SLIDING, CueGameScene
from game.scenes.shared.tables.odds import warm_up as warm_up_odds
from game.scenes.shared.tables.sounds import StrokeSounds
from game.scenes.shared.tables.view import warm_ups as table_warm_ups
from game.scenes.snooker import SNOOKER, layout, saving
from game.scenes.snooker.actions import ACTIONS, HINTS
from game.scenes.snooker.coach import SnookerCoach
from game.scenes.snooker.columns import COLUMN, frame_with
from game.scenes.snooker.course import Course
from game.scenes.snooker.exchange import SnookerExchange
from game.scenes.snooker.figure import draw_table_of_values
from game.scenes.snooker.hand import SnookerHand
from game.scenes.snooker.level import SnookerContent
from game.scenes.snooker.model import SnookerModel
from game.scenes.snooker.opponents import SnookerOpponents
from game.scenes.snooker.parameters import SnookerParameters
from game.scenes.snooker.readouts import readouts
from game.scenes.snooker.view.picture import SnookerView
from game.stage import (
    Decision,
    Equation,
    Frame,
    Readout,
    Strip,
    WarmUp,
)
from game.stage.records.excerpt import Excerpt


class SnookerScene(CueGameScene):
    """A twelve-foot table. Red and colour in turn, a red for 1 point, the colours for 2 to 7; when the reds
    are gone, the colours in order. A player that misses sits down.

    The rules are those of the World Professional Billiards and Snooker Association. They have free ball,
    touching ball, foul and a miss, and the black that is put back after a tie. In six-red snooker no player
    may be snookered behind a nominated colour. Every stroke is computed to its end by the exact table when
    the tip meets the ball.
    """

    name, task, title = SNOOKER.names
    parameters_type = SnookerParameters
    parameters: SnookerParameters
    effects = EXACT_EFFECTS
    study = long_pot_study
    refits = True
    takes = frozenset(("wheel", "right"))
    content_type = SnookerContent

    strips = (ENERGY, CUE_BALL, Strip("Break", "", ("break",)))
    hints = HINTS
    actions = ACTIONS
    figure = staticmethod(draw_table_of_values)
    equations = (
        SLIDING,
        Equation("Cushion", r"W_r = e^2 W_c", "Mathavan, Jackson, Parkin 2010"),
        Equation("Points left", r"8 n_{\text{red}} + 27", "WPBSA 3.1"),
    )
    try_this = (
        "Stun the cue ball behind the black after a red, so that it lies for the next one.",
        "After a foul let the other play again, or have the balls put back if a miss was called.",
        "Set Miss to Club: an escape that passes a ball on closely is good enough then.",
        "Let two masters play, and see their breaks.",
    )
    demo = (PLAYS_ITSELF,)

    def build(self, level: Level | None) -> None:
        given = level.content if level is not None else None
        content: SnookerContent = given or SnookerContent()
        if self.parameters.game not in ("level", content.game):
            content = SnookerContent(game=self.parameters.game, players=content.players)  # type: ignore[arg-type]
        self.model = SnookerModel(content, self.parameters, self.active, self.seed)
        self.course = Course(self.parameters, self.model, self.seed)
        self.hand = SnookerHand(self.course)
        self.opponents = SnookerOpponents(self.course, self.seed)
        self.exchange = SnookerExchange(self.name, self.course)
        self.sounds = StrokeSounds(self.course, (ROLLING, REPLAY))
        title = level.title if level is not None else ""
        self.coach = SnookerCoach(self.course)
        self.view = SnookerView(self.course, self.hand, self.opponents, title)

    def parameter_changed(self, name: str) -> None:
        if name in (
            "best_of",
            "miss",
            "sliding",
            "rolling",
            "ball_restitution",
            "cushion_restitution",
            "table",
        ):
            self.model.configure(self.active)

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("exact table", lambda: _warm_up(cls())), WarmUp("odds of a stroke", warm_up_odds),
            *table_warm_ups(),
        ]  # fmt: skip

    # -- what others decide ----------------------------------------------------------------

    def decide(self, event: Decision) -> None:
        self.opponents.decide(event)

    # -- what is shown, and kept --------------------------------------------------------------------

    def frame(self) -> Frame:
        return frame_with(bool(self.parameters.coach))

    def draw(self, canvas: Any, alpha: float) -> None:
        super().draw(canvas, alpha)
        if self.parameters.coach and canvas.pixels_per_unit >= layout.LEAST_PIXELS:
            draw_coach(canvas, look_of(canvas, layout.PIXELS), COLUMN, self.coach)

    def readouts(self) -> tuple[Readout, ...]:
        return readouts(self.course)

    def worth_keeping(self) -> object:
        return saving.worth_keeping(self.model, self.course.plays_itself)

    def highlights(self) -> tuple[Excerpt, ...]:
        return saving.highlights(self.course, self)

    @property
    def film_wanted(self) -> int:
        return self.course.films

    def save_content(self) -> SnookerContent:
        return saving.content_of(self.model)


def _warm_up(scene: SnookerScene) -> None:
    """Play one stroke, so that all kernels of the table are compiled."""
    scene.course.begin_stroke(Stroke(3.0, 0.5 * np.pi), Call())
    for _ in range(100):
        scene.advance(0.02)
    scene.readouts()
