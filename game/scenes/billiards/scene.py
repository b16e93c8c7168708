"""The billiard game: eight-ball, nine-ball, combination match, practice, drills, trick shots."""

from __future__ import annotations

import math
from collections import deque
from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame as GameFrame
from game.billiards.game.games import Drill
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.lecture.state import POCKETS
from game.billiards.shot.shot import Physics
from game.billiards.shot.trajectory import rotation_matrices
from game.billiards.shot_effects import physics_of
from game.lab.studies.billiards.effects import effects_study
from game.levels import Level
from game.scenes.billiards import BILLIARDS, buttons, deciding, hand, modes, view
from game.scenes.billiards import play as moves
from game.scenes.billiards.actions import ACTIONS, HINTS
from game.scenes.billiards.figure import draw_aim
from game.scenes.billiards.kept import Kept
from game.scenes.billiards.layout import FRAME
from game.scenes.billiards.level import BilliardsContent, PlacedBall, ball_set, game_of, lie_of
from game.scenes.billiards.parameters import BilliardsParameters
from game.scenes.billiards.play import AIMING, PHASE_S, REPLAY, ROLLING, SET_UP, STRIKING
from game.scenes.billiards.players import think, warm_up
from game.scenes.billiards.round import Conditions, Played, Round, begin
from game.scenes.billiards.sounds import hearing_of
from game.scenes.billiards.stroke_motion import warm_ups as cue_warm_ups
from game.scenes.billiards.thinker import Thinker
from game.scenes.shared.tables.cue import CueControl
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.scenes.shared.tables.view import warm_ups as table_warm_ups
from game.stage import (
    Action,
    Decision,
    Equation,
    Frame,
    Hearing,
    Pointer,
    Readout,
    Sound,
    Stamped,
    Strip,
    WarmUp,
)

Array = NDArray[np.float64]


class BilliardsState(NamedTuple):
    """What is on the table at this moment.

    clock (2,) s: time of the phase, place in the replay. places (16, 2) m by number. turns, turns_before
    (16, 3, 3): how the balls lie, and lay before the last stroke. cue (7,). word: of the round.
    """

    clock: Array
    places: Array
    turns: Array
    turns_before: Array
    cue: Array
    word: str


