"""The billiard game: eight-ball, nine-ball, combination match, practice, drills, trick shots."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.games import Drill
from game.billiards.game.rules import Call
from game.billiards.shot_effects import GAME_EFFECTS
from game.billiards.simulation import warm_up_flights
from game.lab.studies.billiards.flights import game_study
from game.levels import Level
from game.scenes.billiards import BILLIARDS, saving
from game.scenes.billiards.actions import ACTIONS, HINTS
from game.scenes.billiards.beside import NONE
from game.scenes.billiards.buttons import Buttons
from game.scenes.billiards.exchange import PoolExchange
from game.scenes.billiards.figure import draw_aim
from game.scenes.billiards.hand import BilliardsHand
from game.scenes.billiards.level import BilliardsContent
from game.scenes.billiards.model import BilliardsModel
from game.scenes.billiards.modes import Replay, SetUp
from game.scenes.billiards.opponents.deciding import Opponents
from game.scenes.billiards.parameters import TABLE_PARAMETERS, BilliardsParameters
from game.scenes.billiards.play import REPLAY, SET_UP, Play
from game.scenes.billiards.practice.advisor import PoolAdvisor
from game.scenes.billiards.practice.coach import PoolCoach
from game.scenes.billiards.practice.columns import frame_with
from game.scenes.billiards.practice.drill_maker import DrillMaker
from game.scenes.billiards.practice.log_text import log_in
from game.scenes.billiards.practice.nearness import scored_by
from game.scenes.billiards.practice.sets import drill_title, standing_set
from game.scenes.billiards.practice.side import DECISIONS, Side
from game.scenes.billiards.readouts import readouts
from game.scenes.billiards.sounds import StrokeSounds
from game.scenes.billiards.story.targets import StrokeSeen
from game.scenes.billiards.story.throw import throw_chart
from game.scenes.billiards.stroke.aiming import Aiming
from game.scenes.billiards.stroke.motion import warm_ups as cue_warm_ups
from game.scenes.billiards.view.beside.column import ColumnView
from game.scenes.billiards.view.beside.on_cloth import OnCloth
from game.scenes.billiards.view.picture import BilliardsView
from game.scenes.shared.tables.cue_game import CUE_BALL, ENERGY, PLAYS_ITSELF, SLIDING, CueGameScene
from game.scenes.shared.tables.lessons.order import level_after
from game.scenes.shared.tables.odds import warm_up as warm_up_odds
from game.scenes.shared.tables.view import warm_ups as table_warm_ups
from game.stage import (
    Action,
    Comparison,
    Decision,
    Equation,
    Frame,
    Readout,
    Stamped,
    Strip,
    WarmUp,
)
from game.stage.records.excerpt import Excerpt
from game.stage.records.history import Practised
from game.stage.records.scored import Scored


class Billiards(CueGameScene):
    """A pool table to play on. Every stroke is computed to its end at the moment when the tip meets the ball,
    from one event to the next: ball meets ball, cushion, jaw or pocket, sliding turns into rolling. What you
    see afterwards is that computation looked at in its time, and so is the line before you strike: it is no
    guess, but the stroke itself.

    A raised cue presses the ball onto the slate, and it jumps: over a ball, against a nose, off the table.
    The line of aim is dashed wide where the ball is in the air; beside it stands how high it gets.

    Eight-ball and nine-ball follow the rules of the World Pool-Billiard Association. In the combination match
    a ball counts only if it goes down by way of another one. Puzzles and drills have goals, and up to three
    stars.
    """

    name, task, title = BILLIARDS.names
    parameters_type = BilliardsParameters
    former_parameters = {"prediction": "guide"}
    parameters: BilliardsParameters
    effects = GAME_EFFECTS
    study = game_study
    refits = True
    takes = frozenset(("wheel", "middle", "right"))
    content_type = BilliardsContent

    strips = (ENERGY, CUE_BALL, Strip("Events", "", ("events",)))
    hints = HINTS
    actions = ACTIONS
    figure = staticmethod(draw_aim)
    equations = (
        SLIDING,
        Equation("Next contact of two balls", r"|\v{r}_2(t) - \v{r}_1(t)|^2 = 4 R^2", "a quartic in t"),
        Equation("Cue and ball", r"v = \frac{2 V}{1 + m/M + \frac{5}{2} (a^2 + b^2)}", "Alciatore, TP A-30"),
        Equation("Bounce on the slate", r"v_z' = -e v_z, \quad \Delta v \le \mu (1 + e) |v_z|", "Cross 2002"),
        Equation("Throw", r"\mu = a + b e^{-c v}", "Alciatore 2006"),
    )
    try_this = (
        "Lock the aim by a click, drag down with the right button, and see the line bend back.",
        "Raise the cue to 60 degrees, the tip to the side, strike gently: the ball turns round another.",
        "Raise the cue to 40 degrees and strike hard at a ball behind another: yours jumps over it.",
        "Choose a computer player as second player, and let it show its thoughts.",
        "Press E, lay out a position of your own, save it, and play it again and again.",
    )
    demo = (PLAYS_ITSELF, Stamped(2400, Action("centre")))

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        given = level.content if level is not None else None
        content: BilliardsContent = given or BilliardsContent()
        if self.parameters.game not in ("level", content.game):
            content = BilliardsContent(
                game=self.parameters.game,  # type: ignore[arg-type]
                players=content.players, calling=content.calling,
            )  # fmt: skip
        self.model = BilliardsModel(content, self.parameters, self.active, self.seed)
        self.aiming = Aiming(self.parameters)
        self.play = self.course = Play(self.parameters, self.model, self.aiming, self.seed)
        self.replay = Replay(self.play)
        self.play.log = log_in(content.log, self.model.frame)
        self.set_up = SetUp(self.play)
        self.advisor = PoolAdvisor(self.play)
        self.coach = PoolCoach(self.play)
        self.side = Side(self.play, self.advisor)
        self.maker = DrillMaker(self.play, self.set_up)
        self.buttons = Buttons(self.play, self.replay, self.set_up, self.side, self.maker)
        self.hand = BilliardsHand(self.play, self.replay, self.set_up, self.buttons)
        self.opponents = Opponents(self.play, self.seed)
        self.exchange = PoolExchange(self.name, self.course)
        self.sounds = StrokeSounds(self.play, self.replay)
        self.seen = StrokeSeen(self.play)
        on_cloth = OnCloth(self.play, self.advisor, self.maker)
        self.view = BilliardsView(self.play, self.replay, self.buttons, self.opponents, on_cloth, level)
        self.column = ColumnView(self.play, self.side, self.advisor, self.coach, level)

    def parameter_changed(self, name: str) -> None:
        if name in TABLE_PARAMETERS:
            self.model.configure(self.active)

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("exact table", lambda: _warm_up(cls())), WarmUp("balls in the air", warm_up_flights),
            WarmUp("odds of a stroke", warm_up_odds),
            *cue_warm_ups(), *table_warm_ups(),
        ]  # fmt: skip

    # -- stepping -----------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        self.replay.advance(dt)
        super().advance(dt)

    # -- what comes in ------------------------------------------------------------------------------

    def act(self, name: str) -> None:
        self.buttons.act(name)

    @property
    def way_out(self) -> str:
        beside = self.side.beside
        return {REPLAY: "replay", SET_UP: "set-up"}.get(self.play.phase, "" if beside == NONE else beside)

    def decisions(self, at_once: bool = False) -> list[Decision]:
        return [*self.advisor.decisions(at_once), *super().decisions(at_once)]

    def decide(self, event: Decision) -> None:
        if event.name in DECISIONS:
            self.side.decide(event)
        else:
            self.opponents.decide(event)

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return frame_with(self.side.beside)

    def draw(self, canvas: Any, alpha: float) -> None:
        super().draw(canvas, alpha)
        self.column.draw(canvas)

    def readouts(self) -> tuple[Readout, ...]:
        return readouts(self.play, self.seen)

    def story_targets(self) -> dict[str, tuple[float, float]]:
        return self.seen.targets()

    def story_sizes(self) -> dict[str, float]:
        return self.seen.sizes()

    def story_names(self) -> list[tuple[tuple[float, float], str]]:
        return self.seen.names()

    def story_charts(self) -> dict[str, Comparison]:
        return {"throw": throw_chart(self.seen.contact)}

    # -- what is kept -------------------------------------------------------------------------------

    def worth_keeping(self) -> object:
        return saving.worth_keeping(self.model, self.play.plays_itself)

    @property
    def stars(self) -> tuple[int, int] | None:
        game = self.model.frame.game
        if self.play.plays_itself or not isinstance(game, Drill):
            return None
        return game.best, 1 + len(game.more)

    @property
    def level_wanted(self) -> str:
        path = self.level.path if self.level is not None else None
        return level_after(path.stem) if self.buttons.goes_on and path is not None else ""

    def save_content(self) -> BilliardsContent:
        return saving.content_of(self.play, self.maker)

    @property
    def practised(self) -> Practised | None:
        return standing_set(self.play, self.level)

    @property
    def scored(self) -> Scored | None:
        return scored_by(self.play)

    @property
    def level_title(self) -> str:
        return drill_title(self.model.frame.game, self.level)

    def highlights(self) -> tuple[Excerpt, ...]:
        return saving.highlights(self.play, self)

    @property
    def film_wanted(self) -> int:
        return self.buttons.films

    def excerpt(self) -> Excerpt | None:
        return saving.stroke_excerpt(self.play, self)


def _warm_up(scene: Billiards) -> None:
    """Play one stroke and look at it, so that all kernels of the table are compiled."""
    scene.play.begin_stroke(Stroke(4.0, 0.5 * np.pi), Call())
    for _ in range(100):
        scene.advance(0.02)
    scene.readouts()
    if scene.model.played is not None:
        scene.model.played.trajectory.orientations_at(0.1)
