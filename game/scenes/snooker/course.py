"""The course of the game: aiming, nominating, the cue's swing, balls rolling; replay, undo, choices."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.shot.cue import speed_ratio
from game.billiards.table.aim import first_contact
from game.billiards.table.snooker import BALL_MASS, BALL_RADIUS, COLOURS, name_of
from game.scenes.shared.tables.cue import MAX_SPEED, CueControl
from game.scenes.shared.tables.unsteady import shaken
from game.scenes.snooker.model import SnookerModel
from game.scenes.snooker.parameters import FIRST, GUIDES, PERSON, WHOLE, SnookerParameters
from game.stage import Part
from game.stage.messages import Messages

AIMING, STRIKING, ROLLING, REPLAY = "aiming", "striking", "rolling", "replay"
BALL_PER_CUE = speed_ratio(BALL_MASS)
AFTER_S = 0.25  # s that a shot is shown beyond its end


class Course(Part):
    """In which phase the game is, and since when.

    clock (1,) s: time of the phase; it belongs to the state, as the cue's data do. pending: the stroke for
    which the cue swings; called: what was nominated for it. chosen: the ball nominated by hand, None: the one
    that is aimed at. locked: the cue does not follow the pointer. grip: what the pointer holds. rest_s: how
    long nobody has done anything, s. by_hand: strokes that a hand has played. asked: the frame for which a
    concession was asked once.
    """

    def __init__(self, parameters: SnookerParameters, model: SnookerModel, seed: int) -> None:
        self.parameters = parameters
        self.model = model
        self.cue = CueControl(0.5 * math.pi)
        self.phase = AIMING
        self.clock = np.zeros(1)
        self.pending: Stroke | None = None
        self.called = Call()
        self.chosen: int | None = None
        self.locked = False
        self.grip = ""
        self.rest_s = 0.0
        self.plays_itself = False
        self.by_hand = 0
        self.asked = ""
        self._seed = seed
        self.messages = Messages()

    # -- who plays ----------------------------------------------------------------------------------

    def grade_of(self, player: int) -> str:
        """ "person", or the grade of a computer player; whoever practises is a person."""
        if len(self.model.game.players) == 1:
            return PERSON
        return str(self.parameters.first_player if player == 0 else self.parameters.second_player)

    def set_grade(self, player: int, grade: str) -> None:
        """Let a person, or a computer player of a grade, play."""
        if player == 0:
            self.parameters.first_player = grade
        else:
            self.parameters.second_player = grade

    @property
    def person_plays(self) -> bool:
        """True if the player at turn is a person."""
        return not self.plays_itself and self.grade_of(self.model.game.turn) == PERSON

    @property
    def plays_alone(self) -> bool:
        """True if no player is a person."""
        return all(self.grade_of(player) != PERSON for player in range(len(self.model.game.players)))

    @property
    def may_aim(self) -> bool:
        """True if a person may aim and strike now."""
        return self.phase == AIMING and self.person_plays and self.model.frame.playable

    @property
    def guide(self) -> str:
        """How much of the stroke that is aimed is shown: one of GUIDES."""
        chosen = str(self.parameters.guide)
        if chosen in GUIDES:
            return chosen
        return WHOLE if len(self.model.game.players) == 1 else FIRST

    def next_guide(self) -> None:
        """The guide after the present one, round the end."""
        self.parameters.guide = GUIDES[(GUIDES.index(self.guide) + 1) % len(GUIDES)]

    # -- the stroke that is set, and what is nominated ----------------------------------------------

    @property
    def stroke(self) -> Stroke:
        """The stroke that is set."""
        chosen = self.parameters
        return Stroke(
            chosen.power / BALL_PER_CUE, self.cue.aim, math.radians(chosen.elevation), chosen.tip_left,
            chosen.tip_up,
        )  # fmt: skip

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

    # -- phases -------------------------------------------------------------------------------------

    def start_phase(self, phase: str) -> None:
        """Go over to a phase, its clock at 0."""
        self.phase = phase
        self.clock[0] = 0.0
        self.rest_s = 0.0

    def advance(self, dt: float) -> None:
        """One step of what goes on by itself."""
        self.clock[0] += dt
        if self.phase == AIMING:
            self.rest_s += dt
        elif self.phase == STRIKING:
            if self.cue.advance(dt):
                self._hit()
        elif self.phase == ROLLING:
            self._roll()
        elif float(self.clock[0]) >= self.shown_s:
            self.start_phase(AIMING)

    def begin_stroke(self, stroke: Stroke, call: Call) -> None:
        """The cue starts to swing. ValueError if no stroke may be played now."""
        if self.phase != AIMING or not self.model.frame.playable:
            raise ValueError("stroke: none may be played now")
        self.pending, self.called, self.grip = stroke, call, ""
        self.cue.strike(stroke.azimuth, min(stroke.cue_speed * BALL_PER_CUE, MAX_SPEED))
        self.start_phase(STRIKING)

    def strike_by_hand(self) -> None:
        """The stroke that is set, as the hand of a person does it; a colour must have been nominated."""
        call = self.call
        if self.model.game.stage == "colour" and not self.model.game.free_ball and call.ball is None:
            aimed = self.aimed_at
            where = f"You aim at the {name_of(aimed)}." if aimed is not None else "You aim at a cushion."
            self.messages.say("Nominate a colour first: click one below the table.")
            self.messages.say(where)
            self.cue.let_go()
            return
        made = shaken(self.stroke, str(self.parameters.hand), self._seed, self.by_hand, BALL_RADIUS)
        self.begin_stroke(made, call)
        self.by_hand += 1

    def _hit(self) -> None:
        """The tip has met the ball."""
        stroke, self.pending = self.pending, None
        self.cue.let_go()
        if stroke is None:
            self.start_phase(AIMING)
            return
        try:
            self.model.strike(stroke, self.called)
        except ValueError as error:
            self.messages.say(f"The stroke cannot be played. {error}")
            self.start_phase(AIMING)
            return
        self.chosen, self.locked = None, False
        self.start_phase(ROLLING)

    @property
    def shown_s(self) -> float:
        """How long the last stroke is shown, s."""
        played = self.model.played
        return AFTER_S + (played.trajectory.end_time if played is not None else 0.0)

    def _roll(self) -> None:
        time = float(self.clock[0])
        self.model.roll(time)
        if time >= self.shown_s:
            self.model.settle()
            self.start_phase(AIMING)

    def skip(self) -> None:
        """On to the end of the shot, or of its replay."""
        if self.phase == ROLLING:
            self.clock[0] = self.shown_s
            self._roll()
        elif self.phase == REPLAY:
            self.start_phase(AIMING)

    def replay(self) -> None:
        """Show the last stroke once more; again ends it."""
        if self.phase == REPLAY:
            self.start_phase(AIMING)
        elif self.phase == AIMING and self.model.frame.last is not None:
            self.start_phase(REPLAY)
        elif self.phase == AIMING:
            self.messages.say("Nothing to show. No stroke has been played.")

    # -- back, on, and what no stroke brings about --------------------------------------------------

    def undo(self) -> None:
        """Before the last stroke of a person."""
        if self.phase == STRIKING:
            self.pending = None
            self.cue.data[1:3] = 0.0
            self.start_phase(AIMING)
            return
        taken: Frame = self.model.frame
        if taken.earlier is None:
            self.messages.say("Nothing to undo. No stroke has been played.")
            return
        while taken.earlier is not None:
            taken = taken.earlier
            if self.grade_of(taken.game.turn) == PERSON or self.plays_itself:
                break
        self.model.go_back_to(taken)
        self.chosen, self.grip = None, ""
        self.start_phase(AIMING)

    def next_frame(self) -> None:
        """The next frame if this one is over; else this level from its beginning."""
        again = bool(self.model.game.drill)
        self.model.next_frame()
        self.pending, self.chosen, self.grip = None, None, ""
        self.cue.data[1:3] = 0.0
        if not again:
            self.cue.point_to(0.5 * math.pi)
        self.start_phase(AIMING)

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
