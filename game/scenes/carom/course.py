"""The course of the game: aiming, the cue's swing, balls rolling; undo, choices, the chosen stroke."""

from __future__ import annotations

import math

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.map.hand import FEWEST
from game.billiards.shot.cue import speed_ratio
from game.billiards.table.carom import BALL_MASS, BALL_RADIUS
from game.scenes.carom.model import CaromModel
from game.scenes.carom.parameters import CaromParameters
from game.scenes.shared.tables.cue import MAX_SPEED, CueControl
from game.scenes.shared.tables.unsteady import shaken
from game.stage import Part
from game.stage.messages import Messages

AIMING, STRIKING, ROLLING = "aiming", "striking", "rolling"
PERSON = "person"
BALL_PER_CUE = speed_ratio(BALL_MASS)
AFTER_S = 0.25  # s that a shot is shown beyond its end
MOST_KEPT = 60  # own strokes


class Course(Part):
    """In which phase the game is, and since when.

    clock (1,) s: time of the phase; it belongs to the state, as the cue's data do. pending: the stroke for
    which the cue swings. chosen: the stroke of the map that is shown, None if none is. grip: what the pointer
    holds. rest_s: how long nobody has done anything, s. by_hand: strokes that a hand has played. own: strokes
    that were chosen and what the hand made of them, (meant, made).
    """

    def __init__(self, parameters: CaromParameters, model: CaromModel, seed: int) -> None:
        self.parameters = parameters
        self.model = model
        self.cue = CueControl(0.5 * math.pi)
        self.phase = AIMING
        self.clock = np.zeros(1)
        self.pending: Stroke | None = None
        self.safety = False
        self.chosen: Stroke | None = None
        self.grip = ""
        self.rest_s = 0.0
        self.plays_itself = False
        self.by_hand = 0
        self.own: tuple[tuple[Stroke, Stroke], ...] = ()
        self._seed = seed
        self.messages = Messages()

    # -- who plays ----------------------------------------------------------------------------------

    def grade_of(self, player: int) -> str:
        """ "person", or the grade of a computer player; whoever practises is a person."""
        if len(self.model.frame.game.players) == 1:
            return PERSON
        return str(self.parameters.first_player if player == 0 else self.parameters.second_player)

    @property
    def person_plays(self) -> bool:
        """True if the player at turn is a person."""
        return not self.plays_itself and self.grade_of(self.model.frame.game.turn) == PERSON

    @property
    def plays_alone(self) -> bool:
        """True if no player is a person."""
        return all(self.grade_of(player) != PERSON for player in range(len(self.model.frame.game.players)))

    @property
    def may_aim(self) -> bool:
        """True if a person may aim and strike now."""
        return self.phase == AIMING and self.person_plays and self.model.frame.playable

    @property
    def stroke(self) -> Stroke:
        """The stroke that is set."""
        chosen = self.parameters
        return Stroke(
            chosen.power / BALL_PER_CUE, self.cue.aim, math.radians(chosen.elevation), chosen.tip_left,
            chosen.tip_up,
        )  # fmt: skip

    @property
    def cue_ball(self) -> tuple[float, float]:
        """Where the ball lies that the player at turn plays, m."""
        return self.model.frame.places[self.model.frame.game.cue]

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
        else:
            self._roll()

    def begin_stroke(self, stroke: Stroke, safety: bool = False) -> None:
        """The cue starts to swing. ValueError if no stroke may be played now."""
        if self.phase != AIMING or not self.model.frame.playable:
            raise ValueError("stroke: none may be played now")
        self.pending, self.safety, self.grip = stroke, safety, ""
        self.cue.strike(stroke.azimuth, min(stroke.cue_speed * BALL_PER_CUE, MAX_SPEED))
        self.start_phase(STRIKING)

    def strike_by_hand(self, safety: bool = False) -> None:
        """The stroke that is set, as the hand of a person does it."""
        meant = self.stroke
        made = shaken(meant, str(self.parameters.hand), self._seed, self.by_hand, BALL_RADIUS)
        if self.chosen is not None:
            self.own = (*self.own, (self.chosen, made))[-MOST_KEPT:]
            if len(self.own) == FEWEST:
                self.messages.say("Your hand has been measured: see Chance of a hand.")
        self.begin_stroke(made, safety)
        self.by_hand += 1

    def _hit(self) -> None:
        """The tip has met the ball."""
        stroke, self.pending = self.pending, None
        self.cue.let_go()
        if stroke is None:
            self.start_phase(AIMING)
            return
        try:
            self.model.strike(stroke, self.safety)
        except ValueError as error:
            self.messages.say(f"The stroke cannot be played. {error}")
            self.start_phase(AIMING)
            return
        self.chosen = None
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
        """On to the end of the shot."""
        if self.phase == ROLLING:
            self.clock[0] = self.shown_s
            self._roll()

    # -- the map, back, and on ----------------------------------------------------------------------

    def choose(self, stroke: Stroke) -> None:
        """Show a stroke of the map; the cue is set to it."""
        self.chosen = stroke
        self.cue.point_to(stroke.azimuth)
        self.parameters.power = min(stroke.cue_speed * BALL_PER_CUE, MAX_SPEED)
        self.parameters.tip_left, self.parameters.tip_up = stroke.tip_left, stroke.tip_up
        self.parameters.elevation = 0.0

    def undo(self) -> None:
        """Before the last stroke of a person, or before balls were moved."""
        if self.phase == STRIKING:
            self.pending = None
            self.cue.data[1:3] = 0.0
            self.start_phase(AIMING)
            return
        taken = self.model.frame
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

    def next_game(self) -> None:
        """The next game if this one is over; else this level from its beginning."""
        self.model.next_game()
        self.pending, self.chosen, self.grip = None, None, ""
        self.cue.data[1:3] = 0.0
        self.start_phase(AIMING)

    def take_option(self, row: int) -> None:
        """The player at turn chooses one of the options, counted from 0; nothing if there is no such."""
        if self.phase == AIMING and 0 <= row < len(self.model.frame.game.options):
            self.model.choose(row)
            self.rest_s = 0.0