class Billiards(BilliardsParameters):
    """A pool table to play on. Every stroke is computed to its end at the moment when the tip meets the ball,
    from one event to the next: ball meets ball, cushion, jaw or pocket, sliding turns into rolling. What you
    see afterwards is that computation looked at in its time, and so is the line before you strike: it is no
    guess, but the stroke itself.

    Eight-ball and nine-ball follow the rules of the World Pool-Billiard Association. In the combination match
    a ball counts only if it goes down by way of another one. Puzzles and drills have goals, and up to three
    stars.
    """

    name, task, title = BILLIARDS.names
    study = effects_study
    covers = True
    quarter_turns = 1
    takes = frozenset(("wheel", "middle", "right"))
    content_type = BilliardsContent

    strips = (
        Strip("Energy", "J", ("energy",)),
        Strip("White ball", "m/s", ("white ball",)),
        Strip("Events", "", ("events",)),
    )
    hints = HINTS
    actions = ACTIONS
    figure = staticmethod(draw_aim)
    equations = (
        Equation(
            "Sliding", r"\v{r} = \v{r}_0 + \v{v}_0 t - \frac{1}{2} \mu g t^2 \v{u}", "Leckie, Greenspan 2006"
        ),
        Equation("Next contact of two balls", r"|\v{r}_2(t) - \v{r}_1(t)|^2 = 4 R^2", "a quartic in t"),
        Equation("Cue and ball", r"v = \frac{2 V}{1 + m/M + \frac{5}{2} (a^2 + b^2)}", "Alciatore, TP A-30"),
        Equation("Throw", r"\mu = a + b e^{-c v}", "Alciatore 2006"),
    )
    try_this = (
        "Drag the blue mark on the white ball's picture down, and see the line after the contact bend back.",
        "Raise the cue to 60 degrees, the tip to the side, strike gently: the ball turns round another.",
        "Choose a computer player as second player, and let it show its thoughts.",
        "Press E, lay out a position of your own, save it, and play it again and again.",
    )
    demo = (Stamped(12, Action("demo")), Stamped(2400, Action("centre")))  # and it goes on playing

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        given = level.content if level is not None else None
        content: BilliardsContent = given or BilliardsContent()
        if self.game not in ("level", content.game):
            content = BilliardsContent(game=self.game, players=content.players, calling=content.calling)  # type: ignore[arg-type]
        self.content = content
        balls = ball_set(self.radius_spread, self.mass_spread, self.seed)
        conditions = self.conditions(tuple(balls.radii.tolist()), tuple(balls.masses.tolist()))
        game = game_of(content)
        lie = lie_of(content, game, conditions.table, balls, self.seed)
        self.round: Round = begin(GameFrame(game, lie, conditions.table, conditions.physics), conditions)
        self.phase = AIMING
        self.clock = np.zeros(2)
        self.places = np.zeros((16, 2))
        self.turns = rotation_matrices(scattered_orientations(16, self.seed))
        self.turns_before = self.turns.copy()
        self.cue = CueControl(moves.AT_THE_RACK)
        self.pending: Stroke | None = None  # while the cue swings
        self.practised = False
        self.grip = ""  # what the pointer holds
        self.call = Call()  # what the player has announced by hand
        self.replay_runs = True
        self.replay_speed = 1.0
        self.plays_itself = False
        self.rest_s = 0.0
        self.racks = 0
        self.told: deque[str] = deque(maxlen=8)
        self.thinker = Thinker(think, warm_up)
        self.hint_shown = False  # the solution of a puzzle
        self.fine_at = math.nan  # bearing of the pointer at which the aim was made finely, rad
        self.power_before = self.power
        self.pulled = math.nan  # power of the stroke that the cue was drawn back for, m/s
        self.kept = Kept()
        moves.lay_out(self)

    def conditions(self, radii: tuple[float, ...], masses: tuple[float, ...]) -> Conditions:
        """What parameters and effects make of the table."""
        physics = Physics(
            sliding=self.sliding, rolling=self.rolling,
            ball_restitution=self.ball_restitution, cushion_restitution=self.cushion_restitution,
        )  # fmt: skip
        return Conditions(radii, masses, physics_of(self.active, physics), POCKETS in self.active)

    def state(self) -> BilliardsState:
        return BilliardsState(
            self.clock, self.places, self.turns, self.turns_before, self.cue.data, self.word
        )

    def restore(self, state: BilliardsState) -> None:
        for mine, then in zip(self.state()[:-1], state[:-1], strict=True):
            mine[...] = then  # the round comes back with the plain attributes

    @property
    def word(self) -> str:
        """A word that stands for the round, for the digest: equal rounds, equal words."""
        return f"{self.phase} {self.kept.word(self.round)}"

    def parameter_changed(self, name: str) -> None:
        if name in ("sliding", "rolling", "ball_restitution", "cushion_restitution"):
            self.effects_changed()

    def effects_changed(self) -> None:
        now = self.round.conditions
        self.round = msgspec.structs.replace(self.round, conditions=self.conditions(now.radii, now.masses))

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("exact table", lambda: moves.warm_up(cls())),
            *cue_warm_ups(),
            *table_warm_ups(),
        ]

    # -- stepping -----------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self.phase == STRIKING:
            self.clock[PHASE_S] += dt
            moves.swing(self)
        elif self.phase == ROLLING:
            self.clock[PHASE_S] += dt
            moves.roll(self)
        elif self.phase == REPLAY:
            modes.run_replay(self, dt)
        elif self.phase == AIMING:
            self.rest_s += dt
            if self.plays_itself or self.plays_alone:
                deciding.play_by_itself(self)

    @property
    def played(self) -> Played | None:
        """What comes, or came, of the last stroke; None before the first."""
        return self.kept.played(self.round)

    @property
    def sounds(self) -> tuple[Sound, ...]:
        """What is to be heard of the last stroke."""
        return self.kept.sounds(self.round)

    @property
    def person_plays(self) -> bool:
        """True if the player at turn is a person."""
        return not self.plays_itself and self.grade_of(self.round.game.turn) == "person"

    def grade_of(self, player: int) -> str:
        """ "person", or the grade of a computer player."""
        return str(self.first_player if player == 0 else self.second_player)

    # -- what comes in ------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        hand.pointer(self, event)

    def action(self, name: str) -> None:
        buttons.action(self, name)

    @property
    def way_out(self) -> str:
        return {REPLAY: "replay", SET_UP: "set-up"}.get(self.phase, "")

    def decisions(self, at_once: bool = False) -> list[Decision]:
        return deciding.decisions(self, at_once)

    @property
    def plays_alone(self) -> bool:
        return all(self.grade_of(player) != "person" for player in range(len(self.round.game.players)))

    def decide(self, event: Decision) -> None:
        deciding.decide(self, event)

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return FRAME

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(self, canvas, alpha)

    def hearing(self) -> Hearing | None:
        return hearing_of(self)

    def legend(self) -> list[tuple[str, str, str]]:
        return []

    def readouts(self) -> tuple[Readout, ...]:
        energy, speed, count = moves.measures(self)
        return (
            Readout("balls", len([1 for number, *_ in self.round.places if number != CUE_BALL])),
            Readout("energy", energy, "J"),
            Readout("white ball", speed, "m/s"),
            Readout("events", count),
            Readout("strokes", self.round.strokes),
            Readout("shot", float(self.clock[PHASE_S]) if self.phase == ROLLING else 0.0, "s"),
        )

    def messages(self) -> list[str]:
        told = list(self.told)
        self.told.clear()
        return told

    def worth_keeping(self) -> object:
        puzzle = isinstance(self.round.game, Drill)  # which begins anew with every stroke
        if puzzle or self.plays_itself or not self.round.strokes:
            return None
        return self.round.game, self.round.places

    @property
    def stars(self) -> tuple[int, int] | None:
        game = self.round.game
        if self.plays_itself or not isinstance(game, Drill):
            return None
        return game.best, 1 + len(game.more)

    def save_content(self) -> BilliardsContent:
        """Game and table as they are; in the midst of a stroke, as they were before it."""
        balls = [PlacedBall(number=number, position=(x, y)) for number, x, y in self.round.places]
        return BilliardsContent(
            game=self.content.game, players=self.content.players, calling=self.content.calling,
            balls=balls, solution=self.content.solution,
            saved=msgspec.to_builtins(self.round.game),
        )  # fmt: skip
