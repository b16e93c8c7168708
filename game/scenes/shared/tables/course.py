"""The course of a game at a cue table: aiming, the cue's swing, balls rolling; back, and on."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.deciding import Marked, taken_back, with_marked
from game.billiards.shot.cue import speed_ratio
from game.scenes.shared.tables.choices import PERSON
from game.scenes.shared.tables.cue import MAX_SPEED, CueControl
from game.scenes.shared.tables.grip import NOTHING
from game.scenes.shared.tables.lessons.lesson import Learning
from game.scenes.shared.tables.minds.hurry import hurried
from game.scenes.shared.tables.moments import OFF, decider, pace_at, slowed_s
from game.scenes.shared.tables.seats.cup import goes_on
from game.scenes.shared.tables.seats.hot_seat import waits
from game.scenes.shared.tables.through.measured import news_of_hand
from game.scenes.shared.tables.through.push import Push
from game.scenes.shared.tables.unsteady import shaken
from game.stage import Part
from game.stage.messages import Messages

AIMING, STRIKING, ROLLING, REPLAY = "aiming", "striking", "rolling", "replay"
MOST_OWN = 200  # pushed strokes from which a hand is measured
LONG_AGO_S = 99.0  # s since a call that is heard no more
AFTER_S = 0.25  # s that a shot is shown beyond its end


class CueCourse(Part):
    """In which phase the game is, and since when. Subclasses say how a stroke is made and what they choose.

    model: with frame, played, strike, roll, settle and go_back_to. clock (1,) s: time of the phase; it
    belongs to the state, as the cue's data do. pending: the stroke for which the cue swings. chosen: what a
    subclass lets the player choose, None for nothing. grip: what the pointer holds. rest_s: how long nothing
    has been done, s. by_hand: strokes that a hand has played. push: the cue of a stroke that is pushed;
    thrust: the next one was; aimed, made: the last stroke of a person; strayed: the last of those, as meant
    and made.
    seated: the player that has the cue, where it is handed over.
    called_s: since the referee last called, s; frame_s: how long the frame has lasted.
    from_side: a replay is seen from its side, slowly about the moments that decide. marked: the strokes of
    the match as they counted; films: how often a film of those that decided it has been asked for.
    advised: number of strokes at which the coach was asked last, coached: how often in this frame.
    rounds: how often the next round of a cup has been asked for. learning: how a lesson goes.
    """

    model: Any
    parameters: Any

    def __init__(self, parameters: Any, model: Any, seed: int, ball_mass: float) -> None:
        self.parameters = parameters
        self.model = model
        self.ball_per_cue = speed_ratio(ball_mass)  # speed of the ball to that of the cue
        self.cue = CueControl(0.5 * math.pi)
        self.push = Push(parameters, ball_mass)
        self.phase = AIMING
        self.clock = np.zeros(1)
        self.pending: Stroke | None = None
        self.chosen: Any = None
        self.grip = NOTHING
        self.rest_s = 0.0
        self.thrust = False
        self.aimed: Stroke | None = None
        self.made: Stroke | None = None
        self.strayed: tuple[tuple[Stroke, Stroke], ...] = ()
        self.plays_itself = False
        self.seated = int(model.frame.game.turn)
        self.from_side = False
        self.by_hand = 0
        self.called_s = LONG_AGO_S
        self.frame_s = 0.0
        self.marked: tuple[Marked, ...] = ()
        self.films = 0
        self.rounds = 0
        self.learning = Learning(model.content.lesson, model.seen, model.name_of)
        self.advised = -1
        self.coached = 0
        self._seed = seed
        self.messages = Messages()

    # -- for subclasses -----------------------------------------------------------------------------

    def strike_now(self, stroke: Stroke) -> None:
        """The tip meets the ball: let the model play the stroke. ValueError if it cannot be played."""
        raise NotImplementedError

    def forget_choice(self) -> None:
        """What had been chosen for a stroke that has been played is chosen no more."""
        self.chosen = None

    # -- who plays ----------------------------------------------------------------------------------

    def grade_of(self, player: int) -> str:
        """ "person", or the grade of a computer player; a player that practises is a person."""
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
    def aimed_and_done(self) -> tuple[Stroke, Stroke] | None:
        """The last stroke of a hand, as it was aimed and as it was done."""
        return (self.aimed, self.made) if self.aimed is not None and self.made is not None else None

    @property
    def own_strokes(self) -> tuple[tuple[Stroke, Stroke], ...]:
        """The last strokes of a person's hand that was measured, (meant, made) each."""
        return self.strayed

    @property
    def may_aim(self) -> bool:
        """True if a person may aim and strike now."""
        return bool(
            self.phase == AIMING and self.person_plays and self.model.frame.playable and not waits(self)
        )

    @property
    def stroke(self) -> Stroke:
        """The stroke that is set."""
        chosen = self.parameters
        return Stroke(
            chosen.power / self.ball_per_cue, self.cue.aim, math.radians(chosen.elevation), chosen.tip_left,
            chosen.tip_up,
        )  # fmt: skip

    # -- phases -------------------------------------------------------------------------------------

    def start_phase(self, phase: str) -> None:
        """Go over to a phase, its clock at 0."""
        self.phase = phase
        self.clock[0] = 0.0
        self.rest_s = 0.0

    def advance(self, dt: float) -> None:
        """One step of what goes on by itself."""
        pace = hurried(self, self.pace, self._decides) if self.phase == ROLLING else self.pace
        self.clock[0] = self.shown_s if math.isinf(pace) else self.clock[0] + dt * pace
        self.push.advance(dt)
        self.called_s += dt
        self.frame_s += 0.0 if self.over else dt
        if self.phase == AIMING:
            self.rest_s += dt
        elif self.phase == STRIKING:
            if self.cue.advance(dt):
                self._hit()
        elif self.phase == ROLLING:
            self._roll()
        elif float(self.clock[0]) >= self.shown_s:
            self.start_phase(AIMING)

    @property
    def over(self) -> bool:
        """True if the frame, or the game of carom, has ended."""
        return self.ended(self.model.frame)

    def ended(self, frame: Any) -> bool:
        """True if a frame is over."""
        return bool(frame.game.over)

    @property
    def may_film(self) -> bool:
        """True if a match has ended of whose strokes there is a film to be made."""
        return self.over and len(self.model.frame.game.players) == 2 and bool(self.marked)

    @property
    def _decides(self) -> bool:
        """True if the stroke that rolls ends the game."""
        played = self.model.played
        return played is not None and self.ended(played.frame)

    @property
    def pace(self) -> float:
        """How fast what is shown goes on: a replay from the side slowly where balls meet, drop or hang."""
        if self.phase == ROLLING and self.parameters.eye_follows != OFF:
            return pace_at(float(self.clock[0]), decider(self.model.moments, self._decides))
        moments = self.model.moments if self.phase == REPLAY and self.from_side else None
        return pace_at(float(self.clock[0]), moments) if moments is not None else 1.0

    def by_the_hand(self, meant: Stroke, radius: float) -> Stroke:
        """A stroke as a person's hand does it: as it was pushed, or as it shakes. radius of the ball, m."""
        if self.push.struck is not None:
            self.thrust = True
            made = self.push.made(meant, radius)
            self.strayed = (*self.strayed, (meant, made))[-MOST_OWN:]
            if news := news_of_hand(self.strayed, radius):
                self.messages.say(news)
        else:
            self.thrust = False
            made = shaken(meant, str(self.parameters.hand), self._seed, self.by_hand, radius)
        done = self.push.after_the_tip(made)
        if self.push.slipped:
            self.messages.say(self.push.miscue_words(made))
        self.aimed, self.made = meant, done
        return done

    def swing(self, stroke: Stroke) -> None:
        """The cue starts to swing for a stroke; one that was pushed is there already. ValueError if no stroke
        may be played now.
        """
        if self.phase != AIMING or not self.model.frame.playable:
            raise ValueError("stroke: none may be played now")
        self.pending, self.grip = stroke, NOTHING
        self.cue.strike(stroke.azimuth, min(stroke.cue_speed * self.ball_per_cue, MAX_SPEED))
        if self.thrust:
            self.cue.data[6], self.thrust = 0.0, False
        self.start_phase(STRIKING)

    def _hit(self) -> None:
        """The tip has met the ball."""
        stroke, self.pending = self.pending, None
        self.cue.let_go()
        if stroke is None:
            self.start_phase(AIMING)
            return
        try:
            self.strike_now(stroke)
        except ValueError as error:
            self.messages.say(f"The stroke cannot be played. {error}")
            self.start_phase(AIMING)
            return
        self.forget_choice()
        self.start_phase(ROLLING)

    @property
    def shown_s(self) -> float:
        """How long the last stroke is shown, s."""
        played = self.model.played
        return AFTER_S + (float(played.trajectory.end_time) if played is not None else 0.0)

    def _roll(self) -> None:
        time = float(self.clock[0])
        self.model.roll(time)
        if time >= self.shown_s:
            self.marked = with_marked(self.marked, self.model.frame.last, self.model.played)
            self.model.settle()
            self.called_s = 0.0
            if self.learning.lesson is not None and not self.plays_itself:
                self.model.put_back(self.learning.judged())
            self.start_phase(AIMING)

    @property
    def slowed_s(self) -> float:
        """How much longer the last stroke may be shown than its balls roll, s."""
        return AFTER_S + (slowed_s(2) if self.parameters.eye_follows != OFF else 0.0)

    def skip(self) -> None:
        """On to the end of the shot, or of its replay."""
        if self.phase == ROLLING:
            self.clock[0] = self.shown_s
            self._roll()
        elif self.phase == REPLAY:
            self.start_phase(AIMING)

    def replay(self, from_side: bool = False) -> None:
        """Show the last stroke once more; again ends it. From the side: in a replay, from there or above."""
        if self.phase == REPLAY and from_side:
            self.from_side = not self.from_side
        elif self.phase == REPLAY:
            self.start_phase(AIMING)
        elif self.phase == AIMING and self.model.frame.last is not None:
            self.from_side = from_side
            self.cue.let_go()
            self.push.let_go()
            self.grip = NOTHING
            self.start_phase(REPLAY)
        elif self.phase == AIMING:
            self.messages.say("Nothing to show. No stroke has been played.")

    # -- back, and on -------------------------------------------------------------------------------

    def ask_coach(self) -> None:
        """Ask what to play, which shows the coach; the score says so until the next frame."""
        self.parameters.coach = True
        strokes = self.model.frame.strokes
        if self.may_aim and self.advised != strokes:
            self.advised = strokes
            self.coached += 1

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
        self.marked = taken_back(self.marked, taken.strokes)
        self.model.go_back_to(taken)
        self.chosen, self.grip = None, NOTHING
        self.start_phase(AIMING)

    def next_one(self) -> None:
        """The next frame or game; after a match of a cup its next round is asked for, and nothing begins."""
        if not goes_on(self):
            self.begin_next()

    def begin_next(self) -> None:
        """The next frame or game if this one is over; else this level from its beginning."""
        raise NotImplementedError

    def begin_again(self) -> None:
        """Nothing is pending, chosen or held; the cue is at rest."""
        self.pending, self.chosen, self.grip = None, None, NOTHING
        self.called_s, self.frame_s = LONG_AGO_S, 0.0
        self.advised, self.coached = -1, 0
        if not self.model.frame.strokes:  # from the very beginning
            self.marked = ()
        self.cue.data[1:3] = 0.0
        self.start_phase(AIMING)
