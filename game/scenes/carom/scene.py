"""Carom: three balls, no pockets, and the map of every stroke that scores."""

from __future__ import annotations

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromStruck
from game.billiards.map.carom import GLANCE, whole_map
from game.billiards.players.carom import position_of
from game.billiards.search.strokes import Noise
from game.billiards.shot.cue import strike
from game.billiards.shot_effects import AIRBORNE, CLOTH, RUBBER, SPIN_DECAY, THROW
from game.billiards.simulation import warm_up_flights
from game.billiards.table.carom import BALL_NAMES
from game.lab.studies.billiards.chances import chances_study
from game.levels import Level
from game.scenes.carom import CAROM, layout, saving
from game.scenes.carom.actions import ACTIONS, HINTS
from game.scenes.carom.advisor import Advisor
from game.scenes.carom.coach import CaromCoach
from game.scenes.carom.course import Course
from game.scenes.carom.exchange import CaromExchange
from game.scenes.carom.figure import draw_three_cushions
from game.scenes.carom.hand import CaromHand
from game.scenes.carom.level import CaromContent
from game.scenes.carom.model import CaromModel
from game.scenes.carom.opponents import CaromOpponents
from game.scenes.carom.parameters import CaromParameters
from game.scenes.carom.readouts import readouts
from game.scenes.carom.view.picture import CaromView
from game.scenes.shared.tables.course import REPLAY, ROLLING
from game.scenes.shared.tables.cue_game import CUE_BALL, ENERGY, PLAYS_ITSELF, SLIDING, CueGameScene
from game.scenes.shared.tables.sounds import StrokeSounds
from game.scenes.shared.tables.view import warm_ups as table_warm_ups
from game.stage import (
    Decision,
    Equation,
    Frame,
    Readout,
    Strip,
    WarmUp,
)
from game.stage.records.excerpt import Excerpt


class CaromScene(CueGameScene):
    """A carom table. A point is made when the cue ball touches both other balls; at three-cushion it must
    touch three cushions before the second of them.

    The list shows every way to score from the position on the table. Whenever a ball is moved, the exact
    table plays 18 000 strokes over aim, speed and the place of the tip to their end. Those that score are
    grouped by the order of balls and cushions that the cue ball touches. Each group's best stroke is tried
    again and again with the noise of a hand. Drag a ball and watch.
    """

    name, task, title = CAROM.names
    parameters_type = CaromParameters
    parameters: CaromParameters
    effects = CLOTH | SPIN_DECAY | THROW | RUBBER | AIRBORNE
    study = chances_study
    takes = frozenset(("wheel", "right"))
    content_type = CaromContent

    strips = (ENERGY, CUE_BALL, Strip("Cushions", "", ("cushions",)))
    hints = HINTS
    actions = ACTIONS
    figure = staticmethod(draw_three_cushions)
    equations = (
        SLIDING,
        Equation("Chance of a stroke", r"p \approx \frac{k}{n}", "k of n strokes of a hand score"),
        Equation("Its error", r"\sigma = \sqrt{p (1 - p) / n}", "binomial"),
        Equation("Average", r"\text{points} / \text{innings}", "UMB"),
    )
    try_this = (
        "Drag the red ball slowly along a cushion, and watch ways come and go.",
        "Click a way, then again: it is played. U takes it back.",
        "Choose the hand of a master, then that of a novice: the surest way becomes another one.",
        "Take the cloth of a club instead of the heated one: the same stroke dies short.",
    )
    demo = (PLAYS_ITSELF,)

    def build(self, level: Level | None) -> None:
        given = level.content if level is not None else None
        content: CaromContent = given or CaromContent()
        if self.parameters.game not in ("level", content.game):
            content = CaromContent(game=self.parameters.game, players=content.players)  # type: ignore[arg-type]
        self.model = CaromModel(content, self.parameters, self.active, self.seed)
        self.course = Course(self.parameters, self.model, self.seed)
        self.advisor = Advisor(self.course)
        self.opponents = CaromOpponents(self.course)
        self.hand = CaromHand(self.course, self.advisor)
        self.exchange = CaromExchange(self.name, self.course)
        self.sounds = StrokeSounds(self.course, (ROLLING, REPLAY), _cue_of)
        self.coach = CaromCoach(self.course, self.advisor)
        self.view = CaromView(self.course, self.hand, self.advisor, self.opponents, self.coach)

    def parameter_changed(self, name: str) -> None:
        if name in ("cloth", "target", "innings"):
            self.model.configure(self.active)

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("exact table", lambda: _warm_up(cls())), WarmUp("balls in the air", warm_up_flights),
            WarmUp("map", lambda: whole_map(position_of(cls().model.frame), Noise(), GLANCE) and None),
            *table_warm_ups(),
        ]  # fmt: skip

    # -- what others decide ----------------------------------------------------------------

    def decisions(self, at_once: bool = False) -> list[Decision]:
        return [*self.advisor.decisions(at_once), *super().decisions(at_once)]

    def decide(self, event: Decision) -> None:
        values = event.values
        if event.name == "option" and len(values) == 1:
            self.course.take_option(int(values[0]))
        elif event.name in ("show", "play") and len(values) == 5:
            stroke = Stroke(*values)
            strike(*stroke)  # refuses what no stroke can be
            if event.name == "show":
                self.course.choose(stroke)
            else:
                self.course.begin_stroke(stroke)
        else:
            raise ValueError(f"{event.name}: expected show, play or option, each with its numbers")

    # -- what is shown, and kept --------------------------------------------------------------------

    def frame(self) -> Frame:
        return layout.FRAME

    def readouts(self) -> tuple[Readout, ...]:
        return readouts(self.course)

    def worth_keeping(self) -> object:
        return saving.worth_keeping(self.model, self.course.plays_itself)

    def highlights(self) -> tuple[Excerpt, ...]:
        return saving.highlights(self.course, self)

    @property
    def film_wanted(self) -> int:
        return self.course.films

    def save_content(self) -> CaromContent:
        return saving.content_of(self.model)


def _cue_of(struck: CaromStruck) -> str:
    """Name of the ball that was struck."""
    return BALL_NAMES[struck.frame.game.cue]


def _warm_up(scene: CaromScene) -> None:
    """Play one stroke, so that all kernels of the table are compiled."""
    scene.course.begin_stroke(Stroke(3.0, 0.5 * np.pi))
    for _ in range(100):
        scene.advance(0.02)
    scene.readouts()
