"""The course of the game: aiming, nominating, the cue's swing, balls rolling; replay, undo, choices."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.shot.cue import speed_ratio
from game.billiards.table.aim import first_contact
from game.billiards.table.snooker import BALL_MASS, BALL_RADIUS, COLOURS, name_of
from game.scenes.shared.tables.choices import FIRST, GUIDES, WHOLE, following
from game.scenes.shared.tables.course import AIMING, CueCourse
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.snooker.model import SnookerModel
from game.scenes.snooker.parameters import SnookerParameters

BALL_PER_CUE = speed_ratio(BALL_MASS)


class Course(CueCourse):
    """As of every cue table, and what is nominated.

    called: what was nominated for the stroke that is pending. chosen: the ball nominated by hand, None: the
    one that is aimed at. locked: the cue does not follow the pointer. asked: the frame for which a concession
    was asked once.
    """

    model: SnookerModel
    parameters: SnookerParameters
    chosen: int | None

    def __init__(self, parameters: SnookerParameters, model: SnookerModel, seed: int) -> None:
        super().__init__(parameters, model, seed, BALL_MASS)
        self.called = Call()
        self.locked = False
        self.asked = ""

    # -- who plays, and what is seen ---------------------------------------------------------------

    def set_grade(self, player: int, grade: str) -> None:
        """Let a person, or a computer player of a grade, play."""
        if player == 0:
            self.parameters.first_player = grade
        else:
            self.parameters.second_player = grade

    @property
    def guide(self) -> str:
        """How much of the stroke that is aimed is shown: one of GUIDES."""
        chosen = str(self.parameters.guide)
        if chosen in GUIDES:
            return chosen
        return WHOLE if len(self.model.game.players) == 1 else FIRST

    def next_guide(self) -> None:
        """The guide after the present one, round the end."""
        self.parameters.guide = following(self.guide, GUIDES)

    @property
    def match_over(self) -> bool:
        """Whether a player has won the match."""
        return bool(self.model.game.match_over)

    # -- the stroke that is set, and what is nominated ----------------------------------------------

    @property
    def aimed_at(self) -> int | None:
        """Number of the ball that a straight stroke along the cue meets first; None for none."""
        layout = self.model.frame.layout
        if CUE_BALL not in layout.numbers:
            return None
        row, every = layout.numbers.index(CUE_BALL), np.ones(len(layout.numbers), dtype=np.bool_)
        first = first_contact(
            row, self.cue.aim, layout.positions, layout.radii, every, self.model.frame.table
        )
        return layout.numbers[first.target] if first.kind == "ball" else None

    @property
    def call(self) -> Call:
        """What is nominated: by hand, else the ball that is aimed at, where one must or may be (2.12)."""
        game = self.model.game
        if not game.needs_call():
            return Call()
        ball = self.chosen if self.chosen is not None else self.aimed_at
        if ball is None or ball not in game.legal_first() or ball not in COLOURS:
            return Call()
        return Call(ball)

    def nominate(self, ball: int) -> None:
        """Nominate a colour by hand, or take that back."""
        game = self.model.game
        if self.may_aim and game.needs_call() and ball in game.legal_first() and ball in COLOURS:
            self.chosen = None if self.chosen == ball else ball
            self.locked = True

    def set_power(self, power: float) -> None:
        """Set the power, m/s, as near as can be."""
        self.parameters.power = min(max(round(power, 3), 0.1), MAX_SPEED)

    # -- strokes ------------------------------------------------------------------------------------

    def begin_stroke(self, stroke: Stroke, call: Call) -> None:
        """The cue starts to swing. ValueError if no stroke may be played now."""
        self.swing(stroke)
        self.called = call

    def strike_now(self, stroke: Stroke) -> None:
        self.model.strike(stroke, self.called)

    def forget_choice(self) -> None:
        super().forget_choice()
        self.locked = False

    def strike_by_hand(self) -> None:
        """The stroke that is set, as the hand of a person does it; a colour must have been nominated."""
        call = self.call
        if self.model.game.stage == "colour" and not self.model.game.free_ball and call.ball is None:
            aimed = self.aimed_at
            where = f"You aim at the {name_of(aimed)}." if aimed is not None else "You aim at a cushion."
            self.messages.say("Nominate a colour first: click one below the table.")
            self.messages.say(where)
            self.cue.let_go()
            self.push.struck = None
            return
        self.begin_stroke(self.by_the_hand(self.stroke, BALL_RADIUS), call)
        self.by_hand += 1

    # -- back, on, and what no stroke brings about --------------------------------------------------

    def begin_next(self) -> None:
        again = bool(self.model.game.drill)
        self.model.next_frame()
        self.begin_again()
        if not again:
            self.cue.point_to(0.5 * math.pi)

    def take_option(self, row: int) -> None:
        """The player at turn chooses one of the options, counted from 0; nothing if there is no such."""
        if self.phase == AIMING and 0 <= row < len(self.model.game.options):
            self.model.choose(row)
            self.chosen = None
            self.rest_s = 0.0

    def concede(self, at_once: bool = False) -> None:
        """Claim the frame if that may be; else concede it, which a person is asked about once."""
        game = self.model.game
        if self.phase != AIMING or game.over or len(game.players) == 1:
            return
        if game.may_claim and not game.options:
            self.model.rule(game.claim())
        elif at_once or self.asked == self.model.word:
            self.model.rule(game.concede())
        else:
            self.asked = self.model.word
            self.messages.say("Concede the frame? Once more concedes it.")

    def restart(self) -> None:
        """A stalemate, agreed upon (3.16)."""
        if self.phase != AIMING:
            return
        if not self.model.game.may_restart:
            self.messages.say("No stalemate: there must be more strokes without a point.")
            return
        self.model.rule(self.model.game.restart())
        self.start_phase(AIMING)
