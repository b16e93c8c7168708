"""The course of the game: aiming, the cue's swing, balls rolling; undo, choices, the chosen stroke."""

from __future__ import annotations

from typing import Any

from game.billiards.game.arrangement import Stroke
from game.billiards.map.hand import FEWEST
from game.billiards.table.carom import BALL_MASS, BALL_RADIUS
from game.scenes.carom.model import CaromModel
from game.scenes.carom.parameters import CaromParameters
from game.scenes.shared.tables.course import AIMING, CueCourse
from game.scenes.shared.tables.cue import MAX_SPEED

MOST_KEPT = 60  # own strokes


class Course(CueCourse):
    """As of every cue table, and what is chosen on the map.

    safety: whether the stroke is called one. chosen: the stroke of the map that is shown, None if none is.
    own: strokes that were chosen and what the hand made of them, (meant, made).
    """

    model: CaromModel
    parameters: CaromParameters
    chosen: Stroke | None

    def __init__(self, parameters: CaromParameters, model: CaromModel, seed: int) -> None:
        super().__init__(parameters, model, seed, BALL_MASS)
        self.safety = False
        self.own: tuple[tuple[Stroke, Stroke], ...] = ()

    @property
    def cue_ball(self) -> tuple[float, float]:
        """Where the ball lies that the player at turn plays, m."""
        return self.model.frame.places[self.model.frame.game.cue]

    def ended(self, frame: Any) -> bool:
        return bool(frame.game.ended)

    # -- strokes ------------------------------------------------------------------------------------

    def begin_stroke(self, stroke: Stroke, safety: bool = False) -> None:
        """The cue starts to swing. ValueError if no stroke may be played now."""
        self.swing(stroke)
        self.safety = safety

    def strike_now(self, stroke: Stroke) -> None:
        self.model.strike(stroke, self.safety)

    def strike_by_hand(self, safety: bool = False) -> None:
        """The stroke that is set, as the hand of a person does it."""
        meant = self.stroke
        made = self.by_the_hand(meant, BALL_RADIUS)
        if self.chosen is not None:
            self.own = (*self.own, (self.chosen, made))[-MOST_KEPT:]
            if len(self.own) == FEWEST:
                self.messages.say("Your hand has been measured: see Chance of a hand.")
        self.begin_stroke(made, safety)
        self.by_hand += 1

    # -- the map, and on ----------------------------------------------------------------------

    def choose(self, stroke: Stroke) -> None:
        """Show a stroke of the map; the cue is set to it."""
        self.chosen = stroke
        self.cue.point_to(stroke.azimuth)
        self.parameters.power = min(stroke.cue_speed * self.ball_per_cue, MAX_SPEED)
        self.parameters.tip_left, self.parameters.tip_up = stroke.tip_left, stroke.tip_up
        self.parameters.elevation = 0.0

    def next_one(self) -> None:
        if self.learning.best:  # a lesson that is done leads on
            self.learning.go_on()
        else:
            super().next_one()

    def begin_next(self) -> None:
        self.model.next_game()
        self.begin_again()

    def take_option(self, row: int) -> None:
        """The player at turn chooses one of the options, counted from 0; nothing if there is no such."""
        if self.phase == AIMING and 0 <= row < len(self.model.frame.game.options):
            self.model.choose(row)
            self.rest_s = 0.0
